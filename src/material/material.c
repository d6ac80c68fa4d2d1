/* SPDX-License-Identifier: MIT */
/* The authored material: how a surface turns the light that falls on it into brightness. */

#include "../base/number.h"
#include "../parameter/check.h"
#include "../parameter/words.h"
#include "lobe.h"
#include "material.h"

#define LX_NAME_MODEL(number, lobe, name) name,
static const char *const model_names[] = {LX_MODELS(LX_NAME_MODEL) NULL};
static const char *const diffuse_names[] = {"lambert", LX_DIFFUSE_MODELS(LX_NAME_MODEL) NULL};
static const char *const highlight_names[] = {"plain", "gated", "cosine", NULL};

static const struct lx_parameter material_parameters[] = {
    {
        .name = "model",
        .label = "Model",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_material, model),
        .choices = model_names,
        .initial = "blinn-phong",
        .meaning = "the shape of the highlight: by the half vector, by the mirrored ray, of small facets (ggx), or no "
                   "highlight (lambert)",
    },
    {
        .name = "diffuse_model",
        .label = "Diffuse model",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_material, diffuse_model),
        .choices = diffuse_names,
        .initial = "lambert",
        .meaning = "how what is no highlight is reflected: to all sides alike (lambert), or as rough surfaces do, of "
                   "grooves (oren-nayar) or so that no light is lost between them (eon)",
    },
    {
        .name = "sigma",
        .label = "Slopes sigma",
        .type = LX_REAL,
        .offset = offsetof(struct lx_material, sigma_degrees),
        .unit = LX_UNIT_DEGREES,
        .initial = "20",
        .legal = LX_BETWEEN(0, 90),
        .advised = {LX_BETWEEN(0, 45)},
        .meaning = "the standard deviation of the slopes of a rough surface: with 0 it is Lambert's",
    },
    {
        .name = "roughness",
        .label = "Roughness",
        .type = LX_REAL,
        .offset = offsetof(struct lx_material, roughness),
        .initial = "0.5",
        .legal = LX_BETWEEN(0, 1),
        .advised = {LX_BETWEEN(0, 1)},
        .meaning = "how rough the surface is: with 0 it is Lambert's",
    },
    {
        .name = "diffuse",
        .label = "Diffuse reflection kd",
        .type = LX_REAL,
        .offset = offsetof(struct lx_material, diffuse),
        .initial = "0.8",
        .legal = LX_FROM(0),
        .advised = {LX_BETWEEN(0, 1)},
        .meaning = "kd, the weight of the diffuse reflection",
    },
    {
        .name = "specular",
        .label = "Specular reflection ks",
        .type = LX_REAL,
        .offset = offsetof(struct lx_material, specular),
        .initial = "0.5",
        .legal = LX_FROM(0),
        .advised = {LX_BETWEEN(0, 1)},
        .meaning = "ks, the weight of the highlight",
    },
    {
        .name = "shininess",
        .label = "Shininess n",
        .type = LX_REAL,
        .offset = offsetof(struct lx_material, shininess),
        .initial = "20",
        .legal = LX_ABOVE(0),
        .advised = {LX_BETWEEN(1, 500)},
        .meaning = "n, the exponent of the highlight: the larger, the smaller and sharper it is",
    },
    {
        .name = "alpha",
        .label = "Facets' roughness alpha",
        .type = LX_REAL,
        .offset = offsetof(struct lx_material, alpha),
        .initial = "0.25",
        .legal = {.given = true, .low = 0, .high = 1, .low_open = true},
        .advised = {LX_BETWEEN(0.02, 1)},
        .meaning = "how rough the facets of the highlight stand: the smaller, the smaller and sharper it is",
    },
    {
        .name = "f0",
        .label = "Reflectance straight on F0",
        .type = LX_REAL,
        .offset = offsetof(struct lx_material, f0),
        .initial = "0.04",
        .legal = LX_BETWEEN(0, 1),
        .advised = {LX_BETWEEN(0.02, 1)},
        .meaning = "what a facet reflects of light that falls straight on it: 0.04 is glass, paint or plastic",
    },
    {
        .name = "ambient",
        .label = "Ambient reflection ka",
        .type = LX_REAL,
        .offset = offsetof(struct lx_material, ambient),
        .legal = LX_FROM(0),
        .advised = {LX_BETWEEN(0, 1)},
        .meaning = "ka, the weight of ambient light; as diffuse where it is not given",
    },
    {
        .name = "over_pi",
        .label = "Divided by pi",
        .type = LX_BOOLEAN,
        .offset = offsetof(struct lx_material, over_pi),
        .initial = "false",
        .meaning = "whether the result is divided by pi, which makes radiance from irradiance, or luminance from "
                   "illuminance",
    },
    {
        .name = "highlight",
        .label = "Highlight factor",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_material, highlight),
        .choices = highlight_names,
        .initial = "plain",
        .meaning = "the factor of the highlight: 1, 1 only where the light is in front (gated), or N.L (cosine)",
    },
    {
        .name = "normalized",
        .label = "Normalised highlight",
        .type = LX_BOOLEAN,
        .offset = offsetof(struct lx_material, normalized),
        .initial = "false",
        .meaning = "whether the highlight is scaled so that, with over_pi and the cosine, it reflects ks of the light",
    },
    {
        .name = "color",
        .label = "Colour",
        .type = LX_REALS,
        .offset = offsetof(struct lx_material, color),
        .count = 3,
        .initial = "[1, 1, 1]",
        .legal = LX_BETWEEN(0, 1),
        .meaning = "the factors of the diffuse and the ambient reflection in red, green and blue (linear sRGB), in "
                   "scenes with channels rgb",
    },
    {
        .name = "specular_color",
        .label = "Colour of the highlight",
        .type = LX_REALS,
        .offset = offsetof(struct lx_material, specular_color),
        .count = 3,
        .initial = "[1, 1, 1]",
        .legal = LX_BETWEEN(0, 1),
        .meaning = "the factors of the highlight in red, green and blue, in scenes with channels rgb",
    },
    {
        .name = "mirror",
        .label = "Mirror",
        .type = LX_BOOLEAN,
        .offset = offsetof(struct lx_material, mirror),
        .initial = "false",
        .meaning = "whether it is a mirror, which reflects all light to one side and has no brightness of its own: of "
                   "rectangles, walls of rooms and sides of boxes alone",
    },
};

