/* SPDX-License-Identifier: MIT */
/* Sampling of the screen and lines of sight; both axes go by the same rule, y downwards from the top. */
#include <float.h>
#include <math.h>
#include <string.h>

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

struct lx_camera lx_camera_of(const struct lx_observer *observer)
{
    struct lx_camera camera = {
        .frame = lx_observer_frame(observer),
        .z_mm = lx_observer_height(observer),
        .is_perspective = observer->projection == LX_PERSPECTIVE,
        .is_parallel = observer->projection == LX_ORTHOGRAPHIC && observer->view == LX_VIEW_PARALLEL,
    };
    if (camera.frame.is_own)
        camera.position_mm[2] = camera.z_mm;
    else
        memcpy(camera.position_mm, observer->position_mm, sizeof camera.position_mm);
    return camera;
}

struct lx_camera lx_camera_carried(const struct lx_camera *camera)
{
    struct lx_camera carried = *camera;
    carried.frame = lx_frame_own();
    carried.position_mm[0] = carried.position_mm[1] = 0;
    carried.position_mm[2] = camera->z_mm;
    return carried;
}

static struct lx_origin origin_of(const struct lx_camera *camera, bool endless)
{
    const lx_bounded3 *axis = &camera->frame.rounded[2];
    const double *at = camera->position_mm;
    if (endless)
        return (struct lx_origin){.endless = true, .at = {axis->x.value, axis->y.value, axis->z.value}};
    return (struct lx_origin){.at = {at[0], at[1], at[2]}};
}

struct lx_origin lx_eye(const struct lx_camera *camera)
{
    return origin_of(camera, !camera->is_perspective);
}

struct lx_origin lx_viewer(const struct lx_camera *camera)
{
    return origin_of(camera, camera->is_parallel);
}

lx_bounded3 lx_view_from(const struct lx_camera *camera, lx_bounded3 place_mm)
{
    if (camera->is_parallel)
        return camera->frame.rounded[2];
    return lx_unit3(lx_sub3(lx_exact3(camera->position_mm), place_mm));
}

/* Whether a screen stands along the axes of the scene: then none of its own are rounded. */
static bool is_straight(const struct lx_frame *frame)
{
    double errors = 0;
    for (int i = 0; i < 3; i++)
        errors += lx_error3(frame->rounded[i]);
    return errors == 0;
}

/* The sum of two wide numbers as a float64 number with its rounding; the sum of two float64 numbers itself has none. */
static void add_rounded(lx_wide a, lx_wide b, bool are_exact, double size, double *value, double *error)
{
    const lx_wide sum = lx_wide_add(a, b);
    const bool is_exact = are_exact && ((a.low == 0 && b.low == 0) || b.high == 0);
    *value = lx_wide_value(sum);
    *error =
        (fabs(lx_wide_value(lx_wide_sub(sum, lx_wide_of(*value)))) + (is_exact ? 0 : 0x1p-90 * size)) * LX_BOUND_SLACK;
}

static void add3_rounded(lx_wide3 a, lx_wide3 b, bool are_exact, double size, double value[3], double error[3])
{
    add_rounded(a.x, b.x, are_exact, size, &value[0], &error[0]);
    add_rounded(a.y, b.y, are_exact, size, &value[1], &error[1]);
    add_rounded(a.z, b.z, are_exact, size, &value[2], &error[2]);
}

/* The way on a carried screen from its middle to a point. */
static lx_wide3 on_screen(const struct lx_frame *frame, double x_mm, double y_mm)
{
    return lx_wide3_add(lx_wide3_mul(frame->axes[0], lx_wide_of(x_mm)), lx_wide3_mul(frame->axes[1], lx_wide_of(y_mm)));
}

struct lx_ray lx_line_of_sight(const struct lx_camera *camera, double x_mm, double y_mm)
{
    const double z_mm = camera->z_mm, *at = camera->position_mm;
    if (camera->frame.is_own && camera->is_perspective)
        return (struct lx_ray){.origin_mm = {0, 0, z_mm}, .direction = {x_mm, y_mm, -z_mm}};
    if (camera->frame.is_own)
        return (struct lx_ray){.origin_mm = {x_mm, y_mm, z_mm}, .direction = {0, 0, -1}};

    const lx_wide3 position = lx_wide3_of(at), aside = on_screen(&camera->frame, x_mm, y_mm);
    const double aside_mm = fabs(x_mm) + fabs(y_mm);
    const bool are_exact = is_straight(&camera->frame);
    struct lx_ray ray = {.origin_mm = {at[0], at[1], at[2]}};
    if (camera->is_perspective) {
        const lx_wide3 target = lx_wide3_of(camera->frame.origin_mm);
        add3_rounded(lx_wide3_sub(target, position), aside, are_exact, aside_mm + z_mm, ray.direction,
                     ray.direction_error);
        return ray;
    }
    const lx_bounded3 back = lx_negate3(camera->frame.rounded[2]);
    const lx_bounded parts[3] = {back.x, back.y, back.z};
    add3_rounded(position, aside, are_exact, aside_mm + fabs(at[0]) + fabs(at[1]) + fabs(at[2]), ray.origin_mm,
                 ray.origin_error);
    for (int i = 0; i < 3; i++) {
        ray.direction[i] = parts[i].value;
        ray.direction_error[i] = parts[i].error;
    }
    return ray;
}

double lx_scale_at(const struct lx_camera *camera, double height_mm)
{
    if (!camera->is_perspective)
        return 1;
    return height_mm < camera->z_mm ? camera->z_mm / (camera->z_mm - height_mm) : 0;
}

double lx_seen_at(const struct lx_camera *camera, const double place_mm[3], double screen_mm[2])
{
    double carried[3];
    lx_frame_carry(&camera->frame, place_mm, carried);
    const double scale = lx_scale_at(camera, carried[2]);
    screen_mm[0] = carried[0] * scale;
    screen_mm[1] = carried[1] * scale;
    return carried[2];
}

bool lx_project(const struct lx_camera *camera, const double place_mm[3], double screen_mm[2])
{
    double at[2];
    const double height = lx_seen_at(camera, place_mm, at);
    if (!(lx_scale_at(camera, height) > 0 && isfinite(height) && isfinite(at[0]) && isfinite(at[1])))
        return false;
    memcpy(screen_mm, at, sizeof at);
    return true;
}

bool lx_unproject(const struct lx_camera *camera, const double screen_mm[2], double height_mm, double place_mm[3])
{
    const double scale = lx_scale_at(camera, height_mm);
    const double carried[3] = {screen_mm[0] / scale, screen_mm[1] / scale, height_mm};
    if (!(scale > 0 && isfinite(height_mm) && isfinite(carried[0]) && isfinite(carried[1])))
        return false;
    lx_frame_bring(&camera->frame, carried, place_mm);
    return true;
}
