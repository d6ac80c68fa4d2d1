/* SPDX-License-Identifier: MIT */
/* Reflected light in pictures: solving for what the picture shows, and adding it to pixels. */
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../format/kept.h"
#include "../picture/seen.h"
#include "../world/evaluate.h"
#include "reflecting.h"

/* The picture is looked at by so many samples on each axis, or by all of its pixels; of about so many of them the whole
 * value is asked for, which tells how bright the picture is at least. */
enum { SAMPLES = 160, WHOLE = 24 };
/* More threads than these are not worth their while. */
enum { MOST_WORTH = 64 };

/* ---- what the picture shows ---- */

struct looking {
    const struct lx_session *session;
    struct luxel_evaluator evaluator; /* of the session's scene, for direct light */
    struct lx_control *control;
    unsigned columns, rows;
    struct lx_reflected_spot *spots; /* of each sample; a share of 0: shows nothing */
};

static unsigned samples_of(unsigned pixels)
{
    return pixels < SAMPLES ? pixels : SAMPLES;
}

static void take(double to[3], lx_bounded3 from)
{
    to[0] = from.x.value, to[1] = from.y.value, to[2] = from.z.value;
}

/* Sample i of a row. */
static void look_at(const struct looking *looking, unsigned row, unsigned i)
{
    const struct lx_prepared *prepared = &looking->session->prepared;
    const struct lx_screen *screen = &prepared->scene->screen;
    const luxel_quantity quantity = looking->session->settings.quantity;
    struct lx_reflected_spot *spot = &looking->spots[row * looking->columns + i];
    const double x_mm = lx_column_x_mm(screen, (unsigned)((i + 0.5) / looking->columns * screen->resolution[0]));
    const double y_mm = lx_row_y_mm(screen, (unsigned)((row + 0.5) / looking->rows * screen->resolution[1]));
    struct lx_element element;
    if (!lx_element_seen(prepared, x_mm, y_mm, &element))
        return;
    spot->surface = (size_t)(element.own - prepared->surfaces);
    spot->share = lx_reflected_value(element.lobe, quantity, lx_exact(1)).value;
    take(spot->place_mm, element.place_mm);
    take(spot->normal, element.normal);
    if (row % (looking->rows / WHOLE + 1) == 0 && i % (looking->columns / WHOLE + 1) == 0) {
        const luxel_value found = lx_evaluate_element(&looking->evaluator, &element, NULL);
        spot->value = found.has_value && isfinite(found.value) ? found.value : 0;
    }
}

static void look_at_rows(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    const struct looking *looking = data;
    (void)worker;
    for (unsigned row = first; row < last; row++)
        for (unsigned i = 0; i < looking->columns && lx_control_goes_on(looking->control, is_caller); i++)
            look_at(looking, row, i);
}

/* Leaves the spots that show something; returns how many. */
static size_t pack(struct lx_reflected_spot *spots, size_t count)
{
    size_t kept = 0;
    for (size_t i = 0; i < count; i++)
        if (spots[i].share > 0)
            spots[kept++] = spots[i];
    return kept;
}

/* ---- solving ---- */

static luxel_status solve(const struct lx_session *session, const struct lx_reflected_key *key,
                          struct lx_control *control, struct lx_radiosity **made)
{
    const unsigned threads = lx_thread_count(session->settings.threads, MOST_WORTH);
    const unsigned *resolution = session->prepared.scene->screen.resolution;
    struct looking looking = {
        .session = session,
        .evaluator = {.settings = session->settings,
                      .world = {.prepared = &session->prepared, .kernels = session->world.kernels}},
        .control = control,
        .columns = samples_of(resolution[0]),
        .rows = samples_of(resolution[1]),
    };
    const size_t count = (size_t)looking.columns * looking.rows;
    looking.spots = lx_new_array(count, sizeof *looking.spots);
    if (!looking.spots)
        return LUXEL_ERROR_MEMORY;
    const struct lx_rows_part part = {
        .last = looking.rows, .counts_itself = true, .work = look_at_rows, .data = &looking};
    luxel_status status = lx_rows_run_part(control, threads, &part) ? LUXEL_OK : LUXEL_CANCELLED;
    if (status == LUXEL_OK) {
        const struct lx_reflected_request request = {
            .prepared = &session->prepared,
            .kernels = session->world.kernels,
            .error = key->error,
            .spots = looking.spots,
            .spot_count = pack(looking.spots, count),
            .key = *key,
            .threads = threads,
            .control = control,
            .within = session->settings.within,
            .is_enough = session->settings.enough,
        };
        status = lx_reflected_make(&request, made);
    }
    free(looking.spots);
    return status;
}

