/* SPDX-License-Identifier: MIT */
/* Parting a scene in colour into grey computations, by the colours of its lights and the channels of its materials. */
#include "colours.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../surface/surface.h"
#include "lit.h"
#include "materials.h"
#include "object.h"

bool lx_is_in_color(const struct lx_scene_parameters *scene)
{
    return scene->channels == LX_RGB && scene->channel == 0;
}

bool luxel_scene_has_color(const luxel_scene *scene)
{
    return luxel_scene_is_committed(scene) && lx_is_in_color(&scene->parameters);
}

/* ---- materials ---- */

/* Whether no material tells two channels apart. */
static bool are_alike(const struct lx_scene_parameters *scene, int a, int b)
{
    struct lx_scene_material at = {.material = NULL};
    while (lx_next_material(scene, &at))
        if (at.material->color[a] != at.material->color[b] ||
            at.material->specular_color[a] != at.material->specular_color[b])
            return false;
    return true;
}

/* The first channel that each is alike; returns how many are different. */
static size_t part_channels(const struct lx_scene_parameters *scene, luxel_quantity quantity, int like[LX_CHANNELS])
{
    const bool count = quantity != LUXEL_IRRADIANCE || scene->reflections.choice != LX_REFLECTIONS_NONE;
    size_t different = 0;
    for (int c = 0; c < LX_CHANNELS; c++) {
        like[c] = c;
        for (int before = c - 1; before >= 0; before--)
            if (!count || are_alike(scene, before, c))
                like[c] = before;
        different += like[c] == c;
    }
    return different;
}

bool lx_is_sum_of_channels(const struct lx_scene_parameters *scene, luxel_quantity quantity)
{
    int like[LX_CHANNELS];
    return lx_is_in_color(scene) && part_channels(scene, quantity, like) > 1;
}

/* What a colour counts for in a channel, or in one of those behind them. */
static double factor_in(const double color[LX_CHANNELS], unsigned channel)
{
    return channel > LX_CHANNELS ? fmax(color[0], fmax(color[1], color[2]))
           : channel > 0         ? color[channel - 1]
                                 : luxel_rgb_luminance(color);
}

struct lx_material lx_material_in_channel(const struct lx_material *material, unsigned channel)
{
    struct lx_material made = *material;
    const double diffuse = channel == LX_CHANNEL_HIGHLIGHT ? 0 : factor_in(material->color, channel);
    made.diffuse *= diffuse;
    made.ambient *= diffuse;
    made.specular *= factor_in(material->specular_color, channel);
    if (channel == LX_CHANNEL_DIFFUSE)
        made.model = LX_LAMBERT;
    return made;
}

/* A view that is ahead of its text, which is not that of a channel. */
static luxel_scene *new_view(const luxel_scene *scene)
{
    luxel_scene *view = lx_new_array(1, sizeof *view);
    if (view)
        *view = *scene;
    if (view)
        view->is_ahead = true;
    return view;
}

luxel_scene *lx_scene_in_channel(const luxel_scene *scene, unsigned channel)
{
    luxel_scene *view = new_view(scene);
    if (view)
        view->parameters.channel = channel;
    return view;
}

luxel_scene *lx_scene_without_colors(const luxel_scene *scene)
{
    luxel_scene *view = new_view(scene);
    if (view) {
        view->parameters.channels = LX_GREY;
        view->parameters.reflections = (struct lx_choice_or_whole){.choice = LX_REFLECTIONS_NONE};
    }
    return view;
}

/* ---- lights ---- */

void lx_light_channels(const struct lx_light_common *light, double rgb[LX_CHANNELS])
{
    for (int c = 0; c < LX_CHANNELS; c++)
        rgb[c] = light->color.given ? light->color.channels[c] : 1;
}

luxel_status luxel_scene_light_rgb(const luxel_scene *scene, size_t i, double rgb[3])
{
    if (!luxel_scene_is_committed(scene) || i >= scene->parameters.lights.count || !rgb)
        return LUXEL_ERROR_ARGUMENT;
    lx_light_channels(scene->parameters.lights.items[i].common, rgb);
    return LUXEL_OK;
}

/* Groups of lights of one colour, one behind the other in `lights`. */
struct colors {
    size_t *lights;
    struct group {
        size_t first, count;
        double rgb[LX_CHANNELS];
    } * groups;
    size_t count;
};

/* Sorts the lights that are on into groups, in their order. */
static void group_lights(const struct lx_list *lights, bool *on, struct colors *colors)
{
    size_t used = 0;
    for (size_t i = 0; i < lights->count; i++) {
        struct group *group = &colors->groups[colors->count];
        if (!on[i])
            continue;
        *group = (struct group){.first = used};
        lx_light_channels(lights->items[i].common, group->rgb);
        for (size_t k = i; k < lights->count; k++) {
            double rgb[LX_CHANNELS];
            lx_light_channels(lights->items[k].common, rgb);
            if (!on[k] || memcmp(rgb, group->rgb, sizeof rgb) != 0)
                continue;
            colors->lights[used++] = k;
            on[k] = false;
        }
        group->count = used - group->first;
        colors->count++;
    }
    if (colors->count == 0) /* all is dark, but it is a part */
        colors->groups[colors->count++] = (struct group){.rgb = {1, 1, 1}};
}

