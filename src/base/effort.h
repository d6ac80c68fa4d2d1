/* SPDX-License-Identifier: MIT */
/*
 * Effort: how much work something may take.  It is counted by what is done, in units of a tenth of a microsecond or so,
 * and never by the clock, so that what comes of it is the same for any number of threads and on any machine; unless
 * somebody says that it is over.
 */
#ifndef LX_BASE_EFFORT_H
#define LX_BASE_EFFORT_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>

struct lx_effort {
    size_t done, most;
    const atomic_bool *over; /* nothing is left once this is set; NULL: never */
};

static inline bool lx_effort_is_left(const struct lx_effort *effort)
{
    return !effort ||
           (effort->done < effort->most && !(effort->over && atomic_load_explicit(effort->over, memory_order_relaxed)));
}

/* Adds units; false: none is left.  NULL: nothing is counted. */
static inline bool lx_effort_take(struct lx_effort *effort, size_t units)
{
    if (effort)
        effort->done += units;
    return lx_effort_is_left(effort);
}

#endif
