/* SPDX-License-Identifier: MIT */
/* Areas in the space view, which are left out where bodies stand before them: panels, cones, measuring grids. */
#include <math.h>

#include "grid_draw.h"
#include "space_view_private.h"

enum { COARSE = 2 /* dots across of an area that are hidden together */ };

/* In perspective the inverse of the distance changes evenly over the picture of a plane: its value at the origin of the
 * widget and its steps by a dot; FALSE: the plane is seen on edge. */
static gboolean find_slope(const AppSpaceView *self, const double (*plane)[3], double slope[3])
{
    double seen[3][3], inverse[3];
    for (int i = 0; i < 3; i++) {
        if (!app_orbit_see(app_space_view_orbit(self), plane[i], seen[i]))
            return FALSE;
        inverse[i] = 1 / seen[i][2];
    }
    const double u[2] = {seen[1][0] - seen[0][0], seen[1][1] - seen[0][1]};
    const double v[2] = {seen[2][0] - seen[0][0], seen[2][1] - seen[0][1]};
    const double p = inverse[1] - inverse[0], q = inverse[2] - inverse[0], area = u[0] * v[1] - u[1] * v[0];
    if (fabs(area) < 1e-6)
        return FALSE;
    slope[1] = (p * v[1] - q * u[1]) / area;
    slope[2] = (q * u[0] - p * v[0]) / area;
    slope[0] = inverse[0] - slope[1] * seen[0][0] - slope[2] * seen[0][1];
    return TRUE;
}

/* Where no body stands before a plane, as a mask of a part of the widget. */
static cairo_surface_t *new_mask(const AppSpaceView *self, const double slope[3], const int part[4])
{
    const int columns = part[2] / COARSE + 1, rows = part[3] / COARSE + 1;
    cairo_surface_t *mask = cairo_image_surface_create(CAIRO_FORMAT_A8, columns, rows);
    guchar *bytes = cairo_image_surface_get_data(mask);
    const int stride = cairo_image_surface_get_stride(mask);
    for (int row = 0; row < rows; row++)
        for (int column = 0; column < columns; column++) {
            const double x = part[0] + (column + 0.5) * COARSE, y = part[1] + (row + 0.5) * COARSE;
            const double depth = app_lit_depth(self->lit, x, y);
            const gboolean is_before = depth > 0 && 1 / depth > slope[0] + slope[1] * x + slope[2] * y + 1e-9;
            bytes[row * stride + column] = is_before ? 0 : 255;
        }
    cairo_surface_mark_dirty(mask);
    return mask;
}

void app_space_view_fill(const AppSpaceView *self, cairo_t *cairo, const double (*outline)[3], gsize count,
                         const double (*plane)[3])
{
    double slope[3], low[2], high[2];
    for (gsize i = 0; i < count; i++) {
        double seen[3];
        if (!app_orbit_see(app_space_view_orbit(self), outline[i], seen)) {
            cairo_new_path(cairo);
            return;
        }
        cairo_line_to(cairo, seen[0], seen[1]);
    }
    cairo_close_path(cairo);
    cairo_save(cairo);
    cairo_clip(cairo);
    cairo_clip_extents(cairo, &low[0], &low[1], &high[0], &high[1]);
    const int part[4] = {(int)floor(low[0]), (int)floor(low[1]), (int)ceil(high[0] - low[0]),
                         (int)ceil(high[1] - low[1])};
    if (part[2] > 0 && part[3] > 0 && self->lit && self->lit->moment && find_slope(self, plane, slope)) {
        cairo_surface_t *mask = new_mask(self, slope, part);
        cairo_pattern_t *pattern = cairo_pattern_create_for_surface(mask);
        cairo_matrix_t matrix;
        cairo_matrix_init_scale(&matrix, 1.0 / COARSE, 1.0 / COARSE);
        cairo_matrix_translate(&matrix, -part[0], -part[1]);
        cairo_pattern_set_matrix(pattern, &matrix);
        cairo_mask(cairo, pattern);
        cairo_pattern_destroy(pattern);
        cairo_surface_destroy(mask);
    } else
        cairo_paint(cairo);
    cairo_restore(cairo);
}

/* ---- grids ---- */

static gboolean see(gconstpointer from, const double place_mm[3], double at[2])
{
    double seen[3];
    const gboolean is_seen = app_orbit_see(from, place_mm, seen);
    at[0] = seen[0];
    at[1] = seen[1];
    return is_seen;
}

void app_space_view_draw_grids(AppSpaceView *self, cairo_t *cairo)
{
    const AppGrids *grids = self->sight.grids;
    const AppOrbit *orbit = app_space_view_orbit(self);
    if (!grids || !self->picture)
        return;
    const double opacity = app_sight_grid_opacity(&self->sight, self->picture->shot->moment);
    const AppGridSight sight = {cairo, GTK_WIDGET(self), see, orbit, opacity};
    for (gsize i = 0; i < grids->count; i++) {
        const AppGrid *grid = &grids->list[i];
        const luxel_grid *outermost = grid->grid->background ? grid->grid->background
                                      : grid->grid->surround ? grid->grid->surround
                                                             : grid->grid;
        double corners[4][3];
        app_grid_corners(outermost, corners);
        cairo_push_group(cairo);
        app_grid_draw(&sight, grid, grids->most);
        cairo_pop_group_to_source(cairo);
        app_space_view_fill(self, cairo, (const double(*)[3])corners, 4, (const double(*)[3])corners);
    }
}
