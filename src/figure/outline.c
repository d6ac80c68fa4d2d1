/* SPDX-License-Identifier: MIT */
/* The outlines of surfaces, as their kinds draw them, where nothing stands before them. */
#include <math.h>
#include <string.h>

#include "../base/memory.h"
#include "../world/camera.h"
#include "../world/evaluate.h"
#include "figure.h"

/* Whether what is seen a little inside the edge is this surface. */
static bool is_seen(const struct lx_figure *figure, const luxel_evaluator *evaluator,
                    const struct lx_prepared_surface *surface, const double inside[2])
{
    const struct lx_screen *screen = &figure->scene->screen;
    if (fabs(inside[0]) > screen->width_mm / 2 || fabs(inside[1]) > screen->height_mm / 2)
        return true; /* it is clipped */
    luxel_value value;
    luxel_trace_screen(evaluator, inside[0], inside[1], &value);
    return value.on_surface && value.surface == surface->authored && value.part == surface->part;
}

static int append(struct lx_figure_outline *outline, const double at[2])
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
        figure->outlines[figure->outline_count++] = (struct lx_figure_outline){0};
    }
    return append(&figure->outlines[figure->outline_count - 1], at);
}

/* All contours run the same way round, so that together they enclose whatever one of them does. */
static void turn_round(struct lx_figure_outline *contour)
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

/* What an observer in perspective has before him ends here: what is higher is drawn nowhere. */
static double highest_seen(const struct lx_camera *camera)
{
    static const double NEAREST = 1e-2; /* of the observer's height: lines from there lead far beyond the screen */
    return camera->is_perspective ? (1 - NEAREST) * camera->z_mm : HUGE_VAL;
}

/* Where a way passes that height, on the screen; false: nowhere. */
static bool cut_way(const struct lx_camera *camera, const double place[3], const double next[3], double at[2])
{
    const double level = highest_seen(camera);
    double cut[3];
    if ((place[2] < level) == (next[2] < level))
        return false;
    const double share = (level - place[2]) / (next[2] - place[2]);
    for (int i = 0; i < 3; i++)
        cut[i] = place[i] + share * (next[i] - place[i]);
    lx_seen_at(camera, cut, at);
    return true;
}

/* What is drawn of one part of a surface, in the frame of the screen. */
struct drawing_of {
    struct lx_figure *figure;
    const luxel_evaluator *evaluator;
    const struct lx_prepared_surface *surface;
    struct lx_figure_outline *contour;
    struct lx_camera camera;
    bool is_open; /* the last place was drawn */
};

static int draw_place(struct drawing_of *drawing, bool is_first, const double at[2], const double inner[2])
{
    const bool seen = is_seen(drawing->figure, drawing->evaluator, drawing->surface, inner);
    if ((!is_first && append(drawing->contour, at) < 0) ||
        (seen && add_place(drawing->figure, !drawing->is_open, at) < 0))
        return -1;
    drawing->is_open = seen;
    return 0;
}

static int draw_outline(struct drawing_of *drawing, const struct lx_shape *shape, int steps)
{
    const struct lx_camera *camera = &drawing->camera;
    const struct lx_origin eye = lx_eye(camera);
    double place[3], inside[3], before[3] = {0, 0, 0}, at[2], inner[2];
    for (int i = 0; i <= steps; i++) {
        shape->kind->outline(shape, &eye, i, steps, place, inside);
        if (i > 0 && cut_way(camera, before, place, at) && draw_place(drawing, false, at, at) < 0)
            return -1;
        memcpy(before, place, sizeof before);
        if (!(place[2] < highest_seen(camera))) {
            drawing->is_open = false;
            continue;
        }
        lx_seen_at(camera, place, at);
        lx_seen_at(camera, inside, inner);
        if (draw_place(drawing, i == 0, at, inner) < 0)
            return -1;
    }
    turn_round(drawing->contour);
    return 0;
}

int lx_figure_outline(struct lx_figure *figure, const luxel_evaluator *evaluator, int steps)
{
    const struct lx_prepared *prepared = &evaluator->prepared;
    /* surfaces are carried into the frame of the screen, where kinds draw what the observer sees of them */
    const struct lx_camera *camera = &prepared->camera, own = lx_camera_carried(camera);
    const struct lx_origin eye = lx_eye(&own);
    figure->contours = lx_new_array(prepared->surface_count + 1, sizeof *figure->contours);
    if (!figure->contours)
        return -1;
    for (size_t s = 0; s < prepared->surface_count; s++) {
        const struct lx_prepared_surface *surface = &prepared->surfaces[s];
        const struct lx_shape shape = lx_shape_carried(&surface->shape, &camera->frame);
        struct drawing_of drawing = {figure, evaluator, surface, &figure->contours[s], own, false};
        figure->contour_count = s + 1;
        if (surface->kind->outline && lx_shape_faces(&shape, &eye) && draw_outline(&drawing, &shape, steps) < 0)
            return -1;
    }
    return 0;
}
