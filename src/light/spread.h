/* SPDX-License-Identifier: MIT */
/*
 * What all lights of some size have in common: a uniform radiance, given as such or by what the whole gives, the
 * attenuation, and into how many parts they are cut.  A kind puts a struct lx_spread named `spread` into its
 * parameters and LX_SPREAD_PARAMETERS and LX_SPREAD_RULES into its table.
 */
#ifndef LX_LIGHT_SPREAD_H
#define LX_LIGHT_SPREAD_H

#include "../parameter/check.h"
#include "law.h"
#include "light.h"
#include "solid/extended.h"
#include "solid/facets.h"

struct lx_spread {
    double radiance; /* W/(sr m^2) or cd/m^2 */
    double power;    /* W or lm */
    struct lx_law law;
    struct lx_choice_or_whole parts; /* LX_CONVERGED, or how many */
};

enum { LX_CONVERGED };

extern const char *const lx_parts_names[];

/* Where a source of some size may well stand, as the advised ranges of the key. */
#define LX_SPREAD_PLACES                                                                                               \
    {                                                                                                                  \
        LX_BETWEEN(-10000, 10000), LX_BETWEEN(-10000, 10000), LX_BETWEEN(100, 10000)                                   \
    }

#define LX_SPREAD_PARAMETERS(type_)                                                                                    \
    {                                                                                                                  \
        .name = "radiance",                                                                                            \
        .label = "Radiance",                                                                                           \
        .type = LX_REAL,                                                                                               \
        .offset = offsetof(type_, spread.radiance),                                                                    \
        .unit = LX_UNIT_RADIANCE,                                                                                      \
        .legal = LX_FROM(0),                                                                                           \
        .advised = {LX_BETWEEN(0.01, 1e6)},                                                                            \
        .meaning = "the radiance, in photometric units the luminance, the same everywhere and in all directions of a " \
                   "lit side",                                                                                         \
    },                                                                                                                 \
        {                                                                                                              \
            .name = "power",                                                                                           \
            .label = "Power",                                                                                          \
            .type = LX_REAL,                                                                                           \
            .offset = offsetof(type_, spread.power),                                                                   \
            .unit = LX_UNIT_POWER,                                                                                     \
            .legal = LX_FROM(0),                                                                                       \
            .advised = {LX_BETWEEN(0.01, 1e5)},                                                                        \
            .meaning = "the power that it emits in all: pi times the radiance times the area of all that shines",      \
        },                                                                                                             \
        LX_LAW_PARAMETERS(type_, spread.law),                                                                          \
    {                                                                                                                  \
        .name = "parts", .label = "Parts", .type = LX_CHOICE_OR_WHOLE, .offset = offsetof(type_, spread.parts),        \
        .choices = lx_parts_names, .initial = "converged", .legal = LX_BETWEEN(1, 1000),                               \
        .advised = {LX_BETWEEN(1, 100)},                                                                               \
        .meaning = "into how many parts each way the source is cut, each a point at its centre; converged: as "        \
                   "many as it takes until more of them change nothing",                                               \
    }

#define LX_SPREAD_RULES LX_LAW_RULES

/* The shapes that a light consists of: emitters that have only their type and place yet. */
struct lx_shapes {
    struct lx_emitters emitters;
    lx_bounded area_mm2;
};

/* Adds a shape, whose facets it takes over; facets of NULL, of LX_FACETS, are memory that ran out.  0, or -1. */
int lx_shapes_add(struct lx_shapes *shapes, const struct lx_emitter *shape);
/* Adds facets as a shape. */
int lx_shapes_add_facets(struct lx_shapes *shapes, struct lx_facets *facets);
void lx_shapes_clear(struct lx_shapes *shapes);

/* The area in m^2. */
lx_bounded lx_shapes_area(const struct lx_shapes *shapes);

/* The radiance of a light that emits this power in all. */
lx_bounded lx_radiance_of_power(double power, const struct lx_shapes *shapes);

/* Reports an area that is too small or too large to be divided by, at the key of the shape. */
void lx_check_area(const struct lx_check *check, const char *key, const struct lx_shapes *shapes);

/* Appends the emitters of the shapes, which it takes over, cut into parts where that is wanted.  0, or -1 when memory
 * ran out. */
int lx_spread_emit(const struct lx_spread *spread, lx_bounded radiance, struct lx_shapes *shapes,
                   struct lx_emitters *emitters);

#endif
