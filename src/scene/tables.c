/* SPDX-License-Identifier: MIT */
/* The tables of what a scene holds beside its surfaces, materials and lights, and the table of the whole. */
#include <math.h>

#include "../base/number.h"
#include "../light/light.h"
#include "../material/measure.h"
#include "../parameter/check.h"
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

/* ---- measuring grids ---- */

enum { MOST_IN_A_ROW = 65536, MOST_CELLS = 10000000 };

static const char *const spacing_names[] = {"en12464", NULL};

static const struct lx_parameter grid_parameters[] = {
    {
        .name = "name",
        .label = "Name",
        .type = LX_TEXT,
        .offset = offsetof(struct lx_grid, name),
        .meaning = "a name for messages and tables",
    },
    {
        .name = "center",
        .label = "Centre",
        .type = LX_REALS,
        .offset = offsetof(struct lx_grid, center_mm),
        .count = 3,
        .unit = LX_UNIT_MM,
        .required = true,
        .meaning = "the centre of the measuring plane",
    },
    {
        .name = "size",
        .label = "Size",
        .type = LX_REALS,
        .offset = offsetof(struct lx_grid, size_mm),
        .count = 2,
        .unit = LX_UNIT_MM,
        .required = true,
        .legal = LX_ABOVE(0),
        .meaning = "the width and the height of the measuring plane; the height runs along up",
    },
    {
        .name = "axis",
        .label = "Axis",
        .type = LX_REALS,
        .offset = offsetof(struct lx_grid, axis),
        .count = 3,
        .nonzero = true,
        .initial = "[0, 0, 1]",
        .meaning = "the normal of the measuring plane, of any length: the side that it is lit from",
    },
    {
        .name = "up",
        .label = "Up direction",
        .type = LX_REALS,
        .offset = offsetof(struct lx_grid, up),
        .count = 3,
        .nonzero = true,
        .initial = "[0, 1, 0]",
        .meaning = "the direction along which the height runs, made perpendicular to axis; where it is not given and "
                   "the axis runs along y, (0, 0, 1)",
    },
    {
        .name = "n",
        .label = "Cells",
        .type = LX_WHOLES,
        .offset = offsetof(struct lx_grid, n),
        .count = 2,
        .legal = LX_BETWEEN(1, MOST_IN_A_ROW),
        .advised = {LX_BETWEEN(2, 500)},
        .meaning = "the number of cells, [columns, rows], at most ten million; the irradiance is measured at the "
                   "centre of each",
    },
    {
        .name = "spacing",
        .label = "Spacing",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_grid, spacing),
        .choices = spacing_names,
        .meaning = "the number of cells by a rule: en12464 makes them at most 0.2 * 5^log10(d) metres wide and high, "
                   "but no more than 10, where d is the longer side in metres, or the shorter one where the longer is "
                   "twice as long or more",
    },
    {
        .name = "measure",
        .label = "Measure",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_grid, measure),
        .choices = lx_measure_names,
        .meaning = "what is measured at the centre of each cell: the illuminance on the plane, or the mean of that on "
                   "the surface of a small body there: on the side of a cylinder along the axis, on that half of "
                   "it which faces along up, on a sphere, or on the half of a sphere that looks along the axis",
    },
    {
        .name = "limits",
        .label = "Limits",
        .type = LX_GROUP,
        .offset = offsetof(struct lx_grid, limits),
        .group = &lx_grid_limits_table,
        .meaning = "what the values are to keep: pass, fail, or undecided where their bounds span the limit",
    },
};

static const struct lx_rule grid_rules[] = {
    {LX_RULE_ONE, "n", NULL, "n|spacing"},
};

/* EN 12464-1:2011, 4.4: the greatest distance between points of a plane, in mm. */
static double en12464_spacing_mm(const double size_mm[2])
{
    const double longer = fmax(size_mm[0], size_mm[1]), shorter = fmin(size_mm[0], size_mm[1]);
    const double d_m = (longer >= 2 * shorter ? shorter : longer) / 1000;
    return 1000 * fmin(0.2 * pow(5, log10(d_m)), 10);
}

/* The cells of a plane: as many as n says, or by the spacing, as a whole number that may be too large. */
static void count_cells(const struct lx_grid *grid, bool is_by_n, double cells[2])
{
    const double spacing = en12464_spacing_mm(grid->size_mm);
    for (int i = 0; i < 2; i++) {
        /* what rounding cannot tell from whole cells is whole */
        const double fit = grid->size_mm[i] / spacing;
        cells[i] = is_by_n ? grid->n[i] : fmax(ceil(fit - 1e-9 * fit), 1);
    }
}

static void check_grid(const struct lx_check *check, void *parameters)
{
    struct lx_grid *grid = parameters;
    const bool is_by_n = lx_is_given(check->table, grid, "n");
    double cells[2];
    lx_check_pose(check, grid->axis, grid->up);
    count_cells(grid, is_by_n, cells);
    if (cells[0] <= MOST_IN_A_ROW && cells[1] <= MOST_IN_A_ROW && cells[0] * cells[1] <= MOST_CELLS) {
        for (int i = 0; i < 2; i++)
            grid->n[i] = (unsigned)cells[i];
        return;
    }
    char columns[LX_NUMBER_SIZE], rows[LX_NUMBER_SIZE], most[LX_NUMBER_SIZE];
    lx_check_report(check, is_by_n ? "n" : "size", LX_ALL_OF_IT, LX_MSG_TOO_MANY_CELLS,
                    LX_ARGS(lx_write_number(cells[0], columns), lx_write_number(cells[1], rows),
                            lx_write_number(MOST_CELLS, most)));
}

static const struct lx_table grid_table = {
    .parameters = grid_parameters,
    .count = LX_COUNT(grid_parameters),
    .rules = grid_rules,
    .rule_count = LX_COUNT(grid_rules),
    .size = sizeof(struct lx_grid),
    .check = check_grid,
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
        .group = &grid_table,
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
