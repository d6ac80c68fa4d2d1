/* SPDX-License-Identifier: MIT */
/* Limits: the interval in which a number lies, and on which side of the limit that is. */
#include <luxel/limits.h>

#include <float.h>
#include <math.h>

#include "../base/phrase.h"
#include "../scene/scene.h"

/* Room for the roundings of an interval. */
static const double ROUNDINGS = 8 * DBL_EPSILON;

/* Where a number lies for certain. */
struct interval {
    double low, high;
};

const char *luxel_verdict_word(luxel_verdict verdict)
{
    static const char *const words[] = {
        [LUXEL_PASS] = LX_N("pass"), [LUXEL_FAIL] = LX_N("fail"), [LUXEL_UNDECIDED] = LX_N("undecided")};
    return verdict <= LUXEL_UNDECIDED ? words[verdict] : NULL;
}

static luxel_verdict judge(struct interval interval, double wanted, bool is_most)
{
    if (is_most ? interval.high <= wanted : interval.low >= wanted)
        return LUXEL_PASS;
    return (is_most ? interval.low > wanted : interval.high < wanted) ? LUXEL_FAIL : LUXEL_UNDECIDED;
}

static void conclude(luxel_limit *limit, double value, struct interval interval)
{
    limit->has_value = isfinite(value);
    limit->value.value = limit->has_value ? value : 0;
    limit->value.error = limit->has_value ? fmax(interval.high - value, value - interval.low) * (1 + ROUNDINGS) : 0;
    limit->verdict = judge(interval, limit->wanted, limit->is_most);
}

/* ---- grids ---- */

static const struct lx_grid *grid_of(const luxel_scene *scene, size_t i)
{
    return i < luxel_scene_grid_count(scene) ? (const struct lx_grid *)lx_scene_parameters(scene)->grids.items + i
                                             : NULL;
}

/* The true minimum is no less than all lower bounds and no more than any upper one; the maximum the other way round. */
static struct interval extreme(const luxel_grid *grid, bool is_maximum)
{
    const double sign = is_maximum ? -1 : 1;
    struct interval least = {HUGE_VAL, HUGE_VAL};
    for (size_t i = 0; i < (size_t)grid->columns * grid->rows; i++)
        if (grid->mask[i]) {
            least.low = fmin(least.low, sign * grid->values[i] - grid->errors[i]);
            least.high = fmin(least.high, sign * grid->values[i] + grid->errors[i]);
        }
    return is_maximum ? (struct interval){fmax(-least.high, 0), -least.low}
                      : (struct interval){fmax(least.low, 0), least.high};
}

/* A quotient of numbers that are not negative. */
static struct interval quotient(struct interval above, struct interval below)
{
    return (struct interval){below.high > 0 ? above.low / below.high * (1 - ROUNDINGS) : HUGE_VAL,
                             below.low > 0 ? above.high / below.low * (1 + ROUNDINGS) : HUGE_VAL};
}

static void judge_number(const luxel_grid *grid, enum lx_grid_limit which, luxel_limit *limit)
{
    const struct interval minimum = extreme(grid, false), maximum = extreme(grid, true);
    const struct interval average = {fmax(grid->average.value - grid->average.error, 0),
                                     grid->average.value + grid->average.error};
    switch (which) {
    case LX_LIMIT_AVERAGE: conclude(limit, grid->average.value, average); return;
    case LX_LIMIT_MINIMUM: conclude(limit, grid->minimum.value, minimum); return;
    case LX_LIMIT_MAXIMUM: conclude(limit, grid->maximum.value, maximum); return;
    case LX_LIMIT_UNIFORMITY:
        conclude(limit, grid->minimum.value / grid->average.value, quotient(minimum, average));
        return;
    case LX_LIMIT_RATIO: break;
    }
    if (limit->is_most)
        conclude(limit, grid->maximum.value / grid->minimum.value, quotient(maximum, minimum));
    else
        conclude(limit, grid->minimum.value / grid->maximum.value, quotient(minimum, maximum));
}

