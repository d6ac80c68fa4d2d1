/* SPDX-License-Identifier: MIT */
/*
 * Scene i of a study: as a scene of its own by assignments, and by a maker, which writes the values into the parameters
 * of one scene and goes the long way only where something is wrong or no number.
 */
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../scene/bind.h"
#include "study.h"

/* A copy of the base scene with the values of scene i, not committed. */
static luxel_status assign_all(const luxel_study *study, uint64_t i, luxel_diagnostics *diagnostics, luxel_scene **made)
{
    luxel_scene *scene = luxel_scene_copy(study->plain);
    luxel_status status = scene ? LUXEL_OK : lx_out_of_memory(diagnostics);
    for (size_t k = 0; k < study->axis_count && status == LUXEL_OK; k++) {
        struct lx_text text = {0};
        lx_axis_assignment(study, k, i, &text);
        char *assignment = lx_text_take(&text);
        status = assignment ? luxel_scene_set(scene, assignment, diagnostics) : lx_out_of_memory(diagnostics);
        free(assignment);
    }
    if (status == LUXEL_OK)
        *made = scene;
    else
        luxel_scene_free(scene);
    return status;
}

luxel_status luxel_study_scene(const luxel_study *study, uint64_t i, luxel_diagnostics *diagnostics,
                               luxel_scene **scene)
{
    if (!study || !scene || i >= study->count)
        return LUXEL_ERROR_ARGUMENT;
    luxel_scene *made = NULL;
    luxel_status status = assign_all(study, i, diagnostics, &made);
    if (status == LUXEL_OK)
        status = luxel_scene_commit(made, diagnostics);
    if (status == LUXEL_OK)
        status = luxel_scene_check_view(made, diagnostics);
    if (status == LUXEL_OK)
        *scene = made;
    else
        luxel_scene_free(made);
    return status;
}

/* ---- the quick way ---- */

struct luxel_study_maker {
    const luxel_study *study;
    luxel_scene *scene;          /* the quick one */
    luxel_scene *own;            /* one that was made the long way; NULL: none */
    struct lx_binding *bindings; /* of each axis; NULL where not all values can be bound */
};

/* Binds every axis in a scene that writes all of their keys. */
static luxel_status bind_all(luxel_study_maker *maker, luxel_diagnostics *diagnostics)
{
    const luxel_study *study = maker->study;
    maker->bindings = lx_new_array(study->axis_count, sizeof *maker->bindings);
    if (!maker->bindings)
        return lx_out_of_memory(diagnostics);
    bool good = true;
    for (size_t k = 0; k < study->axis_count && good; k++) {
        const char *key = study->axes[k].key;
        struct lx_place place = {.source = "-s", .text = key, .length = strlen(key)};
        struct lx_path path;
        good = lx_follow_path(maker->scene, &place, place.length, NULL, &path) == LUXEL_OK &&
               lx_bind(maker->scene, &path, &maker->bindings[k]) && study->axes[k].size > 0;
    }
    if (!good) {
        free(maker->bindings);
        maker->bindings = NULL;
    }
    return LUXEL_OK;
}

luxel_status luxel_study_maker_new(const luxel_study *study, luxel_diagnostics *diagnostics, luxel_study_maker **maker)
{
    if (!study || !maker)
        return LUXEL_ERROR_ARGUMENT;
    luxel_study_maker *made = lx_new_array(1, sizeof *made);
    if (!made)
        return lx_out_of_memory(diagnostics);
    made->study = study;
    luxel_status status = assign_all(study, 0, diagnostics, &made->scene);
    /* a first scene that is wrong is told when it is asked for */
    if (status == LUXEL_OK && luxel_scene_commit(made->scene, NULL) == LUXEL_OK)
        status = bind_all(made, diagnostics);
    if (status == LUXEL_OK)
        *maker = made;
    else
        luxel_study_maker_free(made);
    return status;
}

void luxel_study_maker_free(luxel_study_maker *maker)
{
    if (!maker)
        return;
    luxel_scene_free(maker->scene);
    luxel_scene_free(maker->own);
    free(maker->bindings);
    free(maker);
}

/* Puts what an axis has in scene i into the quick scene. */
static void put(luxel_study_maker *maker, size_t k, uint64_t i)
{
    const struct lx_axis *axis = &maker->study->axes[k];
    const struct lx_study_choice choice = lx_axis_at(maker->study, k, i);
    unsigned wholes[LX_MOST_WIDTH];
    const void *value = choice.numbers;
    if (axis->bytes) {
        value = (const char *)axis->bytes + choice.index * axis->size;
    } else if (axis->parameter.type == LX_WHOLE || axis->parameter.type == LX_WHOLES) {
        for (unsigned n = 0; n < axis->width; n++)
            wholes[n] = (unsigned)choice.numbers[n];
        value = wholes;
    }
    lx_bound_put(maker->scene, &maker->bindings[k], value);
}

luxel_status luxel_study_make(luxel_study_maker *maker, uint64_t i, luxel_diagnostics *diagnostics,
                              const luxel_scene **scene)
{
    if (!maker || !scene || i >= maker->study->count)
        return LUXEL_ERROR_ARGUMENT;
    if (maker->bindings) {
        for (size_t k = 0; k < maker->study->axis_count; k++)
            put(maker, k, i);
        if (lx_bound_check(maker->scene, maker->bindings, maker->study->axis_count) &&
            luxel_scene_check_view(maker->scene, NULL) == LUXEL_OK) {
            *scene = maker->scene;
            return LUXEL_OK;
        }
    }
    luxel_scene_free(maker->own);
    maker->own = NULL;
    luxel_status status = luxel_study_scene(maker->study, i, diagnostics, &maker->own);
    if (status == LUXEL_OK)
        *scene = maker->own;
    return status;
}
