/* SPDX-License-Identifier: MIT */
/*
 * Advice that needs a look at what the scene shows: is it dark, does its peak lie in view and stand out, does the
 * picture's range fit.  With each goes a change that mends it, which was tried on a copy before it is said.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../base/number.h"
#include "../material/lobe.h"
#include "../scene/materials.h"
#include "../surface/part.h"
#include "../world/albedo.h"
#include "adviser.h"

/* Below this the highlight raises the maximum by too little to be told from the diffuse light. */
#define LEAST_RISE 0.1
/* The highlight's half width: wider than this it has no outline; narrower, in pixels, the picture misses it. */
#define WIDEST_RAD (35 * M_PI / 180)
#define LEAST_PIXELS 1.0
/* The share of what is seen that may be white, and the least grey level of the maximum. */
#define MOST_WHITE 0.01
#define LEAST_GREY 32

/* Looks at a changed copy; false where the change does not go, or out of memory, which the adviser remembers. */
static bool look(struct lx_adviser *adviser, const char *const *assignments, struct lx_scout *scout)
{
    luxel_status status = lx_scout(adviser->scene, assignments, &adviser->effort, scout);
    adviser->out_of_memory = adviser->out_of_memory || status == LUXEL_ERROR_MEMORY;
    return status == LUXEL_OK && !scout->too_large;
}

/* The material where the peak is. */
static struct lx_scene_material material_at_peak(const struct lx_adviser *adviser)
{
    return lx_material_of(adviser->parameters, adviser->now.surface, adviser->now.part);
}

/* What advice about a key of that material is about. */
static struct lx_advised about_material(const struct lx_scene_material *at, const char *key)
{
    if (at->part)
        return (struct lx_advised){"surfaces", true, at->surface, "materials", at->part, key};
    return (struct lx_advised){"surfaces", true, at->surface, "material", key, NULL};
}

/* ---- darkness ---- */

static bool is_lit(struct lx_adviser *adviser, const char *const *assignments)
{
    struct lx_scout scout;
    return look(adviser, assignments, &scout) && scout.maximum >= LX_LEAST_LIT;
}

/* What may be wrong with a light: it is off, without strength, or not where it could reach the surfaces. */
static bool mend_dark_light(struct lx_adviser *adviser, size_t light)
{
    static const char *const strengths[] = {"intensity=10", "irradiance=10", "radiance=100", "power=100"};
    char words[LX_ADVICE_SIZE];
    snprintf(words, sizeof words, "lights[%zu].enabled=true", light);
    if (lx_try(adviser, is_lit, words, NULL))
        return true;
    for (size_t i = 0; i < LX_COUNT(strengths); i++) {
        snprintf(words, sizeof words, "lights[%zu].%s", light, strengths[i]);
        if (lx_try(adviser, is_lit, words, NULL))
            return true;
    }
    return lx_try_places(adviser, is_lit, light);
}

static void advise_dark(struct lx_adviser *adviser)
{
    char words[LX_ADVICE_SIZE], place[LX_PLACE_SIZE], key[LX_MATERIAL_KEY_SIZE];
    const struct lx_scene_parameters *scene = adviser->parameters;
    lx_advise(adviser, (struct lx_advised){.list = "lights"}, LX_MSG_PICTURE_DARK, NULL);
    if (scene->lights.count == 0) {
        lx_write_place(adviser, 1, place);
        snprintf(words, sizeof words, "lights=[{type: point, position: %s, intensity: 10}]", place);
        lx_try(adviser, is_lit, words, NULL);
        return;
    }
    for (size_t i = 0; i < scene->lights.count && i < 16; i++)
        if (mend_dark_light(adviser, i))
            return;
    size_t count = 0;
    for (struct lx_scene_material at = {0}; lx_next_material(scene, &at) && count++ < 16;) {
        snprintf(words, sizeof words, "%s.diffuse=0.8", lx_material_key(&at, key));
        if (lx_try(adviser, is_lit, words, NULL))
            return;
    }
}

/* ---- the place of the peak ---- */

static bool is_at_edge(const struct lx_scout *scout)
{
    return scout->is_seen && (scout->place == LUXEL_PEAK_LIMB || scout->place == LUXEL_PEAK_BORDER);
}

