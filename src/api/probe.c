/* SPDX-License-Identifier: MIT */
/* Probes: the reference summed over the lights at each place, and the picture's value at the same pixel. */
#include <luxel/probe.h>

#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../base/rows.h"
#include "../scene/lit.h"
#include "../scene/materials.h"
#include "../scene/scene.h"
#include "../world/albedo.h"
#include "../world/bodies.h"
#include "../world/camera.h"
#include "../world/evaluate.h"
#include "../world/mirrors.h"
#include "coloring.h"
#include "probe_pixels.h"
#include "reflecting.h"
#include "session.h"

/* Probes with all that they point to: a single one is the first of one. */
struct luxel_probes {
    luxel_light_share *shares; /* of all probes, one after the other */
    luxel_light_share *named;  /* what each begins with: one for each light that is on, with its words */
    size_t named_count;
    luxel_color *colors;  /* of all shares; NULL: they have none */
    char **surface_names; /* of all surfaces */
    size_t surface_count;
    size_t count;
    luxel_probe list[];
};

size_t luxel_probes_count(const luxel_probes *probes)
{
    return probes ? probes->count : 0;
}

const luxel_probe *luxel_probes_get(const luxel_probes *probes, size_t i)
{
    return i < luxel_probes_count(probes) ? &probes->list[i] : NULL;
}

void luxel_probes_free(luxel_probes *probes)
{
    if (!probes)
        return;
    for (size_t i = 0; probes->named && i < probes->named_count; i++)
        free((char *)probes->named[i].name);
    for (size_t i = 0; probes->surface_names && i < probes->surface_count; i++)
        free(probes->surface_names[i]);
    free(probes->shares);
    free(probes->named);
    free(probes->colors);
    free((void *)probes->surface_names);
    free(probes);
}

double luxel_probe_albedo(const luxel_scene *scene, const luxel_probe *probe)
{
    double channels[LX_CHANNELS];
    if (!scene || !luxel_scene_is_committed(scene) || !probe || !probe->on_surface ||
        probe->surface >= lx_scene_parameters(scene)->surfaces.count)
        return (double)NAN;
    const double *n = probe->normal, *v = probe->view, n_dot_v = n[0] * v[0] + n[1] * v[1] + n[2] * v[2];
    const struct lx_scene_material at = lx_material_of(lx_scene_parameters(scene), probe->surface, probe->part);
    if (!luxel_scene_has_color(scene) || !lx_has_color(at.material))
        return lx_material_albedo(at.material, n_dot_v);
    for (unsigned c = 0; c < LX_CHANNELS; c++) {
        const struct lx_material seen = lx_material_in_channel(at.material, c + 1);
        channels[c] = lx_material_albedo(&seen, n_dot_v);
    }
    return luxel_rgb_luminance(channels);
}

void luxel_probe_free(luxel_probe *probe)
{
    if (probe)
        luxel_probes_free((luxel_probes *)(void *)((char *)probe - offsetof(luxel_probes, list)));
}

/* Copies the names of surfaces and of lights that are on (NULL: none is); -1: memory ran out. */
static int copy_names(const struct lx_scene_parameters *scene, const bool *on, luxel_probes *probes)
{
    probes->named = lx_new_array(scene->lights.count, sizeof *probes->named);
    probes->surface_names = lx_new_array(scene->surfaces.count, sizeof *probes->surface_names);
    if (!probes->named || !probes->surface_names)
        return -1;
    for (size_t i = 0; i < scene->lights.count; i++) {
        const struct lx_item *item = &scene->lights.items[i];
        const struct lx_light_common *common = item->common;
        if (!on || !on[i])
            continue;
        luxel_light_share *share = &probes->named[probes->named_count++];
        *share = (luxel_light_share){.light = i, .type = item->variant->name};
        if (common->name && !(share->name = lx_copy_text(common->name, strlen(common->name))))
            return -1;
    }
    for (; probes->surface_count < scene->surfaces.count; probes->surface_count++) {
        const struct lx_surface_common *common = scene->surfaces.items[probes->surface_count].common;
        char **name = &probes->surface_names[probes->surface_count];
        if (common->name && !(*name = lx_copy_text(common->name, strlen(common->name))))
            return -1;
    }
    return 0;
}

