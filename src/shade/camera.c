/* SPDX-License-Identifier: MIT */
/* Sampling of the screen and lines of sight; both axes go by the same rule, y downwards from the top. */
#include <float.h>
#include <math.h>

#include "camera.h"

/* Distance of sample i of n from the edge of an axis that is `length` long. */
static double sample_position(int sampling, double length, unsigned n, unsigned i)
{
    if (sampling == LX_CENTERS)
        return (i + 0.5) * length / n;
    return n > 1 ? i * length / (n - 1) : length / 2; /* a single node has no edges to lie on */
}

double lx_column_x_mm(const struct lx_screen *screen, unsigned column)
{
    return -screen->width_mm / 2 + sample_position(screen->sampling, screen->width_mm, screen->resolution[0], column);
}

double lx_row_y_mm(const struct lx_screen *screen, unsigned row)
{
    return screen->height_mm / 2 - sample_position(screen->sampling, screen->height_mm, screen->resolution[1], row);
}

/*
 * The sample whose cell holds a distance from the edge; a border between cells belongs to the one after it, the far
 * edge of the screen to the last.  Decimal numbers are seldom what they were written as: a place is on a border if it
 * differs by no more than roundings.
 */
static bool sample_at(int sampling, double length, unsigned n, double distance, unsigned *i)
{
    if (!(distance >= 0 && distance <= length))
        return false;
    const double roundings = 4 * DBL_EPSILON * n;
    const double cells = sampling == LX_NODES ? distance * (n - 1) / length + 0.5 : distance * n / length;
    const double border = round(cells), place = fabs(cells - border) <= roundings ? border : floor(cells);
    *i = place < n ? (unsigned)place : n - 1;
    return true;
}

bool lx_pixel_at(const struct lx_screen *screen, double x_mm, double y_mm, unsigned *column, unsigned *row)
{
    return sample_at(screen->sampling, screen->width_mm, screen->resolution[0], x_mm + screen->width_mm / 2, column) &&
           sample_at(screen->sampling, screen->height_mm, screen->resolution[1], screen->height_mm / 2 - y_mm, row);
}

bool lx_views_along_z(const struct lx_observer *observer)
{
    return observer->projection == LX_ORTHOGRAPHIC && observer->view == LX_VIEW_PARALLEL;
}

static struct lx_origin origin_of(const struct lx_observer *observer, bool endless)
{
    return (struct lx_origin){.endless = endless, .at = {0, 0, endless ? 1 : observer->z_mm}};
}

struct lx_origin lx_eye(const struct lx_observer *observer)
{
    return origin_of(observer, observer->projection == LX_ORTHOGRAPHIC);
}

struct lx_origin lx_viewer(const struct lx_observer *observer)
{
    return origin_of(observer, lx_views_along_z(observer));
}

struct lx_ray lx_line_of_sight(const struct lx_observer *observer, double x_mm, double y_mm)
{
    if (observer->projection == LX_PERSPECTIVE)
        return (struct lx_ray){.origin_mm = {0, 0, observer->z_mm}, .direction = {x_mm, y_mm, -observer->z_mm}};
    return (struct lx_ray){.origin_mm = {x_mm, y_mm, observer->z_mm}, .direction = {0, 0, -1}};
}

double lx_scale_at(const struct lx_observer *observer, double z_mm)
{
    if (observer->projection == LX_ORTHOGRAPHIC)
        return 1;
    return z_mm < observer->z_mm ? observer->z_mm / (observer->z_mm - z_mm) : 0;
}

bool lx_project(const struct lx_observer *observer, const double place_mm[3], double screen_mm[2])
{
    double scale = lx_scale_at(observer, place_mm[2]), x = place_mm[0] * scale, y = place_mm[1] * scale;
    if (!(scale > 0 && isfinite(place_mm[2]) && isfinite(x) && isfinite(y)))
        return false;
    screen_mm[0] = x;
    screen_mm[1] = y;
    return true;
}

bool lx_unproject(const struct lx_observer *observer, const double screen_mm[2], double z_mm, double place_mm[3])
{
    double scale = lx_scale_at(observer, z_mm), x = screen_mm[0] / scale, y = screen_mm[1] / scale;
    if (!(scale > 0 && isfinite(z_mm) && isfinite(x) && isfinite(y)))
        return false;
    place_mm[0] = x;
    place_mm[1] = y;
    place_mm[2] = z_mm;
    return true;
}
