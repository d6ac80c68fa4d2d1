/* SPDX-License-Identifier: MIT */
/*
 * The light of what an outline leaves of a source of facets, in closed form: in each slab the parts that are seen are
 * trapezoids, and over each of them Lambert's sum over its edges is taken.
 */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/vector.h"
#include "outline.h"

/* The sum of vectors whose part along N is the integral, and how far that may be off. */
struct sum {
    double vector[3], error;
    double error_mm;
};

/* A direction on a line at u, and how far it may be off. */
static double place_on(const struct lx_outline_line *line, double u, double error_mm, double place[3])
{
    const double *a = line->from, *b = line->to, p = a[0] * u - a[1], q = b[0] * u - b[1];
    const double share = p / (p - q);
    double square = 0;
    for (int k = 0; k < 3; k++) {
        place[k] = fabs(share) < 0.5 ? a[k] + share * (b[k] - a[k]) : b[k] + (1 - share) * (a[k] - b[k]);
        square += (b[k] - a[k]) * (b[k] - a[k]);
    }
    if (line->kind == LX_OUTLINE_HORIZON)
        return 8 * DBL_EPSILON;
    (void)square;
    return 8 * DBL_EPSILON + error_mm / sqrt(lx_dot(place, place));
}

/* The edge from a direction to another; both may be off by an angle, which moves what the edge brings by that much of
 * its length. */
static void add_edge(struct sum *sum, const double a[3], const double b[3], double off, double sign)
{
    double across[3];
    lx_cross(a, b, across);
    const double sine = lx_normalize(across), angle = atan2(sine, lx_dot(a, b));
    if (!(sine > 0))
        return;
    for (int k = 0; k < 3; k++)
        sum->vector[k] += sign * 0.5 * angle * across[k];
    sum->error += angle * (off + 4 * DBL_EPSILON);
}

/* What is seen between two lines from u to u. */
static void add_trapezoid(struct sum *sum, const struct lx_outline_line *lower, const struct lx_outline_line *upper,
                          double low, double high)
{
    double corners[4][3], off[4];
    off[0] = place_on(lower, low, sum->error_mm, corners[0]);
    off[1] = place_on(lower, high, sum->error_mm, corners[1]);
    off[2] = place_on(upper, high, sum->error_mm, corners[2]);
    off[3] = place_on(upper, low, sum->error_mm, corners[3]);
    for (int i = 0; i < 4; i++)
        add_edge(sum, corners[i], corners[(i + 1) % 4], i % 2 == 0 ? fmax(off[i], off[i + 1]) : 0, 1);
}

static void add_lay(struct sum *sum, const struct lx_trapezoid_map *map)
{
    for (size_t i = 0; i < map->slab_count; i++) {
        const struct lx_outline_slab *slab = &map->slabs[i];
        uint32_t from = slab->floor;
        if (slab->floor == slab->ceiling)
            continue; /* nothing is looked at */
        for (uint32_t k = 0; k <= slab->count; k++) {
            const uint32_t to = k < slab->count ? map->parts[slab->first + k].lower : slab->ceiling;
            if (from != to)
                add_trapezoid(sum, &map->lines[from], &map->lines[to], slab->low, slab->high);
            from = k < slab->count ? map->parts[slab->first + k].upper : from;
        }
    }
}

bool lx_outline_is_alone(const struct lx_occlusion *occlusion)
{
    for (size_t i = 0; i < occlusion->obstacles.count; i++)
        if (occlusion->obstacles.items[i].type != LX_OBSTACLE_SPACE)
            return false;
    return occlusion->has_outline && occlusion->obstacles.count <= 1;
}

bool lx_outline_add_horizon(struct lx_occlusion *occlusion, const double normal[3])
{
    for (unsigned i = 0; i < occlusion->horizon_count; i++) {
        const double *n = occlusion->horizons[i];
        if (fabs(n[0] - normal[0]) + fabs(n[1] - normal[1]) + fabs(n[2] - normal[2]) <= 1e-14)
            return true;
    }
    if (occlusion->horizon_count == LX_MOST_HORIZONS)
        return false;
    memcpy(occlusion->horizons[occlusion->horizon_count++], normal, sizeof occlusion->horizons[0]);
    return true;
}

bool lx_outline_sum(const struct lx_occlusion *known, const struct lx_emitter *emitter, const double normal[3],
                    double normal_error, const struct lx_asking *asking, double *result, double *error)
{
    struct lx_sweeps sweeps = {0};
    struct lx_occlusion with_horizon = *known, *const occlusion = &with_horizon;
    *result = *error = 0;
    if (!emitter->facets || emitter->attenuation != LX_INVERSE_SQUARE || !lx_outline_is_alone(occlusion) ||
        !lx_outline_add_horizon(occlusion, normal))
        return false;
    const bool failed = lx_sweeps_make(emitter, occlusion->place_mm, normal, true, &sweeps) ||
                        lx_trapezoid_map(occlusion, &sweeps, asking) || occlusion->outline->is_broken;
    for (size_t i = 0; i < sweeps.count && !failed; i++) {
        struct sum sum = {.error_mm = 4 * occlusion->error_mm};
        double n[3];
        const struct lx_sweep_frame *frame = &sweeps.items[i].frame;
        add_lay(&sum, &occlusion->outline->lays[i]);
        n[0] = lx_dot(normal, frame->x), n[1] = lx_dot(normal, frame->y), n[2] = lx_dot(normal, frame->z);
        *result += lx_dot(n, sum.vector);
        *error += sum.error + normal_error * sqrt(lx_dot(sum.vector, sum.vector));
    }
    *error += failed ? 0 : lx_outline_unsure(occlusion->outline) + lx_outline_skipped(occlusion->outline);
    *result = fmax(*result, 0);
    if (!failed && *result + *error <= lx_outline_nothing(occlusion->outline)) {
        *error += *result;
        *result = 0;
    }
    free(sweeps.items);
    return !failed && lx_asking_goes_on(asking);
}