static luxel_status too_many(size_t count, double needed, double available, luxel_diagnostics *diagnostics)
{
    char places[LX_NUMBER_SIZE], need[LX_AMOUNT_SIZE], have[LX_AMOUNT_SIZE];
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_TOO_MANY_PLACES,
              LX_ARGS(lx_write_number((double)count, places), lx_write_amount(needed, need),
                      lx_write_amount(available, have)));
    lx_hint(diagnostics, LX_MSG_FEWER_PLACES, NULL);
    return LUXEL_ERROR_MEMORY;
}

/* Room for the answers; what there is of it is to be freed whatever it returns. */
static luxel_status new_probes(const struct lx_scene_parameters *scene, const bool *on, size_t count,
                               luxel_diagnostics *diagnostics, luxel_probes **probes)
{
    const double needed =
        (double)count * (double)(sizeof(luxel_probe) + scene->lights.count * sizeof(luxel_light_share));
    const double available = count > 1 ? lx_available_bytes() : HUGE_VAL;
    if (needed > available || count > UINT_MAX / 2)
        return too_many(count, needed, available, diagnostics);
    luxel_probes *made = lx_new_array(1, sizeof *made + count * sizeof *made->list);
    *probes = made;
    if (!made || copy_names(scene, on, made) < 0)
        return lx_out_of_memory(diagnostics);
    made->count = count;
    made->shares = lx_new_array(count * made->named_count, sizeof *made->shares);
    if (!made->shares)
        return lx_out_of_memory(diagnostics);
    for (size_t i = 0; i < count; i++) {
        luxel_probe *probe = &made->list[i];
        probe->tolerance_reached = true;
        probe->reflected_reached = true;
        probe->share_count = 0;
        probe->shares = made->shares + i * made->named_count;
        memcpy(probe->shares, made->named, made->named_count * sizeof *probe->shares);
    }
    return LUXEL_OK;
}

/* What is below this share of the sources' radiance is as good as 0: in a source's plane there is only rounding. */
static const double NOTHING = 1e-20;

/* What would arrive if nothing stood in the way. */
static double unhidden(const struct lx_session *session, const struct lx_elements *element)
{
    struct lx_prepared bare = session->prepared;
    const struct lx_world open = {.prepared = &bare, .kernels = session->world.kernels};
    struct lx_received received;
    bare.shadows = bare.shadows_on_free = bare.shadows_extended = false;
    lx_world_light(&open, element, lx_wanted_for(session->settings.quantity), NULL, &received);
    return received.on_element[0] ? 0 : lx_received_value(&received, session->settings.quantity, 0).value;
}

/* An explicit tolerance is checked, the default one where there are integrals and nothing is left over mirrors.  Closed
 * forms are as exact as the scene is to float64, which just within a cone's edge or where light sets is less, relative
 * to a value near 0.  A value that its error does not tell from 0, behind what hides all, is judged by what is
 * hidden.  No bound at all is never good enough. */
static bool is_reached(const struct lx_session *session, const struct lx_elements *element, const luxel_probe *probe)
{
    const struct lx_prepared *prepared = &session->prepared;
    bool integrated = false;
    double radiance = 0;
    for (size_t i = 0; i < probe->share_count; i++)
        integrated = integrated || probe->shares[i].parts > 0;
    for (size_t i = 0; i < lx_item_count(&prepared->emitters); i++)
        radiance = fmax(radiance, prepared->emitters.items[i].radiance.value);
    double allowed = fmax(prepared->tolerance * fabs(probe->value), fmax(NOTHING * radiance, DBL_MIN));
    integrated = integrated && !lx_goes_deeper(&prepared->mirrors);
    const bool is_judged = session->settings.tolerance > 0 || integrated || !isfinite(probe->error);
    if (!is_judged || probe->error <= allowed)
        return true;
    return probe->value <= probe->error && probe->error <= prepared->tolerance * unhidden(session, element);
}

