/* SPDX-License-Identifier: MIT */
/* The integral over azimuths, with closed integrals along each. */
#include "flux_luminaire.h"

#include <math.h>
#include <stdlib.h>

#include "../base/larger.h"
#include "../base/memory.h"
#include "../base/search.h"
#include "../base/vector.h"
#include "../light/distribution.h"
#include "../world/integral/adaptive.h"
#include "flux_edges.h"

/* Panels besides those that are begun with; the fewest of a whole turn. */
enum { MORE_PANELS = 1024, FEWEST = 12 };

static const double DEGREE = 0.017453292519943295;
/* How well the places of edges are known, by the side of the plane. */
static const double PLACES = 1e-11;
/* The share of the flux that directions, angles and sums lose to rounding. */
static const double ROUNDINGS = 1e-13;

struct fan {
    const struct lx_flux_asked *asked;
    const struct lx_distribution *table;
    struct lx_emitter isotropic; /* in its place, whose light has no edges of its own */
    struct lx_edges edges;
    struct lx_line_part *lit;
    double frame[3][3]; /* of the table */
    double normal[3], side[2][3], from_center[3], height;
    double *sums; /* by azimuth, then by polar angle: the integral from the first one on */
    double *ends; /* of the panels: azimuths */
    size_t end_count, end_capacity;
    struct lx_panel *panels;
    bool stopped;
};

/* ---- along polar angles, in degrees ---- */

/* cos a - cos b. */
static double fall(double a, double b)
{
    return 2 * sin((a + b) / 2 * DEGREE) * sin((b - a) / 2 * DEGREE);
}

/* The integral of a row of the table times the sine, within a cell. */
static double within(const struct lx_distribution *table, const double *row, size_t j, double from, double to)
{
    const double *polars = table->polars, step = row[j + 1] - row[j];
    if (table->interpolation == LUXEL_INTERPOLATE_COSINE) {
        const double whole = fall(polars[j], polars[j + 1]);
        const double shares = fall(polars[j], from) / whole + fall(polars[j], to) / whole;
        return (row[j] + step * shares / 2) * fall(from, to);
    }
    const double slope = step / ((polars[j + 1] - polars[j]) * DEGREE), length = (to - from) * DEGREE;
    const double rise = 2 * cos((from + to) / 2 * DEGREE) * sin(length / 2); /* of the sine */
    return (row[j] + slope * (from - polars[j]) * DEGREE) * fall(from, to) + slope * (rise - length * cos(to * DEGREE));
}

static double along_row(const struct fan *fan, size_t i, double from, double to)
{
    const struct lx_distribution *table = fan->table;
    const double *row = table->values + i * table->polar_count, *sums = fan->sums + i * table->polar_count;
    const size_t first = lx_cell_among(table->polars, table->polar_count, from);
    const size_t last = lx_cell_among(table->polars, table->polar_count, to);
    if (first == last)
        return within(table, row, first, from, to);
    return within(table, row, first, from, table->polars[first + 1]) + sums[last] - sums[first + 1] +
           within(table, row, last, table->polars[last], to);
}

/* The integral of the intensity times the sine at an azimuth of cell i. */
static double along(const struct fan *fan, size_t i, double azimuth, double from, double to)
{
    const struct lx_distribution *table = fan->table;
    from = fmax(from, table->polars[0]);
    to = fmin(to, table->polars[table->polar_count - 1]);
    if (!(from < to))
        return 0;
    if (table->table_double.is_axial)
        return along_row(fan, 0, from, to);
    const double share = (azimuth - table->azimuths[i]) / (table->azimuths[i + 1] - table->azimuths[i]);
    return (1 - share) * along_row(fan, i, from, to) + share * along_row(fan, i + 1, from, to);
}

