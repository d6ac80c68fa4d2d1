/* SPDX-License-Identifier: MIT */
/*
 * The unified glare rating of an observer in a scene.  Each light, or each place of its array, is one source: the
 * middle and the area of what its emitters show to the eye tell its solid angle and where in the field of view it is;
 * what part of it surfaces hide is told by the irradiance that it gives there with and without their shadows.  The
 * background is the irradiance of the eye by reflected and ambient light.
 */
#include <luxel/glare.h>

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/glare.h"
#include "../base/memory.h"
#include "../base/phrase.h"
#include "../base/vector.h"
#include "../light/array.h"
#include "../scene/colours.h"
#include "../scene/observer.h"
#include "../scene/scene.h"
#include "../world/evaluate.h"
#include "coloring.h"
#include "glare_light.h"
#include "reflecting.h"

/* How exact places, areas and position indices are, relative: some roundings of plain float64. */
static const double PLAIN = 1e-13;

const char *luxel_glare_reason_words(luxel_glare_reason reason)
{
    static const char *const words[] = {
        [LUXEL_GLARE_COUNTS] = LX_N("counts"),
        [LUXEL_GLARE_NO_AREA] = LX_N("has no luminous area"),
        [LUXEL_GLARE_UNSEEN] = LX_N("outside the field of view"),
        [LUXEL_GLARE_HIDDEN] = LX_N("hidden"),
        [LUXEL_GLARE_DARK] = LX_N("shines elsewhere"),
        [LUXEL_GLARE_BACKGROUND] = LX_N("part of the background"),
    };
    return reason <= LUXEL_GLARE_BACKGROUND ? words[reason] : NULL;
}

void luxel_glare_free(luxel_glare *glare)
{
    if (!glare)
        return;
    for (size_t i = 0; i < glare->source_count; i++)
        free((char *)glare->sources[i].name);
    free(glare->sources);
    free(glare);
}

/* ---- the observer ---- */

/* The eye and its directions, unit and at right angles. */
struct eye {
    const double *place_mm;
    double ahead[3], aside[3], above[3];
};

static bool normalize(double a[3])
{
    double length = lx_normalize(a);
    return length > 0 && isfinite(length);
}

/* Takes the part along a unit direction out of another one; false: nothing is left. */
static bool make_across(const double along[3], double a[3])
{
    if (!normalize(a))
        return false;
    double part = lx_dot(along, a);
    for (int i = 0; i < 3; i++)
        a[i] -= part * along[i];
    return lx_normalize(a) > 1e-9;
}

static bool open_eye(const struct lx_scene_parameters *scene, const luxel_glare_sight *sight, struct eye *eye)
{
    static const double z[3] = {0, 0, 1};
    const bool has_up = sight->up[0] != 0 || sight->up[1] != 0 || sight->up[2] != 0;
    const double *scene_up = lx_scene_up(scene);
    eye->place_mm = sight->eye_mm;
    memcpy(eye->ahead, sight->view, sizeof eye->ahead);
    memcpy(eye->above, has_up ? sight->up : scene_up ? scene_up : z, sizeof eye->above);
    if (!isfinite(lx_dot(sight->eye_mm, sight->eye_mm)) || !normalize(eye->ahead))
        return false;
    if (!make_across(eye->ahead, eye->above)) {
        memcpy(eye->above, (const double[3]){0, 1, 0}, sizeof eye->above);
        if (has_up || !make_across(eye->ahead, eye->above))
            return false;
    }
    lx_cross(eye->ahead, eye->above, eye->aside);
    return true;
}

/* ---- the sum over the sources ---- */

/* A rating in the making. */
struct rating {
    struct lx_session *session;
    struct lx_prepared open; /* the scene without shadows */
    struct eye eye;
    luxel_glare *glare;
    lx_bounded sum;                /* of L^2 w / p^2 */
    lx_bounded ambient, reflected; /* irradiance of the eye: by lights that are part of the background, by surfaces */
    lx_bounded *shares;            /* of the sources */
    struct lx_kept_slot *slot;     /* where what surfaces reflect is left */
};

static lx_bounded plain(double value)
{
    return (lx_bounded){value, PLAIN * fabs(value)};
}

