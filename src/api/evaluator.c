/* SPDX-License-Identifier: MIT */
/* Evaluators: checked settings and a prepared scene, kept. */
#include <luxel/evaluator.h>

#include <stdlib.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../scene/colours.h"
#include "../world/evaluate.h"
#include "reflecting.h"

void luxel_evaluator_free(luxel_evaluator *evaluator)
{
    if (!evaluator)
        return;
    for (size_t i = 0; i < evaluator->part_count; i++)
        luxel_evaluator_free(evaluator->parts[i].evaluator);
    free(evaluator->parts);
    lx_reflected_free(evaluator->world.reflected);
    lx_prepared_clear(&evaluator->prepared);
    free(evaluator->view);
    free(evaluator);
}

/* The evaluators of the channels of its materials, and what of each light counts. */
static luxel_status add_parts(luxel_evaluator *evaluator, const luxel_settings *settings,
                              luxel_diagnostics *diagnostics)
{
    struct lx_color_parts parts;
    luxel_status status = lx_color_parts_make(evaluator->scene, settings, diagnostics, &parts);
    if (status == LUXEL_OK && !(evaluator->parts = lx_new_array(parts.count, sizeof *evaluator->parts)))
        status = lx_out_of_memory(diagnostics);
    for (size_t i = 0; i < parts.count && status == LUXEL_OK; i++) {
        struct lx_evaluator_part *part = &evaluator->parts[i];
        luxel_scene *view = lx_scene_in_channel(evaluator->scene, lx_scene_parameters(parts.list[i].scene)->channel);
        status = view ? luxel_evaluator_new(view, &parts.list[i].settings, diagnostics, &part->evaluator)
                      : lx_out_of_memory(diagnostics);
        if (status != LUXEL_OK) {
            free(view);
            break;
        }
        part->weight = parts.list[i].luminance;
        part->evaluator->view = view;
        evaluator->part_count++;
    }
    lx_color_parts_clear(&parts);
    return status;
}

luxel_status luxel_evaluator_new(const luxel_scene *scene, const luxel_settings *settings,
                                 luxel_diagnostics *diagnostics, luxel_evaluator **evaluator)
{
    if (!evaluator)
        return lx_refuse(diagnostics, LX_MSG_MISSING_ARGUMENT, LX_ARGS("evaluator"));
    struct luxel_evaluator *made = lx_new_array(1, sizeof *made);
    if (!made)
        return lx_out_of_memory(diagnostics);
    struct lx_session session;
    luxel_status status = lx_session_open_world(scene, settings, diagnostics, &session);
    const bool is_sum =
        status == LUXEL_OK && lx_is_sum_of_channels(lx_scene_parameters(scene), session.settings.quantity);
    if (status == LUXEL_OK && !is_sum)
        status = lx_reflect_picture(scene, &session, diagnostics);
    made->scene = scene;
    made->sees = status == LUXEL_OK && luxel_scene_check_view(scene, NULL) == LUXEL_OK;
    made->settings = session.settings;
    made->settings.lights = NULL; /* the prepared scene knows them; the caller's list need not outlive this */
    made->prepared = session.prepared;
    made->world = session.world;
    made->world.prepared = &made->prepared;
    made->world.by_tiles = true;
    if (is_sum)
        status = add_parts(made, settings, diagnostics);
    if (status == LUXEL_OK)
        *evaluator = made;
    else
        luxel_evaluator_free(made);
    return status;
}