static bool make_sums(struct fan *fan)
{
    const struct lx_distribution *table = fan->table;
    fan->sums = lx_new_array(table->azimuth_count * table->polar_count, sizeof *fan->sums);
    for (size_t i = 0; fan->sums && i < table->azimuth_count; i++) {
        const double *row = table->values + i * table->polar_count;
        double *sums = fan->sums + i * table->polar_count;
        sums[0] = 0;
        for (size_t j = 0; j + 1 < table->polar_count; j++)
            sums[j + 1] = sums[j] + within(table, row, j, table->polars[j], table->polars[j + 1]);
    }
    return fan->sums;
}

/* ---- the plane's line at an azimuth ---- */

/* Where the half-plane of an azimuth meets the plane: places from + tau along, from the luminaire. */
struct line {
    double outward[3]; /* of the half-plane, at right angles to the pole */
    double from[3], along[3];
    double first, last; /* of tau, on the measured part */
    unsigned ends[2];   /* which sides that is */
};

/* The plane's four sides, and the pole. */
enum { MOST_ENDS = 5 };

/* The rest of the line, where a + b tau >= 0. */
static void keep(struct line *line, double a, double b, unsigned side)
{
    const double at = -a / b;
    if (b > 0 && at > line->first) {
        line->first = at;
        line->ends[0] = side;
    } else if (b < 0 && at < line->last) {
        line->last = at;
        line->ends[1] = side;
    } else if (b == 0 && a < 0)
        line->last = line->first;
}

static bool find_line(const struct fan *fan, double azimuth, struct line *line)
{
    const double c = cos(azimuth * DEGREE), s = sin(azimuth * DEGREE);
    double across[3];
    *line = (struct line){.first = -HUGE_VAL, .last = HUGE_VAL};
    for (int k = 0; k < 3; k++)
        line->outward[k] = c * fan->frame[0][k] + s * fan->frame[1][k];
    lx_cross(fan->frame[2], line->outward, across);
    const double lean = lx_dot(fan->normal, across), rest = 1 - lean * lean;
    if (!(rest > 1e-20))
        return false;
    lx_cross(across, fan->normal, line->along);
    for (int k = 0; k < 3; k++) {
        line->from[k] = -fan->height / rest * (fan->normal[k] - lean * across[k]);
        line->along[k] /= sqrt(rest);
    }
    for (int i = 0; i < 2; i++) {
        const double size = fan->asked->plane->size_mm[i];
        const double at = lx_dot(fan->side[i], line->from) + lx_dot(fan->side[i], fan->from_center);
        const double slope = lx_dot(fan->side[i], line->along);
        keep(line, size / 2 - at, -slope, 2 * (unsigned)i);
        keep(line, size / 2 + at, slope, 2 * (unsigned)i + 1);
    }
    keep(line, lx_dot(line->outward, line->from), lx_dot(line->outward, line->along), 4);
    return line->first < line->last;
}

static void place_on(const struct line *line, double tau, double way[3])
{
    for (int k = 0; k < 3; k++)
        way[k] = line->from[k] + tau * line->along[k];
}

static double polar_at(const struct fan *fan, const struct line *line, double tau)
{
    double way[3];
    place_on(line, tau, way);
    return atan2(fmax(lx_dot(line->outward, way), 0), lx_dot(fan->frame[2], way)) / DEGREE;
}

/* The part of the line that is measured, as the edges count it: from -1/2 to 1/2. */
static struct lx_plane_line on_plane(const struct fan *fan, const struct line *line)
{
    const double length = line->last - line->first;
    struct lx_plane_line found;
    double middle[3];
    place_on(line, line->first + length / 2, middle);
    for (int i = 0; i < 2; i++) {
        const double size = fan->asked->plane->size_mm[i];
        found.middle[i] = (lx_dot(fan->side[i], middle) + lx_dot(fan->side[i], fan->from_center)) / size;
        found.slope[i] = lx_dot(fan->side[i], line->along) * length / size;
    }
    return found;
}

/* A side of the plane, or an edge. */
static uint64_t bound_of(const struct line *line, const struct lx_line_part *part, int end)
{
    return part->bounds[end] == LX_LINE_END ? line->ends[end] : MOST_ENDS + part->bounds[end];
}