/* An element at the eye. */
static struct lx_element element_at(const struct lx_prepared *prepared, const struct eye *eye, const double normal[3])
{
    luxel_place place = {.is_element = true};
    memcpy(place.position_mm, eye->place_mm, sizeof place.position_mm);
    memcpy(place.normal, normal, sizeof place.normal);
    return lx_element_at(prepared, &place);
}

/* The irradiance of an element at the eye by emitters, 0 where one lies on the eye. */
static lx_bounded light_eye(const struct lx_world *world, const struct eye *eye, const double normal[3], size_t first,
                            size_t end)
{
    const struct lx_element element = element_at(world->prepared, eye, normal);
    struct lx_elements elements;
    struct lx_received received;
    lx_elements_of_one(world->prepared, &element, &elements);
    lx_world_light_between(world, &elements, first, end, LX_WANT_IRRADIANCE, NULL, &received);
    return received.on_element[0] ? lx_exact(0) : lx_column_get(&received.irradiance, 0);
}

/* The numbers of a source that has an area in the field of view, and its share of the sum. */
static lx_bounded weigh(const struct lx_light_seen *seen, lx_bounded open, lx_bounded shadowed,
                        luxel_glare_source *source)
{
    const double solid_angle = seen->area_m2 / (seen->distance_m * seen->distance_m);
    const bool is_lambertian = seen->radiance.value > 0;
    const lx_bounded luminance = is_lambertian ? seen->radiance : lx_div(open, plain(solid_angle));
    const lx_bounded part = lx_div(shadowed, open);
    source->luminance = luminance.value;
    source->solid_angle = solid_angle;
    source->seen = fmin(1, part.value);
    if (!(shadowed.value > 0))
        source->reason = LUXEL_GLARE_HIDDEN;
    else if (isnan(source->position_index))
        source->reason = LUXEL_GLARE_UNSEEN;
    if (source->reason != LUXEL_GLARE_COUNTS)
        return lx_exact(0);
    return lx_mul(lx_mul(lx_mul(luminance, luminance), part),
                  plain(solid_angle / (source->position_index * source->position_index)));
}

/* Rates emitters of the session as a source; `whole`: the same without parts. */
static lx_bounded rate_source(struct rating *rating, const struct lx_emitters *whole, size_t first, size_t end,
                              luxel_glare_source *source)
{
    const struct eye *eye = &rating->eye;
    const struct lx_world without_shadows = {.prepared = &rating->open, .kernels = rating->session->world.kernels};
    struct lx_light_seen seen;
    lx_see_emitters(whole, eye->place_mm, &seen);
    const double *normal = seen.distance_m > 0 ? seen.towards : eye->ahead;
    source->position_index = seen.distance_m > 0
                                 ? lx_position_index(lx_dot(seen.towards, eye->ahead), lx_dot(seen.towards, eye->aside),
                                                     lx_dot(seen.towards, eye->above))
                                 : (double)NAN;
    const lx_bounded open = light_eye(&without_shadows, eye, normal, first, end);
    const lx_bounded shadowed = light_eye(&rating->session->world, eye, normal, first, end);
    if (seen.is_uniform) {
        source->reason = LUXEL_GLARE_BACKGROUND;
        rating->ambient = lx_add(rating->ambient, shadowed);
    } else if (!(open.value > 0)) {
        source->reason = LUXEL_GLARE_DARK;
    } else if (!(seen.area_m2 > 0)) {
        source->reason = LUXEL_GLARE_NO_AREA;
    } else {
        const lx_bounded share = weigh(&seen, open, shadowed, source);
        rating->sum = lx_add(rating->sum, share);
        return share;
    }
    return lx_exact(0);
}

