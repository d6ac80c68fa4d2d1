/* SPDX-License-Identifier: MIT */
/*
 * The spotlight: a point source that shines within a cone, brightest on its axis, falling from the inner to
 * the outer angle.
 */

#include "array.h"
#include "placed.h"

struct spot_parameters {
    uint64_t given;
    struct lx_placed placed;
    double inner_deg, outer_deg;
    int falloff; /* enum lx_falloff */
    double exponent;
    struct lx_array array;
};

static const char *const falloff_names[] = {"smoothstep", "squared", "linear", "hard", NULL};

static const struct lx_parameter spot_parameters[] = {
    LX_PLACED_PARAMETERS(struct spot_parameters),
    {
        .name = "inner",
        .label = "Inner angle",
        .type = LX_REAL,
        .offset = offsetof(struct spot_parameters, inner_deg),
        .unit = LX_UNIT_DEGREES,
        .required = true,
        .legal = LX_BETWEEN(0, 90),
        .meaning = "the half-angle of the cone within which the intensity is full",
    },
    {
        .name = "outer",
        .label = "Outer angle",
        .type = LX_REAL,
        .offset = offsetof(struct spot_parameters, outer_deg),
        .unit = LX_UNIT_DEGREES,
        .required = true,
        .legal = LX_BETWEEN(0, 90),
        .meaning = "the half-angle of the cone outside which there is no light",
    },
    {
        .name = "falloff",
        .label = "Falloff",
        .type = LX_CHOICE,
        .offset = offsetof(struct spot_parameters, falloff),
        .choices = falloff_names,
        .initial = "smoothstep",
        .meaning = "how the intensity falls between the inner and the outer angle",
    },
    {
        .name = "exponent",
        .label = "Exponent m",
        .type = LX_REAL,
        .offset = offsetof(struct spot_parameters, exponent),
        .initial = "0",
        .legal = LX_FROM(0),
        .advised = {LX_BETWEEN(0, 20)},
        .meaning = "the exponent m of the cosine by which the intensity falls from the axis",
    },
    LX_ARRAY_PARAMETER(struct spot_parameters),
};

static const struct lx_rule spot_rules[] = {
    LX_PLACED_RULES,
    {LX_RULE_ORDERED, "inner", "outer", NULL},
};

static void check_spot(const struct lx_check *check, void *parameters);

static const struct lx_table spot_table = {
    .parameters = spot_parameters,
    .count = LX_COUNT(spot_parameters),
    .rules = spot_rules,
    .rule_count = LX_COUNT(spot_rules),
    .size = sizeof(struct spot_parameters),
    .check = check_spot,
};

static struct lx_emitter emitter_of(const struct spot_parameters *spot)
{
    lx_bounded3 axis = lx_placed_axis(&spot_table, spot, &spot->placed);
    return lx_placed_emitter(
        &spot_table, spot, &spot->placed,
        lx_profile_cone(axis, (enum lx_falloff)spot->falloff, spot->inner_deg, spot->outer_deg, spot->exponent));
}

static void check_spot(const struct lx_check *check, void *parameters)
{
    struct lx_emitter emitter = emitter_of(parameters);
    lx_check_power(check, &emitter);
}

static int prepare_spot(const void *parameters, struct lx_emitters *emitters)
{
    struct lx_emitter emitter = emitter_of(parameters);
    return lx_emitters_append(emitters, &emitter);
}

const struct lx_light_kind lx_spot_kind = {
    .variant =
        {
            .name = "spot",
            .meaning = "a point source that shines within a cone",
            .example = "{type: spot, position: [900, 700, 2400], aim: [0, 0, 1000], intensity: 1200, "
                       "inner: 8, outer: 12}",
            .table = &spot_table,
        },
    .prepare = prepare_spot,
};