static bool peaks_inside(struct lx_adviser *adviser, const char *const *assignments)
{
    struct lx_scout scout;
    return look(adviser, assignments, &scout) && scout.is_seen && scout.maximum >= LX_LEAST_LIT && !is_at_edge(&scout);
}

/* A larger screen of the same form. */
static bool try_screens(struct lx_adviser *adviser)
{
    static const double factors[] = {1.1, 1.2, 1.25, 1.5, 2, 2.5, 3, 4, 5, 8, 10};
    const struct lx_screen *screen = &adviser->parameters->screen;
    for (size_t i = 0; i < LX_COUNT(factors); i++) {
        char width[LX_ADVICE_SIZE], height[LX_ADVICE_SIZE], number[LX_NUMBER_SIZE];
        snprintf(width, sizeof width, "screen.width=%s", lx_write_digits(screen->width_mm * factors[i], 15, number));
        snprintf(height, sizeof height, "screen.height=%s",
                 lx_write_digits(screen->height_mm * factors[i], 15, number));
        if (lx_try_pair(adviser, peaks_inside, width, height))
            return true;
    }
    return false;
}

static void advise_place(struct lx_adviser *adviser)
{
    const struct lx_scout *now = &adviser->now;
    if (!is_at_edge(now))
        return;
    if (now->place == LUXEL_PEAK_BORDER)
        lx_advise(adviser, (struct lx_advised){.list = "screen"}, LX_MSG_PEAK_AT_BORDER, NULL);
    else
        lx_advise(adviser, (struct lx_advised){.list = "surfaces", .has_index = true, .index = now->surface},
                  LX_MSG_PEAK_AT_RIM, NULL);
    if ((now->place == LUXEL_PEAK_BORDER && try_screens(adviser)) ||
        lx_try_places(adviser, peaks_inside, now->strongest))
        return;
    /* where that light alone does not do, any other might */
    for (size_t i = 0; i < adviser->parameters->lights.count && i < 8; i++)
        if (i != now->strongest && lx_try_places(adviser, peaks_inside, i))
            return;
}

/* ---- how much is reflected ---- */

/* A material over pi that sends back more light than falls in, which a highlight without a norm easily does. */
static void advise_albedo(struct lx_adviser *adviser)
{
    for (struct lx_scene_material at = {0}; lx_next_material(adviser->parameters, &at);) {
        char words[LX_ADVICE_SIZE], number[LX_NUMBER_SIZE], key[LX_MATERIAL_KEY_SIZE];
        const double albedo = lx_material_albedo(at.material, 1);
        struct lx_material matt = *at.material;
        matt.specular = 0;
        const double diffuse = lx_material_albedo(&matt, 1), glossy = albedo - diffuse;
        if (!at.material->over_pi || !(albedo > 1 + 1e-9) || !(glossy > 0))
            continue;
        lx_advise(adviser, about_material(&at, "specular"), LX_MSG_ALBEDO_ABOVE_ONE,
                  lx_write_digits(100 * albedo, 4, number));
        const double left = floor(100 * at.material->specular * (1 - diffuse) / glossy) / 100;
        if (!(left > 0))
            continue;
        snprintf(words, sizeof words, "%s.specular=%s", lx_material_key(&at, key), lx_write_number(left, number));
        lx_suggest(adviser, (const char *const[]){words, NULL});
    }
}

/* ---- the highlight ---- */

enum { MOST_MATERIALS = 16, MOST_WORDS = MOST_MATERIALS + 3 };

/* How far the highlight raises the maximum, as a share of what the diffuse light alone gives; NaN: not known. */
static double rise_with(struct lx_adviser *adviser, const char *const *assignments, const struct lx_scout *with)
{
    char words[MOST_MATERIALS][LX_ADVICE_SIZE], key[LX_MATERIAL_KEY_SIZE];
    const char *list[MOST_WORDS];
    struct lx_scout without;
    size_t count = 0, used = 0;
    for (; assignments && *assignments; assignments++)
        list[count++] = *assignments;
    for (struct lx_scene_material at = {0}; used < MOST_MATERIALS && lx_next_material(adviser->parameters, &at);) {
        snprintf(words[used], sizeof words[used], "%s.specular=0", lx_material_key(&at, key));
        list[count++] = words[used++];
    }
    list[count] = NULL;
    if (!look(adviser, list, &without))
        return (double)NAN;
    return without.maximum > 0 ? with->maximum / without.maximum - 1 : HUGE_VAL;
}

