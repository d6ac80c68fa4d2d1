/* SPDX-License-Identifier: MIT */
/* Lines over flat openings, where they are cut, and the sums along and across them. */
#include "opening_light.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "../../base/larger.h"
#include "../../base/vector.h"
#include "../../light/distribution.h"
#include "../../light/solid/elliptic.h"
#include "../../light/solid/extended.h"
#include "../../parameter/table.h"
#include "adaptive.h"

enum { MOST_CUTS = 128, MOST_PANELS = 256, MOST_PIECES = 64 };

/* Pieces of a line are so many of their half lengths from the places off it at which the integrand is singular. */
static const double CLEARANCE = 2.2;
/* Gauss's rules with few places, those from the middle on, from -1 to 1; of odd counts the middle has half its weight.
 * `last`: the weights with which the values tell the coefficient of the highest of Legendre's polynomials that such a
 * rule can tell; at the places before the middle with the sign (-1)^(count - 1). */
struct rule {
    unsigned count;
    double places[4], weights[4], last[4];
};

static const struct rule rules[] = {
    {2, {0.57735026918962576}, {1}, {0.86602540378443860}},
    {3,
     {0, 0.77459666924148338},
     {0.44444444444444444, 0.55555555555555556},
     {-0.55555555555555558, 0.55555555555555569}},
    {4,
     {0.33998104358485626, 0.86113631159405258},
     {0.65214515486254614, 0.34785484513745386},
     {-0.93977247037775302, 0.37102700340194722}},
    {6,
     {0.23861918608319691, 0.66120938646626451, 0.93246951420315203},
     {0.46791393457269105, 0.36076157304813861, 0.17132449237917034},
     {0.86115096417790771, -0.58413663668322746, 0.19383956497639665}},
    {8,
     {0.18343464249564980, 0.52553240991632899, 0.79666647741362674, 0.96028985649753623},
     {0.36268378337836198, 0.31370664587788729, 0.22238103445337447, 0.10122853629037626},
     {-0.78490655792181252, 0.63177455311900432, -0.37789693708459171, 0.11769245644771324}},
};

/* The coarse rule across the lines from this tolerance on. */
static const double COARSE = 1e-6;
/* How much more than is allowed across them the rules along the lines may leave, as a share of it. */
static const double ALONG = 0.05;
static const double DEGREE = 0.017453292519943295;

struct line {
    double start[3], along[3]; /* from the element */
    double d[3], e[3];         /* the way from the opening to the element in the table's frame: d + v e */
};

struct work {
    const struct lx_emitter *emitter;
    const struct lx_pointed *luminaire;
    const struct lx_asking *asking;
    struct lx_kept_cell kept;
    double digits; /* logarithm of what the rules along lines leave of the integrand, with its sign turned */
    double normal[3], normal_error, place_error_mm;
    double origin[3], a[3], b[3]; /* from the element: a corner and two sides; of a disk its centre and two half axes */
    double area;                  /* of the parallelogram of the two */
    bool is_round;
    double tolerance, known;
    size_t places;
};

/* The last coefficient that a rule can tell, times what its rate makes of the further ones, times this is more than
 * what it leaves. */
static const double CAUTION = 8;
/* Kinks across the lines are found to that share of the tolerance. */
static const double NARROWEST = 1e-2;

/* Adds the integrand at a place, and its error as far as directions are off; returns it. */
static double add_value(struct work *work, const struct line *line, double v, double weight, struct lx_point_value *sum)
{
    double towards[3];
    for (int k = 0; k < 3; k++)
        towards[k] = line->start[k] + v * line->along[k];
    const double r = lx_normalize(towards), cosine = fmax(lx_dot(work->normal, towards), 0);
    const double turned = work->normal_error + work->place_error_mm / r + 8 * DBL_EPSILON;
    const double value = lx_pointed_near(work->luminaire, towards, &work->kept);
    const double law = lx_relative_law(work->emitter, r) / (r * r), at = law * cosine * value;
    sum->value += weight * at;
    sum->error += weight * law * turned * (4 * value + lx_pointed_slope(work->luminaire) * cosine);
    return at;
}

