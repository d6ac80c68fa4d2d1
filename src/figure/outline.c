/* SPDX-License-Identifier: MIT */
/* The outlines of surfaces, as their kinds draw them, where nothing stands before them. */
#include <math.h>
#include <string.h>

#include "../base/memory.h"
#include "../shade/camera.h"
#include "figure.h"

/* Whether what is seen a little inside the edge is this surface. */
static bool is_seen(const struct lx_figure *figure, const luxel_evaluator *evaluator, size_t surface,
                    const double inside[2])
{
    const struct lx_screen *screen = &figure->scene->screen;
    if (fabs(inside[0]) > screen->width_mm / 2 || fabs(inside[1]) > screen->height_mm / 2)
        return true; /* it is clipped */
    luxel_value value = luxel_evaluate(evaluator, inside[0], inside[1], NULL);
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
    /* surfaces are carried into the frame of the screen, where kinds draw what the observer sees of them */
    const struct lx_camera camera = lx_camera_of(&figure->scene->observer), own = lx_camera_carried(&camera);
    const struct lx_origin eye = lx_eye(&own);
    figure->contours = lx_new_array(surfaces->count + 1, sizeof *figure->contours);
    if (!figure->contours)
        return -1;
    for (size_t s = 0; s < surfaces->count; s++) {
        const struct lx_item *surface = &surfaces->items[s];
        const struct lx_surface_kind *kind = (const struct lx_surface_kind *)surface->variant;
        const struct lx_shape in_scene = lx_surface_shape(kind, surface->parameters);
        const struct lx_shape shape = lx_shape_carried(&in_scene, &camera.frame);
        bool open = false;
        for (int i = 0; kind->outline && i <= steps; i++) {
            double place[3], inside[3], at[2], inner[2];
            kind->outline(&shape, &eye, i, steps, place, inside);
            lx_seen_at(&own, place, at);
            lx_seen_at(&own, inside, inner);
            bool seen = is_seen(figure, evaluator, s, inner);
            if ((i > 0 && append(&figure->contours[s], at) < 0) || (seen && add_place(figure, !open, at) < 0))
                return -1;
            open = seen;
        }
        turn_round(&figure->contours[s]);
        figure->contour_count = s + 1;
    }
    return 0;
}
