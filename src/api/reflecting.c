/* SPDX-License-Identifier: MIT */
/* Solving for places, and asking at each of them. */
#include "reflecting.h"

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

/* Places that are asked, in parallel. */
struct asking {
    const struct lx_reflecting *reflecting;
    const struct lx_radiosity *reflected;
    struct lx_veils *veils; /* of each worker */
};

static void ask_places(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    const struct asking *asking = data;
    for (unsigned i = first; i < last && lx_control_goes_on(asking->reflecting->control, is_caller); i++)
        asking->reflecting->irradiance[i] =
            lx_reflected_at(asking->reflected, asking->reflecting->prepared, &asking->reflecting->places[i].receiver,
                            &asking->veils[worker]);
}

static luxel_status ask(const struct lx_reflecting *reflecting, const struct lx_radiosity *reflected, unsigned threads)
{
    struct asking asking = {reflecting, reflected, lx_new_array(threads, sizeof *asking.veils)};
    const struct lx_rows_part part = {
        .last = (unsigned)reflecting->count, .counts_itself = true, .work = ask_places, .data = &asking};
    luxel_status status = !asking.veils                                            ? LUXEL_ERROR_MEMORY
                          : !lx_rows_run_part(reflecting->control, threads, &part) ? LUXEL_CANCELLED
                                                                                   : LUXEL_OK;
    for (unsigned w = 0; asking.veils && w < threads; w++) {
        status = status == LUXEL_OK && asking.veils[w].failed ? LUXEL_ERROR_MEMORY : status;
        lx_veils_clear(&asking.veils[w]);
    }
    free(asking.veils);
    return status;
}

luxel_status lx_ask_places(const struct lx_reflecting *reflecting, const struct lx_radiosity *reflected,
                           luxel_diagnostics *diagnostics)
{
    const luxel_status status = ask(reflecting, reflected, lx_thread_count(reflecting->settings->threads, MOST_WORTH));
    return status == LUXEL_ERROR_MEMORY ? lx_out_of_memory(diagnostics) : status;
}

luxel_status lx_reflect_places(const struct lx_reflecting *reflecting, luxel_diagnostics *diagnostics)
{
    const unsigned threads = lx_thread_count(reflecting->settings->threads, MOST_WORTH);
    const struct lx_reflected_wish wish = {
        .prepared = reflecting->prepared,
        .kernels = reflecting->kernels,
        .error = lx_reflected_error_of(reflecting->settings),
        .places = reflecting->places,
        .place_count = reflecting->count,
        .key = reflecting->key ? *reflecting->key : (struct lx_reflected_key){0},
        .threads = threads,
        .control = reflecting->control,
    };
    struct lx_radiosity *reflected = NULL;
    const struct lx_radiosity *picture = reflecting->picture;
    if (picture && !reflecting->settings->share_reflected && !lx_reflected_is_reached(picture, &wish))
        picture = NULL;
    luxel_status status = picture ? LUXEL_OK : lx_reflected_make(&wish, &reflected);
    if (status == LUXEL_OK)
        status = ask(reflecting, picture ? picture : reflected, threads);
    if (status == LUXEL_OK && reflected && reflecting->slot)
        lx_kept_slot_put(reflecting->slot, lx_reflected_kept(reflected));
    lx_reflected_free(reflected);
    return status == LUXEL_ERROR_MEMORY ? lx_out_of_memory(diagnostics) : status;
}
