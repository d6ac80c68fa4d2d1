/* SPDX-License-Identifier: MIT */
/* The table of what one luminaire gives, the field where luminaires may stand, and sums over arrays. */
#include "superposition.h"

#include <luxel/light.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../api/session.h"
#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../base/pose.h"
#include "../base/text.h"
#include "../base/vector.h"
#include "../light/array.h"
#include "../light/solid/extended.h"
#include "../scene/lit.h"
#include "../scene/scene.h"
#include "../world/among.h"

enum { FEWEST_STEPS = 8, MOST_STEPS = 48, STEPS_BY_DISTANCE = 10, MOST_IN_A_LINE = 1000 };
/* A ray along the field begins so far from a ceiling that luminaires are level with. */
static const double BELOW_MM = 1;

/* ---- values of scenes ---- */

static const struct lx_grid *grid_of(const luxel_scene *scene, size_t i)
{
    return (const struct lx_grid *)lx_scene_parameters(scene)->grids.items + i;
}

static bool has_limits(const struct lx_grid *grid)
{
    const char *name;
    for (int k = 0; k < LX_GRID_LIMITS; k++)
        if (!isnan(lx_grid_limit(&grid->limits, (enum lx_grid_limit)k, &name)))
            return true;
    return false;
}

static luxel_status judge(const luxel_scene *scene, size_t i, const luxel_grid *grid, luxel_layout_limit *limits,
                          size_t *limit_count)
{
    luxel_limit judged[LX_GOALS_OF_GRID];
    size_t count;
    luxel_status status = luxel_judge_grid_and_areas(scene, i, grid, judged, &count);
    for (size_t k = 0; status == LUXEL_OK && k < count; k++)
        limits[(*limit_count)++] = (luxel_layout_limit){.index = i, .limit = judged[k]};
    return status;
}

/* A grid, or one of the areas around it; NULL: there is none. */
static const luxel_grid *part_of(const luxel_grid *grid, enum lx_grid_part part)
{
    return part == LX_PART_TASK ? grid : part == LX_PART_SURROUND ? grid->surround : grid->background;
}

static size_t count_cells(const luxel_grid *part)
{
    return part ? (size_t)part->columns * part->rows : 0;
}

/* The limits of observer i, of nobody's rating. */
static size_t limits_of_observer(const luxel_scene *scene, size_t i, luxel_limit limits[LUXEL_MOST_LIMITS])
{
    size_t count = 0;
    luxel_judge_glare(scene, i, &(luxel_glare){.has_rating = false}, limits, &count);
    return count;
}

/* The number that a rating is 8 times the logarithm of; without a background, the glare itself. */
static double dazzle(const luxel_glare *glare)
{
    double sum = 0;
    if (glare->has_rating)
        return pow(10, glare->rating.value / 8);
    for (size_t i = 0; i < glare->source_count; i++) {
        const luxel_glare_source *source = &glare->sources[i];
        if (source->reason == LUXEL_GLARE_COUNTS)
            sum += source->luminance * source->luminance * source->seen * source->solid_angle /
                   (source->position_index * source->position_index);
    }
    return sum / 4;
}

static luxel_status measure_observers(const struct lx_superposition *superposition, const luxel_scene *scene,
                                      const luxel_settings *settings, double *values)
{
    luxel_status status = LUXEL_OK;
    for (size_t i = 0; i < luxel_scene_observer_count(scene) && status == LUXEL_OK; i++) {
        luxel_limit limits[LUXEL_MOST_LIMITS];
        luxel_glare_sight sight;
        luxel_glare *glare = NULL;
        const size_t count = limits_of_observer(scene, i, limits);
        if (count == 0)
            continue;
        luxel_scene_observer(scene, i, NULL, &sight);
        status = luxel_find_glare(scene, settings, &sight, superposition->diagnostics, &glare);
        for (size_t k = 0; k < count && status == LUXEL_OK; k++)
            *values++ = dazzle(glare);
        luxel_glare_free(glare);
    }
    return status;
}

