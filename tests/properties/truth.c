/* SPDX-License-Identifier: MIT */
/* The truth at a sample, and near it. */
#include "truth.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* What each light may give at a sample. */
struct range {
    double low[DRAFT_LIGHTS], high[DRAFT_LIGHTS];
};

enum { WAYS = 8 };
static const double ways[WAYS][2] = {{1, 0},     {-1, 0},     {0, 1},      {0, -1},
                                     {0.7, 0.7}, {0.7, -0.7}, {-0.7, 0.7}, {-0.7, -0.7}};

/* SPEC: how near a jump must be to excuse a pixel. */
static const double REACH_MM = 1e-6;

static void widen(struct range *range, size_t light, double value)
{
    range->low[light] = fmin(range->low[light], value);
    range->high[light] = fmax(range->high[light], value);
}

/* Takes what the lights give at a place into the range. */
static void widen_by(struct range *range, const luxel_evaluator *evaluator, double x, double y)
{
    double shares[DRAFT_LIGHTS];
    luxel_value value;
    luxel_evaluate_screen(evaluator, x, y, &value, shares);
    for (size_t i = 0; (value.has_value || !value.on_surface) && i < luxel_evaluator_light_count(evaluator); i++)
        widen(range, i, shares[i]);
}

static double distance(const double a[3], const double b[3])
{
    return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

/* How far samples and places may be rounded: a few roundings of all lengths that make them. */
static double rounding_of(const struct draft *draft, size_t surface)
{
    const struct draft_surface_numbers *seen = &draft->surfaces[surface].numbers;
    const double eye[3] = {0, 0, draft->numbers.observer_z};
    double size = draft->numbers.pitch * (draft->words.columns + draft->words.rows) + seen->size[0] + seen->size[1];
    if (draft->words.perspective)
        size += draft->numbers.observer_z + distance(eye, seen->center);
    return 4 * DBL_EPSILON * size;
}

/* How far from its place a light may have points that shine; below 0: it has none. */
static double reach_of(const struct draft_light *light)
{
    const double *size = light->numbers.size;
    if (light->words.type == DRAFT_POINT || light->words.type == DRAFT_SPOT)
        return 0;
    if (light->words.parts == 0)
        return -1;
    return light->words.parts == 1 && light->words.type == DRAFT_PLANAR && light->words.shape != DRAFT_POLYGON
               ? 0
               : size[0] + size[1] + size[2];
}

/* Whether a source stands where it counts as being on the element: a picture's least distance is 1e-6 mm. */
static bool is_on_source(const struct draft *draft, const luxel_value *value, double rounding)
{
    for (size_t i = 0; i < draft->light_count; i++) {
        const double reach = reach_of(&draft->lights[i]);
        const double away = distance(draft->lights[i].numbers.place, value->position_mm);
        if (reach >= 0 && away < reach + 2e-6 + 4 * rounding)
            return true;
    }
    return false;
}

/* With all lights a little aside, which is as if the surface and who sees it were. */
static void widen_by_moved_lights(struct range *range, const struct draft *draft, double x, double y, double rounding)
{
    const luxel_settings settings = trial_settings(LUXEL_DOUBLE);
    for (int way = 0; way < 6; way++) {
        struct draft moved = *draft;
        luxel_evaluator *evaluator = NULL;
        for (size_t i = 0; i < moved.light_count; i++)
            moved.lights[i].numbers.place[way / 2] += way % 2 ? rounding : -rounding;
        luxel_scene *scene = trial_scene_of(&moved);
        if (scene && luxel_evaluator_new(scene, &settings, NULL, &evaluator) == LUXEL_OK)
            widen_by(range, evaluator, x, y);
        luxel_evaluator_free(evaluator);
        luxel_scene_free(scene);
    }
}

/* With each surface a little nearer to the observer, which then is seen where several meet. */
static void widen_by_raised_surfaces(struct range *range, const struct draft *draft, double x, double y,
                                     double rounding)
{
    const luxel_settings settings = trial_settings(LUXEL_DOUBLE);
    for (size_t i = 0; draft->surface_count > 1 && i < draft->surface_count; i++) {
        struct draft raised = *draft;
        luxel_evaluator *evaluator = NULL;
        raised.surfaces[i].numbers.center[2] += rounding;
        luxel_scene *scene = trial_scene_of(&raised);
        if (scene && luxel_evaluator_new(scene, &settings, NULL, &evaluator) == LUXEL_OK)
            widen_by(range, evaluator, x, y);
        luxel_evaluator_free(evaluator);
        luxel_scene_free(scene);
    }
}

static double share_at(const luxel_evaluator *evaluator, size_t light, double x, double y)
{
    double shares[DRAFT_LIGHTS];
    luxel_value value;
    luxel_evaluate_screen(evaluator, x, y, &value, shares);
    return shares[light];
}

/* The jump of a light's share on the way from the sample; 0 where it only slopes. */
static double jump_on_way(const luxel_evaluator *evaluator, size_t light, double x, double y, const double way[2],
                          double reach, double least)
{
    double from = 0, to = reach;
    double before = share_at(evaluator, light, x, y);
    double after = share_at(evaluator, light, x + to * way[0], y + to * way[1]);
    if (!(fabs(after - before) > least))
        return 0;
    for (int halving = 0; halving < 80; halving++) {
        const double middle = (from + to) / 2, at_x = x + middle * way[0], at_y = y + middle * way[1];
        const double between = share_at(evaluator, light, at_x, at_y);
        if (fabs(between - before) > fabs(after - between))
            to = middle, after = between;
        else
            from = middle, before = between;
    }
    return fabs(after - before) > least ? after - before : 0;
}

static void widen_by_jumps(struct range *range, const luxel_evaluator *evaluator, const double shares[], double x,
                           double y, double reach, double slack)
{
    for (size_t i = 0; i < luxel_evaluator_light_count(evaluator); i++)
        for (int way = 0; way < WAYS; way++)
            widen(range, i, shares[i] + jump_on_way(evaluator, i, x, y, ways[way], reach, slack / 8));
}

static bool allows_nearby(struct trial *trial, double x, double y, const luxel_value *value, const double shares[],
                          double shown, double slack)
{
    const struct draft *draft = trial->draft;
    const luxel_evaluator *evaluator = trial_evaluator(trial);
    const double rounding = rounding_of(draft, value->on_surface ? value->surface : 0);
    struct range range;
    if (is_on_source(draft, value, rounding))
        return true;
    memcpy(range.low, shares, sizeof range.low);
    memcpy(range.high, shares, sizeof range.high);
    for (int way = 0; way < WAYS; way++)
        widen_by(&range, evaluator, x + ways[way][0] * rounding, y + ways[way][1] * rounding);
    widen_by_jumps(&range, evaluator, shares, x, y, fmax(fmin(REACH_MM, 1e-6 * draft->numbers.pitch), 2 * rounding),
                   slack);
    widen_by_moved_lights(&range, draft, x, y, rounding);
    widen_by_raised_surfaces(&range, draft, x, y, rounding);
    double low = -slack - value->error, high = slack + value->error;
    for (size_t i = 0; i < draft->light_count; i++)
        low += range.low[i], high += range.high[i];
    trial->excused++;
    return shown >= low && shown <= high;
}

static luxel_value look(struct trial *trial, unsigned column, unsigned row, double shares[DRAFT_LIGHTS], double *x,
                        double *y)
{
    const luxel_field *picture = trial_picture(trial, LUXEL_DOUBLE);
    *x = luxel_field_x_mm(picture)[column];
    *y = luxel_field_y_mm(picture)[row];
    memset(shares, 0, DRAFT_LIGHTS * sizeof *shares);
    luxel_value value;
    luxel_evaluate_screen(trial_evaluator(trial), *x, *y, &value, shares);
    return value;
}

bool truth_allows(struct trial *trial, unsigned column, unsigned row, double shown, double slack)
{
    double shares[DRAFT_LIGHTS], x, y;
    luxel_value value = look(trial, column, row, shares, &x, &y);
    trial->pixels++;
    trial->vague += value.error <= slack ? 0 : 1;
    if (value.on_surface && !value.has_value) /* a source lies on the element */
        return true;
    if (fabs(shown - value.value) <= slack + value.error)
        return true;
    return allows_nearby(trial, x, y, &value, shares, shown, slack) ||
           trial_fails(trial, "pixel [%u, %u] at (%.17g, %.17g): shown %.17g, true %.17g +- %.3g, slack %.3g", column,
                       row, x, y, shown, value.value, value.error, slack);
}

bool truth_is_touched(struct trial *trial)
{
    const luxel_field *picture = trial_picture(trial, LUXEL_DOUBLE);
    for (unsigned row = 0; picture && row < luxel_field_rows(picture); row++)
        for (unsigned column = 0; column < luxel_field_columns(picture); column++) {
            double shares[DRAFT_LIGHTS], x, y;
            const luxel_value value = look(trial, column, row, shares, &x, &y);
            if (value.on_surface && is_on_source(trial->draft, &value, rounding_of(trial->draft, value.surface)))
                return true;
        }
    return false;
}

bool truth_shows(struct trial *trial, unsigned column, unsigned row, bool is_shown)
{
    double shares[DRAFT_LIGHTS], x, y;
    luxel_value value = look(trial, column, row, shares, &x, &y);
    if (value.on_surface == is_shown)
        return true;
    const double reach = fmax(REACH_MM, 2 * rounding_of(trial->draft, value.surface));
    for (int way = 0; way < WAYS; way++) {
        luxel_evaluate_screen(trial_evaluator(trial), x + ways[way][0] * reach, y + ways[way][1] * reach, &value, NULL);
        if (value.on_surface == is_shown)
            return true;
    }
    return trial_fails(trial, "pixel [%u, %u] at (%.17g, %.17g) is %s a surface", column, row, x, y,
                       is_shown ? "wrongly on" : "not on");
}
