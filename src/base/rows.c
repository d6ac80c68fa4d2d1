/* SPDX-License-Identifier: MIT */
/*
 * The threads behind rows in parallel.  Each has a share of neighbouring rows, which it takes block by block, and then
 * helps with the shares of others: so the rows of one picture after another stay in the cache of the same processor.
 */
#include <stdlib.h>
#include <time.h>

#include "memory.h"
#include "rows.h"
#include "threads.h"

/* Seconds between two reports of progress. */
static const double PAUSE = 0.00025;

/* A share has at least so many blocks, where a block may be as small as that. */
enum { BLOCKS_PER_SHARE = 4 };

struct worker {
    struct job *job;
    unsigned index;
    struct lx_thread thread; /* of all but the first worker, which is the calling thread */
    atomic_uint next;        /* rows of its share that no thread has taken */
    unsigned last;
};

struct job {
    struct lx_control *control;
    const struct lx_rows_part *part;
    unsigned block_rows;
    struct worker *workers;
    unsigned worker_count;
};

double lx_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

static void look_at_patience(const struct lx_control *control, double now)
{
    struct lx_patience *patience = control->patience;
    if (now >= patience->until || (patience->is_enough && patience->is_enough(patience->bound, control->data)))
        atomic_store(&patience->is_over, true);
}

bool lx_control_goes_on(struct lx_control *control, bool is_caller)
{
    if (is_caller && (control->progress || control->patience)) {
        const double now = lx_seconds();
        if (now - control->last >= PAUSE) {
            control->last = now;
            const double rows = (double)atomic_load(&control->rows_done) / control->rows;
            if (control->progress && !control->progress(control->before + (1 - control->before) * rows, control->data))
                atomic_store(&control->stop, true);
            if (control->patience)
                look_at_patience(control, now);
        }
    }
    const struct lx_patience *patience = control->patience;
    if (patience && patience->stops && atomic_load_explicit(&patience->is_over, memory_order_relaxed))
        return false;
    return !atomic_load_explicit(&control->stop, memory_order_relaxed);
}

unsigned lx_thread_count(unsigned wanted, unsigned most)
{
    if (most <= 1)
        return most; /* the system need not be asked */
    const unsigned threads = wanted ? wanted : lx_processor_count();
    return threads < most ? threads : most;
}

/* Takes what is left of a share, whosever it is.  False: the work was stopped. */
static bool take_share(const struct worker *worker, struct worker *share)
{
    const struct job *job = worker->job;
    const struct lx_rows_part *part = job->part;
    const bool is_caller = worker->index == 0;
    while (lx_control_goes_on(job->control, is_caller)) {
        unsigned first = atomic_fetch_add(&share->next, job->block_rows);
        if (first >= share->last)
            return true;
        unsigned last = share->last - first < job->block_rows ? share->last : first + job->block_rows;
        part->work(part->data, worker->index, is_caller, first, last);
        if (!part->counts_itself)
            atomic_fetch_add(&job->control->rows_done, last - first);
    }
    return false;
}

static void run_worker(void *argument)
{
    const struct worker *worker = argument;
    const struct job *job = worker->job;
    bool goes_on = true;
    for (unsigned i = 0; goes_on && i < job->worker_count; i++)
        goes_on = take_share(worker, &job->workers[(worker->index + i) % job->worker_count]);
}

/* Divides the rows evenly, in whole blocks. */
static void share_out(struct job *job)
{
    const struct lx_rows_part *part = job->part;
    const unsigned rows = part->last - part->first;
    const unsigned fair = rows / job->worker_count / BLOCKS_PER_SHARE;
    job->block_rows = fair >= LX_ROWS_AT_ONCE ? LX_ROWS_AT_ONCE : fair < 1 ? 1 : fair;
    if (part->tile_rows > 0)
        job->block_rows = part->tile_rows;
    const unsigned blocks = (rows + job->block_rows - 1) / job->block_rows;
    unsigned next = part->first;
    for (unsigned i = 0; i < job->worker_count; i++) {
        struct worker *worker = &job->workers[i];
        const size_t end = (size_t)blocks * (i + 1) / job->worker_count * job->block_rows;
        *worker = (struct worker){.job = job, .index = i, .last = part->first + (unsigned)(end < rows ? end : rows)};
        atomic_init(&worker->next, next);
        next = worker->last;
    }
}

bool lx_rows_run(struct lx_control *control, unsigned threads, lx_rows_work *work, void *data)
{
    const struct lx_rows_part all = {.last = control->rows, .work = work, .data = data};
    return lx_rows_run_part(control, threads, &all);
}

bool lx_rows_run_part(struct lx_control *control, unsigned threads, const struct lx_rows_part *part)
{
    struct worker alone;
    struct worker *workers = threads > 1 ? lx_new_array(threads, sizeof *workers) : NULL;
    struct job job = {
        .control = control, .part = part, .workers = workers ? workers : &alone, .worker_count = workers ? threads : 1};
    share_out(&job);
    unsigned running = 1;
    /* A thread that cannot be had is done without: the others take its rows. */
    while (running < job.worker_count && lx_thread_start(&workers[running].thread, run_worker, &workers[running]))
        running++;
    if (part->meanwhile)
        part->meanwhile(part->data);
    run_worker(&job.workers[0]);
    for (unsigned i = 1; i < running; i++)
        lx_thread_end(&workers[i].thread);
    free(workers);
    return lx_control_goes_on(control, false);
}