/* Adds up the emitters, light by light; stops at one that lies on the element. */
static void sum_lights(const struct lx_session *session, const struct lx_element *asked, luxel_probe *probe)
{
    const enum lx_wanted both = (enum lx_wanted)(LX_WANT_IRRADIANCE | LX_WANT_BRIGHTNESS);
    struct lx_elements element;
    lx_bounded total = lx_exact(0);
    size_t next = 0;
    lx_elements_of_one(&session->prepared, asked, &element);
    for (size_t s = 0; s < probe->share_count; s++) {
        luxel_light_share *share = &probe->shares[s];
        struct lx_received light;
        lx_world_light_of(&session->world, &element, share->light, both, NULL, &next, &light);
        if (light.on_element[0]) {
            probe->source_on_element = true;
            probe->blocking_light = share->light;
            return;
        }
        const lx_bounded value = lx_received_value(&light, session->settings.quantity, 0);
        share->parts = light.parts[0];
        share->irradiance = light.irradiance.value[0];
        share->diffuse = light.diffuse.value[0];
        share->specular = light.specular.value[0];
        share->error = lx_reported(value).error;
        total = lx_add(total, value);
    }
    probe->has_value = true;
    probe->value = total.value;
    probe->error = lx_reported(total).error;
    probe->tolerance_reached = is_reached(session, &element, probe);
}

/* The work on all places. */
struct probing {
    const luxel_scene *scene;
    struct lx_session *session; /* of it */
    const luxel_place *places;
    luxel_probes *probes;
    struct lx_control *control;
    bool shows_pixels; /* the pixels' values are told as well */
};

static void copy3(double to[3], lx_bounded3 from)
{
    to[0] = from.x.value, to[1] = from.y.value, to[2] = from.z.value;
}

static const struct lx_surface_kind *kind_of(const struct lx_prepared *prepared, size_t surface)
{
    return (const struct lx_surface_kind *)prepared->scene->surfaces.items[surface].variant;
}

static void probe_element(const struct probing *probing, const luxel_place *place, const struct lx_element *element,
                          luxel_probe *probe)
{
    const struct lx_prepared *prepared = &probing->session->prepared;
    probe->on_surface = true;
    probe->share_count = probing->probes->named_count;
    probe->lies_on_surface = element->own != NULL;
    probe->surface = prepared->surface_count > 0 ? place->surface : SIZE_MAX;
    if (element->own) {
        probe->surface = element->own->authored;
        probe->part = element->own->part;
        probe->part_name = lx_part_name(kind_of(prepared, probe->surface), probe->part);
    }
    probe->surface_name = prepared->surface_count > 0 ? probing->probes->surface_names[probe->surface] : NULL;
    copy3(probe->position_mm, element->place_mm);
    copy3(probe->normal, element->normal);
    copy3(probe->view, element->view);
    sum_lights(probing->session, element, probe);
}

static void probe_free_element(const struct probing *probing, const luxel_place *place, luxel_probe *probe)
{
    const struct lx_prepared *prepared = &probing->session->prepared;
    const struct lx_element asked = lx_element_at(prepared, place), element = lx_element_shown(prepared, &asked);
    const struct lx_prepared_surface *around = lx_surface_around(prepared, place->position_mm);
    probe_element(probing, place, &element, probe);
    probe->is_enclosed = around != NULL;
    if (around)
        probe->enclosing_surface = around->authored;
}

static void probe_screen(const struct probing *probing, const luxel_place *place, luxel_probe *probe)
{
    const struct lx_prepared *prepared = &probing->session->prepared;
    const double x_mm = place->screen_mm[0], y_mm = place->screen_mm[1];
    struct lx_element element;
    probe->has_screen = true;
    probe->x_mm = x_mm;
    probe->y_mm = y_mm;
    probe->has_pixel = lx_pixel_at(&prepared->scene->screen, x_mm, y_mm, &probe->column, &probe->row);
    if (lx_element_seen(prepared, x_mm, y_mm, &element))
        probe_element(probing, place, &element, probe);
}