luxel_status lx_measure_goals(const struct lx_superposition *superposition, const luxel_scene *scene,
                              const luxel_settings *settings, double *values, luxel_layout_limit *limits,
                              size_t *limit_count)
{
    luxel_status status = LUXEL_OK;
    size_t first = 0;
    for (size_t i = 0; status == LUXEL_OK && i < luxel_scene_grid_count(scene); i++) {
        luxel_grid *grid = NULL;
        if (!has_limits(grid_of(scene, i)))
            continue;
        status = luxel_find_grid_values(scene, settings, i, superposition->diagnostics, &grid);
        for (enum lx_grid_part part = 0; status == LUXEL_OK && part < LX_GRID_PARTS; part++) {
            const luxel_grid *from = part_of(grid, part);
            for (size_t k = 0; k < count_cells(from); k++)
                values[first++] = from->mask[k] ? from->values[k] : (double)NAN;
        }
        if (status == LUXEL_OK && limits)
            status = judge(scene, i, grid, limits, limit_count);
        luxel_grid_free(grid);
    }
    return status == LUXEL_OK && superposition->observers > 0
               ? measure_observers(superposition, scene, settings, &values[first])
               : status;
}

static luxel_status set_numbers(luxel_scene *scene, size_t light, const char *key, const double numbers[2],
                                luxel_diagnostics *diagnostics)
{
    struct lx_text text = {0};
    char first[LX_NUMBER_SIZE], second[LX_NUMBER_SIZE];
    lx_text_printf(&text, "lights[%zu].array.%s=[%s, %s]", light, key, lx_write_number(numbers[0], first),
                   lx_write_number(numbers[1], second));
    const luxel_status status =
        text.failed ? lx_out_of_memory(diagnostics) : luxel_scene_set(scene, text.bytes, diagnostics);
    lx_text_clear(&text);
    return status;
}

luxel_status lx_array_set(luxel_scene *scene, size_t light, const struct lx_array_try *array,
                          luxel_diagnostics *diagnostics)
{
    luxel_status status = set_numbers(scene, light, "n", (const double[]){array->n[0], array->n[1]}, diagnostics);
    if (status == LUXEL_OK)
        status = set_numbers(scene, light, "spacing", array->spacing_mm, diagnostics);
    if (status == LUXEL_OK)
        status = luxel_scene_commit(scene, diagnostics);
    return status;
}

/* ---- the field ---- */

/* How far a ray goes to the nearest surface; infinite: it meets none. */
static double way_along(const struct lx_prepared *prepared, const double from_mm[3], const double direction[3],
                        double sign)
{
    struct lx_ray ray = {.origin_mm = {0}};
    struct lx_found found;
    double nearest = HUGE_VAL;
    for (int k = 0; k < 3; k++) {
        ray.origin_mm[k] = from_mm[k];
        ray.direction[k] = sign * direction[k];
    }
    const bool is_found = lx_among_ray(prepared, &ray, &found);
    const size_t count = lx_found_count(&found, is_found, prepared->surface_count);
    for (size_t i = 0; i < count; i++) {
        const struct lx_prepared_surface *surface = &prepared->surfaces[lx_found_at(&found, is_found, i)];
        const struct lx_hit hit = surface->kind->hit(&surface->shape, &ray);
        if (hit.exists && hit.t > 0)
            nearest = fmin(nearest, hit.t);
    }
    return nearest;
}

/* How far a luminaire comes out of its middle. */
static double half_width(const struct lx_prepared *prepared, size_t light, const double middle_mm[3],
                         const double axis[3])
{
    double most = 0;
    for (size_t i = 0; i < lx_item_count(&prepared->emitters); i++) {
        const struct lx_emitter *emitter = &prepared->emitters.items[i];
        if (emitter->light != light || !lx_is_extended(emitter))
            continue;
        for (int sign = -1; sign <= 1; sign += 2) {
            double place_mm[3], away = 0;
            const double towards[3] = {sign * axis[0], sign * axis[1], sign * axis[2]};
            lx_emitter_kind(emitter)->farthest(emitter, towards, place_mm);
            for (int k = 0; k < 3; k++)
                away += (place_mm[k] - middle_mm[k]) * towards[k];
            most = fmax(most, away);
        }
    }
    return most;
}