/* ---- cuts ---- */

/* Where a line is cut, and by which lines of the table. */
struct cuts {
    size_t count;
    double at[MOST_CUTS + 2];
    uint64_t form;
};

/* Each line of the table has a number, those that may cross twice two. */
static void put(double v, size_t number, struct cuts *cuts)
{
    if (cuts->count == MOST_CUTS || !(v > 0 && v < 1))
        return;
    cuts->at[cuts->count++] = v;
    cuts->form = lx_mixed_form(cuts->form, number);
}

/*
 * Where the way has a polar angle: (d2 + v e2)^2 = cos^2 |d + v e|^2, on the side that its cosine says.  Near a right
 * angle the two roots are almost one, so that their distance is not a difference of great numbers here, and at it
 * they are one.
 */
static void cross_polar(const struct line *line, double angle, size_t number, struct cuts *cuts)
{
    static const double RIGHT = 1e-14;
    const double cosine = cos(angle), share = cosine * cosine;
    if (fabs(cosine) < RIGHT) {
        put(-line->d[2] / line->e[2], number, cuts);
        return;
    }
    double turned[3], cross[3];
    for (int k = 0; k < 3; k++)
        turned[k] = line->e[2] * line->d[k] - line->d[2] * line->e[k];
    lx_cross(line->d, line->e, cross);
    const double a = line->e[2] * line->e[2] - share * lx_dot(line->e, line->e);
    const double b = line->d[2] * line->e[2] - share * lx_dot(line->d, line->e);
    const double c = line->d[2] * line->d[2] - share * lx_dot(line->d, line->d);
    const double under = share * (lx_dot(turned, turned) - share * lx_dot(cross, cross));
    if (!(under >= 0))
        return;
    const double q = -(b + copysign(sqrt(under), b)), roots[2] = {q / a, c / q};
    for (int i = 0; i < 2; i++)
        if (isfinite(roots[i]) && (line->d[2] + roots[i] * line->e[2]) * cosine >= 0)
            put(roots[i], number + (size_t)(b > 0 ? i : 1 - i), cuts);
}

static double polar_at(const struct line *line, double v)
{
    const double x = line->d[0] + v * line->e[0], y = line->d[1] + v * line->e[1];
    return atan2(sqrt(x * x + y * y), line->d[2] + v * line->e[2]);
}

/* The polar angle is extreme between the ends where d2 |..|' = ... holds: its tangent's square has one such place. */
static void cross_polars(const struct work *work, const struct line *line, struct cuts *cuts)
{
    const struct lx_distribution *table = work->luminaire->distribution;
    const double *d = line->d, *e = line->e;
    /* the cosine (d2 + v e2)/|d + v e| is extreme where e2 |d + v e|^2 = (d2 + v e2) (d + v e).e */
    const double extreme = (d[2] * lx_dot(d, e) - e[2] * lx_dot(d, d)) / (e[2] * lx_dot(d, e) - d[2] * lx_dot(e, e));
    const double first = polar_at(line, 0), last = polar_at(line, 1);
    double least = fmin(first, last), greatest = fmax(first, last);
    if (extreme > 0 && extreme < 1) {
        least = fmin(least, polar_at(line, extreme));
        greatest = fmax(greatest, polar_at(line, extreme));
    }
    for (size_t j = 0; j < table->polar_count; j++) {
        const double angle = table->polars[j] * DEGREE;
        if (angle > least && angle < greatest)
            cross_polar(line, angle, 2 * j + 1, cuts);
    }
}

