/* SPDX-License-Identifier: MIT */
/*
 * What all lights that stand at a place and shine with a radiant intensity have in common: position,
 * intensity, attenuation, and the axis, given as such or by a point to aim at.  A kind puts a struct
 * lx_placed named `placed` into its parameters and LX_PLACED_PARAMETERS and LX_PLACED_RULES into its table.  A kind of
 * many places has a struct lx_shining only, with LX_SHINING_PARAMETERS and LX_SHINING_RULES.
 */
#ifndef LX_LIGHT_PLACED_H
#define LX_LIGHT_PLACED_H

#include "law.h"
#include "light.h"

/* How a source shines from where it stands. */
struct lx_shining {
    struct lx_law law;
    double axis[3];
    double aim_mm[3];
};

struct lx_placed {
    double position_mm[3];
    double intensity; /* W/sr or cd; or: */
    double power;     /* W or lm */
    struct lx_shining shining;
};

#define LX_PLACED_PARAMETERS(type_)                                                                                    \
    {                                                                                                                  \
        .name = "position",                                                                                            \
        .label = "Position",                                                                                           \
        .type = LX_REALS,                                                                                              \
        .offset = offsetof(type_, placed.position_mm),                                                                 \
        .count = 3,                                                                                                    \
        .unit = LX_UNIT_MM,                                                                                            \
        .required = true,                                                                                              \
        .advised = {LX_BETWEEN(-10000, 10000), LX_BETWEEN(-10000, 10000), LX_BETWEEN(100, 10000)},                     \
        .meaning = "where the source stands",                                                                          \
    },                                                                                                                 \
        {                                                                                                              \
            .name = "intensity",                                                                                       \
            .label = "Intensity",                                                                                      \
            .type = LX_REAL,                                                                                           \
            .offset = offsetof(type_, placed.intensity),                                                               \
            .unit = LX_UNIT_INTENSITY,                                                                                 \
            .legal = LX_FROM(0),                                                                                       \
            .advised = {LX_BETWEEN(0.01, 10000)},                                                                      \
            .meaning = "the intensity, radiant or luminous, along the axis where it depends on the direction",         \
        },                                                                                                             \
        {                                                                                                              \
            .name = "power",                                                                                           \
            .label = "Power",                                                                                          \
            .type = LX_REAL,                                                                                           \
            .offset = offsetof(type_, placed.power),                                                                   \
            .unit = LX_UNIT_POWER,                                                                                     \
            .legal = LX_FROM(0),                                                                                       \
            .advised = {LX_BETWEEN(0.1, 1e5)},                                                                         \
            .meaning = "the power that it emits in all, instead of the intensity, which is the power over the "        \
                       "integral of pattern and cone over all directions: 4 pi of an isotropic source",                \
        },                                                                                                             \
        LX_SHINING_PARAMETERS(type_, placed.shining)

#define LX_SHINING_PARAMETERS(type_, member_)                                                                          \
    LX_LAW_PARAMETERS(type_, member_.law),                                                                             \
        {                                                                                                              \
            .name = "axis",                                                                                            \
            .label = "Axis",                                                                                           \
            .type = LX_REALS,                                                                                          \
            .offset = offsetof(type_, member_.axis),                                                                   \
            .count = 3,                                                                                                \
            .nonzero = true,                                                                                           \
            .initial = "[0, 0, -1]",                                                                                   \
            .meaning = "the direction in which the source shines, of any length",                                      \
        },                                                                                                             \
    {                                                                                                                  \
        .name = "aim", .label = "Aim", .type = LX_REALS, .offset = offsetof(type_, member_.aim_mm), .count = 3,        \
        .unit = LX_UNIT_MM, .meaning = "the point at which the source is aimed, instead of axis",                      \
    }

#define LX_SHINING_RULES                                                                                               \
    LX_LAW_RULES,                                                                                                      \
    {                                                                                                                  \
        LX_RULE_EXCLUSIVE, "axis", "aim", NULL                                                                         \
    }

#define LX_PLACED_RULES                                                                                                \
    {LX_RULE_ONE, "intensity", NULL, "intensity|power"}, LX_SHINING_RULES,                                             \
    {                                                                                                                  \
        LX_RULE_DISTINCT, "aim", "position", NULL                                                                      \
    }

/* The point emitter with this profile at a place. */
struct lx_emitter lx_shining_emitter(const struct lx_shining *shining, const double position_mm[3], double intensity,
                                     struct lx_profile profile);

/* The unit axis: towards the aim where one is given (`table` tells), else along the axis. */
lx_bounded3 lx_placed_axis(const struct lx_table *table, const void *parameters, const struct lx_placed *placed);

/* The point emitter with this profile, of the intensity or the power that is given. */
struct lx_emitter lx_placed_emitter(const struct lx_table *table, const void *parameters,
                                    const struct lx_placed *placed, struct lx_profile profile);

/* Reports a power that gives no intensity. */
void lx_check_power(const struct lx_check *check, const struct lx_emitter *emitter);

#endif