/* The cells' extent along an axis, and how near a cell comes to the field. */
static void look_at_cells(const struct lx_superposition *superposition, const double middle_mm[3], double extent_mm[2],
                          double *nearest_mm)
{
    const luxel_scene *scene = superposition->scene;
    extent_mm[0] = extent_mm[1] = 0;
    *nearest_mm = HUGE_VAL;
    for (size_t i = 0; i < luxel_scene_grid_count(scene); i++) {
        const struct lx_grid *grid = grid_of(scene, i);
        if (!has_limits(grid))
            continue;
        const struct lx_pose pose = lx_pose_of(grid->axis, grid->up);
        double across[3], up[3];
        lx_wide3_values(pose.across, across);
        lx_wide3_values(pose.upward, up);
        for (int corner = 0; corner < 9; corner++) {
            double away[3], square = 0, beyond;
            for (int k = 0; k < 3; k++)
                away[k] = grid->center_mm[k] + (corner % 3 - 1) / 2.0 * grid->size_mm[0] * across[k] +
                          (corner / 3 - 1) / 2.0 * grid->size_mm[1] * up[k] - middle_mm[k];
            square = lx_dot(away, away);
            for (int axis = 0; axis < 2; axis++) {
                const double along = fabs(lx_dot(away, superposition->axes[axis]));
                extent_mm[axis] = fmax(extent_mm[axis], along);
                beyond = fmax(along - superposition->half_mm[axis], 0);
                square += beyond * beyond - along * along;
            }
            *nearest_mm = fmin(*nearest_mm, sqrt(fmax(square, 0)));
        }
    }
}

/* The axes of the array; those of an array that is none yet are x and y. */
static void find_axes(struct lx_superposition *superposition)
{
    static const double usual[2][3] = {{1, 0, 0}, {0, 1, 0}};
    const struct lx_array *array =
        lx_array_of(&lx_scene_parameters(superposition->scene)->lights.items[superposition->light]);
    for (int i = 0; i < 2; i++) {
        const double *axis = array && array->axes.count == 2 ? array->axes.xyz[i] : usual[i];
        const double length = sqrt(lx_dot(axis, axis));
        for (int k = 0; k < 3; k++)
            superposition->axes[i][k] = axis[k] / length;
    }
}

/* Where luminaires may stand, from a scene with one of them, and how fine the table has to be. */
static luxel_status find_field(struct lx_superposition *superposition, const luxel_scene *one)
{
    const size_t light = superposition->light;
    double middle_mm[3] = {0}, from_mm[3], direction[3] = {0, 0, -1}, extent_mm[2], nearest_mm;
    struct lx_prepared prepared;
    find_axes(superposition);
    luxel_status status = lx_session_prepare(one, superposition->settings, superposition->diagnostics, &prepared);
    if (status == LUXEL_OK && !luxel_scene_light_place(one, light, middle_mm))
        status = lx_out_of_memory(superposition->diagnostics);
    luxel_scene_light_direction(one, light, direction);
    for (int k = 0; k < 3; k++)
        from_mm[k] = middle_mm[k] + BELOW_MM * direction[k];
    look_at_cells(superposition, middle_mm, extent_mm, &nearest_mm);
    for (int i = 0; status == LUXEL_OK && i < 2; i++) {
        const double width = half_width(&prepared, light, middle_mm, superposition->axes[i]);
        const double wall = fmin(way_along(&prepared, from_mm, superposition->axes[i], 1),
                                 way_along(&prepared, from_mm, superposition->axes[i], -1));
        superposition->wall_mm[i] = isfinite(wall) ? wall : extent_mm[i];
        superposition->half_mm[i] = isfinite(wall) ? fmax(wall - width, 0) : extent_mm[i];
        superposition->least_mm[i] = fmax(2 * width, 1);
    }
    look_at_cells(superposition, middle_mm, extent_mm, &nearest_mm);
    for (int i = 0; i < 2; i++) {
        const double steps = ceil(STEPS_BY_DISTANCE * superposition->half_mm[i] / fmax(nearest_mm, 1));
        superposition->nodes[i] =
            superposition->half_mm[i] > 0 ? (unsigned)fmin(fmax(steps, FEWEST_STEPS), MOST_STEPS) + 1 : 1;
    }
    lx_prepared_clear(&prepared);
    return status;
}

