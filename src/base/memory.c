/* SPDX-License-Identifier: MIT */
/* Checked allocation: every size is multiplied with care, and memory that ran out is an answer, not an end. */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include "memory.h"
#include "number.h"

enum { ALIGNMENT = 64, FIRST_CAPACITY = 8 };

/* Much memory is had in large pages where the system has them: a thousand times as many small ones take milliseconds to
 * give back, for which a front end that has cancelled its work would wait. */
enum { LARGE_PAGE = 2 << 20, MUCH = 4 << 20 };

void *lx_new_array(size_t count, size_t size)
{
    return calloc(count ? count : 1, size ? size : 1);
}

void *lx_new_aligned(size_t count, size_t size)
{
    size_t bytes;
    if (__builtin_mul_overflow(count, size, &bytes) || bytes > SIZE_MAX - LARGE_PAGE)
        return NULL;
    /* aligned_alloc wants a multiple of the alignment */
    const size_t alignment = bytes < MUCH ? ALIGNMENT : LARGE_PAGE;
    bytes = (bytes + alignment - 1) / alignment * alignment;
    void *memory = aligned_alloc(alignment, bytes ? bytes : alignment);
#ifdef MADV_HUGEPAGE
    if (memory && bytes >= MUCH)
        (void)madvise(memory, bytes, MADV_HUGEPAGE); /* a hint: without it all works as well */
#endif
    return memory;
}

int lx_reserve(void *items, size_t *capacity, size_t needed, size_t size)
{
    if (needed <= *capacity)
        return 0;
    size_t wanted = *capacity > SIZE_MAX / 2 ? needed : 2 * *capacity;
    if (wanted < needed)
        wanted = needed;
    if (wanted < FIRST_CAPACITY)
        wanted = FIRST_CAPACITY;
    size_t bytes;
    if (__builtin_mul_overflow(wanted, size, &bytes))
        return -1;
    /* The pointer is of the caller's type: it is copied as bytes, so that no two types meet in one object. */
    void *array;
    memcpy(&array, items, sizeof array);
    array = realloc(array, bytes);
    if (!array)
        return -1;
    memcpy(items, &array, sizeof array);
    *capacity = wanted;
    return 0;
}

char *lx_copy_text(const char *text, size_t length)
{
    if (length == SIZE_MAX)
        return NULL;
    char *copy = malloc(length + 1);
    if (copy) {
        if (length)
            memcpy(copy, text, length);
        copy[length] = 0;
    }
    return copy;
}

double lx_available_bytes(void)
{
    struct rlimit limit;
    double available = HUGE_VAL, kilobytes;
    char line[128];
    FILE *file = fopen("/proc/meminfo", "re");
    while (file && fgets(line, sizeof line, file))
        if (sscanf(line, "MemAvailable: %lf kB", &kilobytes) == 1)
            available = kilobytes * 1024 * 0.8;
    if (file)
        fclose(file);
    bool is_limited = getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
    return is_limited ? fmin(available, (double)limit.rlim_cur) : available;
}

char *lx_write_amount(double bytes, char buffer[LX_AMOUNT_SIZE])
{
    return lx_write_digits(bytes / 1e9, 3, buffer);
}
