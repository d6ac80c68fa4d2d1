/* SPDX-License-Identifier: MIT */
/* Checked allocation: sizes that overflow fail like memory that ran out. */
#ifndef LX_BASE_MEMORY_H
#define LX_BASE_MEMORY_H

#include <stddef.h>

/* Zeroed memory for count items of size bytes, or NULL. */
void *lx_new_array(size_t count, size_t size);

/* Memory for count items aligned for vector loads (64 bytes), not zeroed, or NULL; free with free(), which is quick
 * even of much of it. */
void *lx_new_aligned(size_t count, size_t size);

/*
 * Makes room for at least `needed` items of `size` bytes in a growing array: `items` is the address of the
 * pointer to it, which is updated with *capacity.  Returns 0, or -1 when memory ran out (the array is then
 * unchanged).
 */
int lx_reserve(void *items, size_t *capacity, size_t needed, size_t size);

/*
 * Memory that something large may take: four fifths of what the system says can be had, so that everybody else
 * finds room too, and no more than the process may; infinite where the system does not tell.
 */
double lx_available_bytes(void);

/* An amount of memory in GB, "1.5"; returns buffer. */
enum { LX_AMOUNT_SIZE = 48 };
char *lx_write_amount(double bytes, char buffer[LX_AMOUNT_SIZE]);

/* A copy of length bytes with a terminating 0, or NULL. */
char *lx_copy_text(const char *text, size_t length);

#endif