/* For the pool a place is a row. */
static void probe_places(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    const struct probing *probing = data;
    (void)worker;
    for (unsigned i = first; i < last && lx_control_goes_on(probing->control, is_caller); i++)
        if (probing->places[i].is_element)
            probe_free_element(probing, &probing->places[i], &probing->probes->list[i]);
        else
            probe_screen(probing, &probing->places[i], &probing->probes->list[i]);
}

static luxel_status check_values(const luxel_probe *probes, size_t count, luxel_diagnostics *diagnostics)
{
    for (size_t i = 0; i < count; i++)
        if (probes[i].has_value && !isfinite(probes[i].value)) {
            lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_VALUE_TOO_LARGE, LX_ARGS("double"));
            lx_hint(diagnostics, LX_MSG_LOWER_STRENGTHS, NULL);
            return LUXEL_ERROR_RANGE;
        }
    return LUXEL_OK;
}

/* ---- reflected light ---- */

/* The element of a probe that has a value, and its direct irradiance, or what would give as much. */
static bool element_of(const void *data, size_t i, struct lx_element *element, double *direct)
{
    const struct probing *probing = data;
    const struct lx_session *session = probing->session;
    const luxel_place *place = &probing->places[i];
    const luxel_probe *probe = &probing->probes->list[i];
    if (!probe->has_value)
        return false;
    if (place->is_element)
        *element = lx_element_at(&session->prepared, place);
    else
        lx_element_seen(&session->prepared, place->screen_mm[0], place->screen_mm[1], element);
    const double share = lx_reflected_value(element->lobe, session->settings.quantity, lx_exact(1)).value;
    *direct = share > 0 ? probe->value / share : HUGE_VAL;
    return true;
}

/* Adds what is reflected to a probe. */
static void take_reflected(void *data, size_t i, lx_bounded irradiance)
{
    const struct probing *probing = data;
    const luxel_settings *settings = &probing->session->settings;
    struct lx_element element;
    luxel_probe *probe = &probing->probes->list[i];
    double direct;
    element_of(probing, i, &element, &direct);
    const lx_bounded value = lx_reflected_value(element.lobe, settings->quantity, irradiance);
    const lx_bounded total = lx_add((lx_bounded){probe->value, probe->error}, value);
    probe->has_reflected = true;
    probe->reflected_irradiance = irradiance.value;
    probe->reflected = lx_reported(value);
    probe->value = total.value;
    probe->error = lx_reported(total).error;
    probe->reflected_reached =
        probe->reflected.error <= fmax(lx_reflected_error_of(settings) * fabs(probe->value), DBL_MIN);
}

/* Finds what surfaces reflect in the picture, if some probe has a pixel there, or it is to serve all. */
static luxel_status reflect_picture(const struct probing *probing, size_t count, luxel_diagnostics *diagnostics)
{
    bool is_wanted = probing->session->settings.share_reflected;
    for (size_t i = 0; i < count && !is_wanted; i++)
        is_wanted = probing->shows_pixels && probing->probes->list[i].on_surface && probing->probes->list[i].has_pixel;
    if (!is_wanted)
        return LUXEL_OK;
    const luxel_status status = lx_reflect_picture(probing->scene, probing->session, diagnostics);
    probing->control->before = probing->session->done;
    return status;
}

