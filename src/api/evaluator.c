/* SPDX-License-Identifier: MIT */
/* Evaluators: checked settings and a prepared scene, kept. */
#include <luxel/evaluator.h>

#include <stdlib.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../world/evaluate.h"
#include "reflecting.h"

void luxel_evaluator_free(luxel_evaluator *evaluator)
{
    if (!evaluator)
        return;
    lx_reflected_free(evaluator->world.reflected);
    lx_prepared_clear(&evaluator->prepared);
    free(evaluator);
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
    if (status == LUXEL_OK)
        status = lx_reflect_picture(scene, &session, diagnostics);
    made->scene = scene;
    made->sees = status == LUXEL_OK && luxel_scene_check_view(scene, NULL) == LUXEL_OK;
    made->settings = session.settings;
    made->settings.lights = NULL; /* the prepared scene knows them; the caller's list need not outlive this */
    made->prepared = session.prepared;
    made->world = session.world;
    made->world.prepared = &made->prepared;
    made->world.by_tiles = true;
    if (status == LUXEL_OK)
        *evaluator = made;
    else
        luxel_evaluator_free(made);
    return status;
}