/* The integral along an azimuth of cell i; its form is what bounds the parts that are seen. */
static struct lx_point_value at_azimuth(void *data, size_t i, double azimuth)
{
    struct fan *fan = data;
    struct lx_point_value point = {.form = UINT64_C(14695981039346656037)};
    struct line line;
    fan->stopped = fan->stopped || !lx_asking_goes_on(fan->asked->asking);
    if (fan->stopped || !find_line(fan, azimuth, &line))
        return point;
    const struct lx_plane_line measured = on_plane(fan, &line);
    const size_t count = lx_edges_lit(&fan->edges, &measured, fan->lit);
    const double length = line.last - line.first, middle = line.first + length / 2;
    for (size_t k = 0; k < count; k++) {
        const struct lx_line_part *part = &fan->lit[k];
        const double a = polar_at(fan, &line, middle + length * part->from);
        const double b = polar_at(fan, &line, middle + length * part->to);
        point.value += along(fan, i, azimuth, fmin(a, b), fmax(a, b));
        point.form = lx_mixed_form(lx_mixed_form(point.form, bound_of(&line, part, 0)), bound_of(&line, part, 1));
    }
    return point;
}

static uint64_t form_at(void *data, size_t i, double azimuth)
{
    return at_azimuth(data, i, azimuth).form;
}

/* ---- the whole ---- */

static double target(void *data, const struct lx_integral *integral)
{
    const struct fan *fan = data;
    const double unit = DEGREE * fabs(fan->asked->emitter->strength);
    return fan->stopped ? HUGE_VAL : fan->asked->tolerance * fmax(integral->value, fan->asked->usual / unit);
}

/* ---- where panels end ---- */

/* Appends an azimuth where it is within the table's. */
static void note_end(struct fan *fan, double azimuth)
{
    const struct lx_distribution *table = fan->table;
    if (!(azimuth >= table->azimuths[0] && azimuth <= table->azimuths[table->azimuth_count - 1]))
        return;
    if (lx_reserve(&fan->ends, &fan->end_capacity, fan->end_count + 1, sizeof *fan->ends))
        fan->stopped = true;
    else
        fan->ends[fan->end_count++] = azimuth;
}

/* The azimuth of a place (u, v) of the plane, whatever turn it is counted in. */
static void note_place(struct fan *fan, double u, double v)
{
    const double at[2] = {u * fan->asked->plane->size_mm[0], v * fan->asked->plane->size_mm[1]};
    double way[3];
    for (int k = 0; k < 3; k++)
        way[k] = at[0] * fan->side[0][k] + at[1] * fan->side[1][k] - fan->from_center[k];
    const double azimuth = atan2(lx_dot(fan->frame[1], way), lx_dot(fan->frame[0], way)) / DEGREE;
    for (int turn = -1; turn <= 1; turn++)
        note_end(fan, azimuth + 360 * turn);
}

/* The places of a side of the plane that are seen under a polar angle: (way . pole)^2 = cos^2 |way|^2. */
static void note_polar(struct fan *fan, int side, double end, double polar)
{
    const double *size = fan->asked->plane->size_mm, cosine = cos(polar * DEGREE), *pole = fan->frame[2];
    const double *along = fan->side[side], *aside = fan->side[1 - side];
    double from[3], roots[2];
    for (int k = 0; k < 3; k++)
        from[k] = end * size[1 - side] * aside[k] - fan->from_center[k];
    const double fall = lx_dot(from, pole), slope = lx_dot(along, pole), square = cosine * cosine;
    const bool is_level = fabs(cosine) < 1e-12; /* a plane, and no cone */
    const int count =
        is_level ? lx_edge_roots(fall, slope, 0, roots)
                 : lx_edge_roots(fall * fall - square * lx_dot(from, from),
                                 2 * (fall * slope - square * lx_dot(from, along)), slope * slope - square, roots);
    for (int i = 0; i < count; i++)
        if (fabs(roots[i]) < size[side] / 2 && (is_level || (fall + roots[i] * slope > 0) == (cosine > 0)))
            note_place(fan, side == 0 ? roots[i] / size[0] : end, side == 0 ? end : roots[i] / size[1]);
}