/* First the values, then the pixels, and what surfaces reflect. */
static luxel_status compute(struct probing *probing, struct lx_control *control, size_t count,
                            luxel_diagnostics *diagnostics)
{
    luxel_probe *list = probing->probes->list;
    const unsigned places = (unsigned)count;
    const struct lx_rows_part values = {.last = places, .work = probe_places, .data = probing};
    if (count == 0)
        return LUXEL_OK;
    if (!lx_rows_run_part(control, lx_thread_count(probing->session->settings.threads, places / 4 + 1), &values))
        return LUXEL_CANCELLED;
    luxel_status status = reflect_picture(probing, count, diagnostics);
    if (status == LUXEL_OK && probing->shows_pixels) {
        status = lx_probe_pixels(probing->session, control, list, count);
        if (status == LUXEL_ERROR_MEMORY)
            lx_out_of_memory(diagnostics);
    }
    if (status == LUXEL_OK && lx_wants_reflections(probing->session->prepared.scene))
        status = lx_reflect_places(probing->session,
                                   &(struct lx_reflecting){probing->control, count, element_of, take_reflected, probing,
                                                           lx_scene_reflected_on_plane(probing->scene), NULL, NULL},
                                   false, diagnostics);
    return status == LUXEL_OK ? check_values(list, count, diagnostics) : status;
}

/* The places are such that can be probed. */
static luxel_status check_places(const struct lx_scene_parameters *scene, const luxel_place *places, size_t count,
                                 luxel_diagnostics *diagnostics)
{
    char index[LX_NUMBER_SIZE], most[LX_NUMBER_SIZE];
    for (size_t i = 0; i < count; i++) {
        if (LX_CHECK_RESERVE(&places[i], diagnostics) != LUXEL_OK)
            return LUXEL_ERROR_ARGUMENT;
        if (!lx_is_place(&places[i]))
            return lx_refuse(diagnostics, LX_MSG_BAD_PLACE, NULL);
        if (places[i].is_element && places[i].surface >= lx_material_count(scene))
            return lx_refuse(diagnostics, LX_MSG_NO_SUCH_SURFACE,
                             LX_ARGS(lx_write_number((double)places[i].surface, index),
                                     lx_write_number((double)scene->surfaces.count - 1, most)));
    }
    return LUXEL_OK;
}

/* Whether some of the places are seen on the screen, and whether their pixels' values are told. */
static bool is_any_seen(const luxel_place *places, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!places[i].is_element)
            return true;
    return false;
}

static bool are_pixels_wanted(const luxel_scene *scene, const luxel_settings *settings)
{
    return !(settings && settings->skip_reflected_pixels && !settings->share_reflected && scene &&
             luxel_scene_is_committed(scene) && lx_wants_reflections(lx_scene_parameters(scene)));
}

/* No place needs no world, and values of pixels alone need the plan of a picture, which takes long where surfaces are
 * many. */
static luxel_status open(struct probing *probing, const luxel_settings *settings, size_t count,
                         luxel_diagnostics *diagnostics)
{
    const luxel_scene *scene = probing->scene;
    const bool sees = is_any_seen(probing->places, count);
    probing->shows_pixels = sees && are_pixels_wanted(scene, settings);
    if (probing->shows_pixels)
        return lx_session_open(scene, settings, diagnostics, probing->session);
    const luxel_status status = count > 0 ? lx_session_open_world(scene, settings, diagnostics, probing->session)
                                          : lx_session_begin(scene, settings, diagnostics, probing->session);
    return status == LUXEL_OK && sees ? luxel_scene_check_view(scene, diagnostics) : status;
}

luxel_status lx_probes_new(const luxel_scene *scene, const luxel_settings *settings, size_t count,
                           luxel_diagnostics *diagnostics, luxel_probes **probes)
{
    bool *on = lx_lights_on(lx_scene_parameters(scene), settings);
    luxel_status status =
        on ? new_probes(lx_scene_parameters(scene), on, count, diagnostics, probes) : lx_out_of_memory(diagnostics);
    free(on);
    return status;
}

bool lx_probes_add_colors(luxel_probes *probes)
{
    const size_t count = probes->count * probes->named_count;
    probes->colors = lx_new_array(count, sizeof *probes->colors);
    for (size_t i = 0; probes->colors && i < count; i++)
        probes->shares[i].color = &probes->colors[i];
    return probes->colors;
}