static bool has_high_peak(struct lx_adviser *adviser, const char *const *assignments)
{
    struct lx_scout scout;
    return look(adviser, assignments, &scout) && rise_with(adviser, assignments, &scout) >= LEAST_RISE;
}

static void mend_height(struct lx_adviser *adviser)
{
    static const char *const speculars[] = {"0.1", "0.2", "0.3", "0.5", "0.7", "1"};
    static const char *const diffuses[] = {"0.5", "0.3", "0.1"};
    char specular[LX_ADVICE_SIZE], diffuse[LX_ADVICE_SIZE], key[LX_MATERIAL_KEY_SIZE];
    const struct lx_scene_material at = material_at_peak(adviser);
    lx_material_key(&at, key);
    for (size_t i = 0; i < LX_COUNT(speculars); i++) {
        snprintf(specular, sizeof specular, "%s.specular=%s", key, speculars[i]);
        if (lx_try(adviser, has_high_peak, specular, NULL))
            return;
    }
    if (lx_try_places(adviser, has_high_peak, adviser->now.strongest))
        return;
    for (size_t i = 0; i < LX_COUNT(diffuses); i++) {
        snprintf(diffuse, sizeof diffuse, "%s.diffuse=%s", key, diffuses[i]);
        if (lx_try_pair(adviser, has_high_peak, specular, diffuse))
            return;
    }
}

/* The power that a material's highlight is; NULL: it is none. */
static const struct lx_power_lobe *power_of(const struct lx_material *material)
{
    return lx_power_lobe_of((enum lx_model)material->model);
}

/* How far the normal turns from the highlight's middle to where it has fallen to half, under a distant source. */
static double half_width_rad(const struct lx_material *material)
{
    return acos(exp2(-1 / material->shininess)) / power_of(material)->turns_of_normal;
}

/* The shape of what shows the peak. */
static struct lx_shape shape_at_peak(const struct lx_adviser *adviser)
{
    const struct lx_item *surface = &adviser->parameters->surfaces.items[adviser->now.surface];
    struct lx_part part;
    lx_part_make((const struct lx_surface_kind *)surface->variant, surface->parameters, adviser->now.part, &part);
    return part.shape;
}

static double pixels_of_half(const struct lx_adviser *adviser, const struct lx_material *material)
{
    const struct lx_screen *screen = &adviser->parameters->screen;
    const struct lx_shape shape = shape_at_peak(adviser);
    return sin(half_width_rad(material)) * shape.radius_mm / (screen->width_mm / screen->resolution[0]);
}

/* A value of the shininess with which the highlight is neither too wide nor too narrow, tried in this order. */
static void mend_width(struct lx_adviser *adviser)
{
    static const double values[] = {20, 10, 50, 100, 200, 500};
    const struct lx_scene_material at = material_at_peak(adviser);
    struct lx_material changed = *at.material;
    for (size_t i = 0; i < LX_COUNT(values); i++) {
        changed.shininess = values[i];
        if (half_width_rad(&changed) > WIDEST_RAD || pixels_of_half(adviser, &changed) < LEAST_PIXELS)
            continue;
        char words[LX_ADVICE_SIZE], number[LX_NUMBER_SIZE], key[LX_MATERIAL_KEY_SIZE];
        snprintf(words, sizeof words, "%s.shininess=%s", lx_material_key(&at, key), lx_write_number(values[i], number));
        lx_suggest(adviser, (const char *const[]){words, NULL});
        return;
    }
}

