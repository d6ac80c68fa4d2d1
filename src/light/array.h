/* SPDX-License-Identifier: MIT */
/*
 * Arrays: a light that stands at many places in columns and rows, as luminaires do under a ceiling.  It is one light
 * of its scene, and all its copies shine the same way.  A kind puts a struct lx_array named `array` into its
 * parameters and LX_ARRAY_PARAMETER into its table.
 */
#ifndef LX_LIGHT_ARRAY_H
#define LX_LIGHT_ARRAY_H

#include "light.h"

struct lx_array {
    uint64_t given;
    unsigned n[2];          /* columns, rows */
    double spacing_mm[2];   /* of the columns, of the rows */
    struct lx_vectors axes; /* along which these follow each other; none: x and y */
};

extern const struct lx_table lx_array_table;

#define LX_ARRAY_PARAMETER(type_)                                                                                      \
    {                                                                                                                  \
        .name = "array", .label = "Array", .type = LX_GROUP, .offset = offsetof(type_, array),                         \
        .group = &lx_array_table,                                                                                      \
        .meaning = "copies of the light in columns and rows around where it stands, all shining the same way; they "   \
                   "remain one light of the list",                                                                     \
    }

/* The array of a light; NULL: it stands where it stands. */
const struct lx_array *lx_array_of(const struct lx_item *light);

/* How many places a light has: 1 without an array. */
size_t lx_light_places(const struct lx_item *light);

/* Appends the emitters of a light at all its places, their strength by the scene's maintenance factor and how the light
 * is dimmed; 0, or -1 when memory or room ran out, or the work is to stop. */
int lx_light_lower(const struct lx_item *light, double maintenance, double dimming, struct lx_emitters *emitters);

/* The emitters of one of so many places of a light, of those of all; they stay those of the list. */
struct lx_emitters lx_emitters_of_place(const struct lx_emitters *emitters, size_t places, size_t place);

/* The middle of a light at each of its places, of which there are lx_light_places(); NULL: it comes from everywhere or
 * far away, or memory ran out.  The caller's. */
double (*lx_light_find_places(const struct lx_item *light))[3];

#endif