luxel_probe *lx_probes_list(luxel_probes *probes)
{
    return probes->list;
}

void lx_probe_take_place(luxel_probes *probes, size_t i, const luxel_probe *from)
{
    luxel_probe *probe = &probes->list[i];
    luxel_light_share *shares = probe->shares;
    *probe = *from;
    probe->shares = shares;
    probe->share_count = from->on_surface ? probes->named_count : 0;
    if (from->surface_name)
        probe->surface_name = probes->surface_names[from->surface];
}

luxel_status luxel_probe_places(const luxel_scene *scene, const luxel_settings *settings, const luxel_place *places,
                                size_t count, luxel_diagnostics *diagnostics, luxel_probes **probes)
{
    return luxel_scene_has_color(scene) && probes && count > 0
               ? lx_probe_in_color(scene, settings, places, count, diagnostics, probes)
               : lx_probe_grey(scene, settings, places, count, diagnostics, probes);
}

luxel_status lx_probe_grey(const luxel_scene *scene, const luxel_settings *settings, const luxel_place *places,
                           size_t count, luxel_diagnostics *diagnostics, luxel_probes **probes)
{
    struct lx_session session;
    struct lx_control control = {.rows = count < UINT_MAX / 2 ? 2 * (unsigned)count : UINT_MAX};
    struct probing probing = {.scene = scene, .session = &session, .places = places, .control = &control};
    if (!probes || (!places && count > 0))
        return lx_refuse(diagnostics, LX_MSG_MISSING_ARGUMENT, LX_ARGS(probes ? "places" : "probes"));
    luxel_status status = open(&probing, settings, count, diagnostics);
    if (status == LUXEL_OK)
        status = check_places(lx_scene_parameters(scene), places, count, diagnostics);
    if (status == LUXEL_OK)
        status = new_probes(lx_scene_parameters(scene), session.prepared.on, count, diagnostics, &probing.probes);
    if (status == LUXEL_OK) {
        control.progress = session.settings.progress;
        control.data = session.settings.progress_data;
        status = compute(&probing, &control, count, diagnostics);
    }
    lx_session_clear(&session);
    if (status == LUXEL_OK)
        *probes = probing.probes;
    else
        luxel_probes_free(probing.probes);
    return status;
}

luxel_status luxel_probe_place(const luxel_scene *scene, const luxel_settings *settings, const luxel_place *place,
                               luxel_diagnostics *diagnostics, luxel_probe **probe)
{
    luxel_probes *probes;
    const luxel_status status = luxel_probe_places(scene, settings, place, 1, diagnostics, probe ? &probes : NULL);
    if (status == LUXEL_OK)
        *probe = probes->list;
    return status;
}

luxel_status luxel_probe_screen(const luxel_scene *scene, const luxel_settings *settings, double x_mm, double y_mm,
                                luxel_diagnostics *diagnostics, luxel_probe **probe)
{
    const luxel_place place = {.screen_mm = {x_mm, y_mm}};
    return luxel_probe_place(scene, settings, &place, diagnostics, probe);
}

luxel_status luxel_probe_element(const luxel_scene *scene, const luxel_settings *settings, const double position_mm[3],
                                 const double normal[3], luxel_diagnostics *diagnostics, luxel_probe **probe)
{
    luxel_place place = {.is_element = true};
    memcpy(place.position_mm, position_mm, sizeof place.position_mm);
    memcpy(place.normal, normal, sizeof place.normal);
    return luxel_probe_place(scene, settings, &place, diagnostics, probe);
}

const char *luxel_scene_unit(const luxel_scene *scene, luxel_quantity quantity)
{
    return luxel_settings_unit(scene, &(luxel_settings){.quantity = quantity});
}

const char *luxel_settings_unit(const luxel_scene *scene, const luxel_settings *settings)
{
    return scene && luxel_scene_is_committed(scene) ? lx_unit_of_scene(lx_scene_parameters(scene), settings)
                                                    : "relative";
}
