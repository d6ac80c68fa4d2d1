/* SPDX-License-Identifier: MIT */
/* Header <sched.h> with what Windows lacks: the processors that this process may use, of the first 64. */
#ifndef LX_WINDOWS_SCHED_H
#define LX_WINDOWS_SCHED_H

#include_next <sched.h>

#include <stdint.h>

typedef struct {
    uintptr_t mask;
} cpu_set_t;

int sched_getaffinity(int process, size_t size, cpu_set_t *set);
#define CPU_COUNT(set) __builtin_popcountll((set)->mask)

#endif
