/* SPDX-License-Identifier: MIT */
/* The table of instruction sets and the choice among them. */
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "kernel.h"

/* The build defines LX_KERNEL_SETS(SET) as the list of the sets that it makes, the best first. */
#define DECLARE(set) extern const struct lx_kernels lx_kernels_##set;
LX_KERNEL_SETS(DECLARE)

#define KERNELS(set) &lx_kernels_##set,
static const struct lx_kernels *const sets[] = {LX_KERNEL_SETS(KERNELS)};

const struct lx_kernels *lx_kernels_get(size_t i)
{
    return i < sizeof sets / sizeof sets[0] ? sets[i] : NULL;
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
