/* SPDX-License-Identifier: MIT */
/* The balance of the flux, and the means of all sides: of the picture's solution where that is good enough, or of one
 * made for them. */
#include <luxel/balance.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../base/phrase.h"
#include "../light/totals.h"
#include "../scene/colours.h"
#include "../world/evaluate.h"
#include "reflecting.h"
#include "sides.h"

/* More threads than these are not worth their while. */
enum { MOST_WORTH = 64 };
/* How well the flux of emitters is known. */
static const double FLUX = 1e-12;

void luxel_balance_free(luxel_balance *balance)
{
    if (!balance)
        return;
    for (size_t i = 0; i < balance->side_count; i++)
        free((char *)balance->sides[i].surface_name);
    free((luxel_balance_side *)balance->sides);
    free(balance);
}

/* The sources' flux, and what of it meets no surface. */
static void weigh_sources(const struct lx_prepared *prepared, luxel_balance *balance)
{
    const double flux = lx_emitters_flux(&prepared->emitters);
    balance->has_emitted = isfinite(flux) && prepared->scene->shadows == LX_SHADOWS_ALL;
    if (!balance->has_emitted)
        return;
    balance->emitted = (lx_bounded){flux, FLUX * flux};
    balance->missed = (lx_bounded){flux - balance->arrives.value, balance->emitted.error + balance->arrives.error};
}

/* 0, or -1 when memory ran out. */
static int tell_sides(const struct lx_prepared *prepared, const struct lx_radiosity *reflected, luxel_balance *balance)
{
    const size_t most = lx_reflected_most_sides(reflected);
    bool failed;
    struct lx_lit_side *found = lx_new_array(most + 1, sizeof *found);
    luxel_balance_side *sides = lx_new_array(most + 1, sizeof *sides);
    balance->sides = sides;
    failed = !found || !sides;
    if (!failed)
        balance->side_count = lx_reflected_sides(reflected, found);
    for (size_t i = 0; i < balance->side_count; i++) {
        struct lx_named_side named;
        failed = lx_side_name(prepared, found[i].surface, found[i].is_flat, found[i].is_back, &named) || failed;
        sides[i] = (luxel_balance_side){.surface = named.surface,
                                        .surface_name = named.surface_name,
                                        .part = named.part,
                                        .part_name = named.part_name,
                                        .side = named.side,
                                        .area_m2 = found[i].area_m2,
                                        .reflectance = found[i].reflectance,
                                        .direct = lx_reported(found[i].direct),
                                        .irradiance = lx_reported(found[i].irradiance)};
    }
    free(found);
    return failed ? -1 : 0;
}

/* Tells the bound that was missed, as a share of the greatest mean. */
static void report_error(const luxel_balance *balance, const struct lx_radiosity *reflected,
                         const struct lx_prepared *prepared, luxel_diagnostics *diagnostics)
{
    double error = 0, greatest = 0;
    char share[LX_NUMBER_SIZE];
    for (size_t i = 0; i < balance->side_count; i++) {
        error = fmax(error, balance->sides[i].irradiance.error);
        greatest = fmax(greatest, balance->sides[i].irradiance.value);
    }
    lx_report(diagnostics, LUXEL_SEVERITY_ADVICE, NULL, LX_MSG_BALANCE_ERROR,
              LX_ARGS(lx_write_bound(greatest > 0 ? error / greatest : 0, 2, share)));
    lx_hint_overlap(reflected, prepared, diagnostics);
}

static luxel_status tell(const struct lx_session *session, const struct lx_reflected_request *request,
                         luxel_diagnostics *diagnostics, luxel_balance **made)
{
    const struct lx_radiosity *reflected = session->world.reflected;
    luxel_balance *balance = lx_new_array(1, sizeof *balance);
    if (!balance)
        return LUXEL_ERROR_MEMORY;
    const struct lx_light_balance fluxes = lx_reflected_balance(reflected);
    balance->unit = lx_unit_of(&session->prepared, LUXEL_IRRADIANCE);
    balance->flux_unit = session->prepared.scene->units == LX_PHOTOMETRIC ? "lm" : "W";
    balance->arrives = lx_reported(fluxes.arrives);
    balance->absorbed = lx_reported(fluxes.absorbed);
    balance->escaped = lx_reported(fluxes.escaped);
    balance->pending = lx_reported(fluxes.pending);
    balance->difference = lx_reported(fluxes.difference);
    weigh_sources(&session->prepared, balance);
    balance->closes = fabs(balance->difference.value) <= balance->difference.error &&
                      (!balance->has_emitted || balance->missed.value >= -balance->missed.error);
    balance->reached = lx_reflected_is_reached(reflected, request);
    if (tell_sides(&session->prepared, reflected, balance)) {
        luxel_balance_free(balance);
        return LUXEL_ERROR_MEMORY;
    }
    if (!balance->reached)
        report_error(balance, reflected, &session->prepared, diagnostics);
    *made = balance;
    return LUXEL_OK;
}

static luxel_status find(const luxel_scene *scene, struct lx_session *session, luxel_diagnostics *diagnostics,
                         luxel_balance **made)
{
    const luxel_settings *settings = &session->settings;
    struct lx_control control = {.rows = 1, .progress = settings->progress, .data = settings->progress_data};
    const struct lx_reflected_request request = {
        .prepared = &session->prepared,
        .kernels = session->world.kernels,
        .error = lx_pictured_error_of(settings),
        .threads = lx_thread_count(settings->threads, MOST_WORTH),
        .control = &control,
    };
    luxel_status status = lx_reflect_shared(scene, session, diagnostics);
    if (!session->world.reflected)
        session->world.reflected = lx_reflected_of_picture(scene, session);
    if (status == LUXEL_OK && !lx_reflected_serves(session, &request)) {
        lx_reflected_free(session->world.reflected);
        status = lx_reflected_make(&request, &session->world.reflected);
    }
    if (status == LUXEL_OK)
        status = tell(session, &request, diagnostics, made);
    return status == LUXEL_ERROR_MEMORY ? lx_out_of_memory(diagnostics) : status;
}

luxel_status luxel_find_balance(const luxel_scene *scene, const luxel_settings *settings,
                                luxel_diagnostics *diagnostics, luxel_balance **balance)
{
    struct lx_session session;
    luxel_balance *made = NULL;
    if (!balance)
        return lx_refuse(diagnostics, LX_MSG_MISSING_ARGUMENT, LX_ARGS("balance"));
    luxel_status status = lx_session_open_world(scene, settings, diagnostics, &session);
    if (status == LUXEL_OK)
        status = lx_refuse_sum(scene, LUXEL_IRRADIANCE, LX_N("the balance"), diagnostics);
    if (status == LUXEL_OK && lx_wants_reflections(session.prepared.scene))
        status = find(scene, &session, diagnostics, &made);
    lx_session_clear(&session);
    if (status == LUXEL_OK)
        *balance = made;
    return status;
}
