/* SPDX-License-Identifier: MIT */
/* Ambient light: scattered light without a source or direction, the same on every element. */

#include "light.h"

struct ambient_parameters {
    uint64_t given;
    double irradiance;
};

static const struct lx_parameter ambient_parameters[] = {
    {
        .name = "irradiance",
        .label = "Irradiance",
        .type = LX_REAL,
        .offset = offsetof(struct ambient_parameters, irradiance),
        .unit = LX_UNIT_IRRADIANCE,
        .required = true,
        .legal = LX_FROM(0),
        .meaning = "the irradiance, in photometric units the illuminance, that it adds to every element, whatever "
                   "its normal",
    },
};

static const struct lx_table ambient_table = {
    .parameters = ambient_parameters,
    .count = LX_COUNT(ambient_parameters),
    .size = sizeof(struct ambient_parameters),
};

static int prepare_ambient(const void *parameters, struct lx_emitters *emitters)
{
    const struct ambient_parameters *ambient = parameters;
    struct lx_emitter emitter = {.type = LX_UNIFORM, .strength = ambient->irradiance};
    return lx_emitters_append(emitters, &emitter);
}

const struct lx_light_kind lx_ambient_kind = {
    .variant =
        {
            .name = "ambient",
            .meaning = "scattered light without a direction",
            .example = "{type: ambient, irradiance: 60}",
            .table = &ambient_table,
        },
    .prepare = prepare_ambient,
};
