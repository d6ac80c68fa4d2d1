/* SPDX-License-Identifier: MIT */
/* The tables of what a scene holds beside its surfaces, materials and lights, and the table of the whole. */
#include <math.h>

#include "../light/light.h"
#include "../surface/surface.h"
#include "observer.h"

static const char *const units_names[] = {"radiometric", "photometric", NULL};
static const char *const channels_names[] = {"grey", "rgb", NULL};
static const char *const shadows_names[] = {"all", "points", "none", NULL};
static const char *const reflections_names[] = {"none", "all", NULL};
static const char *const sampling_names[] = {"centers", "nodes", NULL};
static const char *const range_names[] = {"max", "minmax", "log", NULL};
static const char *const rounding_names[] = {"truncate", "nearest", NULL};

/* ---- screen ---- */

static const struct lx_parameter screen_parameters[] = {
    {
        .name = "width",
        .label = "Width",
        .type = LX_REAL,
        .offset = offsetof(struct lx_screen, width_mm),
        .unit = LX_UNIT_MM,
        .required = true,
        .legal = LX_ABOVE(0),
        .advised = {LX_BETWEEN(100, 10000)},
        .meaning = "the width of the screen, along x",
    },
    {
        .name = "height",
        .label = "Height",
        .type = LX_REAL,
        .offset = offsetof(struct lx_screen, height_mm),
        .unit = LX_UNIT_MM,
        .required = true,
        .legal = LX_ABOVE(0),
        .advised = {LX_BETWEEN(100, 10000)},
        .meaning = "the height of the screen, along y",
    },
    {
        .name = "resolution",
        .label = "Resolution",
        .type = LX_WHOLES,
        .offset = offsetof(struct lx_screen, resolution),
        .count = 2,
        .required = true,
        .legal = LX_BETWEEN(1, 65536),
        .advised = {LX_BETWEEN(200, 800)},
        .meaning = "the number of pixels, [horizontal, vertical]; pixels must be square",
    },
    {
        .name = "sampling",
        .label = "Sampling",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_screen, sampling),
        .initial = "centers",
        .choices = sampling_names,
        .meaning = "where samples lie: in the centres of pixels, or on nodes from one edge of the screen to the other",
    },
};

static const struct lx_table screen_table = {
    .parameters = screen_parameters,
    .count = LX_COUNT(screen_parameters),
    .size = sizeof(struct lx_screen),
};

/* ---- picture ---- */

static const struct lx_parameter picture_parameters[] = {
    {
        .name = "range",
        .label = "Range of values",
        .type = LX_CHOICE_OR_PAIR,
        .offset = offsetof(struct lx_picture, range),
        .initial = "max",
        .choices = range_names,
        .meaning = "which values become black and white: 0 and the maximum, the least and greatest value on a "
                   "surface, a logarithmic scale of four decades, or [low, high]",
    },
    {
        .name = "rounding",
        .label = "Rounding",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_picture, rounding),
        .initial = "truncate",
        .choices = rounding_names,
        .meaning = "how grey levels become whole numbers",
    },
};

static const struct lx_table picture_table = {
    .parameters = picture_parameters,
    .count = LX_COUNT(picture_parameters),
    .size = sizeof(struct lx_picture),
};

/* ---- what all surfaces and all lights have ---- */

static const struct lx_parameter surface_common_parameters[] = {
    {
        .name = "name",
        .label = "Name",
        .type = LX_TEXT,
        .offset = offsetof(struct lx_surface_common, name),
        .meaning = "a name for messages and tables",
    },
    {
        .name = "material",
        .label = "Material",
        .type = LX_GROUP,
        .offset = offsetof(struct lx_surface_common, material),
        .group = &lx_material_table,
        .meaning = "how the surface turns light into brightness",
    },
};

static const struct lx_table surface_common_table = {
    .parameters = surface_common_parameters,
    .count = LX_COUNT(surface_common_parameters),
    .size = sizeof(struct lx_surface_common),
};

static const struct lx_parameter light_common_parameters[] = {
    {
        .name = "name",
        .label = "Name",
        .type = LX_TEXT,
        .offset = offsetof(struct lx_light_common, name),
        .meaning = "a name for messages and tables",
    },
    {
        .name = "group",
        .label = "Group",
        .type = LX_TEXT,
        .offset = offsetof(struct lx_light_common, group),
        .meaning = "the name of the group that the light is dimmed with: see dimming",
    },
    {
        .name = "enabled",
        .label = "Enabled",
        .type = LX_BOOLEAN,
        .offset = offsetof(struct lx_light_common, enabled),
        .initial = "true",
        .meaning = "whether the light shines",
    },
    {
        .name = "color",
        .label = "Colour",
        .type = LX_GROUP,
        .offset = offsetof(struct lx_light_common, color),
        .group = &lx_light_color_table,
        .meaning =
            "the colour of the light in scenes with channels rgb; its strength stays what it is, as the luminance",
    },
};

static const struct lx_table light_common_table = {
    .parameters = light_common_parameters,
    .count = LX_COUNT(light_common_parameters),
    .size = sizeof(struct lx_light_common),
};

/* ---- the scene ---- */