/* The places at which half-planes of the pole touch an edge: where the polar of the pole's foot meets it. */
static void note_touches(struct fan *fan, const struct lx_conic *edge)
{
    const double *c = edge->c, *pole = fan->frame[2];
    const double weight = lx_dot(pole, fan->normal); /* the foot in homogeneous coordinates, in its plane's sides */
    const double u = (weight * lx_dot(fan->from_center, fan->side[0]) - fan->height * lx_dot(pole, fan->side[0])) /
                     fan->asked->plane->size_mm[0];
    const double v = (weight * lx_dot(fan->from_center, fan->side[1]) - fan->height * lx_dot(pole, fan->side[1])) /
                     fan->asked->plane->size_mm[1];
    const double a = 2 * c[3] * u + c[4] * v + c[1] * weight, b = c[4] * u + 2 * c[5] * v + c[2] * weight;
    const double rest = c[1] * u + c[2] * v + 2 * c[0] * weight, square = a * a + b * b;
    double roots[2];
    if (!(square > 0))
        return;
    const struct lx_plane_line line = {.middle = {-a * rest / square, -b * rest / square}, .slope = {-b, a}};
    const double du = line.slope[0], dv = line.slope[1], *at = line.middle;
    const int count =
        lx_edge_roots(lx_conic_at(edge, at[0], at[1]),
                      du * (c[1] + 2 * c[3] * at[0] + c[4] * at[1]) + dv * (c[2] + 2 * c[5] * at[1] + c[4] * at[0]),
                      du * (c[3] * du + c[4] * dv) + c[5] * dv * dv, roots);
    for (int i = 0; i < count; i++) {
        const double place[2] = {at[0] + roots[i] * du, at[1] + roots[i] * dv};
        if (fabs(place[0]) < 0.5 && fabs(place[1]) < 0.5)
            note_place(fan, place[0], place[1]);
    }
}

/*
 * Panels end where the table has a plane, at the corners of what is measured, where its sides leave an angle of the
 * table and where shadows turn or begin: else what falls on it within a few azimuths alone, seen all but edge-on, would
 * lie between the points of a rule.  None is wide.  False: memory ran out.
 */
static bool find_ends(struct fan *fan)
{
    const struct lx_distribution *table = fan->table;
    struct lx_plane_places turns = {.items = NULL};
    for (size_t i = 0; i + 1 < table->azimuth_count; i++) {
        const double from = table->azimuths[i], length = table->azimuths[i + 1] - from;
        const size_t parts = (size_t)ceil(length * FEWEST / 360);
        for (size_t k = 0; k < parts; k++)
            note_end(fan, from + length * (double)k / (double)parts);
    }
    note_end(fan, table->azimuths[table->azimuth_count - 1]);
    for (int i = 0; i < 4; i++) {
        const double end = i & 1 ? 0.5 : -0.5;
        note_place(fan, end, i & 2 ? 0.5 : -0.5);
        for (size_t k = 0; k < table->polar_count; k++)
            note_polar(fan, i / 2, end, table->polars[k]);
    }
    for (size_t i = 0; i < fan->edges.count; i++)
        note_touches(fan, &fan->edges.items[i]);
    const bool is_whole = lx_edges_turns(&fan->edges, &turns) == 0 && !fan->stopped;
    for (size_t i = 0; i < turns.count; i++)
        note_place(fan, turns.items[i].u, turns.items[i].v);
    free(turns.items);
    if (is_whole && !fan->stopped)
        qsort(fan->ends, fan->end_count, sizeof *fan->ends, lx_by_value);
    return is_whole && !fan->stopped;
}

