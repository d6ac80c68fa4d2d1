/* SPDX-License-Identifier: MIT */
/* The outlines of surfaces: the rims of spheres and the edges of plates, where nothing stands before them. */
#include <math.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/pose.h"
#include "../surface/surface.h"
#include "figure.h"

/* Where a place is seen on the screen. */
static void project(const struct lx_observer *observer, const double place[3], double at[2])
{
    double scale = observer->projection == LX_PERSPECTIVE ? observer->z_mm / (observer->z_mm - place[2]) : 1;
    at[0] = place[0] * scale;
    at[1] = place[1] * scale;
}

static void cross(const double a[3], const double b[3], double product[3])
{
    product[0] = a[1] * b[2] - a[2] * b[1];
    product[1] = a[2] * b[0] - a[0] * b[2];
    product[2] = a[0] * b[1] - a[1] * b[0];
}

static void normalize(double a[3])
{
    double length = sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    for (int i = 0; i < 3; i++)
        a[i] /= length;
}

/* A point of a sphere's rim: where lines of sight touch it. */
static void rim_of_sphere(const struct lx_observer *observer, const struct lx_sphere_parameters *sphere, double turn,
                          double at[2])
{
    double front[3] = {0, 0, 1}, aside[3] = {1, 0, 0}, up[3] = {0, 1, 0}, height = 0, place[3];
    if (observer->projection == LX_PERSPECTIVE) {
        double distance;
        front[0] = -sphere->center_mm[0], front[1] = -sphere->center_mm[1];
        front[2] = observer->z_mm - sphere->center_mm[2];
        distance = sqrt(front[0] * front[0] + front[1] * front[1] + front[2] * front[2]);
        height = sphere->radius_mm / distance;
        normalize(front);
        cross(up, front, aside);
        normalize(aside);
        cross(front, aside, up);
    }
    double around = sqrt(1 - height * height);
    for (int i = 0; i < 3; i++)
        place[i] = sphere->center_mm[i] +
                   sphere->radius_mm * (height * front[i] + around * (cos(turn) * aside[i] + sin(turn) * up[i]));
    project(observer, place, at);
}

/* A point of a plate's edge, by a number from 0 to 4 around it. */
static void edge_of_plate(const struct lx_observer *observer, const struct lx_plate_parameters *plate, double turn,
                          double at[2])
{
    double axis[3], up[3], across[3], place[3], along = fmod(turn, 1);
    const double u[4] = {along, 1, 1 - along, 0}, v[4] = {0, along, 1, 1 - along};
    int side = (int)turn % 4;
    memcpy(axis, plate->axis, sizeof axis);
    memcpy(up, plate->up, sizeof up);
    normalize(axis);
    cross(up, axis, across);
    if (across[0] == 0 && across[1] == 0 && across[2] == 0) /* up along the axis: (0, 0, 1) takes its place */
        cross((const double[]){0, 0, 1}, axis, across);
    normalize(across);
    cross(axis, across, up);
    for (int i = 0; i < 3; i++)
        place[i] = plate->center_mm[i] + (u[side] - 0.5) * plate->size_mm[0] * across[i] +
                   (v[side] - 0.5) * plate->size_mm[1] * up[i];
    project(observer, place, at);
}

/* Whether what is seen a little inside the edge is this surface. */
static bool is_seen(const struct lx_figure *figure, const luxel_evaluator *evaluator, size_t surface,
                    const double at[2], const double center[2])
{
    const struct lx_screen *screen = &figure->scene->screen;
    double x = at[0] + 1e-3 * (center[0] - at[0]), y = at[1] + 1e-3 * (center[1] - at[1]);
    if (fabs(x) > screen->width_mm / 2 || fabs(y) > screen->height_mm / 2)
        return true; /* it is clipped */
    luxel_value value = luxel_evaluate(evaluator, x, y, NULL);
    return value.on_surface && value.surface == surface;
}

static int append(struct lx_outline *outline, const double at[2])
{
    if (lx_reserve((void **)&outline->places_mm, &outline->capacity, outline->count + 1, sizeof *outline->places_mm) <
        0)
        return -1;
    memcpy(outline->places_mm[outline->count++], at, sizeof *outline->places_mm);
    return 0;
}

static int add_place(struct lx_figure *figure, bool begins, const double at[2])
{
    if (begins) {
        if (lx_reserve((void **)&figure->outlines, &figure->outline_capacity, figure->outline_count + 1,
                       sizeof *figure->outlines) < 0)
            return -1;
        figure->outlines[figure->outline_count++] = (struct lx_outline){0};
    }
    return append(&figure->outlines[figure->outline_count - 1], at);
}

/* All contours run the same way round, so that together they enclose whatever one of them does. */
static void turn_round(struct lx_outline *contour)
{
    double area = 0;
    for (size_t i = 0; i < contour->count; i++) {
        const double *a = contour->places_mm[i], *b = contour->places_mm[(i + 1) % contour->count];
        area += a[0] * b[1] - a[1] * b[0];
    }
    for (size_t i = 0; area < 0 && i < contour->count / 2; i++) {
        double *a = contour->places_mm[i], *b = contour->places_mm[contour->count - 1 - i];
        const double kept[2] = {a[0], a[1]};
        memcpy(a, b, sizeof kept);
        memcpy(b, kept, sizeof kept);
    }
}

int lx_figure_outline(struct lx_figure *figure, const luxel_evaluator *evaluator, int steps)
{
    const struct lx_list *surfaces = &figure->scene->surfaces;
    const struct lx_observer *observer = &figure->scene->observer;
    figure->contours = lx_new_array(surfaces->count + 1, sizeof *figure->contours);
    if (!figure->contours)
        return -1;
    for (size_t s = 0; s < surfaces->count; s++) {
        const struct lx_item *surface = &surfaces->items[s];
        bool round = strcmp(surface->variant->name, "sphere") == 0, open = false;
        double center[2];
        project(observer,
                round ? ((const struct lx_sphere_parameters *)surface->parameters)->center_mm
                      : ((const struct lx_plate_parameters *)surface->parameters)->center_mm,
                center);
        for (int i = 0; i <= steps; i++) {
            double at[2];
            if (round)
                rim_of_sphere(observer, surface->parameters, 2 * M_PI * i / steps, at);
            else
                edge_of_plate(observer, surface->parameters, fmod(4.0 * i / steps, 4), at);
            bool seen = is_seen(figure, evaluator, s, at, center);
            if ((i > 0 && append(&figure->contours[s], at) < 0) || (seen && add_place(figure, !open, at) < 0))
                return -1;
            open = seen;
        }
        turn_round(&figure->contours[s]);
        figure->contour_count = s + 1;
    }
    return 0;
}