/* Rates a light place by place; `next`, the first of its emitters, moves behind them. */
static luxel_status rate_light(struct rating *rating, size_t light, size_t *next)
{
    const struct lx_prepared *prepared = &rating->session->prepared;
    const struct lx_item *item = &prepared->scene->lights.items[light];
    const struct lx_light_common *common = item->common;
    const size_t places = lx_light_places(item), first = *next;
    luxel_glare *glare = rating->glare;
    struct lx_emitters whole = {.is_whole = true};
    struct lx_emitter room;
    luxel_status status =
        lx_light_lower(item, prepared->scene->maintenance, lx_dimming_of(prepared->scene, item), &whole) == 0
            ? LUXEL_OK
            : LUXEL_ERROR_MEMORY;
    while (*next < prepared->emitters.count && lx_emitter_at(&prepared->emitters, *next, &room)->light == light)
        (*next)++;
    const size_t each = (*next - first) / places;
    for (size_t place = 0; place < places && status == LUXEL_OK; place++) {
        const struct lx_emitters these = lx_emitters_of_place(&whole, places, place);
        luxel_glare_source *source = &glare->sources[glare->source_count];
        *source = (luxel_glare_source){.light = light, .type = item->variant->name, .place = place, .places = places};
        if (common->name && !(source->name = lx_copy_text(common->name, strlen(common->name))))
            status = LUXEL_ERROR_MEMORY;
        else
            rating->shares[glare->source_count++] =
                rate_source(rating, &these, first + place * each, first + (place + 1) * each, source);
    }
    lx_emitters_clear(&whole);
    return status;
}

/* Reads the lights of the group that gives light; they come first, so that names can be freed. */
static luxel_status rate_lights(struct rating *rating)
{
    const struct lx_list *lights = &rating->session->prepared.scene->lights;
    luxel_glare *glare = rating->glare;
    luxel_status status = LUXEL_OK;
    size_t next = 0, most = 1;
    for (size_t i = 0; i < lights->count; i++)
        most += rating->session->prepared.on[i] ? lx_light_places(&lights->items[i]) : 0;
    glare->sources = lx_new_array(most, sizeof *glare->sources);
    rating->shares = lx_new_array(most, sizeof *rating->shares);
    if (!glare->sources || !rating->shares)
        return LUXEL_ERROR_MEMORY;
    for (size_t i = 0; i < lights->count && status == LUXEL_OK; i++)
        if (rating->session->prepared.on[i])
            status = rate_light(rating, i, &next);
    for (size_t i = 0; i < glare->source_count && rating->sum.value > 0; i++)
        glare->sources[i].share = rating->shares[i].value / rating->sum.value;
    return status;
}

/* ---- the background ---- */

/* The eye as an element that looks ahead, and what falls on it directly of the background. */
static bool ask_eye(const void *data, size_t i, struct lx_element *element, double *direct)
{
    const struct rating *rating = data;
    (void)i;
    *element = element_at(&rating->session->prepared, &rating->eye, rating->eye.ahead);
    *direct = rating->ambient.value;
    return true;
}

static void take_reflected(void *data, size_t i, lx_bounded irradiance)
{
    (void)i;
    ((struct rating *)data)->reflected = irradiance;
}

/* What surfaces reflect to the eye, in a session that may have shared what it knows. */
static luxel_status reflect(struct rating *rating, luxel_diagnostics *diagnostics)
{
    const luxel_settings *settings = &rating->session->settings;
    struct lx_control control = {.rows = 1, .progress = settings->progress, .data = settings->progress_data};
    const struct lx_reflecting reflecting = {&control, 1, ask_eye, take_reflected, rating, rating->slot, NULL, NULL};
    return lx_reflect_places(rating->session, &reflecting, false, diagnostics);
}

/* The luminance of that where it is a sum of parts. */
static luxel_status reflect_parts(const luxel_scene *scene, struct rating *rating, luxel_diagnostics *diagnostics)
{
    luxel_settings settings = rating->session->settings;
    struct lx_color_parts parts;
    settings.quantity = LUXEL_IRRADIANCE;
    luxel_status status = lx_color_parts_make(scene, &settings, diagnostics, &parts);
    for (size_t p = 0; p < parts.count && status == LUXEL_OK; p++) {
        const struct lx_color_part *part = &parts.list[p];
        luxel_settings own = part->settings;
        struct lx_part_progress progress;
        struct lx_session session;
        struct rating of_part = {.session = &session,
                                 .eye = rating->eye,
                                 .ambient = rating->ambient,
                                 .slot = lx_scene_reflected_on_plane(part->scene)};
        lx_part_progress_begin(&progress, p, parts.count, &settings, &own);
        status = lx_session_open_world(part->scene, &own, diagnostics, &session);
        if (status == LUXEL_OK)
            status = reflect(&of_part, diagnostics);
        rating->reflected =
            lx_add_part(rating->reflected, part->luminance, of_part.reflected.value, of_part.reflected.error);
        lx_session_clear(&session);
    }
    lx_color_parts_clear(&parts);
    return status;
}

