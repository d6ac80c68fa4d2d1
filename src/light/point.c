/* SPDX-License-Identifier: MIT */
/* The point source: a small lamp with a pattern about its axis. */
#include <math.h>

#include "pattern.h"
#include "placed.h"

struct point_parameters {
    uint64_t given;
    struct lx_placed placed;
    struct lx_pattern pattern;
};

static const struct lx_parameter point_parameters[] = {
    LX_PLACED_PARAMETERS(struct point_parameters),
    LX_PATTERN_PARAMETERS(struct point_parameters),
};

static const struct lx_rule point_rules[] = {
    LX_PLACED_RULES,
    LX_PATTERN_RULES,
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
    lx_bounded3 axis = lx_placed_axis(&point_table, parameters, &point->placed);
    struct lx_emitter emitter = lx_placed_emitter(&point->placed, lx_pattern_profile(&point->pattern, axis));
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