/* The solution in something kept (NULL: nothing), which it takes, if it was made with the same, or also for other eyes;
 * NULL: there is none. */
static struct lx_radiosity *taken(struct lx_kept *kept, const struct lx_reflected_key *key, bool is_elsewhere)
{
    struct lx_radiosity *found = !kept          ? NULL
                                 : is_elsewhere ? lx_reflected_like_kept(kept, key)
                                                : lx_reflected_of_kept(kept, key);
    if (!found)
        lx_kept_release(kept);
    return found;
}

/* The solution that the scene keeps, if it was made with the same; NULL: there is none. */
static struct lx_radiosity *find_kept(struct lx_kept_slot *slot, const struct lx_reflected_key *key)
{
    return taken(slot ? lx_kept_slot_look(slot) : NULL, key, false);
}

/* The settings that a solution for the session's picture is made with. */
static struct lx_reflected_key key_of(const struct lx_session *session)
{
    const luxel_settings *settings = &session->settings;
    return (struct lx_reflected_key){.quantity = (int)settings->quantity,
                                     .error = lx_pictured_error_of(settings),
                                     .tolerance = session->prepared.tolerance,
                                     .kernels = session->kernels,
                                     .on = session->prepared.on,
                                     .within = settings->within,
                                     .is_asked = settings->enough};
}

struct lx_radiosity *lx_reflected_of_picture(const luxel_scene *scene, const struct lx_session *session)
{
    const struct lx_reflected_key key = key_of(session);
    return find_kept(lx_scene_reflected(scene), &key);
}

struct lx_reflected_key lx_reflected_key_of_places(const struct lx_session *session)
{
    struct lx_reflected_key key = key_of(session);
    key.quantity = INT_MIN; /* below those of pictures and planes */
    key.error = lx_reflected_error_of(&session->settings);
    return key;
}

struct lx_radiosity *lx_reflected_of_places(struct lx_kept_slot *slot, const struct lx_reflected_key *key)
{
    return taken(slot ? lx_kept_slot_look(slot) : NULL, key, true);
}

struct lx_reflected_key lx_reflected_key_of_plane(const struct lx_session *session, size_t i)
{
    struct lx_reflected_key key = lx_reflected_key_of_places(session);
    key.quantity = -1 - (int)i; /* below those of pictures */
    return key;
}

struct lx_radiosity *lx_reflected_of_plane(const luxel_scene *scene, const struct lx_session *session, size_t i)
{
    const struct lx_reflected_key key = lx_reflected_key_of_plane(session, i);
    return find_kept(lx_scene_reflected_on_plane(scene), &key);
}

luxel_status lx_reflect_picture(const luxel_scene *scene, struct lx_session *session, luxel_diagnostics *diagnostics)
{
    const luxel_settings *settings = &session->settings;
    if (!lx_wants_reflections(session->prepared.scene))
        return LUXEL_OK;
    struct lx_kept_slot *slot = lx_scene_reflected(scene);
    const struct lx_reflected_key key = key_of(session);
    struct lx_control control = {.rows = 1, .progress = settings->progress, .data = settings->progress_data};
    session->world.reflected = find_kept(slot, &key);
    if (!session->world.reflected && settings->share_reflected)
        session->world.reflected = taken(lx_scene_reflected_elsewhere(scene), &key, true);
    if (session->world.reflected)
        return LUXEL_OK;
    const luxel_status status = solve(session, &key, &control, &session->world.reflected);
    session->done = control.before;
    if (status == LUXEL_OK && slot)
        lx_kept_slot_put(slot, lx_reflected_kept(session->world.reflected));
    return status == LUXEL_ERROR_MEMORY ? lx_out_of_memory(diagnostics) : status;
}

