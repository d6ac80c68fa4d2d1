/* SPDX-License-Identifier: MIT */
/* Header <malloc.h> with what Windows lacks: hints for the allocator, which its own does not need. */
#ifndef LX_WINDOWS_MALLOC_H
#define LX_WINDOWS_MALLOC_H

#include_next <malloc.h>

#define mallopt(what, value) ((void)0)

#endif