static void cross_azimuths(const struct work *work, const struct line *line, struct cuts *cuts)
{
    const struct lx_distribution *table = work->luminaire->distribution;
    const double *d = line->d, *e = line->e, way = d[0] * e[1] - d[1] * e[0] > 0 ? 1 : -1;
    const double first = atan2(d[1], d[0]), last = atan2(d[1] + e[1], d[0] + e[0]);
    double swept = way * (last - first);
    swept -= 2 * M_PI * floor(swept / (2 * M_PI));
    for (size_t i = 0; i < table->azimuth_count; i++) {
        const double angle = table->azimuths[i] * DEGREE;
        double ahead = way * (angle - first);
        ahead -= 2 * M_PI * floor(ahead / (2 * M_PI));
        if (!(ahead < swept))
            continue;
        const double sine = sin(angle), cosine = cos(angle);
        put((d[1] * cosine - d[0] * sine) / (e[0] * sine - e[1] * cosine), 2 * (table->polar_count + i) + 1, cuts);
    }
}

/* Where pieces of the line end. */
static void cut_line(const struct work *work, const struct line *line, struct cuts *cuts)
{
    const double level = lx_dot(work->normal, line->start), rise = lx_dot(work->normal, line->along);
    *cuts = (struct cuts){.form = rise > 0};
    put(-level / rise, 0, cuts);
    cross_polars(work, line, cuts);
    if (!work->luminaire->distribution->table_double.is_axial)
        cross_azimuths(work, line, cuts);
}

/* ---- sums ---- */

struct pole {
    double along, off;
};

/* Where the integrand is singular beside the line: where a distance of 0 would be, and on the luminaire's axis. */
static void find_poles(const struct line *line, struct pole poles[2])
{
    const double square = lx_dot(line->along, line->along), *d = line->d, *e = line->e;
    const double flat = e[0] * e[0] + e[1] * e[1];
    double cross[3];
    lx_cross(line->start, line->along, cross);
    poles[0] = (struct pole){-lx_dot(line->start, line->along) / square, sqrt(lx_dot(cross, cross)) / square};
    poles[1] = (struct pole){0, HUGE_VAL};
    if (flat > 1e-24 * square)
        poles[1] = (struct pole){-(d[0] * e[0] + d[1] * e[1]) / flat, fabs(d[0] * e[1] - d[1] * e[0]) / flat};
}

/* Adds a piece, by as many places as it needs, or its halves. */
static void add_piece(struct work *work, const struct line *line, const struct pole poles[2], double from, double to,
                      struct lx_point_value *sum)
{
    enum { DEEPEST = 40 };
    struct {
        double from, to;
    } left[MOST_PIECES] = {{from, to}};
    for (size_t count = 1; count > 0;) {
        const double low = left[count - 1].from, high = left[count - 1].to, half = (high - low) / 2;
        const double middle = low + half;
        double nearest = HUGE_VAL;
        for (int i = 0; i < 2; i++)
            nearest = fmin(nearest, hypot(middle - poles[i].along, poles[i].off));
        const double ratio = nearest / half;
        if (ratio < CLEARANCE && count < DEEPEST && half > 1e-12) {
            left[count - 1].to = middle;
            left[count].from = middle;
            left[count++].to = high;
            continue;
        }
        const double clear = fmax(ratio, CLEARANCE), rate = log(clear + sqrt(clear * clear - 1));
        const struct rule *rule = rules;
        while (rule < &rules[LX_COUNT(rules) - 1] &&
               2 * rate * rule->count < work->digits + log(1.6 * (rule->count + 1)))
            rule++;
        const double sign = rule->count % 2 ? 1 : -1;
        double last = 0;
        for (unsigned i = 0; i < (rule->count + 1) / 2; i++) {
            const double offset = half * rule->places[i], weight = half * rule->weights[i];
            last += rule->last[i] * (sign * add_value(work, line, middle - offset, weight, sum) +
                                     add_value(work, line, middle + offset, weight, sum));
        }
        sum->error += CAUTION * fabs(last) * half * exp(-rate * (rule->count + 1));
        work->places += rule->count;
        count--;
    }
}

