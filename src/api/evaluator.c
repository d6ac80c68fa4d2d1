/* SPDX-License-Identifier: MIT */
/* Evaluators: checked settings and a prepared scene, kept. */
#include <luxel/evaluator.h>

#include <math.h>
#include <stdlib.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../world/evaluate.h"
#include "reflecting.h"

/* On surfaces by what was found for the picture, elsewhere by an integral over all of them. */
static lx_bounded reflected_at(const struct luxel_evaluator *evaluator, const struct lx_element *element)
{
    const struct lx_radiosity *reflected = evaluator->reflected;
    const struct lx_receiver receiver = lx_receiver_of(&evaluator->prepared, element);
    struct lx_veils veils = {0};
    size_t near = 0;
    if (element->own && !receiver.is_turned)
        return lx_reflected_on(reflected, &evaluator->prepared, receiver.own, receiver.place_mm, receiver.normal,
                               &near);
    const lx_bounded light = lx_reflected_at(reflected, &evaluator->prepared, &receiver, &veils);
    const bool failed = veils.failed;
    lx_veils_clear(&veils);
    return failed ? (lx_bounded){light.value, HUGE_VAL} : light;
}

void luxel_evaluator_free(luxel_evaluator *evaluator)
{
    if (!evaluator)
        return;
    lx_reflected_free(evaluator->reflected);
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
        status = lx_reflect_picture(scene, &session, diagnostics);
    made->scene = scene;
    made->sees = status == LUXEL_OK && luxel_scene_check_view(scene, NULL) == LUXEL_OK;
    made->reflected = session.reflected;
    made->reflected_at = session.reflected ? reflected_at : NULL;
    made->settings = session.settings;
    made->settings.lights = NULL; /* the prepared scene knows them; the caller's list need not outlive this */
    made->kernels = session.kernels;
    made->prepared = session.prepared;
    if (status == LUXEL_OK)
        *evaluator = made;
    else
        luxel_evaluator_free(made);
    return status;
}
