/* SPDX-License-Identifier: MIT */
/* Solving for places, and asking at each of them. */
#include "reflecting.h"

#include <math.h>
#include <stdlib.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"

/* More threads than this are of no use. */
enum { MOST_WORTH = 64 };

bool lx_wants_reflections(const struct lx_scene_parameters *scene)
{
    return scene->reflections.choice != LX_REFLECTIONS_NONE;
}

double lx_reflected_error_of(const luxel_settings *settings)
{
    return settings->reflected_error > 0 ? settings->reflected_error : 1e-3;
}

double lx_pictured_error_of(const luxel_settings *settings)
{
    return settings->reflected_error > 0 ? settings->reflected_error : 1e-2;
}

void lx_hint_overlap(const struct lx_radiosity *reflected, const struct lx_prepared *prepared,
                     luxel_diagnostics *diagnostics)
{
    size_t surfaces[2];
    char first[LX_NUMBER_SIZE], second[LX_NUMBER_SIZE];
    if (!lx_reflected_overlaps(reflected, surfaces))
        return;
    lx_write_number((double)prepared->surfaces[surfaces[0]].authored, first);
    lx_write_number((double)prepared->surfaces[surfaces[1]].authored, second);
    lx_hint(diagnostics, LX_MSG_HINT_ONE_PLANE, LX_ARGS(first, second));
}

/* ---- the world's question ---- */

/* On surfaces by the tiles, where that is enough, elsewhere by an integral over all faces. */
static lx_bounded reflected_to(const struct lx_world *world, const struct lx_element *element,
                               struct lx_occluder_cones *cones)
{
    const struct lx_receiver receiver = lx_receiver_of(world->prepared, element);
    size_t near = 0;
    if (world->by_tiles && element->own && !receiver.is_turned)
        return lx_reflected_on(world->reflected, world->prepared, receiver.own, receiver.place_mm, receiver.normal,
                               &near);
    return lx_reflected_at(world->reflected, world->prepared, &receiver, cones);
}

void lx_reflect_elements(const struct lx_world *world, const struct lx_elements *elements,
                         const struct lx_asking *asking, struct lx_received *received)
{
    struct lx_occluder_cones cones = {0};
    for (size_t i = 0; i < elements->count && lx_asking_goes_on(asking); i++) {
        const struct lx_element element = lx_elements_get(world->prepared, elements, i);
        const lx_bounded light = reflected_to(world, &element, &cones);
        received->reflected.value[i] = light.value;
        received->reflected.error[i] = cones.failed ? HUGE_VAL : light.error;
    }
    lx_occluder_cones_clear(&cones);
}

/* ---- solving for places ---- */

/* Places that are asked, in parallel. */
struct asking {
    const struct lx_session *session;
    struct lx_control *control;
    size_t count;
    struct lx_reflected_place *places;
    size_t *of;                      /* which elements they are */
    lx_bounded *irradiance;          /* found there */
    struct lx_occluder_cones *cones; /* of each worker */
};

static void ask_places(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    const struct asking *asking = data;
    const struct lx_world *world = &asking->session->world;
    for (unsigned i = first; i < last && lx_control_goes_on(asking->control, is_caller); i++)
        asking->irradiance[i] =
            lx_reflected_at(world->reflected, world->prepared, &asking->places[i].receiver, &asking->cones[worker]);
}

static luxel_status ask(struct asking *asking, unsigned threads)
{
    asking->cones = lx_new_array(threads, sizeof *asking->cones);
    const struct lx_rows_part part = {
        .last = (unsigned)asking->count, .counts_itself = true, .work = ask_places, .data = asking};
    luxel_status status = !asking->cones                                       ? LUXEL_ERROR_MEMORY
                          : !lx_rows_run_part(asking->control, threads, &part) ? LUXEL_CANCELLED
                                                                               : LUXEL_OK;
    for (unsigned w = 0; asking->cones && w < threads; w++) {
        status = status == LUXEL_OK && asking->cones[w].failed ? LUXEL_ERROR_MEMORY : status;
        lx_occluder_cones_clear(&asking->cones[w]);
    }
    free(asking->cones);
    return status;
}

