/* SPDX-License-Identifier: MIT */
/* The table of what instruction sets have for elements, in the order of the kernels' own table (kernel/dispatch.c). */
#include "kernel_elements.h"

#define DECLARE(set) extern const struct lx_element_kernels lx_element_kernels_##set;
LX_KERNEL_SETS(DECLARE)

#define ELEMENT_KERNELS(set) &lx_element_kernels_##set,
static const struct lx_element_kernels *const sets[] = {LX_KERNEL_SETS(ELEMENT_KERNELS)};

const struct lx_element_kernels *lx_element_kernels_of(const struct lx_kernels *kernels)
{
    size_t i = 0;
    while (lx_kernels_get(i) != kernels)
        i++;
    return sets[i];
}
