/* SPDX-License-Identifier: MIT */
/* The tables as a flat list, for help texts, forms and references. */
#ifndef LX_PARAMETER_REFLECT_H
#define LX_PARAMETER_REFLECT_H

#include <luxel/diagnostics.h>
#include <luxel/parameter.h>

#include "table.h"

struct lx_reflected {
    luxel_parameter shown; /* its texts are those below, the reflection's words, or the tables' */
    char *path, *choices;
    luxel_parameter_rule *rules; /* their choices are texts of their own */
};

struct lx_parameter_reflection {
    struct lx_reflected *items;
    size_t count, capacity;
    luxel_parameter_kind *kinds;
    size_t kind_count, kind_capacity;
    char **words; /* what is said in the language of `translate` */
    size_t word_count, word_capacity;
    luxel_translate translate; /* NULL: English */
    void *data;
};

/*
 * Lists all parameters of a table and of those below it, in words of a language (NULL: English).  0, or -1 when
 * memory ran out (the list is then empty).
 */
int lx_reflect(const struct lx_table *table, luxel_translate translate, void *data,
               struct lx_parameter_reflection *reflection);
void lx_reflection_clear(struct lx_parameter_reflection *reflection);

#endif
