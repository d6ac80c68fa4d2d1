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
#include "../world/evaluate.h"
#include "coloring.h"
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

/* The greatest bound of the means as a share of the greatest of these. */
static double error_of(const luxel_balance *balance)
{
    double error = 0, greatest = 0;
    for (size_t i = 0; i < balance->side_count; i++) {
        error = fmax(error, balance->sides[i].irradiance.error);
        greatest = fmax(greatest, balance->sides[i].irradiance.value);
    }
    return greatest > 0 ? error / greatest : 0;
}

/* Tells the bound that was missed. */
static void report_error(const luxel_balance *balance, luxel_diagnostics *diagnostics)
{
    char share[LX_NUMBER_SIZE];
    lx_report(diagnostics, LUXEL_SEVERITY_ADVICE, NULL, LX_MSG_BALANCE_ERROR,
              LX_ARGS(lx_write_bound(error_of(balance), 2, share)));
}

/* Whether no more is missing than the bounds tell. */
static bool does_close(const luxel_balance *balance)
{
    return fabs(balance->difference.value) <= balance->difference.error &&
           (!balance->has_emitted || balance->missed.value >= -balance->missed.error);
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
    balance->closes = does_close(balance);
    balance->reached = lx_reflected_is_reached(reflected, request);
    if (tell_sides(&session->prepared, reflected, balance)) {
        luxel_balance_free(balance);
        return LUXEL_ERROR_MEMORY;
    }
    if (!balance->reached) {
        report_error(balance, diagnostics);
        lx_hint_overlap(reflected, &session->prepared, diagnostics);
    }
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
        .within = settings->within,
        .is_enough = settings->enough,
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

static luxel_status find_grey(const luxel_scene *scene, const luxel_settings *settings, luxel_diagnostics *diagnostics,
                              luxel_balance **balance)
{
    struct lx_session session;
    luxel_status status = lx_session_open_world(scene, settings, diagnostics, &session);
    if (status == LUXEL_OK && lx_wants_reflections(session.prepared.scene))
        status = find(scene, &session, diagnostics, balance);
    lx_session_clear(&session);
    return status;
}

/* ---- in colour ---- */

/* Adds a part to a number, or begins with it. */
static void add(const struct lx_color_part *part, bool begins, luxel_bounded from, luxel_bounded *sum)
{
    *sum = lx_reported(lx_add_part(begins ? lx_exact(0) : *sum, part->luminance, from.value, from.error));
}

/* Adds a part to the luminances of a balance; the first is the balance itself.  Until they are concluded reflectances
 * are what is sent back. */
static void add_part(luxel_balance *balance, const struct lx_color_part *part, const luxel_balance *from)
{
    const bool begins = balance == from;
    luxel_balance_side *sides = (luxel_balance_side *)balance->sides;
    for (size_t i = 0; i < balance->side_count; i++) {
        const luxel_balance_side *side = &from->sides[i];
        const double sent = part->luminance * side->reflectance * side->irradiance.value;
        sides[i].reflectance = begins ? sent : sides[i].reflectance + sent;
        add(part, begins, side->direct, &sides[i].direct);
        add(part, begins, side->irradiance, &sides[i].irradiance);
    }
    add(part, begins, from->emitted, &balance->emitted);
    add(part, begins, from->missed, &balance->missed);
    add(part, begins, from->arrives, &balance->arrives);
    add(part, begins, from->absorbed, &balance->absorbed);
    add(part, begins, from->escaped, &balance->escaped);
    add(part, begins, from->pending, &balance->pending);
    add(part, begins, from->difference, &balance->difference);
}

static void conclude(luxel_balance *balance, const luxel_settings *settings, luxel_diagnostics *diagnostics)
{
    luxel_balance_side *sides = (luxel_balance_side *)balance->sides;
    for (size_t i = 0; i < balance->side_count; i++)
        sides[i].reflectance = sides[i].irradiance.value > 0 ? sides[i].reflectance / sides[i].irradiance.value : 0;
    balance->closes = does_close(balance);
    balance->reached = error_of(balance) <= lx_pictured_error_of(settings);
    if (!balance->reached)
        report_error(balance, diagnostics);
}

/* The luminance of what its parts give, which have the same sides. */
static luxel_status find_sum(const luxel_scene *scene, const luxel_settings *settings, luxel_diagnostics *diagnostics,
                             luxel_balance **balance)
{
    struct lx_color_parts parts;
    luxel_status status = lx_color_parts_make(scene, settings, diagnostics, &parts);
    for (size_t p = 0; p < parts.count && status == LUXEL_OK; p++) {
        luxel_settings own = parts.list[p].settings;
        struct lx_part_progress progress;
        luxel_balance *from = NULL;
        lx_part_progress_begin(&progress, p, parts.count, settings, &own);
        status = find_grey(parts.list[p].scene, &own, NULL, &from);
        if (status != LUXEL_OK)
            break;
        *balance = p == 0 ? from : *balance;
        add_part(*balance, &parts.list[p], from);
        if (p > 0)
            luxel_balance_free(from);
    }
    lx_color_parts_clear(&parts);
    if (status == LUXEL_OK)
        conclude(*balance, settings, diagnostics);
    return status == LUXEL_ERROR_MEMORY ? lx_out_of_memory(diagnostics) : status;
}

luxel_status luxel_find_balance(const luxel_scene *scene, const luxel_settings *settings,
                                luxel_diagnostics *diagnostics, luxel_balance **balance)
{
    luxel_balance *made = NULL;
    luxel_settings own;
    if (!balance)
        return lx_refuse(diagnostics, LX_MSG_MISSING_ARGUMENT, LX_ARGS("balance"));
    luxel_status status = lx_settings_check(scene, settings, diagnostics, &own);
    own.quantity = LUXEL_IRRADIANCE;
    if (status == LUXEL_OK)
        status = lx_is_sum_of_channels(lx_scene_parameters(scene), own.quantity) &&
                         lx_wants_reflections(lx_scene_parameters(scene))
                     ? find_sum(scene, &own, diagnostics, &made)
                     : find_grey(scene, settings, diagnostics, &made);
    if (status == LUXEL_OK)
        *balance = made;
    else
        luxel_balance_free(made);
    return status;
}