/* The part of a group in channel `channel` and those that are like it. */
static struct lx_color_part part_of(const struct colors *colors, size_t g, int channel, const int like[LX_CHANNELS])
{
    const struct group *group = &colors->groups[g];
    struct lx_color_part part = {.luminance = 0};
    double counts[LX_CHANNELS] = {0, 0, 0};
    for (int c = 0; c < LX_CHANNELS; c++)
        if (like[c] == channel)
            part.rgb[c] = counts[c] = group->rgb[c];
    part.luminance = luxel_rgb_luminance(counts);
    return part;
}

/* The views of a scene that parts are of: in which channel of the materials, 0 being the scene itself, and for which
 * channel of a value and all that are like it. */
struct division {
    size_t count;
    unsigned views[LX_CHANNELS];
    int channels[LX_CHANNELS], like[LX_CHANNELS];
};

static luxel_status make_parts(const luxel_scene *scene, const luxel_settings *settings,
                               const struct division *division, luxel_diagnostics *diagnostics,
                               struct lx_color_parts *parts)
{
    const struct lx_scene_parameters *parameters = &scene->parameters;
    const size_t lights = parameters->lights.count;
    const luxel_settings wanted = settings ? *settings : (luxel_settings){.stride = 1};
    struct colors colors = {.lights = lx_new_array(lights + 1, sizeof *colors.lights),
                            .groups = lx_new_array(lights + 1, sizeof *colors.groups)};
    bool *on = lx_lights_on(parameters, settings);
    *parts = (struct lx_color_parts){.is_sum = division->views[0] > 0, .lights = colors.lights};
    bool is_made = colors.lights && colors.groups && on;
    if (is_made)
        group_lights(&parameters->lights, on, &colors);
    if (is_made)
        parts->list = lx_new_array(division->count * colors.count, sizeof *parts->list);
    is_made = is_made && parts->list;
    for (size_t v = 0; v < division->count && is_made; v++) {
        if (parts->is_sum && !(parts->views[v] = lx_scene_in_channel(scene, division->views[v])))
            is_made = false;
        for (size_t g = 0; g < colors.count && is_made; g++) {
            struct lx_color_part *part = &parts->list[parts->count++];
            *part = part_of(&colors, g, division->channels[v], division->like);
            part->scene = parts->is_sum ? parts->views[v] : scene;
            part->settings = wanted;
            part->group = g;
            if (colors.count > 1) {
                part->settings.lights = colors.lights + colors.groups[g].first;
                part->settings.light_count = colors.groups[g].count;
            }
        }
    }
    parts->is_single = parts->count == 1;
    free(colors.groups);
    free(on);
    return is_made ? LUXEL_OK : lx_out_of_memory(diagnostics);
}

luxel_status lx_color_parts_make(const luxel_scene *scene, const luxel_settings *settings,
                                 luxel_diagnostics *diagnostics, struct lx_color_parts *parts)
{
    struct division division = {.count = 0};
    const luxel_quantity quantity = settings ? settings->quantity : LUXEL_BRIGHTNESS;
    const size_t channels = part_channels(&scene->parameters, quantity, division.like);
    for (int c = 0; c < LX_CHANNELS; c++)
        if (division.like[c] == c) {
            division.channels[division.count] = c;
            division.views[division.count++] = channels > 1 ? (unsigned)c + 1 : 0;
        }
    return make_parts(scene, settings, &division, diagnostics, parts);
}

/* A model of the diffuse part that is not linear in its reflectance is none that colours could be factors of, and what
 * a mirror shows is not of the material that its pixels would take them from. */
bool lx_is_sum_of_lobes(const struct lx_scene_parameters *scene, luxel_quantity quantity)
{
    struct lx_scene_material at = {.material = NULL};
    if (!lx_is_sum_of_channels(scene, quantity) || quantity == LUXEL_IRRADIANCE ||
        scene->reflections.choice != LX_REFLECTIONS_NONE)
        return false;
    while (lx_next_material(scene, &at))
        if (at.material->mirror || (lx_has_color(at.material) && LX_LAMBERT + at.material->diffuse_model == LX_EON))
            return false;
    for (size_t i = 0; i < scene->surfaces.count; i++) {
        const struct lx_surface_kind *kind = (const struct lx_surface_kind *)scene->surfaces.items[i].variant;
        if (kind->is_mirror && kind->is_mirror(scene->surfaces.items[i].parameters))
            return false;
    }
    return true;
}

luxel_status lx_color_lobes_make(const luxel_scene *scene, const luxel_settings *settings,
                                 luxel_diagnostics *diagnostics, struct lx_color_parts *parts)
{
    struct division division = {.count = 1, .views = {LX_CHANNEL_DIFFUSE, LX_CHANNEL_HIGHLIGHT}};
    struct lx_scene_material at = {.material = NULL};
    while (lx_next_material(&scene->parameters, &at))
        if (at.material->specular > 0 && at.material->model != LX_LAMBERT)
            division.count = 2;
    return make_parts(scene, settings, &division, diagnostics, parts);
}

luxel_status lx_color_lights_make(const luxel_scene *scene, const luxel_settings *settings,
                                  luxel_diagnostics *diagnostics, struct lx_color_parts *parts)
{
    const struct division division = {.count = 1, .views = {LX_CHANNEL_WHOLE}};
    return make_parts(scene, settings, &division, diagnostics, parts);
}

void lx_color_parts_clear(struct lx_color_parts *parts)
{
    for (int c = 0; c < LX_CHANNELS; c++)
        free(parts->views[c]);
    free(parts->list);
    free(parts->lights);
    *parts = (struct lx_color_parts){.count = 0};
}