/* The line at x, which goes from 0 to 1 over the opening. */
static struct line line_at(const struct work *work, double x)
{
    const double sine = sin(M_PI * x), cosine = cos(M_PI * x);
    struct line line;
    for (int k = 0; k < 3; k++) {
        line.start[k] = work->origin[k] + (work->is_round ? -cosine * work->a[k] - sine * work->b[k] : x * work->a[k]);
        line.along[k] = work->is_round ? 2 * sine * work->b[k] : work->b[k];
    }
    for (int k = 0; k < 3; k++) {
        line.d[k] = -lx_dot(work->luminaire->frame_double[k], line.start);
        line.e[k] = -lx_dot(work->luminaire->frame_double[k], line.along);
    }
    return line;
}

static uint64_t form_at(void *data, size_t interval, double x)
{
    const struct line line = line_at(data, x);
    struct cuts cuts;
    (void)interval;
    cut_line(data, &line, &cuts);
    return cuts.form;
}

/* The integral over a line. */
static struct lx_point_value at_line(void *data, size_t interval, double x)
{
    struct work *work = data;
    const struct line line = line_at(work, x);
    const double sine = sin(M_PI * x), measure = work->is_round ? 2 * M_PI * sine * sine * work->area : work->area;
    struct lx_point_value sum = {.value = 0};
    struct pole poles[2];
    struct cuts cuts;
    (void)interval;
    cut_line(work, &line, &cuts);
    sum.form = cuts.form;
    cuts.at[cuts.count++] = 0;
    cuts.at[cuts.count++] = 1;
    qsort(cuts.at, cuts.count, sizeof *cuts.at, lx_by_value);
    find_poles(&line, poles);
    for (size_t i = 0; i + 1 < cuts.count && measure > 0; i++)
        if (cuts.at[i + 1] > cuts.at[i] + 1e-13)
            add_piece(work, &line, poles, cuts.at[i], cuts.at[i + 1], &sum);
    sum.value *= measure, sum.error *= measure;
    return sum;
}

static double target(void *data, const struct lx_integral *integral)
{
    const struct work *work = data;
    return lx_asking_goes_on(work->asking) ? work->tolerance * fmax(work->known, integral->value) : HUGE_VAL;
}

/* ---- the whole ---- */

bool lx_opening_is_flat(const struct lx_emitter *emitter)
{
    const struct lx_facets *facets = emitter->facets;
    return lx_is_disk(emitter) || (facets && facets->face_count == 1 && facets->faces[0].count == 4);
}

static void corner_of(const struct lx_facets *facets, unsigned i, double corner[3])
{
    const lx_wide3 *wide = &facets->corners_mm[facets->loop[facets->faces[0].first + i]];
    corner[0] = wide->x.high, corner[1] = wide->y.high, corner[2] = wide->z.high;
}

/* Sets the two directions of the opening, and whether the place is before it. */
static bool set_shape(struct work *work, const double place_mm[3])
{
    const struct lx_emitter *emitter = work->emitter;
    double first[3], second[3], last[3],
        axis[3] = {emitter->axis.x.value, emitter->axis.y.value, emitter->axis.z.value};
    work->is_round = lx_is_disk(emitter);
    if (work->is_round) {
        lx_half_axes(emitter, work->a, work->b);
        for (int k = 0; k < 3; k++)
            work->origin[k] = emitter->center_mm[k] - place_mm[k];
        work->area = sqrt(lx_dot(work->a, work->a) * lx_dot(work->b, work->b));
    } else {
        corner_of(emitter->facets, 0, first);
        corner_of(emitter->facets, 1, second);
        corner_of(emitter->facets, 3, last);
        for (int k = 0; k < 3; k++) {
            work->origin[k] = first[k] - place_mm[k];
            work->a[k] = second[k] - first[k];
            work->b[k] = last[k] - first[k];
        }
        lx_cross(work->a, work->b, axis);
        work->area = lx_normalize(axis);
    }
    const double height = -lx_dot(axis, work->origin);
    return height > 0 || (height == 0 && !emitter->is_back);
}