static const struct lx_parameter scene_parameters[] = {
    {
        .name = "luxel",
        .label = "Format version",
        .type = LX_WHOLE,
        .offset = offsetof(struct lx_scene_parameters, luxel),
        .required = true,
        .legal = LX_BETWEEN(1, 1),
        .meaning = "the version of the scene format",
    },
    {
        .name = "units",
        .label = "Units",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_scene_parameters, units),
        .initial = "radiometric",
        .choices = units_names,
        .meaning = "the names of the units: watts or lumens; numbers stay as they are",
    },
    {
        .name = "channels",
        .label = "Channels",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_scene_parameters, channels),
        .initial = "grey",
        .choices = channels_names,
        .meaning = "what is computed: grey values, or red, green and blue (linear sRGB), by the colours of lights and "
                   "materials, which count for nothing else",
    },
    {
        .name = "shadows",
        .label = "Shadows",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_scene_parameters, shadows),
        .initial = "all",
        .choices = shadows_names,
        .meaning =
            "what light surfaces take from one another: that of all sources, of extended ones as far as they are "
            "hidden; that of point-like and distant ones, and of sources cut into parts; none",
    },
    {
        .name = "reflections",
        .label = "Reflections",
        .type = LX_CHOICE_OR_WHOLE,
        .offset = offsetof(struct lx_scene_parameters, reflections),
        .initial = "none",
        .legal = LX_FROM(1),
        .choices = reflections_names,
        .meaning =
            "how often the light that falls on surfaces is sent on to other surfaces, by Lambert's law with the "
            "reflectance diffuse: never, so many times, until nothing is left; needs over_pi, diffuse below 1 and "
            "physical laws of attenuation",
    },
    {
        .name = "mirrors",
        .label = "Mirrors in a row",
        .type = LX_WHOLE,
        .offset = offsetof(struct lx_scene_parameters, mirrors),
        .initial = "4",
        .legal = LX_BETWEEN(1, 64),
        .advised = {LX_BETWEEN(1, 8)},
        .meaning = "how many mirrors in a row light and sights are followed by; what more of them give is in the bound",
    },
    {
        .name = "maintenance_factor",
        .label = "Maintenance factor",
        .type = LX_REAL,
        .offset = offsetof(struct lx_scene_parameters, maintenance),
        .initial = "1",
        .legal = {.given = true, .low = 0, .high = 1, .low_open = true},
        .advised = {LX_BETWEEN(0.5, 1)},
        .meaning = "the share of its light that every light still gives when the installation is due to be cleaned and "
                   "its lamps changed; the maintenance_factor of a luminaire multiplies it",
    },
    {
        .name = "dimming",
        .label = "Dimming",
        .type = LX_GROUPS,
        .offset = offsetof(struct lx_scene_parameters, dimming),
        .initial = "[]",
        .group = &lx_dimming_table,
        .meaning =
            "groups of lights that are dimmed together, such as {name: a, factor: 0.3}: lights with group: a give "
            "three tenths of their light; -s 'dimming[a].factor=0.5' changes it by name",
    },
    {
        .name = "screen",
        .label = "Screen",
        .type = LX_GROUP,
        .offset = offsetof(struct lx_scene_parameters, screen),
        .required = true,
        .group = &screen_table,
        .meaning = "the screen in the plane z = 0, centred on the origin",
    },
    {
        .name = "observer",
        .label = "Observer",
        .type = LX_GROUP,
        .offset = offsetof(struct lx_scene_parameters, observer),
        .required = true,
        .group = &lx_observer_table,
        .meaning = "who looks: along -z from a height, or from a position at a target",
    },
    {
        .name = "surfaces",
        .label = "Surfaces",
        .type = LX_VARIANTS,
        .offset = offsetof(struct lx_scene_parameters, surfaces),
        .required = true,
        .group = &surface_common_table,
        .variants = lx_surface_variants,
        .meaning = "the surfaces; the list may be empty where only grids and free elements are asked for",
    },
    {
        .name = "lights",
        .label = "Lights",
        .type = LX_VARIANTS,
        .offset = offsetof(struct lx_scene_parameters, lights),
        .required = true,
        .group = &light_common_table,
        .variants = lx_light_variants,
        .meaning = "the lights; the list may be empty",
    },
    {
        .name = "points",
        .label = "Points",
        .type = LX_POINTS,
        .offset = offsetof(struct lx_scene_parameters, points),
        .unit = LX_UNIT_MM,
        .initial = "[]",
        .meaning = "points of the screen whose values are printed with the picture",
    },
    {
        .name = "picture",
        .label = "Picture",
        .type = LX_GROUP,
        .offset = offsetof(struct lx_scene_parameters, picture),
        .group = &picture_table,
        .meaning = "how values become grey levels",
    },
    {
        .name = "grids",
        .label = "Measuring grids",
        .type = LX_GROUPS,
        .offset = offsetof(struct lx_scene_parameters, grids),
        .initial = "[]",
        .group = &lx_grid_table,
        .meaning = "measuring planes of luxel grid: the irradiance at the centres of their cells",
    },
    {
        .name = "observers",
        .label = "Observers",
        .type = LX_GROUPS,
        .offset = offsetof(struct lx_scene_parameters, glare_observers),
        .initial = "[]",
        .group = &lx_glare_observer_table,
        .meaning = "who is asked by luxel grid --limits how much the lights dazzle; they have no say in pictures",
    },
};

const struct lx_table lx_scene_table = {
    .parameters = scene_parameters,
    .count = LX_COUNT(scene_parameters),
    .size = sizeof(struct lx_scene_parameters),
};