/* ---- the table ---- */

static luxel_status fill_table(struct lx_superposition *superposition, luxel_scene *one, const luxel_settings *settings)
{
    luxel_status status = LUXEL_OK;
    const unsigned *nodes = superposition->nodes;
    for (unsigned row = 0; row < nodes[1]; row++)
        for (unsigned column = 0; column < nodes[0] && status == LUXEL_OK; column++) {
            const unsigned at[2] = {column, row};
            struct lx_array_try array;
            double *values = &superposition->table[((size_t)row * nodes[0] + column) * superposition->cells];
            for (int i = 0; i < 2; i++) {
                array.n[i] = at[i] > 0 ? 2 : 1;
                array.spacing_mm[i] = at[i] > 0 ? 2 * superposition->half_mm[i] * at[i] / (nodes[i] - 1) : 1;
            }
            status = lx_array_set(one, superposition->light, &array, superposition->diagnostics);
            if (status == LUXEL_OK)
                status = lx_measure_goals(superposition, one, settings, values, NULL, NULL);
            for (size_t k = 0; k < superposition->cells; k++)
                values[k] /= array.n[0] * array.n[1];
        }
    return status;
}

/* The weights of the table's places along an axis, of one luminaire at so many steps from the middle. */
static void add_weights(double at, unsigned nodes, double *weights)
{
    if (nodes < 4) {
        weights[0] += 1;
        return;
    }
    const int last = (int)nodes - 1, first = (int)fmin(floor(at) - 1, last - 3);
    for (int i = first; i < first + 4; i++) {
        double weight = 1;
        for (int k = first; k < first + 4; k++)
            if (k != i)
                weight *= (at - k) / (i - k);
        weights[abs(i)] += weight; /* the other side of the middle is the same */
    }
}

void lx_superpose(const struct lx_superposition *superposition, const struct lx_array_try *array, double *values)
{
    const unsigned *nodes = superposition->nodes;
    const size_t cells = superposition->cells;
    double weights[2][MOST_STEPS + 1] = {{0}};
    for (int i = 0; i < 2; i++)
        for (unsigned k = 0; k < array->n[i]; k++) {
            const double away_mm = fabs((k - (array->n[i] - 1) / 2.0) * array->spacing_mm[i]);
            const double at = nodes[i] > 1 ? away_mm / superposition->half_mm[i] * (nodes[i] - 1) : 0;
            add_weights(fmin(at, nodes[i] - 1), nodes[i], weights[i]);
        }
    for (size_t k = 0; k < cells; k++)
        values[k] = superposition->correction[k] * array->n[0] * array->n[1];
    for (unsigned row = 0; row < nodes[1]; row++)
        for (unsigned column = 0; column < nodes[0]; column++) {
            const double weight = weights[0][column] * weights[1][row];
            const double *one = &superposition->table[((size_t)row * nodes[0] + column) * cells];
            for (size_t k = 0; weight != 0 && k < cells; k++)
                values[k] += weight * one[k];
        }
}

void lx_superposition_learn(struct lx_superposition *superposition, const struct lx_array_try *array, double dimming,
                            const double *values)
{
    double *sums = superposition->sums;
    const double count = array->n[0] * array->n[1];
    lx_superpose(superposition, array, sums);
    for (size_t k = 0; k < superposition->cells; k++)
        superposition->correction[k] += ((values[k] - superposition->base[k]) / dimming - sums[k]) / count;
}

