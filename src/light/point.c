/* SPDX-License-Identifier: MIT */
/* The point source: a small lamp with a pattern about its axis. */

#include "array.h"
#include "pattern.h"
#include "placed.h"

struct point_parameters {
    uint64_t given;
    struct lx_placed placed;
    struct lx_pattern pattern;
    struct lx_array array;
};

static const struct lx_parameter point_parameters[] = {
    LX_PLACED_PARAMETERS(struct point_parameters),
    LX_PATTERN_PARAMETERS(struct point_parameters),
    LX_ARRAY_PARAMETER(struct point_parameters),
};

static const struct lx_rule point_rules[] = {
    LX_PLACED_RULES,
    LX_PATTERN_RULES,
};

static void check_point(const struct lx_check *check, void *parameters);

static const struct lx_table point_table = {
    .parameters = point_parameters,
    .count = LX_COUNT(point_parameters),
    .rules = point_rules,
    .rule_count = LX_COUNT(point_rules),
    .size = sizeof(struct point_parameters),
    .check = check_point,
};

static struct lx_emitter emitter_of(const struct point_parameters *point)
{
    lx_bounded3 axis = lx_placed_axis(&point_table, point, &point->placed);
    return lx_placed_emitter(&point_table, point, &point->placed, lx_pattern_profile(&point->pattern, axis));
}

static void check_point(const struct lx_check *check, void *parameters)
{
    struct lx_emitter emitter = emitter_of(parameters);
    lx_check_power(check, &emitter);
}

static int prepare_point(const void *parameters, struct lx_emitters *emitters)
{
    struct lx_emitter emitter = emitter_of(parameters);
    return lx_emitters_append(emitters, &emitter);
}

const struct lx_light_kind lx_point_kind = {
    .variant =
        {
            .name = "point",
            .meaning = "a small source, such as a bulb",
            .example = "{type: point, position: [1300, 700, 2600], intensity: 30}",
            .table = &point_table,
        },
    .prepare = prepare_point,
};
