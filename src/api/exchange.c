/* SPDX-License-Identifier: MIT */
/* The form factors of a scene, with the names of its sides. */
#include <luxel/exchange.h>

#include <stdlib.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../reflect/exchange.h"
#include "../surface/mesh_faces.h"
#include "../world/evaluate.h"
#include "reflecting.h"
#include "sides.h"

/* More threads than these are not worth their while. */
enum { MOST_WORTH = 64 };

void luxel_exchange_free(luxel_exchange *exchange)
{
    if (!exchange)
        return;
    for (size_t i = 0; i < exchange->count; i++)
        free((char *)exchange->sides[i].surface_name);
    free((luxel_exchange_side *)exchange->sides);
    free((luxel_bounded *)exchange->factors);
    free(exchange);
}

/* Whether all sides of the scene can be integrated over, which reflected light asks for as well. */
static luxel_status check_sides(const struct lx_prepared *prepared, luxel_diagnostics *diagnostics)
{
    const struct lx_list *surfaces = &prepared->scene->surfaces;
    char sum[LX_NUMBER_SIZE], most[LX_NUMBER_SIZE];
    size_t triangles = 0;
    for (size_t i = 0; i < surfaces->count; i++) {
        const struct lx_surface_kind *kind = (const struct lx_surface_kind *)surfaces->items[i].variant;
        if (lx_surface_has_sides(kind))
            continue;
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_REFLECTS_WITHOUT_SIDES,
                  LX_ARGS("type", kind->variant.name));
        return LUXEL_ERROR_SCENE;
    }
    for (size_t s = 0; s < prepared->surface_count; s++)
        triangles += lx_mesh_count(&prepared->surfaces[s].shape);
    if (triangles <= LX_MOST_REFLECTING)
        return LUXEL_OK;
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_EXCHANGES_TOO_MANY,
              LX_ARGS(lx_write_number((double)triangles, sum), lx_write_number(LX_MOST_REFLECTING, most)));
    return LUXEL_ERROR_SCENE;
}

static luxel_status tell(const struct lx_prepared *prepared, struct lx_exchange *found, luxel_exchange **made)
{
    luxel_exchange *exchange = lx_new_array(1, sizeof *exchange);
    luxel_exchange_side *sides = lx_new_array(found->count + 1, sizeof *sides);
    bool failed = !exchange || !sides;
    for (size_t i = 0; i < found->count && !failed; i++) {
        const struct lx_exchange_side *side = &found->sides[i];
        struct lx_named_side named;
        failed = lx_side_name(prepared, side->surface, side->is_flat, side->is_back, &named);
        sides[i] = (luxel_exchange_side){.surface = named.surface,
                                         .surface_name = named.surface_name,
                                         .part = named.part,
                                         .part_name = named.part_name,
                                         .side = named.side,
                                         .area_m2 = side->area_m2};
    }
    if (failed) {
        for (size_t i = 0; sides && i < found->count; i++)
            free((char *)sides[i].surface_name);
        free(sides);
        free(exchange);
        return LUXEL_ERROR_MEMORY;
    }
    for (size_t i = 0; i < found->count * found->count; i++)
        found->factors[i] = lx_reported(found->factors[i]);
    *exchange = (luxel_exchange){found->count, sides, found->factors, found->reached};
    found->factors = NULL;
    *made = exchange;
    return LUXEL_OK;
}

static luxel_status find(struct lx_session *session, luxel_diagnostics *diagnostics, luxel_exchange **made)
{
    const luxel_settings *settings = &session->settings;
    struct lx_control control = {.rows = 1, .progress = settings->progress, .data = settings->progress_data};
    struct lx_exchange found = {.reached = true};
    const struct lx_reflected_request request = {
        .prepared = &session->prepared,
        .kernels = session->world.kernels,
        .error = lx_reflected_error_of(settings),
        .threads = lx_thread_count(settings->threads, MOST_WORTH),
        .control = &control,
    };
    luxel_status status = check_sides(&session->prepared, diagnostics);
    if (status == LUXEL_OK && session->prepared.surface_count > 0)
        status = lx_exchange_make(&request, &found);
    if (status == LUXEL_OK)
        status = tell(&session->prepared, &found, made);
    lx_exchange_clear(&found);
    return status == LUXEL_ERROR_MEMORY ? lx_out_of_memory(diagnostics) : status;
}

luxel_status luxel_find_exchange(const luxel_scene *scene, const luxel_settings *settings,
                                 luxel_diagnostics *diagnostics, luxel_exchange **exchange)
{
    struct lx_session session;
    luxel_exchange *made = NULL;
    if (!exchange)
        return lx_refuse(diagnostics, LX_MSG_MISSING_ARGUMENT, LX_ARGS("exchange"));
    luxel_status status = lx_session_open_world(scene, settings, diagnostics, &session);
    if (status == LUXEL_OK)
        status = find(&session, diagnostics, &made);
    lx_session_clear(&session);
    if (status == LUXEL_OK)
        *exchange = made;
    return status;
}
