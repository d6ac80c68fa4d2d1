/* SPDX-License-Identifier: MIT */
/*
 * Rows in parallel: blocks of rows are handed to threads, which come and go with the call.  Each row's result
 * must depend on the row alone; then it is the same for any number of threads.
 */
#ifndef LX_BASE_ROWS_H
#define LX_BASE_ROWS_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>

#include "effort.h"

/* Progress and cancelling of one piece of work.  Only the calling thread reports. */
struct lx_control {
    atomic_bool stop;
    atomic_uint rows_done;
    unsigned rows;                             /* of the whole work, which may be done in parts */
    bool (*progress)(double done, void *data); /* NULL: none; false stops the work */
    void *data;
    double before;                /* share of the whole work that was done beside the rows; the calling thread's own */
    double last;                  /* when progress was last reported, by lx_seconds() */
    struct lx_patience *patience; /* NULL: with no end */
};

/* How long somebody waits for the best of a work that can end with what there is. */
struct lx_patience {
    double until;                                /* seconds of the monotonic clock; infinite: no end */
    bool (*is_enough)(double bound, void *data); /* with the control's data; NULL: nobody is asked */
    double bound;                                /* of the error, that is reached so far; infinite: none */
    bool stops;                                  /* then the work stops; else no effort is left for it */
    atomic_bool is_over;
};

/* Seconds of the monotonic clock. */
double lx_seconds(void);

/*
 * Whether the work goes on.  To be asked often, every tenth of a millisecond or so; `is_caller` tells the calling
 * thread, which then reports progress about 4000 times a second: the work is to end within a millisecond of the wish.
 */
bool lx_control_goes_on(struct lx_control *control, bool is_caller);

/* Who asks.  NULL, or a control of NULL: nobody, and the work always goes on, as long as there is effort for it. */
struct lx_asking {
    struct lx_control *control;
    bool is_caller;
    struct lx_effort *effort; /* that each question counts as; NULL: nothing is counted */
};

/* The effort of what is done between two questions, about. */
enum { LX_QUESTION_EFFORT = 20 };

static inline bool lx_asking_goes_on(const struct lx_asking *asking)
{
    return !asking || (lx_effort_take(asking->effort, LX_QUESTION_EFFORT) &&
                       (!asking->control || lx_control_goes_on(asking->control, asking->is_caller)));
}

/* Whether step i of a loop goes on, which asks at every so many-th step, the first among them. */
static inline bool lx_asking_at_step(const struct lx_asking *asking, size_t i, size_t every)
{
    return i % every != 0 || lx_asking_goes_on(asking);
}

/* At most so many rows are handed out at once: few enough to share the work evenly and to notice a stop, enough not to
 * fight for the counter. */
enum { LX_ROWS_AT_ONCE = 4 };

/* Does rows first to last - 1 with the worker's own memory; `is_caller` as above. */
typedef void lx_rows_work(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last);

/* How many threads to take: as many as wanted (0: one for each processor that the caller may run on), but no more than
 * there is work for. */
unsigned lx_thread_count(unsigned wanted, unsigned most);

/* Does control->rows rows with up to `threads` threads, the calling one among them.  False: it was stopped. */
bool lx_rows_run(struct lx_control *control, unsigned threads, lx_rows_work *work, void *data);

/* Rows first to last - 1 of a work that is done in parts. */
struct lx_rows_part {
    unsigned first, last;
    unsigned tile_rows; /* so many are handed out together, from `first` on; 0: as it suits */
    bool counts_itself; /* the work adds to the control's rows_done itself, whose rows are not these */
    lx_rows_work *work;
    void (*meanwhile)(void *data); /* what the calling thread does before it takes rows itself; NULL: nothing */
    void *data;                    /* handed to both */
};

/* Does a part as lx_rows_run() does the whole. */
bool lx_rows_run_part(struct lx_control *control, unsigned threads, const struct lx_rows_part *part);

#endif