luxel_status luxel_judge_grid(const luxel_scene *scene, size_t i, const luxel_grid *grid,
                              luxel_limit limits[LUXEL_MOST_LIMITS], size_t *count)
{
    const struct lx_grid *from = grid_of(scene, i);
    if (!from || !grid || !limits || !count)
        return LUXEL_ERROR_ARGUMENT;
    *count = 0;
    for (int k = 0; k < LX_GRID_LIMITS; k++) {
        const enum lx_grid_limit which = (enum lx_grid_limit)k;
        luxel_limit limit = {.verdict = LUXEL_UNDECIDED};
        limit.wanted = lx_grid_limit(&from->limits, which, &limit.name);
        if (isnan(limit.wanted))
            continue;
        limit.is_most = which == LX_LIMIT_MAXIMUM || (which == LX_LIMIT_RATIO && limit.wanted > 1);
        if (grid->measured > 0)
            judge_number(grid, which, &limit);
        limits[(*count)++] = limit;
    }
    return LUXEL_OK;
}

/* ---- observers ---- */

size_t luxel_scene_observer_count(const luxel_scene *scene)
{
    return scene && luxel_scene_is_committed(scene) ? lx_scene_parameters(scene)->glare_observers.count : 0;
}

static const struct lx_glare_observer *sight_of(const luxel_scene *scene, size_t i)
{
    return i < luxel_scene_observer_count(scene)
               ? (const struct lx_glare_observer *)lx_scene_parameters(scene)->glare_observers.items + i
               : NULL;
}

luxel_status luxel_scene_observer(const luxel_scene *scene, size_t i, const char **name, luxel_glare_sight *sight)
{
    const struct lx_glare_observer *from = sight_of(scene, i);
    if (!from)
        return LUXEL_ERROR_ARGUMENT;
    if (name)
        *name = from->name;
    if (sight)
        *sight = (luxel_glare_sight){.eye_mm = {from->eye_mm[0], from->eye_mm[1], from->eye_mm[2]},
                                     .view = {from->view[0], from->view[1], from->view[2]}};
    return LUXEL_OK;
}

static bool is_any(const luxel_glare *glare, luxel_glare_reason reason)
{
    for (size_t i = 0; i < glare->source_count; i++)
        if (glare->sources[i].reason == reason)
            return true;
    return false;
}

luxel_status luxel_judge_glare(const luxel_scene *scene, size_t i, const luxel_glare *glare,
                               luxel_limit limits[LUXEL_MOST_LIMITS], size_t *count)
{
    const struct lx_glare_observer *from = sight_of(scene, i);
    if (!from || !glare || !limits || !count)
        return LUXEL_ERROR_ARGUMENT;
    luxel_limit limit = {.name = "ugr", .is_most = true, .verdict = LUXEL_UNDECIDED};
    limit.wanted = lx_glare_limit(&from->limits);
    *count = 0;
    if (!isnan(limit.wanted))
        (*count)++;
    const bool is_least = is_any(glare, LUXEL_GLARE_NO_AREA);
    if (glare->has_rating)
        conclude(&limit, glare->rating.value,
                 (struct interval){glare->rating.value - glare->rating.error,
                                   is_least ? HUGE_VAL : glare->rating.value + glare->rating.error});
    else if (!is_least && !is_any(glare, LUXEL_GLARE_COUNTS))
        limit.verdict = LUXEL_PASS;
    limits[0] = limit;
    return LUXEL_OK;
}

bool luxel_scene_has_limits(const luxel_scene *scene)
{
    const char *name;
    for (size_t i = 0; i < luxel_scene_grid_count(scene); i++)
        for (int k = 0; k < LX_GRID_LIMITS; k++)
            if (!isnan(lx_grid_limit(&grid_of(scene, i)->limits, (enum lx_grid_limit)k, &name)))
                return true;
    for (size_t i = 0; i < luxel_scene_observer_count(scene); i++)
        if (!isnan(lx_glare_limit(&sight_of(scene, i)->limits)))
            return true;
    return false;
}
