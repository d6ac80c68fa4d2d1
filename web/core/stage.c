/* SPDX-License-Identifier: MIT */
/*
 * The stage: the present scene as another camera sees it, lit by the same sums as the picture, with the distance of
 * what each pixel shows, and the exact value at a place of it.
 */
#include <stdio.h>
#include <stdlib.h>

#include "answer.h"
#include "core.h"

/* What the page tells of a camera, which looks at the middle of a screen through its target; all in mm. */
enum { EYE = 0, TARGET = 3, UP = 6, WIDTH = 9, HEIGHT = 10 };

static luxel_scene *stage;       /* the scene with the camera; NULL: none */
static luxel_field *stage_field; /* NULL: none */
static float *stage_depth;       /* NULL: none */

void drop_stage(void)
{
    luxel_scene_free(stage);
    stage = NULL;
}

static bool takes(const char *assignment)
{
    return luxel_scene_set(stage, assignment, core.diagnostics) == LUXEL_OK;
}

/* Puts the camera into a copy of the scene; false where it can see nothing, as from inside of a body. */
static bool look(const double *camera, unsigned columns, unsigned rows)
{
    char observer[512], screen[160];
    const double *const eye = camera + EYE, *const target = camera + TARGET, *const up = camera + UP;
    (void)snprintf(
        observer, sizeof observer,
        "observer={position: [%.17g, %.17g, %.17g], target: [%.17g, %.17g, %.17g], up: [%.17g, %.17g, %.17g], "
        "projection: perspective}",
        eye[0], eye[1], eye[2], target[0], target[1], target[2], up[0], up[1], up[2]);
    (void)snprintf(screen, sizeof screen, "screen={width: %.17g, height: %.17g, resolution: [%u, %u]}", camera[WIDTH],
                   camera[HEIGHT], columns, rows);
    (void)fresh_diagnostics();
    drop_stage();
    stage = computed_scene() ? luxel_scene_copy(computed_scene()) : NULL;
    if (stage && takes(observer) && takes(screen) && luxel_scene_commit(stage, core.diagnostics) == LUXEL_OK)
        return true;
    drop_stage();
    return false;
}

/* Renders what the camera of 11 numbers sees: position, target, up, width and height of the screen.  A luxel_status. */
PAGE_CALLS(page_stage) int page_stage(const double *camera, unsigned columns, unsigned rows)
{
    const luxel_settings settings = present_settings();
    luxel_field *field = NULL;
    if (!look(camera, columns, rows))
        return LUXEL_ERROR_SCENE;
    const luxel_status status = luxel_render(stage, &settings, fresh_diagnostics(), &field);
    if (status == LUXEL_OK) {
        luxel_field_free(stage_field);
        stage_field = viewed(field);
    }
    return (int)status;
}

PAGE_CALLS(page_stage_values) const float *page_stage_values(void)
{
    return stage_field ? luxel_field_single(stage_field) : NULL;
}

/* The channels, 3 for each pixel; NULL: it is grey. */
PAGE_CALLS(page_stage_rgb) const float *page_stage_rgb(void)
{
    return stage_field ? luxel_field_rgb_single(stage_field) : NULL;
}

PAGE_CALLS(page_stage_mask) const uint8_t *page_stage_mask(void)
{
    return stage_field ? luxel_field_mask(stage_field) : NULL;
}

/* How far it is from a camera to what each of so many pixels shows, along its line of view; 0: nothing.  NULL: it sees
 * nothing. */
PAGE_CALLS(page_stage_depth)
const float *page_stage_depth(const double *camera, unsigned columns, unsigned rows)
{
    const luxel_settings settings = present_settings();
    const size_t count = (size_t)columns * rows;
    free(stage_depth);
    stage_depth = NULL;
    if (!look(camera, columns, rows))
        return NULL;
    double *depth = calloc(count, sizeof *depth);
    float *made = malloc(count * sizeof *made);
    const luxel_geometry wanted = {.depth_mm = depth};
    if (depth && made && luxel_find_geometry(stage, &settings, fresh_diagnostics(), &wanted) == LUXEL_OK) {
        for (size_t i = 0; i < count; i++)
            made[i] = (float)depth[i];
        stage_depth = made;
    } else
        free(made);
    free(depth);
    return stage_depth;
}

/* The exact value that a camera sees through a point of its screen, and what each light gives of it. */
PAGE_CALLS(page_stage_probe)
const char *page_stage_probe(const double *camera, unsigned columns, unsigned rows, double x_mm, double y_mm)
{
    const luxel_settings settings = present_settings();
    luxel_evaluator *evaluator = NULL;
    if (!look(camera, columns, rows) ||
        luxel_evaluator_new(stage, &settings, fresh_diagnostics(), &evaluator) != LUXEL_OK)
        return NULL;
    const char *answer = answer_probe(evaluator, x_mm, y_mm);
    luxel_evaluator_free(evaluator);
    return answer;
}
