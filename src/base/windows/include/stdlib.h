/* SPDX-License-Identifier: MIT */
/*
 * Header <stdlib.h> with what Windows lacks.  Its aligned memory cannot be given back by free(), so all memory of the
 * program comes from one allocator that can align.
 */
#ifndef LX_WINDOWS_STDLIB_H
#define LX_WINDOWS_STDLIB_H

#include_next <stdlib.h>

void *lx_windows_malloc(size_t bytes);
void *lx_windows_calloc(size_t count, size_t bytes);
void *lx_windows_realloc(void *memory, size_t bytes);
void lx_windows_free(void *memory);

/* The alignment is at most a cache line's, whatever is asked for: more is a hint for large pages. */
void *lx_windows_aligned_alloc(size_t alignment, size_t bytes);

/* The whole path with slashes, of what exists; NULL and errno otherwise.  `buffer` must be NULL. */
char *realpath(const char *path, char *buffer);

#define malloc lx_windows_malloc
#define calloc lx_windows_calloc
#define realloc lx_windows_realloc
#define free lx_windows_free
#define aligned_alloc lx_windows_aligned_alloc

#endif