double lx_fewest_luminaires(const struct lx_superposition *superposition)
{
    const size_t places = (size_t)superposition->nodes[0] * superposition->nodes[1], cells = superposition->cells;
    double fewest = 1;
    for (size_t i = 0; i < superposition->goal_count; i++) {
        const struct lx_goal *goal = &superposition->goals[i];
        double best = 0, base = 0;
        if (goal->which != LX_LIMIT_AVERAGE && goal->which != LX_LIMIT_MINIMUM)
            continue;
        for (size_t place = 0; place < places; place++) {
            double sum = 0, others = 0, count = 0;
            for (size_t k = goal->first; k < goal->first + goal->count; k++) {
                const double one = superposition->table[place * cells + k] + superposition->correction[k];
                if (isnan(one))
                    continue;
                sum += one;
                others += superposition->base[k];
                count++;
            }
            best = fmax(best, count > 0 ? sum / count : 0);
            base = count > 0 ? others / count : 0;
        }
        fewest = fmax(fewest, best > 0 ? (goal->wanted - base) / best : HUGE_VAL);
    }
    return fewest;
}

/* ---- all of it ---- */

static void add_goal(struct lx_superposition *superposition, const luxel_grid *grid, enum lx_grid_part part,
                     enum lx_grid_limit which, const luxel_limit *limit)
{
    size_t first = superposition->cells;
    for (enum lx_grid_part before = 0; before < part; before++)
        first += count_cells(part_of(grid, before));
    superposition->goals[superposition->goal_count++] =
        (struct lx_goal){first, count_cells(part_of(grid, part)), which, limit->wanted, limit->above};
}

/* The goals of a grid, and of the areas around it what is wanted of those; its cells are as many without any light. */
static luxel_status list_goals_of(struct lx_superposition *superposition, size_t i, const luxel_settings *dark)
{
    const struct lx_grid *from = grid_of(superposition->scene, i);
    luxel_limit limits[LX_GOALS_OF_GRID];
    luxel_grid *grid = NULL;
    size_t count = 0;
    const char *name;
    luxel_status status = luxel_find_grid_values(superposition->scene, dark, i, superposition->diagnostics, &grid);
    if (status == LUXEL_OK)
        status = luxel_judge_grid(superposition->scene, i, grid, limits, &count);
    for (int k = 0, next = 0; status == LUXEL_OK && k < LX_GRID_LIMITS; k++)
        if (!isnan(lx_grid_limit(&from->limits, (enum lx_grid_limit)k, &name)))
            add_goal(superposition, grid, LX_PART_TASK, (enum lx_grid_limit)k, &limits[next++]);
    if (status == LUXEL_OK)
        status = luxel_judge_areas(superposition->scene, i, grid, limits, &count);
    for (size_t k = 0; status == LUXEL_OK && k < count; k++)
        add_goal(superposition, grid,
                 strncmp(limits[k].name, "surround", 8) == 0 ? LX_PART_SURROUND : LX_PART_BACKGROUND,
                 strstr(limits[k].name, "average") ? LX_LIMIT_AVERAGE : LX_LIMIT_UNIFORMITY, &limits[k]);
    for (enum lx_grid_part part = 0; status == LUXEL_OK && part < LX_GRID_PARTS; part++)
        superposition->cells += count_cells(part_of(grid, part));
    luxel_grid_free(grid);
    return status;
}

/* The rating is at most so much where what it is the logarithm of is. */
static void list_observers(struct lx_superposition *superposition)
{
    const luxel_scene *scene = superposition->scene;
    for (size_t i = 0; i < luxel_scene_observer_count(scene); i++) {
        luxel_limit limits[LUXEL_MOST_LIMITS];
        const size_t count = limits_of_observer(scene, i, limits);
        for (size_t k = 0; k < count; k++)
            superposition->goals[superposition->goal_count++] =
                (struct lx_goal){superposition->cells++, 1, LX_LIMIT_MAXIMUM, pow(10, limits[k].wanted / 8), 0};
        superposition->observers += count;
    }
}

