/* SPDX-License-Identifier: MIT */
/* Computing what the figure of a measuring plane shows: the values of its grid, the field between them, its axes, and
 * where lights stand in front of it. */
#include <math.h>
#include <stdlib.h>

#include <luxel/light.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/phrase.h"
#include "../base/vector.h"
#include "../light/array.h"
#include "figure.h"

/* The scene whose plane is measured. */
const luxel_scene *lx_figure_measured(const struct lx_figure *figure)
{
    return figure->daylit ? figure->daylit : figure->copy;
}

void lx_plane_free(struct lx_figure_plane *plane)
{
    if (!plane)
        return;
    luxel_grid_free(plane->grid);
    free(plane->lamps);
    free(plane->caption);
    free(plane);
}

/* ---- axes ---- */

/* The axis of the scene along which a direction runs; 3: none. */
static int axis_along(const double direction[3])
{
    for (int k = 0; k < 3; k++)
        if (fabs(direction[k]) > 1 - 1e-12)
            return k;
    return 3;
}

/* The scene's coordinates along a side of the plane that runs along an axis, else lengths from the middle. */
static void set_axis(struct lx_figure *figure, int side)
{
    static const char *const along[] = {LX_N("x, mm"), LX_N("y, mm"), LX_N("z, mm")};
    static const char *const beside[] = {LX_N("across from the middle, mm"), LX_N("up from the middle, mm")};
    const luxel_grid *grid = figure->plane->grid;
    const double *direction = side == 0 ? grid->across : grid->up, half = grid->size_mm[side] / 2;
    const int axis = axis_along(direction);
    const double middle = axis < 3 ? grid->center_mm[axis] : 0, sign = axis < 3 && direction[axis] < 0 ? -1 : 1;
    figure->size_mm[side] = grid->size_mm[side];
    figure->axes[side] = (struct lx_scale){.low = middle - sign * half, .high = middle + sign * half};
    figure->axis_names[side] = axis < 3 ? along[axis] : beside[side];
}

/* ---- lights ---- */

/* A light, or a place of its array, where that stands in front of the plane. */
static void add_lamp(struct lx_figure_plane *plane, size_t light, const double place[3])
{
    const luxel_grid *grid = plane->grid;
    double away[3];
    for (int k = 0; k < 3; k++)
        away[k] = place[k] - grid->center_mm[k];
    const struct lx_lamp lamp = {.place_mm = {lx_dot(away, grid->across), lx_dot(away, grid->up)}, .light = light};
    if (lx_dot(away, grid->axis) > 0 && fabs(lamp.place_mm[0]) <= grid->size_mm[0] / 2 &&
        fabs(lamp.place_mm[1]) <= grid->size_mm[1] / 2)
        plane->lamps[plane->lamp_count++] = lamp;
}

/* The lights that stand in front of the plane, where they stand over it. */
static int find_lamps(struct lx_figure *figure)
{
    struct lx_figure_plane *plane = figure->plane;
    const struct lx_list *lights = &lx_scene_parameters(lx_figure_measured(figure))->lights;
    size_t most = 1;
    for (size_t i = 0; i < lights->count; i++)
        most += lx_light_places(&lights->items[i]);
    plane->lamps = lx_new_array(most, sizeof *plane->lamps);
    for (size_t i = 0; plane->lamps && i < lights->count; i++) {
        double(*places_mm)[3] =
            luxel_scene_light_enabled(lx_figure_measured(figure), i) ? lx_light_find_places(&lights->items[i]) : NULL;
        for (size_t k = 0; places_mm && k < lx_light_places(&lights->items[i]); k++)
            add_lamp(plane, i, places_mm[k]);
        free(places_mm);
    }
    return plane->lamps ? 0 : -1;
}

/* ---- the field ---- */

/* The whole plane, as the contour of what has colours. */
static int make_contour(struct lx_figure *figure)
{
    struct lx_figure_outline *contour = figure->contours = lx_new_array(1, sizeof *figure->contours);
    if (!contour)
        return -1;
    figure->contour_count = 1;
    contour->places_mm = lx_new_array(4, sizeof *contour->places_mm);
    if (!contour->places_mm)
        return -1;
    contour->count = contour->capacity = 4;
    for (int i = 0; i < 4; i++) {
        contour->places_mm[i][0] = figure->size_mm[0] * (i == 1 || i == 2 ? 0.5 : -0.5);
        contour->places_mm[i][1] = figure->size_mm[1] * (i > 1 ? 0.5 : -0.5);
    }
    return 0;
}

/* The maximum on the plane, where it is known between the points, else that of the points. */
static luxel_status find_maximum(struct lx_figure *figure, const luxel_settings *settings,
                                 luxel_diagnostics *diagnostics)
{
    struct lx_figure_plane *plane = figure->plane;
    const luxel_grid *grid = plane->grid;
    luxel_peak *maximum = &figure->extrema.maximum;
    double away[3];
    const luxel_status status = luxel_find_grid_extrema(lx_figure_measured(figure), settings, figure->settings.grid - 1,
                                                        diagnostics, &plane->extrema);
    for (int k = 0; k < 3; k++)
        away[k] = grid->maximum.position_mm[k] - grid->center_mm[k];
    *maximum = (luxel_peak){.exists = grid->measured > 0,
                            .value = grid->maximum.value,
                            .x_mm = lx_dot(away, grid->across),
                            .y_mm = lx_dot(away, grid->up)};
    if (plane->extrema.maximum.exists) {
        maximum->value = plane->extrema.maximum.value;
        maximum->x_mm = plane->extrema.maximum.on_plane_mm[0];
        maximum->y_mm = plane->extrema.maximum.on_plane_mm[1];
    }
    return status;
}

luxel_status lx_figure_plane(struct lx_figure *figure, const luxel_settings *settings, luxel_diagnostics *diagnostics)
{
    figure->settings.section = LUXEL_SECTION_NONE; /* those are of the picture */
    figure->plane = lx_new_array(1, sizeof *figure->plane);
    if (!figure->plane)
        return lx_out_of_memory(diagnostics);
    const luxel_settings whole = lx_whole_picture(settings);
    const size_t number = figure->settings.grid - 1;
    const luxel_scene *measured = lx_figure_measured(figure);
    luxel_status status = luxel_find_grid_values(measured, settings, number, diagnostics, &figure->plane->grid);
    if (status != LUXEL_OK)
        return status;
    for (int side = 0; side < 2; side++)
        set_axis(figure, side);
    status = find_maximum(figure, settings, diagnostics);
    if (status == LUXEL_OK)
        status = luxel_find_grid_field(measured, &whole, number, 0, 0, diagnostics, &figure->own.field);
    if (status == LUXEL_OK && (make_contour(figure) < 0 || find_lamps(figure) < 0))
        status = lx_out_of_memory(diagnostics);
    return status;
}