luxel_status lx_reflect_shared(const luxel_scene *scene, struct lx_session *session, luxel_diagnostics *diagnostics)
{
    return session->settings.share_reflected ? lx_reflect_picture(scene, session, diagnostics) : LUXEL_OK;
}

/* ---- pixels ---- */

/* A vector of the screen's frame in the scene's. */
static void bring(const struct lx_frame *frame, const double carried[3], double brought[3])
{
    for (int i = 0; i < 3; i++)
        brought[i] = 0;
    for (int k = 0; k < 3; k++) {
        brought[0] += carried[k] * frame->rounded[k].x.value;
        brought[1] += carried[k] * frame->rounded[k].y.value;
        brought[2] += carried[k] * frame->rounded[k].z.value;
    }
}

/* Element k of a block on surface s, in the frame of the scene. */
static void element_of(const struct lx_session *session, const struct lx_block_double *block, size_t s, size_t k,
                       double place_mm[3], double normal[3])
{
    const struct lx_plan *plan = &session->plan;
    const struct lx_frame *frame = &session->prepared.camera.frame;
    const double *anchor = plan->surfaces[s].shape.anchor_mm;
    const double place[3] = {block->px[k] + anchor[0], block->py[k] + anchor[1], block->pz[k] + anchor[2]};
    const double faces[3] = {block->nx[k], block->ny[k], block->nz[k]};
    for (int i = 0; i < 3; i++) {
        place_mm[i] = place[i];
        normal[i] = faces[i];
    }
    if (!plan->carried)
        return;
    bring(frame, place, place_mm);
    bring(frame, faces, normal);
    for (int i = 0; i < 3; i++)
        place_mm[i] += frame->origin_mm[i];
}

static void add(const struct lx_session *session, const struct lx_lit_row *row, size_t i, double value)
{
    if (session->settings.precision == LUXEL_DOUBLE)
        ((double *)row->values)[i] += value;
    else
        ((float *)row->values)[i] = (float)((double)((float *)row->values)[i] + value);
}

/* The pixels from `first` on, no more than a block of them. */
static double reflect_block(const struct lx_session *session, struct lx_seen *seen, const struct lx_lit_row *row,
                            size_t first, size_t count)
{
    const struct lx_plan *plan = &session->plan;
    _Alignas(64) double x_mm[LX_BLOCK]; /* as kernels read it: whole lanes */
    double error = 0;
    memcpy(x_mm, row->x_mm + first, count * sizeof *x_mm);
    lx_seen_pad(x_mm, count);
    size_t left = lx_seen_find(plan, seen, row->y_mm, x_mm, count), near = 0;
    for (size_t s = 0; left > 0 && s < plan->surface_count; s++) {
        const struct lx_seen_run gathered = lx_seen_gather(plan, seen, s, count);
        const double share =
            lx_reflected_value(&session->prepared.surfaces[s].lobe, session->settings.quantity, lx_exact(1)).value;
        for (size_t k = 0; k < gathered.count; k++) {
            const size_t pixel = first + (gathered.first < LX_BLOCK ? gathered.first + k : seen->place[k]);
            double place[3], normal[3];
            if (!row->mask[pixel])
                continue;
            element_of(session, &seen->block, s, k, place, normal);
            const lx_bounded light =
                lx_reflected_on(session->world.reflected, &session->prepared, s, place, normal, &near);
            add(session, row, pixel, share * light.value);
            error = fmax(error, share * light.error);
        }
        left -= gathered.count;
    }
    return error;
}

double lx_reflect_row(const struct lx_session *session, struct lx_shader_memory *memory, const struct lx_lit_row *row)
{
    double error = 0;
    for (size_t first = 0; first < row->count; first += LX_BLOCK) {
        const size_t count = row->count - first < LX_BLOCK ? row->count - first : LX_BLOCK;
        error = fmax(error, reflect_block(session, lx_shader_seen(memory), row, first, count));
    }
    return error;
}
