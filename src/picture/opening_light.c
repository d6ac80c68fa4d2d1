/* SPDX-License-Identifier: MIT */
/* Lines over flat openings, where they are cut, and the sums along and across them. */
#include "opening_light.h"

#include <math.h>
#include <stdlib.h>

#include "../base/larger.h"
#include "../base/vector.h"
#include "../light/distribution.h"
#include "../light/solid/elliptic.h"
#include "../light/solid/extended.h"
#include "../world/integral/adaptive.h"
#include "area_light.h"

enum { MOST_CUTS = 128, MOST_PANELS = 256, MOST_PIECES = 64 };

/* Pieces of a line are so many of their half lengths from the places off it at which the integrand is singular. */
static const double CLEARANCE = 2.2;
/* Logarithm of what rules leave of the integrand, with its sign turned. */
static const double DIGITS = 21;

static const double DEGREE = 0.017453292519943295;

struct line {
    double start[3], along[3]; /* from the element */
    double d[3], e[3];         /* the way from the opening to the element in the table's frame: d + v e */
};

struct work {
    const struct lx_emitter *emitter;
    const struct lx_pointed *luminaire;
    const struct lx_gauss_rules *rules;
    const struct lx_asking *asking;
    struct lx_area_light_law law;
    double normal[3];
    double origin[3], a[3], b[3]; /* from the element: a corner and two sides; of a disk its centre and two half axes */
    double area;                  /* of the parallelogram of the two */
    bool is_round;
    double allowed;
};

static double value_at(const struct work *work, const struct line *line, double v)
{
    double towards[3];
    for (int k = 0; k < 3; k++)
        towards[k] = line->start[k] + v * line->along[k];
    const double r = lx_normalize(towards), cosine = lx_dot(work->normal, towards);
    if (!(cosine > 0))
        return 0;
    return cosine * lx_pointed_plain(work->luminaire, towards) /
           (work->law.none + r * (work->law.root + r * work->law.square));
}

/* ---- cuts ---- */

static size_t put(double v, size_t count, double *cuts)
{
    if (count == MOST_CUTS || !(v > 0 && v < 1))
        return count;
    cuts[count] = v;
    return count + 1;
}

/*
 * Where the way has a polar angle: (d2 + v e2)^2 = cos^2 |d + v e|^2, on the side that its cosine says.  Near a right
 * angle the two roots are almost one, so that their distance is not a difference of great numbers here, and at it
 * they are one.
 */
static size_t cross_polar(const struct line *line, double angle, size_t count, double *cuts)
{
    static const double RIGHT = 1e-14;
    const double cosine = cos(angle), share = cosine * cosine;
    if (fabs(cosine) < RIGHT)
        return put(-line->d[2] / line->e[2], count, cuts);
    double turned[3], cross[3];
    for (int k = 0; k < 3; k++)
        turned[k] = line->e[2] * line->d[k] - line->d[2] * line->e[k];
    lx_cross(line->d, line->e, cross);
    const double a = line->e[2] * line->e[2] - share * lx_dot(line->e, line->e);
    const double b = line->d[2] * line->e[2] - share * lx_dot(line->d, line->e);
    const double c = line->d[2] * line->d[2] - share * lx_dot(line->d, line->d);
    const double under = share * (lx_dot(turned, turned) - share * lx_dot(cross, cross));
    if (!(under >= 0))
        return count;
    const double q = -(b + copysign(sqrt(under), b)), roots[2] = {q / a, c / q};
    for (int i = 0; i < 2; i++)
        if (isfinite(roots[i]) && (line->d[2] + roots[i] * line->e[2]) * cosine >= 0)
            count = put(roots[i], count, cuts);
    return count;
}

static double polar_at(const struct line *line, double v)
{
    const double x = line->d[0] + v * line->e[0], y = line->d[1] + v * line->e[1];
    return atan2(sqrt(x * x + y * y), line->d[2] + v * line->e[2]);
}

/* The polar angle is extreme between the ends where d2 |..|' = ... holds: its tangent's square has one such place. */
static size_t cross_polars(const struct work *work, const struct line *line, size_t count, double *cuts)
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
            count = cross_polar(line, angle, count, cuts);
    }
    return count;
}

