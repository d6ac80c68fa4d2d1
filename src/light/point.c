/* SPDX-License-Identifier: MIT */
/*
 * The point source: a small lamp that shines the same in all directions (isotropic) or by a power of the
 * cosine from its axis (lambertian: the cosine itself).
 */
#include <math.h>

#include "placed.h"

enum pattern { ISOTROPIC, LAMBERTIAN, COSINE };

struct point_parameters {
    uint64_t given;
    struct lx_placed placed;
    int pattern;
    double exponent;
};

static const char *const pattern_names[] = {"isotropic", "lambertian", "cosine", NULL};

static const struct lx_parameter point_parameters[] = {
    LX_PLACED_PARAMETERS(struct point_parameters),
    {
        .name = "pattern",
        .label = "Pattern",
        .type = LX_CHOICE,
        .offset = offsetof(struct point_parameters, pattern),
        .choices = pattern_names,
        .initial = "isotropic",
        .meaning = "how the intensity depends on the angle from the axis: not, by its cosine, or by a power of it",
    },
    {
        .name = "exponent",
        .label = "Exponent m",
        .type = LX_REAL,
        .offset = offsetof(struct point_parameters, exponent),
        .legal = LX_FROM(0),
        .advised = {LX_BETWEEN(0, 20)},
        .meaning = "the exponent m of the cosine in the pattern cosine",
    },
};

static const struct lx_rule point_rules[] = {
    LX_PLACED_RULES,
    {LX_RULE_NEEDED, "exponent", "pattern", "cosine"},
    {LX_RULE_USED, "exponent", "pattern", "cosine"},
    {LX_RULE_USED, "axis", "pattern", "lambertian|cosine"},
    {LX_RULE_USED, "aim", "pattern", "lambertian|cosine"},
};

static const struct lx_table point_table = {
    .parameters = point_parameters,
    .count = LX_COUNT(point_parameters),
    .rules = point_rules,
    .rule_count = LX_COUNT(point_rules),
    .size = sizeof(struct point_parameters),
};

static int prepare_point(const void *parameters, struct lx_emitters *emitters)
{
    const struct point_parameters *point = parameters;
    struct lx_profile profile = lx_profile_isotropic();
    if (point->pattern != ISOTROPIC)
        profile = lx_profile_cosine(lx_placed_axis(&point_table, parameters, &point->placed),
                                    point->pattern == LAMBERTIAN ? 1 : point->exponent);
    struct lx_emitter emitter = lx_placed_emitter(&point->placed, profile);
    return lx_emitters_append(emitters, &emitter);
}

const struct lx_light_kind lx_point_kind = {
    .variant =
        {
            .name = "point",
            .meaning = "a small source at a place, such as a bulb",
            .example = "{type: point, position: [1300, 700, 2600], intensity: 30}",
            .table = &point_table,
        },
    .prepare = prepare_point,
};