/* UGR and its bound: between the least sum over the greatest background and the other way round. */
static void conclude(const struct rating *rating, lx_bounded background)
{
    luxel_glare *glare = rating->glare;
    const lx_bounded sum = rating->sum;
    glare->background = lx_reported(background);
    glare->has_rating = rating->session->prepared.scene->units == LX_PHOTOMETRIC && sum.value > sum.error &&
                        background.value > background.error;
    if (!glare->has_rating)
        return;
    glare->rating.value = 8 * log10(0.25 * sum.value / background.value);
    glare->rating.error =
        8 * fmax(
                log10((sum.value + sum.error) / sum.value * background.value / (background.value - background.error)),
                log10(sum.value / (sum.value - sum.error) * (background.value + background.error) / background.value)) +
        16 * DBL_EPSILON * (1 + fabs(glare->rating.value));
}

static luxel_status rate(const luxel_scene *scene, struct rating *rating, luxel_diagnostics *diagnostics)
{
    const luxel_settings *settings = &rating->session->settings;
    luxel_status status = rate_lights(rating);
    if (status == LUXEL_OK && lx_wants_reflections(rating->session->prepared.scene))
        status = lx_is_sum_of_channels(lx_scene_parameters(scene), LUXEL_IRRADIANCE)
                     ? reflect_parts(scene, rating, diagnostics)
                     : reflect(rating, diagnostics);
    const lx_bounded background = lx_add(rating->reflected, rating->ambient);
    rating->glare->reached = rating->reflected.error <= lx_reflected_error_of(settings) * fabs(background.value);
    if (status == LUXEL_OK)
        conclude(rating, lx_div(background, plain(M_PI)));
    return status == LUXEL_ERROR_MEMORY ? lx_out_of_memory(diagnostics) : status;
}

/* Images of lamps in mirrors would have places of their own in the field of view. */
static luxel_status refuse_mirrors(const struct lx_prepared *prepared, luxel_diagnostics *diagnostics)
{
    if (prepared->mirrors.count == 0)
        return LUXEL_OK;
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_GLARE_OF_MIRRORS, NULL);
    return LUXEL_ERROR_SCENE;
}

luxel_status luxel_find_glare(const luxel_scene *scene, const luxel_settings *settings, const luxel_glare_sight *sight,
                              luxel_diagnostics *diagnostics, luxel_glare **glare)
{
    struct lx_session session;
    struct rating rating = {.session = &session, .sum = lx_exact(0), .ambient = lx_exact(0), .reflected = lx_exact(0)};
    if (!sight || !glare)
        return lx_refuse(diagnostics, LX_MSG_MISSING_ARGUMENT, LX_ARGS(glare ? "sight" : "glare"));
    luxel_status status = LX_CHECK_RESERVE(sight, diagnostics);
    if (status != LUXEL_OK)
        return status;
    status = lx_session_open_world(scene, settings, diagnostics, &session);
    if (status == LUXEL_OK)
        rating.slot = lx_scene_reflected_on_plane(scene);
    if (status == LUXEL_OK)
        status = refuse_mirrors(&session.prepared, diagnostics);
    if (status == LUXEL_OK && !open_eye(session.prepared.scene, sight, &rating.eye)) {
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_MISSING_ARGUMENT, LX_ARGS("sight"));
        status = LUXEL_ERROR_ARGUMENT;
    }
    if (status == LUXEL_OK && !lx_is_sum_of_channels(lx_scene_parameters(scene), LUXEL_IRRADIANCE))
        status = lx_reflect_shared(scene, &session, diagnostics);
    if (status == LUXEL_OK) {
        rating.open = session.prepared;
        rating.open.shadows_on_free = rating.open.shadows_extended = false;
        rating.glare = lx_new_array(1, sizeof *rating.glare);
        status = rating.glare ? rate(scene, &rating, diagnostics) : lx_out_of_memory(diagnostics);
    }
    lx_session_clear(&session);
    free(rating.shares);
    if (status == LUXEL_OK)
        *glare = rating.glare;
    else
        luxel_glare_free(rating.glare);
    return status;
}
