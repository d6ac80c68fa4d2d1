/* SPDX-License-Identifier: MIT */
/*
 * Colours of a scene: the grey computations that its values in colour are sums of.
 *
 * Light is linear in the lights and in the reflectances.  So each colour of lights makes a part, in which these lights
 * are white, for each channel in which materials are different; a value's channels, and its luminance, are the parts'
 * values with weights.  A part is computed as any grey scene is.
 */
#ifndef LX_SCENE_COLOURS_H
#define LX_SCENE_COLOURS_H

#include <luxel/colour.h>

#include "../base/bounded.h"
#include "scene.h"

enum { LX_CHANNELS = 3 };

/* Behind the channels of materials, from 1: what they scatter, and their highlights, by the greatest of each; and
 * both. */
enum { LX_CHANNEL_DIFFUSE = LX_CHANNELS + 1, LX_CHANNEL_HIGHLIGHT, LX_CHANNEL_WHOLE };
/* Pictures of these are as exact as those of channels with a maximum smaller by this factor have to be. */
enum { LX_LOBES_TO_CHANNEL = 4 };

/* The greatest value that the picture of a scene, or of a channel, must be exact for, as a share of its own. */
static inline double lx_share_of_channel(const struct lx_scene_parameters *scene)
{
    return scene->channel > LX_CHANNELS ? 1.0 / LX_LOBES_TO_CHANNEL : 1;
}

/* A grey computation, and what its value counts for. */
struct lx_color_part {
    const luxel_scene *scene; /* the scene itself, or, of one channel of its materials, a view of it */
    luxel_settings settings;  /* with the lights of the part as their group */
    double rgb[LX_CHANNELS], luminance;
    size_t group; /* which colour of lights it is of */
};

struct lx_color_parts {
    struct lx_color_part *list;
    size_t count;
    bool is_sum;    /* the luminance is the sum of the parts; else it is the scene's own value, materials being grey */
    bool is_single; /* there is one part, and it is the scene's own value */
    luxel_scene *views[LX_CHANNELS];
    size_t *lights; /* of all groups */
};

/* Whether values of the scene have colours: channels: rgb, and it is no view of one of them. */
bool lx_is_in_color(const struct lx_scene_parameters *scene);

/* Whether a quantity of it is a sum over the channels of materials, so that no single computation tells it. */
bool lx_is_sum_of_channels(const struct lx_scene_parameters *scene, luxel_quantity quantity);

/* Whether a material has colours other than white. */
static inline bool lx_has_color(const struct lx_material *material)
{
    for (int c = 0; c < LX_CHANNELS; c++)
        if (material->color[c] != 1 || material->specular_color[c] != 1)
            return true;
    return false;
}

/* What a material is in a channel, from 1, or in one of those behind them; 0: by the luminance of its colours. */
struct lx_material lx_material_in_channel(const struct lx_material *material, unsigned channel);

/* The channels of a light at luminance 1. */
void lx_light_channels(const struct lx_light_common *light, double rgb[LX_CHANNELS]);

/* The parts of what settings (NULL: the defaults) ask of a scene in color; release with lx_color_parts_clear() whatever
 * it returns.  LUXEL_OK, LUXEL_ERROR_MEMORY, which is reported. */
luxel_status lx_color_parts_make(const luxel_scene *scene, const luxel_settings *settings,
                                 luxel_diagnostics *diagnostics, struct lx_color_parts *parts);
/* Whether a quantity is a sum of such parts of another kind, of the whole light of a group each: of what the materials
 * scatter, and of their highlights, which take their colours pixel by pixel. */
bool lx_is_sum_of_lobes(const struct lx_scene_parameters *scene, luxel_quantity quantity);
/* Makes these; views[0] is that of what is scattered, and views[1], if any, of the highlights. */
luxel_status lx_color_lobes_make(const luxel_scene *scene, const luxel_settings *settings,
                                 luxel_diagnostics *diagnostics, struct lx_color_parts *parts);
/* Makes the parts of a scene whose materials are grey, a group of lights each, for pictures that are their sum; else as
 * lx_color_parts_make(). */
luxel_status lx_color_lights_make(const luxel_scene *scene, const luxel_settings *settings,
                                  luxel_diagnostics *diagnostics, struct lx_color_parts *parts);
void lx_color_parts_clear(struct lx_color_parts *parts);

/* A view of the scene in channel `channel` from 1, which shares all with it and must not outlive it: free() it.  NULL:
 * memory ran out. */
luxel_scene *lx_scene_in_channel(const luxel_scene *scene, unsigned channel);

/* A view likewise of the direct light in it, of which no material has a colour. */
luxel_scene *lx_scene_without_colors(const luxel_scene *scene);

/* Adds a part's share of a channel, or of the luminance, to a sum. */
static inline lx_bounded lx_add_part(lx_bounded sum, double weight, double value, double error)
{
    return lx_add(sum, lx_mul(lx_exact(weight), (lx_bounded){value, error}));
}

#endif
