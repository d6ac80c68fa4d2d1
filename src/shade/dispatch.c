/* SPDX-License-Identifier: MIT */
/* The table of instruction sets and the choice among them. */
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "kernel.h"
#include "kernel_elements.h"

/* The build defines LX_KERNEL_SETS(SET) as the list of the sets that it makes, the best first. */
#define DECLARE(set)                                                                                                   \
    extern const struct lx_kernels lx_kernels_##set;                                                                   \
    extern const struct lx_element_kernels lx_element_kernels_##set;
LX_KERNEL_SETS(DECLARE)

#define KERNELS(set) &lx_kernels_##set,
static const struct lx_kernels *const sets[] = {LX_KERNEL_SETS(KERNELS)};

/* In the same order. */
#define ELEMENT_KERNELS(set) &lx_element_kernels_##set,
static const struct lx_element_kernels *const of_elements[] = {LX_KERNEL_SETS(ELEMENT_KERNELS)};

const struct lx_kernels *lx_kernels_get(size_t i)
{
    return i < sizeof sets / sizeof sets[0] ? sets[i] : NULL;
}

const struct lx_element_kernels *lx_element_kernels_of(const struct lx_kernels *kernels)
{
    size_t i = 0;
    while (sets[i] != kernels)
        i++;
    return of_elements[i];
}

/* "x86-64-v3" is also known as "v3" and "-v3"; the last set, which runs everywhere, as "generic". */
static bool is_called(size_t i, const char *name)
{
    const char *level = strrchr(sets[i]->name, '-');
    return strcasecmp(sets[i]->name, name) == 0 || (!lx_kernels_get(i + 1) && strcasecmp(name, "generic") == 0) ||
           (level && level[1] == 'v' && (strcasecmp(level, name) == 0 || strcasecmp(level + 1, name) == 0));
}

const struct lx_kernels *lx_kernels_choose(const char *name)
{
    if (!name)
        name = getenv("LUXEL_ISA");
    for (size_t i = 0; lx_kernels_get(i); i++)
        if (lx_kernels_get(i)->runs() && (!name || !*name || is_called(i, name)))
            return lx_kernels_get(i);
    return NULL;
}
