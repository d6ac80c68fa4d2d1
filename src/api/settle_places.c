/* SPDX-License-Identifier: MIT */
/*
 * Putting places back that rounding took off a surface: luxel_evaluator_settle_places().  What lies a little inside of
 * a body is in its shadow, although nobody meant it; a place that is known to few digits is within these of the surface
 * it was computed for.
 */
#include <luxel/evaluator.h>

#include <math.h>
#include <string.h>

#include "../base/rows.h"
#include "../base/vector.h"
#include "../world/among.h"
#include "../world/evaluate.h"

struct settling {
    const struct lx_prepared *prepared;
    luxel_place *places;
    const double *tolerances_mm;
    double *moved_mm;
    struct lx_control *control;
};

/* The nearest surface along the normal of a place, and where it is met. */
struct nearest {
    const struct lx_prepared_surface *surface; /* NULL: there is none as near as the tolerance */
    lx_bounded3 place_mm;
    double away_mm; /* of the place */
};

/* Looks along a place's normal from a little above it, from where what is oblique to it is met, too. */
static struct nearest find_nearest(const struct lx_prepared *prepared, const luxel_place *place, double tolerance_mm)
{
    const double above_mm = 4 * tolerance_mm, length = sqrt(lx_dot(place->normal, place->normal));
    struct nearest nearest = {.away_mm = tolerance_mm};
    struct lx_ray ray = {.origin_mm = {0}};
    struct lx_found found;
    for (int k = 0; k < 3; k++) {
        ray.direction[k] = -place->normal[k] / length;
        ray.origin_mm[k] = place->position_mm[k] - above_mm * ray.direction[k];
    }
    const bool is_found = lx_among_ray(prepared, &ray, &found);
    const size_t count = lx_found_count(&found, is_found, prepared->surface_count);
    for (size_t i = 0; i < count; i++) {
        const struct lx_prepared_surface *surface = &prepared->surfaces[lx_found_at(&found, is_found, i)];
        const struct lx_hit hit = surface->kind->hit(&surface->shape, &ray);
        const double normal[3] = {hit.normal.x.value, hit.normal.y.value, hit.normal.z.value};
        const double away_mm = hit.exists ? fabs((hit.t - above_mm) * lx_dot(normal, ray.direction)) : HUGE_VAL;
        if (away_mm <= nearest.away_mm)
            nearest = (struct nearest){surface, hit.place_mm, away_mm};
    }
    return nearest;
}

/* Puts a place on the surface that it is as near to as its tolerance, unless it lies there as far as numbers tell;
 * returns by how much it was moved. */
static double settle(const struct lx_prepared *prepared, luxel_place *place, double tolerance_mm)
{
    if (!place->is_element || !(tolerance_mm > 0) || !lx_is_place(place))
        return 0;
    const struct nearest nearest = find_nearest(prepared, place, tolerance_mm);
    const lx_bounded3 *on = &nearest.place_mm;
    if (!nearest.surface || nearest.away_mm <= 2 * lx_error3(*on))
        return 0;
    const double settled[3] = {on->x.value, on->y.value, on->z.value};
    const double moved_mm = lx_distance(settled, place->position_mm);
    memcpy(place->position_mm, settled, sizeof settled);
    return moved_mm;
}

/* For the threads a place is a row. */
static void settle_some(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    enum { BETWEEN_CHECKS = 64 };
    const struct settling *work = data;
    (void)worker;
    for (unsigned i = first; i < last; i++) {
        const double moved_mm = settle(work->prepared, &work->places[i], work->tolerances_mm[i]);
        if (work->moved_mm)
            work->moved_mm[i] = moved_mm;
        if (i % BETWEEN_CHECKS == 0 && !lx_control_goes_on(work->control, is_caller))
            return;
    }
}

luxel_status luxel_evaluator_settle_places(const luxel_evaluator *evaluator, luxel_place *places, size_t count,
                                           const double *tolerances_mm, double *moved_mm)
{
    enum { AT_ONCE = 256, MOST_AT_A_TIME = 1 << 30 };
    if (!evaluator || (count > 0 && (!places || !tolerances_mm)))
        return LUXEL_ERROR_ARGUMENT;
    const luxel_settings *settings = &evaluator->settings;
    for (size_t done = 0; done < count; done += MOST_AT_A_TIME) {
        const unsigned now = (unsigned)(count - done < MOST_AT_A_TIME ? count - done : MOST_AT_A_TIME);
        struct lx_control control = {.rows = now, .progress = settings->progress, .data = settings->progress_data};
        struct settling work = {.prepared = &evaluator->prepared,
                                .places = places + done,
                                .tolerances_mm = tolerances_mm + done,
                                .moved_mm = moved_mm ? moved_mm + done : NULL,
                                .control = &control};
        const struct lx_rows_part part = {.last = now, .tile_rows = AT_ONCE, .work = settle_some, .data = &work};
        if (!lx_rows_run_part(&control, lx_thread_count(settings->threads, now / AT_ONCE + 1), &part))
            return LUXEL_CANCELLED;
    }
    return LUXEL_OK;
}
