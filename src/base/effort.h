/* SPDX-License-Identifier: MIT */
/*
 * Effort: how much work something may take.  It is counted by what is done, in units of a tenth of a microsecond or so,
 * and never by the clock, so that what comes of it is the same for any number of threads and on any machine.
 */
#ifndef LX_BASE_EFFORT_H
#define LX_BASE_EFFORT_H

#include <stdbool.h>
#include <stddef.h>

struct lx_effort {
    size_t done, most;
};

static inline bool lx_effort_is_left(const struct lx_effort *effort)
{
    return !effort || effort->done < effort->most;
}

/* Adds units; false: none is left.  NULL: nothing is counted. */
static inline bool lx_effort_take(struct lx_effort *effort, size_t units)
{
    if (effort)
        effort->done += units;
    return lx_effort_is_left(effort);
}

#endif