/* On a sphere, where the normal's turn says how wide the highlight is. */
static void advise_width(struct lx_adviser *adviser)
{
    const struct lx_scene_material material = material_at_peak(adviser);
    const struct lx_advised at = about_material(&material, "shininess");
    char number[LX_NUMBER_SIZE];
    const struct lx_shape shape = shape_at_peak(adviser);
    if (!(lx_curvature(&shape) > 0))
        return;
    double angle = half_width_rad(material.material), pixels = pixels_of_half(adviser, material.material);
    if (angle > WIDEST_RAD)
        lx_advise(adviser, at, LX_MSG_PEAK_WIDE, lx_write_digits(angle * 180 / M_PI, 2, number));
    else if (pixels < LEAST_PIXELS && !adviser->now.is_coarse)
        lx_advise(adviser, at, LX_MSG_PEAK_NARROW, lx_write_digits(pixels, 2, number));
    else
        return;
    mend_width(adviser);
}

/* Whether some light that shines makes highlights; ambient light does not. */
static bool may_shine(const struct lx_scene_parameters *scene)
{
    for (size_t i = 0; i < scene->lights.count; i++) {
        const struct lx_item *light = &scene->lights.items[i];
        if (((const struct lx_light_common *)light->common)->enabled && strcmp(light->variant->name, "ambient") != 0)
            return true;
    }
    return false;
}

static void advise_highlight(struct lx_adviser *adviser)
{
    const struct lx_scout *now = &adviser->now;
    const struct lx_scene_material material = material_at_peak(adviser);
    size_t materials = 0;
    for (struct lx_scene_material at = {0}; lx_next_material(adviser->parameters, &at);)
        materials++;
    if (!power_of(material.material) || !may_shine(adviser->parameters) || materials > MOST_MATERIALS)
        return;
    /* a highlight that may fall between the samples of a coarse picture is not judged by it */
    double samples = pixels_of_half(adviser, material.material) * adviser->parameters->screen.width_mm /
                     adviser->parameters->screen.resolution[0] / now->sample_mm;
    if (now->is_coarse && samples < 1)
        return;
    double rise = rise_with(adviser, NULL, now);
    if (rise < LEAST_RISE) {
        char number[LX_NUMBER_SIZE];
        lx_advise(adviser, about_material(&material, "specular"), LX_MSG_PEAK_LOW,
                  lx_write_digits(floor(1000 * fmax(rise, 0)) / 10, 2, number));
        mend_height(adviser);
    } else if (!isnan(rise)) {
        advise_width(adviser);
    }
}

/* ---- the picture's range ---- */

static void advise_range(struct lx_adviser *adviser)
{
    const struct lx_choice_or_pair *range = &adviser->parameters->picture.range;
    const struct lx_advised at = {.list = "picture", .key = "range"};
    char number[LX_NUMBER_SIZE];
    if (range->choice >= 0)
        return;
    double grey = floor(255 * fmax(0, (adviser->now.maximum - range->low) / (range->high - range->low)));
    if (adviser->now.white > MOST_WHITE)
        lx_advise(adviser, at, LX_MSG_RANGE_CLIPS, lx_write_digits(100 * adviser->now.white, 2, number));
    else if (grey < LEAST_GREY)
        lx_advise(adviser, at, LX_MSG_RANGE_DIM, lx_write_number(grey, number));
    else
        return;
    lx_suggest(adviser, (const char *const[]){"picture.range=max", NULL});
}

luxel_status luxel_scene_advise_peak(const luxel_scene *scene, luxel_diagnostics *diagnostics)
{
    struct lx_adviser adviser;
    if (luxel_scene_is_committed(scene) && luxel_scene_check_view(scene, NULL) != LUXEL_OK)
        return LUXEL_OK; /* there is no picture to speak of */
    luxel_status status = lx_adviser_begin(&adviser, scene, diagnostics);
    if (status != LUXEL_OK)
        return status;
    lx_advise_distances(&adviser);
    advise_albedo(&adviser);
    if (!look(&adviser, NULL, &adviser.now) || !adviser.now.is_seen)
        return adviser.out_of_memory ? lx_out_of_memory(diagnostics) : LUXEL_OK;
    if (adviser.now.maximum < LX_LEAST_LIT) {
        advise_dark(&adviser);
    } else {
        advise_place(&adviser);
        advise_highlight(&adviser);
        advise_range(&adviser);
    }
    lx_settle_hints(diagnostics);
    return adviser.out_of_memory || adviser.walk.out_of_memory ? lx_out_of_memory(diagnostics) : LUXEL_OK;
}