/* How far a place in the plane of the opening is from it. */
static double distance_in_plane(const struct work *work)
{
    double nearest[3];
    if (work->is_round) {
        const double radius = fmax(sqrt(lx_dot(work->a, work->a)), sqrt(lx_dot(work->b, work->b)));
        return sqrt(lx_dot(work->origin, work->origin)) - radius;
    }
    for (int k = 0; k < 3; k++)
        nearest[k] = work->origin[k];
    const double *const sides[2] = {work->a, work->b};
    for (int i = 0; i < 2; i++) {
        const double square = lx_dot(sides[i], sides[i]);
        const double share = fmin(fmax(-lx_dot(sides[i], work->origin) / square, 0), 1);
        for (int k = 0; k < 3; k++)
            nearest[k] += share * sides[i][k];
    }
    return sqrt(lx_dot(nearest, nearest));
}

bool lx_opening_is_level(const struct lx_emitter *emitter, const struct lx_element *element, lx_bounded *light)
{
    static const double LEVEL = 1e-12;
    struct work work = {.emitter = emitter};
    double place[3], nearest;
    lx_values3(element->place_mm, place);
    lx_values3(element->normal, work.normal);
    set_shape(&work, place);
    const double distance = distance_in_plane(&work), radius = lx_emitter_radius(emitter);
    const double away = sqrt(lx_dot(work.origin, work.origin)) + 2 * radius;
    const double level = LEVEL * away + lx_error3(element->place_mm) + lx_error3(element->normal) * away;
    if (!(distance > 0 && lx_emitter_extent(emitter, place, work.normal, &nearest) <= level))
        return false;
    /* no more than the greatest intensity, 1, from all of the plane beyond: the integral of level/r^3 dA */
    *light = (lx_bounded){0, 2 * M_PI * 2 * level / distance * fmax(lx_relative_law(emitter, away), 1)};
    return true;
}

bool lx_opening_is_away(const struct lx_emitter *emitter, const double place_mm[3])
{
    static const double AWAY = 0.25, FLAT = 1e-9;
    const double *center = lx_emitter_center(emitter);
    const double way[3] = {place_mm[0] - center[0], place_mm[1] - center[1], place_mm[2] - center[2]};
    const double distance = sqrt(lx_dot(way, way));
    double on_plane[3], axis[3];
    return distance > (1 + AWAY) * lx_emitter_radius(emitter) && lx_emitter_plane(emitter, on_plane, axis) &&
           fabs(lx_dot(axis, way)) > FLAT * distance;
}

lx_bounded lx_opening_light(const struct lx_emitter *emitter, const struct lx_element *element, double tolerance,
                            double known, const struct lx_asking *asking, size_t *parts)
{
    struct work work = {.emitter = emitter,
                        .luminaire = emitter->profile.luminaire,
                        .asking = asking,
                        .digits = -log(ALONG * tolerance),
                        .normal_error = lx_error3(element->normal),
                        .place_error_mm = lx_error3(element->place_mm),
                        .tolerance = tolerance,
                        .known = known};
    struct lx_panel items[MOST_PANELS] = {{.from = 0, .to = 1}};
    struct lx_panels panels = {items, 1, MOST_PANELS};
    const struct lx_integrand integrand = {.at = at_line,
                                           .target = target,
                                           .data = &work,
                                           .form = form_at,
                                           .narrowest = NARROWEST * tolerance,
                                           .is_coarse = tolerance >= COARSE};
    double place[3];
    lx_values3(element->place_mm, place);
    lx_values3(element->normal, work.normal);
    if (!set_shape(&work, place))
        return lx_exact(0);
    const struct lx_integral found = lx_integrate_panels(&integrand, &panels);
    *parts += work.places;
    return (lx_bounded){found.value, found.error + found.inherited + ALONG * tolerance * found.value};
}