static luxel_status find_places(const struct lx_reflecting *reflecting, struct asking *asking)
{
    const size_t count = reflecting->count * (reflecting->response ? LX_MOST_RECEIVERS : 1);
    asking->places = lx_new_array(count, sizeof *asking->places);
    asking->of = lx_new_array(count, sizeof *asking->of);
    asking->irradiance = lx_new_array(count, sizeof *asking->irradiance);
    if (!asking->places || !asking->of || !asking->irradiance)
        return LUXEL_ERROR_MEMORY;
    for (size_t i = 0; i < reflecting->count; i++) {
        struct lx_element element;
        struct lx_receiver receivers[LX_MOST_RECEIVERS];
        double direct;
        if (!reflecting->element(reflecting->data, i, &element, &direct))
            continue;
        const size_t found = lx_receivers_of(&asking->session->prepared, &element, reflecting->response, receivers);
        for (size_t k = 0; k < found; k++) {
            asking->places[asking->count] = (struct lx_reflected_place){receivers[k], direct / (double)found};
            asking->of[asking->count++] = i;
        }
    }
    return LUXEL_OK;
}

/* Whether the solution that was left by whoever asked before is enough, which the session's world then has. */
static bool takes_kept(struct lx_session *session, struct lx_kept_slot *slot,
                       const struct lx_reflected_request *request)
{
    struct lx_world *world = &session->world;
    struct lx_radiosity *own = world->reflected, *kept = lx_reflected_of_places(slot, &request->key);
    if (!kept)
        return false;
    world->reflected = kept;
    const bool serves = lx_reflected_serves(session, request);
    world->reflected = serves ? kept : own;
    lx_reflected_free(serves ? own : kept);
    return serves;
}

/* Finds a solution that is exact enough at the places. */
static luxel_status solve(struct lx_session *session, const struct lx_reflecting *reflecting,
                          const struct asking *asking, unsigned threads)
{
    struct lx_world *world = &session->world;
    const struct lx_reflected_key key = reflecting->key ? *reflecting->key : lx_reflected_key_of_places(session);
    const struct lx_reflected_request request = {
        .prepared = world->prepared,
        .kernels = world->kernels,
        .error = lx_reflected_error_of(&session->settings),
        .places = asking->places,
        .place_count = asking->count,
        .key = key,
        .threads = threads,
        .control = reflecting->control,
        .within = session->settings.within,
        .is_enough = session->settings.enough,
    };
    struct lx_radiosity *made = NULL;
    const bool is_shared = session->settings.share_reflected && world->reflected;
    if (is_shared || takes_kept(session, reflecting->slot, &request) || lx_reflected_serves(session, &request))
        return LUXEL_OK;
    const luxel_status status = lx_reflected_make(&request, &made);
    lx_reflected_free(world->reflected);
    world->reflected = made;
    if (made && reflecting->slot)
        lx_kept_slot_put(reflecting->slot, lx_reflected_kept(made));
    return status;
}

luxel_status lx_reflect_places(struct lx_session *session, const struct lx_reflecting *reflecting, bool is_known,
                               luxel_diagnostics *diagnostics)
{
    const unsigned threads = lx_thread_count(session->settings.threads, MOST_WORTH);
    struct asking asking = {.session = session, .control = reflecting->control};
    luxel_status status = find_places(reflecting, &asking);
    if (status == LUXEL_OK && asking.count > 0 && !is_known)
        status = solve(session, reflecting, &asking, threads);
    if (status == LUXEL_OK && asking.count > 0)
        status = ask(&asking, threads);
    for (size_t i = 0, next; i < asking.count && status == LUXEL_OK; i = next) {
        lx_bounded sum = asking.irradiance[i];
        for (next = i + 1; next < asking.count && asking.of[next] == asking.of[i]; next++)
            sum = lx_add(sum, asking.irradiance[next]);
        reflecting->take(reflecting->data, asking.of[i], sum);
    }
    free(asking.places);
    free(asking.of);
    free(asking.irradiance);
    return status == LUXEL_ERROR_MEMORY ? lx_out_of_memory(diagnostics) : status;
}