static const struct lx_rule material_rules[] = {
    {LX_RULE_USED, "sigma", "diffuse_model", "oren-nayar"},
    {LX_RULE_USED, "roughness", "diffuse_model", "eon"},
    {LX_RULE_USED, "specular", "model", "blinn-phong|phong|ggx"},
    {LX_RULE_USED, "specular_color", "model", "blinn-phong|phong|ggx"},
    {LX_RULE_USED, "alpha", "model", "ggx"},
    {LX_RULE_USED, "f0", "model", "ggx"},
    {LX_RULE_USED, "shininess", "model", "blinn-phong|phong"},
    {LX_RULE_USED, "highlight", "model", "blinn-phong|phong"},
    {LX_RULE_USED, "normalized", "model", "blinn-phong|phong"},
};

static void check_material(const struct lx_check *check, void *parameters)
{
    const struct lx_material *material = parameters;
    char number[LX_NUMBER_SIZE];
    const double most = lx_diffuse_kind_of(material)->most_diffuse;
    if (most > 0 && material->diffuse > most)
        lx_check_report(check, "diffuse", LX_ALL_OF_IT, LX_MSG_EON_ABOVE_ONE,
                        (const char *const[]){lx_write_number(material->diffuse, number), NULL});
}

const struct lx_table lx_material_table = {
    .parameters = material_parameters,
    .count = LX_COUNT(material_parameters),
    .rules = material_rules,
    .rule_count = LX_COUNT(material_rules),
    .size = sizeof(struct lx_material),
    .check = check_material,
};

double lx_material_ambient(const struct lx_material *material)
{
    return lx_is_given(&lx_material_table, material, "ambient") ? material->ambient : material->diffuse;
}
