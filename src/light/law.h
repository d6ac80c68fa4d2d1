/* SPDX-License-Identifier: MIT */
/*
 * The attenuation law as it is written in a scene.  A kind of lights that weaken with the distance puts a struct lx_law
 * into its parameters and LX_LAW_PARAMETERS and LX_LAW_RULES into its table.
 */
#ifndef LX_LIGHT_LAW_H
#define LX_LIGHT_LAW_H

#include "light.h"

struct lx_law {
    int attenuation; /* enum lx_attenuation */
    double k_mm;
    double coefficients[3];
};

extern const char *const lx_attenuation_names[];

/* `member_`: the struct lx_law in the parameters. */
#define LX_LAW_PARAMETERS(type_, member_)                                                                              \
    {                                                                                                                  \
        .name = "attenuation",                                                                                         \
        .label = "Attenuation",                                                                                        \
        .type = LX_CHOICE,                                                                                             \
        .offset = offsetof(type_, member_.attenuation),                                                                \
        .choices = lx_attenuation_names,                                                                               \
        .initial = "inverse-square",                                                                                   \
        .meaning = "how light weakens with the distance r in metres: 1/r^2, 1/(k + r), not at all, or "                \
                   "1/(kc + kl r + kq r^2)",                                                                           \
    },                                                                                                                 \
        {                                                                                                              \
            .name = "k",                                                                                               \
            .label = "Length k",                                                                                       \
            .type = LX_REAL,                                                                                           \
            .offset = offsetof(type_, member_.k_mm),                                                                   \
            .unit = LX_UNIT_MM,                                                                                        \
            .legal = LX_ABOVE(0),                                                                                      \
            .advised = {LX_BETWEEN(10, 2000)},                                                                         \
            .meaning = "the length k of the practical law 1/(k + r), which keeps it finite near the source",           \
        },                                                                                                             \
    {                                                                                                                  \
        .name = "coefficients", .label = "Coefficients", .type = LX_REALS,                                             \
        .offset = offsetof(type_, member_.coefficients), .count = 3, .nonzero = true, .legal = LX_FROM(0),             \
        .advised = {LX_BETWEEN(0, 10)},                                                                                \
        .meaning = "kc, kl and kq of the polynomial law 1/(kc + kl r + kq r^2), r in metres, not all of them 0; with " \
                   "kl = 1 and kq = 0 it is the practical law with k = kc",                                            \
    }

#define LX_LAW_RULES                                                                                                   \
    {LX_RULE_NEEDED, "k", "attenuation", "practical"}, {LX_RULE_USED, "k", "attenuation", "practical"},                \
        {LX_RULE_NEEDED, "coefficients", "attenuation", "polynomial"},                                                 \
    {                                                                                                                  \
        LX_RULE_USED, "coefficients", "attenuation", "polynomial"                                                      \
    }

/* Gives an emitter the law; a polynomial that is the practical law becomes that. */
void lx_law_set(const struct lx_law *law, struct lx_emitter *emitter);
/* Gives an emitter the law of another one. */
void lx_law_copy(const struct lx_emitter *from, struct lx_emitter *emitter);

#endif
