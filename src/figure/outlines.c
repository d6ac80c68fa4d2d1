/* SPDX-License-Identifier: MIT */
/* Outlines for programs that draw pictures of their own: those of figures, in finer steps, as plain arrays. */
#include <luxel/drawing.h>
#include <stdlib.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../exercise/parameter_tables.h"
#include "figure.h"

/* Steps of a contour: so many that a sphere looks round however far a program zooms in. */
enum { STEPS = 1440 };

/* The list that callers see comes first, so that a pointer to it is one to the whole. */
struct outlines {
    luxel_surface_outlines list;
    luxel_surface_outline *lines;
    double *places_mm;
};

void luxel_surface_outlines_free(luxel_surface_outlines *outlines)
{
    struct outlines *whole = (struct outlines *)outlines;
    if (!whole)
        return;
    free(whole->lines);
    free(whole->places_mm);
    free(whole);
}

/* Chains of one place are no lines. */
static bool is_line(const struct lx_figure_outline *outline)
{
    return outline->count >= 2;
}

static luxel_surface_outlines *copy(const struct lx_figure *figure)
{
    size_t places = 0, count = 0;
    struct outlines *whole = lx_new_array(1, sizeof *whole);
    for (size_t i = 0; i < figure->outline_count; i++)
        places += figure->outlines[i].count;
    if (!whole)
        return NULL;
    whole->lines = lx_new_array(figure->outline_count + 1, sizeof *whole->lines);
    whole->places_mm = lx_new_array(2 * places + 1, sizeof *whole->places_mm);
    if (!whole->lines || !whole->places_mm) {
        luxel_surface_outlines_free(&whole->list);
        return NULL;
    }
    double *at = whole->places_mm;
    for (size_t i = 0; i < figure->outline_count; i++) {
        const struct lx_figure_outline *outline = &figure->outlines[i];
        if (!is_line(outline))
            continue;
        whole->lines[count++] = (luxel_surface_outline){outline->count, at, at + outline->count};
        for (size_t k = 0; k < outline->count; k++) {
            at[k] = outline->places_mm[k][0];
            at[outline->count + k] = outline->places_mm[k][1];
        }
        at += 2 * outline->count;
    }
    whole->list = (luxel_surface_outlines){count, whole->lines};
    return &whole->list;
}

luxel_status luxel_find_surface_outlines(const luxel_scene *scene, luxel_diagnostics *diagnostics,
                                         luxel_surface_outlines **outlines)
{
    static const size_t nobody[1];
    luxel_settings dark; /* what is seen at a place costs as much as its light, so there is none */
    luxel_evaluator *evaluator = NULL;
    luxel_settings_init(&dark);
    dark.lights = nobody;
    *outlines = NULL;
    luxel_status status = luxel_evaluator_new(scene, &dark, diagnostics, &evaluator);
    struct lx_figure *figure = status == LUXEL_OK ? lx_new_array(1, sizeof *figure) : NULL;
    if (figure) {
        figure->scene = lx_scene_parameters(scene);
        *outlines = lx_figure_outline(figure, evaluator, STEPS) == 0 ? copy(figure) : NULL;
        lx_figure_free(figure);
    }
    if (status == LUXEL_OK && !*outlines)
        status = lx_out_of_memory(diagnostics);
    luxel_evaluator_free(evaluator);
    return status;
}
