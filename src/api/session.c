/* SPDX-License-Identifier: MIT */
/* Settings: their defaults and checks, the choice of kernels, and preparing the scene by them. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/number.h"
#include "../picture/plan_make.h"
#include "../scene/scene.h"
#include "reflecting.h"
#include "refuse.h"
#include "session.h"

enum { MAXIMUM_THREADS = 1024, MAXIMUM_STRIDE = 65536 };

void luxel_settings_init(luxel_settings *settings)
{
    *settings = (luxel_settings){.quantity = LUXEL_BRIGHTNESS, .precision = LUXEL_SINGLE, .stride = 1};
}

const char *luxel_instruction_set_name(size_t i)
{
    const struct lx_kernels *kernels = lx_kernels_get(i);
    return kernels ? kernels->name : NULL;
}

bool luxel_instruction_set_runs(size_t i)
{
    const struct lx_kernels *kernels = lx_kernels_get(i);
    return kernels && kernels->runs();
}

const char *luxel_instruction_set_chosen(const char *wanted)
{
    const struct lx_kernels *kernels = lx_kernels_choose(wanted);
    return kernels ? kernels->name : NULL;
}

static luxel_status check_settings(const luxel_settings *settings, luxel_diagnostics *diagnostics)
{
    luxel_status status = LUXEL_OK;
    if (settings->quantity != LUXEL_BRIGHTNESS && settings->quantity != LUXEL_IRRADIANCE)
        status = lx_setting_out_of_range(diagnostics, "quantity", (double)settings->quantity,
                                         LX_N("brightness or irradiance"));
    if (settings->precision != LUXEL_SINGLE && settings->precision != LUXEL_DOUBLE)
        status =
            lx_setting_out_of_range(diagnostics, "precision", (double)settings->precision, LX_N("single or double"));
    if (settings->threads > MAXIMUM_THREADS)
        status = lx_setting_out_of_range(diagnostics, "threads", settings->threads, LX_N("0 to 1024"));
    if (!(settings->tolerance >= 0 && settings->tolerance < 1))
        status = lx_setting_out_of_range(diagnostics, "tolerance", settings->tolerance, LX_N("from 0 to below 1"));
    if (!(settings->light_error >= 0 && settings->light_error < 1))
        status = lx_setting_out_of_range(diagnostics, "light_error", settings->light_error, LX_N("from 0 to below 1"));
    if (!(settings->reflected_error >= 0 && settings->reflected_error < 1))
        status = lx_setting_out_of_range(diagnostics, "reflected_error", settings->reflected_error,
                                         LX_N("from 0 to below 1"));
    if (!(settings->within >= 0 && settings->within < HUGE_VAL))
        status = lx_setting_out_of_range(diagnostics, "within", settings->within, LX_N("seconds, 0 for no end"));
    if (settings->stride > MAXIMUM_STRIDE)
        status = lx_setting_out_of_range(diagnostics, "stride", settings->stride, LX_N("0 to 65536"));
    const luxel_status reserved = LX_CHECK_RESERVE(settings, diagnostics);
    return status == LUXEL_OK ? reserved : status;
}

/* Whether the lights of the group are there, and give light that may be reflected, if it is. */
static luxel_status check_group(const struct lx_scene_parameters *scene, const luxel_settings *settings,
                                luxel_diagnostics *diagnostics)
{
    luxel_status status = LUXEL_OK;
    for (size_t i = 0; settings->lights && i < settings->light_count; i++) {
        const size_t light = settings->lights[i];
        char number[LX_NUMBER_SIZE], count[LX_NUMBER_SIZE], key[64];
        if (light >= scene->lights.count) {
            lx_report(
                diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_NO_SUCH_LIGHT,
                LX_ARGS(lx_write_number((double)light, number), lx_write_number((double)scene->lights.count, count)));
            status = LUXEL_ERROR_ARGUMENT;
            continue;
        }
        const char *law = lx_wants_reflections(scene) ? lx_foreign_law(&scene->lights.items[light]) : NULL;
        if (law) {
            snprintf(key, sizeof key, "lights[%zu].attenuation", light);
            lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_REFLECTS_BY_LAW, LX_ARGS(key, law));
            lx_hint(diagnostics, LX_MSG_HINT_INVERSE_SQUARE, NULL);
            status = LUXEL_ERROR_ARGUMENT;
        }
    }
    return status;
}

