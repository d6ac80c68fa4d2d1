/* SPDX-License-Identifier: MIT */
/* The threads behind rows in parallel: each takes the next block of rows until none is left. */
#include <pthread.h>
#include <stdlib.h>
#include <unistd.h>

#include "memory.h"
#include "rows.h"

/* Seconds between two reports of progress. */
static const double PAUSE = 0.00025;

/* So many shares of the work for each thread, where a share may be as small as that. */
enum { BLOCKS_PER_THREAD = 4 };

struct job {
    struct lx_control *control;
    const struct lx_rows_part *part;
    unsigned block_rows;
    atomic_uint next;
};

struct worker {
    struct job *job;
    unsigned index;
    pthread_t thread;
};

bool lx_control_goes_on(struct lx_control *control, bool is_caller)
{
    if (is_caller && control->progress) {
        struct timespec now;
        clock_gettime(CLOCK_MONOTONIC, &now);
        double seconds = difftime(now.tv_sec, control->last.tv_sec);
        seconds += (double)(now.tv_nsec - control->last.tv_nsec) * 1e-9;
        if (seconds >= PAUSE) {
            control->last = now;
            if (!control->progress((double)atomic_load(&control->rows_done) / control->rows, control->data))
                atomic_store(&control->stop, true);
        }
    }
    return !atomic_load_explicit(&control->stop, memory_order_relaxed);
}

unsigned lx_thread_count(unsigned wanted, unsigned most)
{
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    unsigned threads = wanted ? wanted : processors > 0 ? (unsigned)processors : 1;
    return threads < most ? threads : most;
}

static void take_rows(struct job *job, unsigned index, bool is_caller)
{
    struct lx_control *control = job->control;
    const struct lx_rows_part *part = job->part;
    while (lx_control_goes_on(control, is_caller)) {
        unsigned first = atomic_fetch_add(&job->next, job->block_rows);
        if (first >= part->last)
            return;
        unsigned last = part->last - first < job->block_rows ? part->last : first + job->block_rows;
        part->work(part->data, index, is_caller, first, last);
        atomic_fetch_add(&control->rows_done, last - first);
    }
}

static void *run_worker(void *argument)
{
    struct worker *worker = argument;
    take_rows(worker->job, worker->index, false);
    return NULL;
}

bool lx_rows_run(struct lx_control *control, unsigned threads, lx_rows_work *work, void *data)
{
    const struct lx_rows_part all = {.last = control->rows, .work = work, .data = data};
    return lx_rows_run_part(control, threads, &all);
}

bool lx_rows_run_part(struct lx_control *control, unsigned threads, const struct lx_rows_part *part)
{
    unsigned share = (part->last - part->first) / threads / BLOCKS_PER_THREAD;
    struct job job = {.control = control, .part = part, .block_rows = LX_ROWS_AT_ONCE, .next = part->first};
    if (!part->in_tiles && share < LX_ROWS_AT_ONCE)
        job.block_rows = share < 1 ? 1 : share;
    unsigned started = 0;
    struct worker *workers = threads > 1 ? lx_new_array(threads - 1, sizeof *workers) : NULL;
    /* A thread that cannot be had is done without: the others take its rows. */
    for (unsigned i = 0; workers && i < threads - 1; i++) {
        workers[started] = (struct worker){.job = &job, .index = started + 1};
        if (pthread_create(&workers[started].thread, NULL, run_worker, &workers[started]) != 0)
            break;
        started++;
    }
    if (part->meanwhile)
        part->meanwhile(part->data);
    take_rows(&job, 0, true);
    for (unsigned i = 0; i < started; i++)
        pthread_join(workers[i].thread, NULL);
    free(workers);
    return !atomic_load(&control->stop);
}
