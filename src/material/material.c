/* SPDX-License-Identifier: MIT */
/* The authored material: how a surface turns the light that falls on it into brightness. */
#include <math.h>

#include "material.h"

#define LX_NAME_MODEL(number, lobe, name) name,
static const char *const model_names[] = {LX_MODELS(LX_NAME_MODEL) NULL};
static const char *const highlight_names[] = {"plain", "gated", "cosine", NULL};

static const struct lx_parameter material_parameters[] = {
    {
        .name = "model",
        .label = "Model",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_material, model),
        .choices = model_names,
        .initial = "blinn-phong",
        .meaning = "the shape of the highlight: by the half vector, by the mirrored ray, or no highlight (lambert)",
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
};

static const struct lx_rule material_rules[] = {
    {LX_RULE_USED, "specular", "model", "blinn-phong|phong"},
    {LX_RULE_USED, "specular_color", "model", "blinn-phong|phong"},
    {LX_RULE_USED, "shininess", "model", "blinn-phong|phong"},
    {LX_RULE_USED, "highlight", "model", "blinn-phong|phong"},
    {LX_RULE_USED, "normalized", "model", "blinn-phong|phong"},
};

const struct lx_table lx_material_table = {
    .parameters = material_parameters,
    .count = LX_COUNT(material_parameters),
    .rules = material_rules,
    .rule_count = LX_COUNT(material_rules),
    .size = sizeof(struct lx_material),
};

double lx_material_ambient(const struct lx_material *material)
{
    return lx_is_given(&lx_material_table, material, "ambient") ? material->ambient : material->diffuse;
}
