/* SPDX-License-Identifier: MIT */
/* Limits: the interval in which a number lies, and on which side of the limit that is. */
#include <luxel/limits.h>

#include <float.h>
#include <math.h>
#include <string.h>

#include "../base/phrase.h"
#include "../scene/observer.h"

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

/* The percents of the cells that have at least so much: for certain, by their values, and at most. */
static void judge_share(const luxel_grid *grid, luxel_limit *limit)
{
    double certain = 0, found = 0, possible = 0;
    for (size_t i = 0; i < (size_t)grid->columns * grid->rows; i++)
        if (grid->mask[i]) {
            certain += grid->values[i] - grid->errors[i] >= limit->above;
            found += grid->values[i] >= limit->above;
            possible += grid->values[i] + grid->errors[i] >= limit->above;
        }
    const double percent = 100 / (double)grid->measured;
    conclude(limit, found * percent, (struct interval){certain * percent, possible * percent});
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
    case LX_LIMIT_SHARE: judge_share(grid, limit); return;
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
        limit.above = which == LX_LIMIT_SHARE ? from->limits.share.above : 0;
        limit.is_most = which == LX_LIMIT_MAXIMUM || (which == LX_LIMIT_RATIO && limit.wanted > 1);
        if (grid->measured > 0)
            judge_number(grid, which, &limit);
        limits[(*count)++] = limit;
    }
    return LUXEL_OK;
}