static size_t begin_panels(const struct fan *fan)
{
    const struct lx_distribution *table = fan->table;
    size_t count = 0;
    for (size_t i = 0; i + 1 < fan->end_count; i++) {
        const double from = fan->ends[i], to = fan->ends[i + 1];
        if (to > from)
            fan->panels[count++] = (struct lx_panel){
                .interval = lx_cell_among(table->azimuths, table->azimuth_count, from), .from = from, .to = to};
    }
    return count;
}

static lx_bounded integrate(struct fan *fan)
{
    struct lx_integrand integrand = {.at = at_azimuth, .target = target, .data = fan, .form = form_at};
    const size_t begun = begin_panels(fan);
    struct lx_panels panels = {.items = fan->panels, .count = begun, .capacity = begun + MORE_PANELS};
    const struct lx_integral integral = lx_integrate_panels(&integrand, &panels);
    const double edges = fan->edges.count > 0 ? 8 * (double)fan->edges.count * PLACES : 0;
    const lx_bounded turned = {integral.value,
                               integral.error + integral.inherited + (edges + ROUNDINGS) * integral.value};
    return lx_mul(lx_mul(turned, lx_rounded(DEGREE, 0, 2)), lx_strength(fan->asked->emitter));
}

/* Its height above the plane, negative behind it; false: it may be in it. */
static bool find_height(struct fan *fan)
{
    const struct lx_cells *plane = fan->asked->plane;
    const double *position = fan->asked->emitter->position_mm;
    const lx_bounded height =
        lx_dot3(lx_sub3(lx_exact3(position), lx_exact3(plane->center_mm)), lx_wide3_direction(plane->pose.axis));
    fan->height = height.value;
    for (int k = 0; k < 3; k++)
        fan->from_center[k] = position[k] - plane->center_mm[k];
    return fabs(height.value) > fmax(height.error, 1e-9 * hypot(plane->size_mm[0], plane->size_mm[1]));
}

static bool begin(struct fan *fan)
{
    const struct lx_flux_asked *asked = fan->asked;
    const struct lx_pointed *pointed = asked->emitter->profile.luminaire;
    if (!pointed || !lx_is_point(asked->emitter) || asked->emitter->attenuation != LX_INVERSE_SQUARE ||
        !find_height(fan))
        return false;
    fan->table = pointed->distribution;
    lx_values3(lx_wide3_direction(asked->plane->pose.axis), fan->normal);
    lx_values3(lx_wide3_direction(asked->plane->pose.across), fan->side[0]);
    lx_values3(lx_wide3_direction(asked->plane->pose.upward), fan->side[1]);
    for (int i = 0; i < 3; i++)
        lx_values3(pointed->frame[i], fan->frame[i]);
    fan->isotropic = *asked->emitter;
    fan->isotropic.profile = lx_profile_isotropic();
    return true;
}

/* Makes the edges of shadows, and room; false: some are unknown, or memory ran out. */
static bool make_room(struct fan *fan)
{
    const struct lx_flux_asked *asked = fan->asked;
    if (lx_edges_make(asked->prepared, asked->plane, &fan->isotropic, asked->aside, asked->casts, &fan->edges) ||
        !fan->edges.knows_shadows)
        return false;
    fan->lit = lx_new_array(lx_edges_most(&fan->edges), sizeof *fan->lit);
    fan->panels = find_ends(fan) ? lx_new_array(fan->end_count + MORE_PANELS, sizeof *fan->panels) : NULL;
    return fan->lit && fan->panels && make_sums(fan);
}

bool lx_luminaire_flux(const struct lx_flux_asked *asked, lx_bounded *flux)
{
    struct fan fan = {.asked = asked};
    *flux = lx_exact(0);
    bool is_found = begin(&fan);
    if (is_found && fan.height > 0) {
        is_found = make_room(&fan);
        if (is_found)
            *flux = integrate(&fan);
        is_found = is_found && !fan.stopped;
    }
    lx_edges_clear(&fan.edges);
    free(fan.lit);
    free(fan.ends);
    free(fan.panels);
    free(fan.sums);
    return is_found;
}
