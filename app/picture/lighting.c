/* SPDX-License-Identifier: MIT */
/* Measuring and judging by the library, entry by entry of the scene's lists. */
#include "lighting.h"

#include <math.h>
#include <string.h>

#include "../../front/words.h"

/* Four digits are shown, with their bounds. */
static const double TOLERANCE = 1e-5;
static const double LEAST_AREA = 0.02; /* of what a plane shows, seen aslant */

luxel_verdict app_limits_verdict(const luxel_limit *limits, gsize count)
{
    return count > 0 ? luxel_worst_limit(limits, count).verdict : LUXEL_PASS;
}

/* ---- grids ---- */

static double greatest(const luxel_grid *grid)
{
    return grid && grid->measured > 0 ? grid->maximum.value : 0;
}

static void clear_grids(gpointer data)
{
    AppGrids *grids = data;
    for (gsize i = 0; i < grids->count; i++)
        luxel_grid_free(grids->list[i].grid);
    g_free(grids->list);
    app_moment_unref(grids->moment);
}

AppGrids *app_grids_new(AppMoment *moment, const luxel_settings *settings)
{
    const gsize count = luxel_scene_grid_count(moment->scene);
    luxel_settings own = *settings;
    AppGrids *grids = g_atomic_rc_box_new0(AppGrids);
    own.tolerance = TOLERANCE;
    grids->moment = app_moment_ref(moment);
    grids->list = g_new0(AppGrid, count);
    while (grids->count < count) {
        AppGrid *grid = &grids->list[grids->count];
        if (luxel_find_grid_values(moment->scene, &own, grids->count, NULL, &grid->grid) != LUXEL_OK) {
            app_grids_unref(grids);
            return NULL;
        }
        luxel_judge_grid_and_areas(moment->scene, grids->count++, grid->grid, grid->limits, &grid->limit_count);
        grids->most = MAX(grids->most, greatest(grid->grid));
        grids->most = MAX(grids->most, greatest(grid->grid->surround));
        grids->most = MAX(grids->most, greatest(grid->grid->background));
    }
    return grids;
}

AppGrids *app_grids_ref(AppGrids *grids)
{
    return grids ? g_atomic_rc_box_acquire(grids) : NULL;
}

void app_grids_unref(AppGrids *grids)
{
    if (grids)
        g_atomic_rc_box_release_full(grids, clear_grids);
}

gboolean app_grid_find_cell(const luxel_grid *grid, int other, const double place_mm[3], gsize *cell)
{
    const double area = grid->across[0] * grid->up[other] - grid->across[other] * grid->up[0];
    const double x = place_mm[0] - grid->center_mm[0], y = place_mm[other] - grid->center_mm[other];
    if (fabs(area) < LEAST_AREA)
        return FALSE;
    const double along = (x * grid->up[other] - y * grid->up[0]) / area;
    const double up = (y * grid->across[0] - x * grid->across[other]) / area;
    const double column = floor((along / grid->size_mm[0] + 0.5) * grid->columns);
    const double row = floor((0.5 - up / grid->size_mm[1]) * grid->rows);
    if (!(column >= 0 && column < grid->columns && row >= 0 && row < grid->rows))
        return FALSE;
    *cell = (gsize)row * grid->columns + (gsize)column;
    return grid->mask[*cell];
}

char *app_grid_name(const AppGrids *grids, gsize i)
{
    const char *name = grids->list[i].grid->name;
    return name ? g_strdup(name) : g_strdup_printf(_("grid %zu"), i + 1);
}

/* ---- observers ---- */

static void clear_eyes(gpointer data)
{
    AppEyes *eyes = data;
    g_free(eyes->list);
    app_moment_unref(eyes->moment);
}

/* Rates one place and keeps what is worse than before. */
static gboolean rate(const luxel_scene *scene, const luxel_settings *settings, gsize i, AppEye *eye)
{
    luxel_limit limits[LUXEL_MOST_LIMITS];
    luxel_glare_sight sight;
    luxel_glare *glare = NULL;
    gsize count = 0;
    luxel_scene_observer(scene, i, NULL, &sight);
    if (luxel_find_glare(scene, settings, &sight, NULL, &glare) != LUXEL_OK)
        return FALSE;
    if (glare->has_rating && (!eye->has_rating || glare->rating.value > eye->rating.value)) {
        eye->has_rating = TRUE;
        eye->rating = glare->rating;
    }
    luxel_judge_glare(scene, i, glare, limits, &count);
    for (gsize k = 0; k < count; k++)
        eye->limits[k] = k < eye->limit_count
                             ? luxel_worst_limit((const luxel_limit[]){eye->limits[k], limits[k]}, 2)
                             : limits[k];
    eye->limit_count = count;
    luxel_glare_free(glare);
    return TRUE;
}

AppEyes *app_eyes_new(AppMoment *moment, const luxel_settings *settings)
{
    const luxel_scene *scene = moment->scene;
    const gsize all = luxel_scene_observer_count(scene);
    luxel_observer_places places = {.count = 1};
    AppEyes *eyes = g_atomic_rc_box_new0(AppEyes);
    eyes->moment = app_moment_ref(moment);
    eyes->list = g_new0(AppEye, all);
    for (gsize i = 0; i < all; i += places.count) {
        AppEye *eye = &eyes->list[eyes->count++];
        luxel_scene_observer(scene, i, NULL, &eye->sight);
        luxel_scene_observer_places(scene, i, &places);
        eye->places = places.count;
        for (gsize k = i; k < i + places.count; k++)
            if (!rate(scene, settings, k, eye)) {
                app_eyes_unref(eyes);
                return NULL;
            }
    }
    return eyes;
}

AppEyes *app_eyes_ref(AppEyes *eyes)
{
    return eyes ? g_atomic_rc_box_acquire(eyes) : NULL;
}

void app_eyes_unref(AppEyes *eyes)
{
    if (eyes)
        g_atomic_rc_box_release_full(eyes, clear_eyes);
}

char *app_eye_name(const AppEyes *eyes, gsize i)
{
    const char *name = NULL;
    gsize first = 0;
    for (gsize k = 0; k < i; k++)
        first += eyes->list[k].places;
    luxel_scene_observer(eyes->moment->scene, first, &name, NULL);
    return name ? g_strdup(name) : g_strdup_printf(_("observer %zu"), i + 1);
}