/* The least average of the area around a task area that is to have so much (EN 12464-1:2011, table 1). */
static double wanted_around(double task)
{
    static const double rows[][2] = {{750, 500}, {500, 300}, {300, 200}, {200, 150}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (task >= rows[i][0])
            return rows[i][1];
    return task;
}

luxel_status luxel_judge_areas(const luxel_scene *scene, size_t i, const luxel_grid *grid,
                               luxel_limit limits[LUXEL_MOST_LIMITS], size_t *count)
{
    static const struct {
        const char *names[2];
        double average, uniformity; /* the average as a share of that wanted of the surrounding area */
    } rules[] = {{{"surround_average", "surround_uniformity"}, 1, 0.4},
                 {{"background_average", "background_uniformity"}, 1.0 / 3, 0.1}};
    const struct lx_grid *from = grid_of(scene, i);
    const char *name;
    if (!from || !grid || !limits || !count)
        return LUXEL_ERROR_ARGUMENT;
    const luxel_grid *const areas[] = {grid->surround, grid->background};
    const double task = lx_grid_limit(&from->limits, LX_LIMIT_AVERAGE, &name);
    *count = 0;
    for (size_t k = 0; k < 2 && !isnan(task); k++) {
        const double wanted[] = {rules[k].average * wanted_around(task), rules[k].uniformity};
        for (size_t n = 0; n < 2 && areas[k] && areas[k]->measured > 0; n++) {
            luxel_limit limit = {.name = rules[k].names[n], .wanted = wanted[n], .verdict = LUXEL_UNDECIDED};
            judge_number(areas[k], n == 0 ? LX_LIMIT_AVERAGE : LX_LIMIT_UNIFORMITY, &limit);
            limits[(*count)++] = limit;
        }
    }
    return LUXEL_OK;
}

luxel_status luxel_judge_grid_and_areas(const luxel_scene *scene, size_t i, const luxel_grid *grid,
                                        luxel_limit limits[2 * LUXEL_MOST_LIMITS], size_t *count)
{
    size_t around = 0;
    luxel_status status = luxel_judge_grid(scene, i, grid, limits, count);
    if (status == LUXEL_OK)
        status = luxel_judge_areas(scene, i, grid, limits + *count, &around);
    if (status == LUXEL_OK)
        *count += around;
    return status;
}

/* ---- observers ---- */

/* How many ways an observer looks from each of its places. */
static size_t count_views(const struct lx_glare_observer *observer)
{
    return lx_observer_has_view(observer) ? 1 : LX_LEVEL_VIEWS;
}

static size_t count_sights(const struct lx_glare_observer *observer)
{
    return (size_t)observer->n[0] * observer->n[1] * count_views(observer);
}

size_t luxel_scene_observer_count(const luxel_scene *scene)
{
    size_t count = 0;
    if (!scene || !luxel_scene_is_committed(scene))
        return 0;
    const struct lx_groups *observers = &lx_scene_parameters(scene)->glare_observers;
    for (size_t i = 0; i < observers->count; i++)
        count += count_sights((const struct lx_glare_observer *)observers->items + i);
    return count;
}

/* The observer that the i-th sight belongs to, whose first sight is *first; NULL: there is no such. */
static const struct lx_glare_observer *observer_of(const luxel_scene *scene, size_t i, size_t *first)
{
    const size_t count =
        scene && luxel_scene_is_committed(scene) ? lx_scene_parameters(scene)->glare_observers.count : 0;
    *first = 0;
    for (size_t k = 0; k < count; k++) {
        const struct lx_glare_observer *observer =
            (const struct lx_glare_observer *)lx_scene_parameters(scene)->glare_observers.items + k;
        const size_t sights = count_sights(observer);
        if (i < *first + sights)
            return observer;
        *first += sights;
    }
    return NULL;
}

static const struct lx_glare_observer *sight_of(const luxel_scene *scene, size_t i)
{
    size_t first;
    return observer_of(scene, i, &first);
}

luxel_status luxel_scene_observer(const luxel_scene *scene, size_t i, const char **name, luxel_glare_sight *sight)
{
    size_t first;
    const struct lx_glare_observer *from = observer_of(scene, i, &first);
    if (!from)
        return LUXEL_ERROR_ARGUMENT;
    if (name)
        *name = from->name;
    if (sight) {
        *sight = (luxel_glare_sight){.eye_mm = {0}};
        lx_observer_sight(lx_scene_parameters(scene), from, (i - first) / count_views(from),
                          (i - first) % count_views(from), sight->eye_mm, sight->view);
    }
    return LUXEL_OK;
}

luxel_status luxel_scene_observer_places(const luxel_scene *scene, size_t i, luxel_observer_places *places)
{
    size_t first;
    const struct lx_glare_observer *from = observer_of(scene, i, &first);
    if (!from || !places)
        return LUXEL_ERROR_ARGUMENT;
    *places = (luxel_observer_places){.first = first,
                                      .count = count_sights(from),
                                      .columns = from->n[0],
                                      .rows = from->n[1],
                                      .views = (unsigned)count_views(from)};
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

luxel_limit luxel_worst_limit(const luxel_limit *limits, size_t count)
{
    luxel_limit worst = limits[0];
    for (size_t i = 1; i < count; i++) {
        const luxel_limit *limit = &limits[i];
        if (limit->has_value && (!worst.has_value || limit->value.value > worst.value.value)) {
            worst.has_value = true;
            worst.value = limit->value;
        }
        if (limit->verdict == LUXEL_FAIL || (limit->verdict == LUXEL_UNDECIDED && worst.verdict == LUXEL_PASS))
            worst.verdict = limit->verdict;
    }
    return worst;
}

static const struct limit_kind {
    const char *name, *words;
    bool has_unit;
} kinds[] = {{"average", LX_N("average"), true},
             {"minimum", LX_N("minimum"), true},
             {"maximum", LX_N("maximum"), true},
             {"uniformity", LX_N("uniformity U0"), false},
             {"share", LX_N("share of the area"), false},
             {"ugr", "UGR", false},
             {"surround_average", LX_N("surrounding area: average"), true},
             {"surround_uniformity", LX_N("surrounding area: U0"), false},
             {"background_average", LX_N("background area: average"), true},
             {"background_uniformity", LX_N("background area: U0"), false}};

/* NULL: it is a ratio. */
static const struct limit_kind *kind_of(const luxel_limit *limit)
{
    for (size_t i = 0; i < LX_COUNT(kinds); i++)
        if (strcmp(kinds[i].name, limit->name) == 0)
            return &kinds[i];
    return NULL;
}

const char *luxel_limit_word(const luxel_limit *limit)
{
    const struct limit_kind *kind = kind_of(limit);
    return kind ? kind->words : limit->is_most ? LX_N("maximum / minimum") : LX_N("minimum / maximum");
}

bool luxel_limit_has_unit(const luxel_limit *limit)
{
    const struct limit_kind *kind = kind_of(limit);
    return kind && kind->has_unit;
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