luxel_status lx_superposition_list(const luxel_scene *scene, const luxel_settings *settings,
                                   luxel_diagnostics *diagnostics, bool observe, struct lx_superposition *superposition)
{
    *superposition = (struct lx_superposition){.scene = scene, .settings = settings, .diagnostics = diagnostics};
    luxel_settings dark = *superposition->settings;
    const size_t none = 0;
    luxel_status status = LUXEL_OK;
    dark.lights = &none;
    dark.light_count = 0;
    superposition->goals = lx_new_array(luxel_scene_grid_count(scene) * LX_GOALS_OF_GRID +
                                            luxel_scene_observer_count(scene) * LUXEL_MOST_LIMITS + 1,
                                        sizeof(struct lx_goal));
    if (!superposition->goals)
        return lx_out_of_memory(superposition->diagnostics);
    for (size_t i = 0; i < luxel_scene_grid_count(scene) && status == LUXEL_OK; i++)
        if (has_limits(grid_of(scene, i)))
            status = list_goals_of(superposition, i, &dark);
    if (observe)
        list_observers(superposition);
    if (status != LUXEL_OK || superposition->cells > 0)
        return status;
    return lx_refuse(superposition->diagnostics, LX_MSG_ARRANGE_NO_GOAL, NULL);
}

/* What the other lights give. */
static luxel_status find_base(struct lx_superposition *superposition)
{
    const struct lx_scene_parameters *parameters = lx_scene_parameters(superposition->scene);
    luxel_settings settings = *superposition->settings;
    luxel_status status = LUXEL_OK;
    bool *on = lx_lights_on(parameters, superposition->settings);
    size_t *others = lx_new_array(parameters->lights.count + 1, sizeof *others), count = 0;
    if (!on || !others)
        status = lx_out_of_memory(superposition->diagnostics);
    for (size_t i = 0; status == LUXEL_OK && i < parameters->lights.count; i++)
        if (on[i] && i != superposition->light)
            others[count++] = i;
    settings.lights = others;
    settings.light_count = count;
    if (status == LUXEL_OK && count > 0)
        status = lx_measure_goals(superposition, superposition->scene, &settings, superposition->base, NULL, NULL);
    free(on);
    free(others);
    return status;
}

/* A copy of the scene in which nothing is reflected, and the light stands at one place. */
static luxel_status make_one(const struct lx_superposition *superposition, luxel_scene **one)
{
    *one = luxel_scene_copy(superposition->scene);
    if (!*one)
        return lx_out_of_memory(superposition->diagnostics);
    const luxel_status status = luxel_scene_set(*one, "reflections=none", superposition->diagnostics);
    return status != LUXEL_OK ? status
                              : lx_array_set(*one, superposition->light, &(struct lx_array_try){{1, 1}, {1, 1}},
                                             superposition->diagnostics);
}

luxel_status lx_superposition_make(const luxel_scene *scene, const luxel_settings *settings, size_t light,
                                   luxel_diagnostics *diagnostics, struct lx_superposition *superposition)
{
    luxel_scene *one = NULL;
    luxel_settings alone = *settings;
    luxel_status status = lx_superposition_list(scene, settings, diagnostics, false, superposition);
    superposition->light = light;
    alone.lights = &superposition->light;
    alone.light_count = 1;
    if (status == LUXEL_OK)
        status = make_one(superposition, &one);
    if (status == LUXEL_OK)
        status = find_field(superposition, one);
    if (status == LUXEL_OK) {
        const size_t places = (size_t)superposition->nodes[0] * superposition->nodes[1];
        superposition->table = lx_new_array(places * superposition->cells, sizeof *superposition->table);
        superposition->base = lx_new_array(superposition->cells, sizeof *superposition->base);
        superposition->correction = lx_new_array(superposition->cells, sizeof *superposition->correction);
        superposition->sums = lx_new_array(superposition->cells, sizeof *superposition->sums);
        if (!superposition->table || !superposition->base || !superposition->correction || !superposition->sums)
            status = lx_out_of_memory(diagnostics);
    }
    if (status == LUXEL_OK)
        status = find_base(superposition);
    if (status == LUXEL_OK)
        status = fill_table(superposition, one, &alone);
    luxel_scene_free(one);
    return status;
}

void lx_superposition_clear(struct lx_superposition *superposition)
{
    free(superposition->goals);
    free(superposition->table);
    free(superposition->base);
    free(superposition->correction);
    free(superposition->sums);
    *superposition = (struct lx_superposition){.scene = NULL};
}
