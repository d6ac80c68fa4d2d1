/* SPDX-License-Identifier: MIT */
/*
 * The angular pattern of a small lamp: the same in all directions (isotropic) or by a power of the cosine from its axis
 * (lambertian: the cosine itself).  A kind puts a struct lx_pattern named `pattern` into its parameters and
 * LX_PATTERN_PARAMETERS and LX_PATTERN_RULES into its table, beside its keys axis and aim.
 */
#ifndef LX_LIGHT_PATTERN_H
#define LX_LIGHT_PATTERN_H

#include "light.h"

struct lx_pattern {
    int shape;
    double exponent;
};

extern const char *const lx_pattern_names[];

#define LX_PATTERN_PARAMETERS(type_)                                                                                   \
    {                                                                                                                  \
        .name = "pattern",                                                                                             \
        .label = "Pattern",                                                                                            \
        .type = LX_CHOICE,                                                                                             \
        .offset = offsetof(type_, pattern.shape),                                                                      \
        .choices = lx_pattern_names,                                                                                   \
        .initial = "isotropic",                                                                                        \
        .meaning = "how the intensity depends on the angle from the axis: not, by its cosine, or by a power of it",    \
    },                                                                                                                 \
    {                                                                                                                  \
        .name = "exponent", .label = "Exponent m", .type = LX_REAL, .offset = offsetof(type_, pattern.exponent),       \
        .legal = LX_FROM(0), .advised = {LX_BETWEEN(0, 20)},                                                           \
        .meaning = "the exponent m of the cosine in the pattern cosine",                                               \
    }

#define LX_PATTERN_RULES                                                                                               \
    {LX_RULE_NEEDED, "exponent", "pattern", "cosine"}, {LX_RULE_USED, "exponent", "pattern", "cosine"},                \
        {LX_RULE_USED, "axis", "pattern", "lambertian|cosine"},                                                        \
    {                                                                                                                  \
        LX_RULE_USED, "aim", "pattern", "lambertian|cosine"                                                            \
    }

/* Whether the axis matters. */
bool lx_pattern_has_axis(const struct lx_pattern *pattern);

/* The pattern as a profile about a unit axis. */
struct lx_profile lx_pattern_profile(const struct lx_pattern *pattern, lx_bounded3 axis);

#endif