static luxel_status choose_kernels(struct lx_session *session, luxel_diagnostics *diagnostics)
{
    session->kernels = lx_kernels_choose(session->settings.instruction_set);
    if (session->kernels)
        return LUXEL_OK;
    char known[128] = "";
    size_t used = 0;
    for (size_t i = 0; luxel_instruction_set_name(i); i++)
        if (luxel_instruction_set_runs(i) && used < sizeof known)
            used += (size_t)snprintf(known + used, sizeof known - used, "%s%s", used ? ", " : "",
                                     luxel_instruction_set_name(i));
    const char *wanted = session->settings.instruction_set;
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_NO_INSTRUCTION_SET,
              LX_ARGS(wanted ? wanted : getenv("LUXEL_ISA")));
    lx_hint(diagnostics, LX_MSG_INSTRUCTION_SETS, LX_ARGS(known));
    return LUXEL_ERROR_ARGUMENT;
}

luxel_status lx_settings_check(const luxel_scene *scene, const luxel_settings *settings, luxel_diagnostics *diagnostics,
                               luxel_settings *checked)
{
    if (!scene || !luxel_scene_is_committed(scene))
        return lx_refuse(diagnostics, LX_MSG_NOT_COMMITTED, NULL);
    luxel_settings_init(checked);
    if (settings)
        *checked = *settings;
    const luxel_status status = check_settings(checked, diagnostics);
    const luxel_status group = check_group(lx_scene_parameters(scene), checked, diagnostics);
    return status == LUXEL_OK ? group : status;
}

luxel_status lx_session_prepare(const luxel_scene *scene, const luxel_settings *settings,
                                luxel_diagnostics *diagnostics, struct lx_prepared *prepared)
{
    struct lx_control control = {.rows = 1, .progress = settings->progress, .data = settings->progress_data};
    const struct lx_asking asking = {.control = &control, .is_caller = true};
    if (lx_prepare(lx_scene_parameters(scene), settings, &asking, prepared) == 0)
        return LUXEL_OK;
    if (atomic_load(&control.stop))
        return LUXEL_CANCELLED;
    if (prepared->mirrors.is_short) {
        char most[LX_NUMBER_SIZE];
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_TOO_MANY_MIRRORS,
                  LX_ARGS(lx_write_number(lx_scene_parameters(scene)->mirrors, most)));
        lx_hint(diagnostics, LX_MSG_HINT_FEWER_MIRRORS, NULL);
        return LUXEL_ERROR_MEMORY;
    }
    if (!prepared->emitters.is_short)
        return lx_out_of_memory(diagnostics);
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_TOO_MANY_PARTS, NULL);
    lx_hint(diagnostics, LX_MSG_FEWER_PARTS, NULL);
    return LUXEL_ERROR_MEMORY;
}

luxel_status lx_session_begin(const luxel_scene *scene, const luxel_settings *settings, luxel_diagnostics *diagnostics,
                              struct lx_session *session)
{
    memset(session, 0, sizeof *session);
    const luxel_status status = lx_settings_check(scene, settings, diagnostics, &session->settings);
    return status == LUXEL_OK ? choose_kernels(session, diagnostics) : status;
}

static luxel_status prepare(const luxel_scene *scene, luxel_diagnostics *diagnostics, struct lx_session *session)
{
    session->world = (struct lx_world){.prepared = &session->prepared,
                                       .kernels = lx_element_kernels_of(session->kernels),
                                       .reflect = lx_reflect_elements};
    return lx_session_prepare(scene, &session->settings, diagnostics, &session->prepared);
}

luxel_status lx_session_open_world(const luxel_scene *scene, const luxel_settings *settings,
                                   luxel_diagnostics *diagnostics, struct lx_session *session)
{
    const luxel_status status = lx_session_begin(scene, settings, diagnostics, session);
    return status == LUXEL_OK ? prepare(scene, diagnostics, session) : status;
}

luxel_status lx_session_open(const luxel_scene *scene, const luxel_settings *settings, luxel_diagnostics *diagnostics,
                             struct lx_session *session)
{
    luxel_status status = lx_session_begin(scene, settings, diagnostics, session);
    if (status == LUXEL_OK)
        status = luxel_scene_check_view(scene, diagnostics);
    if (status == LUXEL_OK)
        status = prepare(scene, diagnostics, session);
    if (status == LUXEL_OK) {
        status = lx_plan_make(&session->prepared, session->kernels, &session->settings, &session->plan);
        if (status == LUXEL_ERROR_MEMORY)
            lx_out_of_memory(diagnostics);
    }
    return status;
}

void lx_session_clear(struct lx_session *session)
{
    lx_reflected_free(session->world.reflected);
    lx_plan_clear(&session->plan);
    lx_prepared_clear(&session->prepared);
}
