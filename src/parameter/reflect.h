/* SPDX-License-Identifier: MIT */
/* The tables as a flat list, for help texts, forms and references. */
#ifndef LX_PARAMETER_REFLECT_H
#define LX_PARAMETER_REFLECT_H

#include <luxel/parameter.h>

#include "table.h"

struct lx_reflected {
    luxel_parameter shown; /* its texts are those below, or the tables' */
    char *path, *type, *choices, *legal, *advised;
    luxel_rule *rules; /* their choices are texts of their own */
};

struct lx_reflection {
    struct lx_reflected *items;
    size_t count, capacity;
    luxel_kind *kinds; /* their texts are the tables' */
    size_t kind_count, kind_capacity;
};

/* Lists all parameters of a table and of those below it; 0, or -1 when memory ran out (the list is then empty). */
int lx_reflect(const struct lx_table *table, struct lx_reflection *reflection);
void lx_reflection_clear(struct lx_reflection *reflection);

#endif
