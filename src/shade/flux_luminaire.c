/* SPDX-License-Identifier: MIT */
/* The integral over azimuths, with closed integrals along each. */
#include "flux_luminaire.h"

#include <math.h>
#include <stdlib.h>

#include "../base/memory.h"
#include "../base/vector.h"
#include "../light/distribution.h"
#include "adaptive.h"
#include "flux_edges.h"

/* Panels besides those that the table makes; the fewest of a whole turn. */
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

static size_t cell_of(const double *lines, size_t count, double at)
{
    size_t low = 0, high = count - 1;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        *(lines[middle] <= at ? &low : &high) = middle;
    }
    return low;
}

static double along_row(const struct fan *fan, size_t i, double from, double to)
{
    const struct lx_distribution *table = fan->table;
    const double *row = table->values + i * table->polar_count, *sums = fan->sums + i * table->polar_count;
    const size_t first = cell_of(table->polars, table->polar_count, from);
    const size_t last = cell_of(table->polars, table->polar_count, to);
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

static uint64_t mixed(uint64_t form, uint64_t with)
{
    return (form ^ with) * UINT64_C(1099511628211);
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
        point.form = mixed(mixed(point.form, bound_of(&line, part, 0)), bound_of(&line, part, 1));
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

/* A panel for each cell of the table, and no wide ones. */
static size_t begin_panels(const struct fan *fan)
{
    const struct lx_distribution *table = fan->table;
    size_t count = 0;
    for (size_t i = 0; i + 1 < table->azimuth_count; i++) {
        const double from = table->azimuths[i], length = table->azimuths[i + 1] - from;
        const size_t parts = (size_t)ceil(length * FEWEST / 360);
        for (size_t k = 0; k < parts; k++)
            fan->panels[count++] = (struct lx_panel){.interval = i,
                                                     .from = from + length * (double)k / (double)parts,
                                                     .to = from + length * (double)(k + 1) / (double)parts};
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
    return lx_mul(lx_mul(turned, lx_rounded(DEGREE, 0, 2)), lx_exact(fan->asked->emitter->strength));
}

static void value_of(lx_bounded3 a, double value[3])
{
    value[0] = a.x.value, value[1] = a.y.value, value[2] = a.z.value;
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
    if (!pointed || asked->emitter->type != LX_POINT || asked->emitter->attenuation != LX_INVERSE_SQUARE ||
        !find_height(fan))
        return false;
    fan->table = pointed->distribution;
    value_of(lx_wide3_direction(asked->plane->pose.axis), fan->normal);
    value_of(lx_wide3_direction(asked->plane->pose.across), fan->side[0]);
    value_of(lx_wide3_direction(asked->plane->pose.upward), fan->side[1]);
    for (int i = 0; i < 3; i++)
        value_of(pointed->frame[i], fan->frame[i]);
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
    fan->panels = lx_new_array(fan->table->azimuth_count + FEWEST + MORE_PANELS, sizeof *fan->panels);
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
    free(fan.panels);
    free(fan.sums);
    return is_found;
}
