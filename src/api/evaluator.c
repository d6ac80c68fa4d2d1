/* SPDX-License-Identifier: MIT */
/* Evaluators: checked settings and a prepared scene, kept. */
#include <luxel/evaluator.h>

#include <stdlib.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../shade/evaluate.h"
#include "reflecting.h"

void luxel_evaluator_free(luxel_evaluator *evaluator)
{
    if (!evaluator)
        return;
    lx_prepared_clear(&evaluator->prepared);
    free(evaluator);
}

luxel_status luxel_evaluator_new(const luxel_scene *scene, const luxel_settings *settings,
                                 luxel_diagnostics *diagnostics, luxel_evaluator **evaluator)
{
    if (!evaluator) {
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_MISSING_ARGUMENT, LX_ARGS("evaluator"));
        return LUXEL_ERROR_ARGUMENT;
    }
    struct luxel_evaluator *made = lx_new_array(1, sizeof *made);
    if (!made)
        return lx_out_of_memory(diagnostics);
    struct lx_session session;
    luxel_status status = lx_session_open_world(scene, settings, diagnostics, &session);
    if (status == LUXEL_OK)
        status = lx_refuse_reflections(session.prepared.scene, diagnostics);
    made->settings = session.settings;
    made->kernels = session.kernels;
    made->prepared = session.prepared;
    if (status == LUXEL_OK)
        *evaluator = made;
    else
        luxel_evaluator_free(made);
    return status;
}
