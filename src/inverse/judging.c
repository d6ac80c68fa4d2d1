/* SPDX-License-Identifier: MIT */
/* Layouts judged by their own scenes: limits of grids, of the areas around them and of observers, with bounds. */
#include "arranging.h"

#include <math.h>
#include <stdlib.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"

void lx_computed_clear(struct lx_computed *computed)
{
    free((luxel_layout_limit *)computed->layout.limits);
    free((double *)computed->layout.numbers);
    luxel_scene_free(computed->scene);
}

void lx_end_part(struct lx_arranging *arranging)
{
    arranging->done += (1 - arranging->done) / 8;
}

static luxel_status judge_observers(struct lx_arranging *arranging, const luxel_scene *scene,
                                    const luxel_settings *settings, luxel_layout *told, luxel_layout_limit *limits)
{
    luxel_status status = LUXEL_OK;
    for (size_t i = 0; i < luxel_scene_observer_count(scene) && status == LUXEL_OK; i++) {
        luxel_limit judged[LUXEL_MOST_LIMITS];
        luxel_glare_sight sight;
        luxel_glare *glare = NULL;
        size_t count = 0;
        luxel_judge_glare(scene, i, &(luxel_glare){.has_rating = false}, judged, &count);
        if (count == 0) /* it has no limit */
            continue;
        luxel_scene_observer(scene, i, NULL, &sight);
        status = luxel_find_glare(scene, settings, &sight, arranging->diagnostics, &glare);
        if (status == LUXEL_OK)
            status = luxel_judge_glare(scene, i, glare, judged, &count);
        for (size_t k = 0; status == LUXEL_OK && k < count; k++)
            limits[told->limit_count++] = (luxel_layout_limit){.is_observer = true, .index = i, .limit = judged[k]};
        luxel_glare_free(glare);
    }
    return status;
}

/* Computes the limits of a layout's scene; `limits` has room for all. */
static luxel_status judge_scene(struct lx_arranging *arranging, const luxel_scene *scene,
                                const luxel_settings *settings, luxel_layout *told, luxel_layout_limit *limits,
                                bool *grids_pass)
{
    told->limit_count = 0;
    luxel_status status =
        lx_measure_goals(&arranging->superposition, scene, settings, arranging->values, limits, &told->limit_count);
    if (status == LUXEL_OK)
        status = judge_observers(arranging, scene, settings, told, limits);
    told->reaches = true;
    *grids_pass = true;
    told->is_undecided = false;
    told->reserve = HUGE_VAL;
    for (size_t i = 0; i < told->limit_count; i++) {
        told->reaches = told->reaches && limits[i].limit.verdict == LUXEL_PASS;
        *grids_pass = *grids_pass && (limits[i].is_observer || limits[i].limit.verdict == LUXEL_PASS);
        told->is_undecided = told->is_undecided || limits[i].limit.verdict == LUXEL_UNDECIDED;
        told->reserve = fmin(told->reserve, lx_goal_reserve_of(&limits[i].limit));
    }
    lx_end_part(arranging);
    return status;
}

luxel_status lx_judge_layout(struct lx_arranging *arranging, double reflected_error, struct lx_computed *computed)
{
    const luxel_scene *goals = arranging->made->goals;
    const size_t most = luxel_scene_grid_count(goals) * LX_GOALS_OF_GRID + luxel_scene_observer_count(goals) + 1;
    luxel_layout_limit *limits = lx_new_array(most, sizeof *limits);
    luxel_settings coarse = arranging->settings;
    luxel_layout *told = &computed->layout;
    told->limits = limits;
    if (!limits)
        return lx_out_of_memory(arranging->diagnostics);
    /* one solution for all that is asked */
    coarse.share_reflected = arranging->reflects;
    coarse.reflected_error = fmax(coarse.reflected_error, reflected_error);
    luxel_status status = judge_scene(arranging, computed->scene, &coarse, told, limits, &computed->grids_pass);
    if (status == LUXEL_OK && arranging->reflects && told->is_undecided && reflected_error <= LX_COARSE)
        status = judge_scene(arranging, computed->scene, &arranging->settings, told, limits, &computed->grids_pass);
    return status;
}
