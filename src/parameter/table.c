/* SPDX-License-Identifier: MIT */
/* Questions about a table that more than one room asks. */
#include <string.h>

#include "table.h"

bool lx_is_given(const struct lx_table *table, const void *parameters, const char *name)
{
    const uint64_t given = *(const uint64_t *)parameters;
    for (size_t i = 0; i < table->count; i++)
        if (strcmp(table->parameters[i].name, name) == 0)
            return given >> i & 1;
    return false;
}
