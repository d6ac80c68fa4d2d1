/* SPDX-License-Identifier: MIT */
/* The distant source: parallel light from one direction, such as sunlight. */

#include "light.h"

struct distant_parameters {
    uint64_t given;
    double direction[3];
    double irradiance;
};

static const struct lx_parameter distant_parameters[] = {
    {
        .name = "direction",
        .label = "Direction",
        .type = LX_REALS,
        .offset = offsetof(struct distant_parameters, direction),
        .count = 3,
        .required = true,
        .nonzero = true,
        .meaning = "the direction in which the light travels, of any length",
    },
    {
        .name = "irradiance",
        .label = "Irradiance",
        .type = LX_REAL,
        .offset = offsetof(struct distant_parameters, irradiance),
        .unit = LX_UNIT_IRRADIANCE,
        .required = true,
        .legal = LX_FROM(0),
        .meaning = "the irradiance, in photometric units the illuminance, on a plane that faces the light",
    },
};

static const struct lx_table distant_table = {
    .parameters = distant_parameters,
    .count = LX_COUNT(distant_parameters),
    .size = sizeof(struct distant_parameters),
};

static int prepare_distant(const void *parameters, struct lx_emitters *emitters)
{
    const struct distant_parameters *distant = parameters;
    struct lx_emitter emitter = {
        .type = LX_DIRECTION,
        .strength = distant->irradiance,
        .towards = lx_negate3(lx_unit3(lx_exact3(distant->direction))),
    };
    return lx_emitters_append(emitters, &emitter);
}

const struct lx_light_kind lx_distant_kind = {
    .variant =
        {
            .name = "distant",
            .meaning = "parallel light from one direction",
            .example = "{type: distant, direction: [-1, -0.6, -0.5], irradiance: 900}",
            .table = &distant_table,
        },
    .prepare = prepare_distant,
};