static size_t cross_azimuths(const struct work *work, const struct line *line, size_t count, double *cuts)
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
        count = put((d[1] * cosine - d[0] * sine) / (e[0] * sine - e[1] * cosine), count, cuts);
    }
    return count;
}

/* Where pieces of the line end. */
static size_t cut_line(const struct work *work, const struct line *line, double cuts[MOST_CUTS + 2])
{
    const double level = lx_dot(work->normal, line->start), rise = lx_dot(work->normal, line->along);
    size_t count = put(-level / rise, 0, cuts);
    count = cross_polars(work, line, count, cuts);
    if (!work->luminaire->distribution->table_double.is_axial)
        count = cross_azimuths(work, line, count, cuts);
    cuts[count++] = 0;
    cuts[count++] = 1;
    qsort(cuts, count, sizeof *cuts, lx_by_value);
    return count;
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

/* The sum of a piece, by as many places as it needs, or of its halves. */
static double sum_piece(const struct work *work, const struct line *line, const struct pole poles[2], double from,
                        double to)
{
    enum { DEEPEST = 40 };
    struct {
        double from, to;
    } left[MOST_PIECES] = {{from, to}};
    double sum = 0;
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
        const unsigned places = (unsigned)fmin(fmax(ceil(DIGITS / (2 * rate)), 1), 8);
        const struct lx_gauss_rule *rule = &work->rules->rules[places - 1];
        double part = 0;
        for (unsigned i = 0; i < places; i++)
            part += rule->weights_double[i] * value_at(work, line, middle + half * rule->places_double[i]);
        sum += part * half;
        count--;
    }
    return sum;
}

/* The integral over the line at x, which goes from 0 to 1 over the opening. */
static struct lx_point_value at_line(void *data, size_t interval, double x)
{
    const struct work *work = data;
    struct line line;
    struct pole poles[2];
    double cuts[MOST_CUTS + 2], sum = 0, measure = work->area;
    const double sine = sin(M_PI * x), cosine = cos(M_PI * x);
    (void)interval;
    if (work->is_round)
        measure *= 2 * M_PI * sine * sine;
    for (int k = 0; k < 3; k++) {
        line.start[k] = work->origin[k] + (work->is_round ? -cosine * work->a[k] - sine * work->b[k] : x * work->a[k]);
        line.along[k] = work->is_round ? 2 * sine * work->b[k] : work->b[k];
    }
    if (!(measure > 0))
        return (struct lx_point_value){.value = 0};
    for (int k = 0; k < 3; k++) {
        line.d[k] = -lx_dot(work->luminaire->frame_double[k], line.start);
        line.e[k] = -lx_dot(work->luminaire->frame_double[k], line.along);
    }
    find_poles(&line, poles);
    const size_t count = cut_line(work, &line, cuts);
    for (size_t i = 0; i + 1 < count; i++)
        if (cuts[i + 1] > cuts[i] + 1e-13)
            sum += sum_piece(work, &line, poles, cuts[i], cuts[i + 1]);
    return (struct lx_point_value){.value = sum * measure};
}

static double target(void *data, const struct lx_integral *integral)
{
    const struct work *work = data;
    return lx_asking_goes_on(work->asking) ? fmax(work->allowed, 1e-9 * integral->value) : HUGE_VAL;
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

double lx_opening_light(const struct lx_emitter *emitter, const struct lx_gauss_rules *rules, const double place_mm[3],
                        const double normal[3], double allowed, const struct lx_asking *asking)
{
    struct work work = {.emitter = emitter,
                        .luminaire = emitter->profile.luminaire,
                        .rules = rules,
                        .asking = asking,
                        .law = lx_law_of(emitter),
                        .normal = {normal[0], normal[1], normal[2]},
                        .allowed = allowed};
    struct lx_panel items[MOST_PANELS] = {{.from = 0, .to = 1}};
    struct lx_panels panels = {items, 1, MOST_PANELS};
    const struct lx_integrand integrand = {.at = at_line, .target = target, .data = &work, .is_coarse = false};
    if (!set_shape(&work, place_mm))
        return 0;
    return lx_integrate_panels(&integrand, &panels).value;
}
