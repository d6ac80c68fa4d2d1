/* SPDX-License-Identifier: MIT */
/*
 * Rows in parallel: each row of a part is done once, in blocks of the promised size, by however many threads there
 * are; threads that cannot be had are done without, and a stop is a stop.
 */
#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <unistd.h>

#include <cmocka.h>

#include "base/rows.h"
#include "wrapped.h"

enum { MOST_ROWS = 90, MOST_THREADS = 7 };

/* How many threads may still be started. */
static unsigned threads_left;

WRAPPED(int, pthread_create, pthread_t *thread, const pthread_attr_t *attributes, void *(*run)(void *), void *argument)
{
    if (threads_left == 0)
        return -1;
    threads_left--;
    return REAL(pthread_create)(thread, attributes, run, argument);
}

struct work {
    struct lx_control control;
    struct lx_rows_part part;
    unsigned threads;
    unsigned stop_after; /* so many rows; 0: never */
    bool meanwhile_is_done;
    atomic_uint wrong;
    atomic_uchar times[MOST_ROWS]; /* each row was done */
};

static void meanwhile(void *data)
{
    struct work *work = data;
    work->meanwhile_is_done = true;
}

static void do_rows(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    struct work *work = data;
    const struct lx_rows_part *part = &work->part;
    bool right = worker < work->threads && is_caller == (worker == 0) && (!is_caller || work->meanwhile_is_done);
    right = right && part->first <= first && first < last && last <= part->last;
    const unsigned tile = part->tile_rows;
    if (tile > 0)
        right = right && (first - part->first) % tile == 0 && (last == first + tile || last == part->last);
    else
        right = right && last - first <= LX_ROWS_AT_ONCE;
    work->wrong += !right;
    for (unsigned row = first; row < last && row < MOST_ROWS; row++)
        work->times[row]++;
    if (work->stop_after > 0 && last - part->first >= work->stop_after)
        work->control.stop = true;
}

static bool run(struct work *work, unsigned first, unsigned rows, unsigned tile_rows)
{
    work->control.rows = first + rows;
    work->part = (struct lx_rows_part){.first = first,
                                       .last = first + rows,
                                       .tile_rows = tile_rows,
                                       .work = do_rows,
                                       .meanwhile = meanwhile,
                                       .data = work};
    return lx_rows_run_part(&work->control, work->threads, &work->part);
}

/* Every number of threads up to the most, of which all but some can be had. */
static void run_all(unsigned first, unsigned rows, unsigned tile_rows, unsigned refused)
{
    for (unsigned threads = 1; threads <= MOST_THREADS; threads++) {
        struct work work = {.threads = threads};
        threads_left = threads - 1 > refused ? threads - 1 - refused : 0;
        assert_true(run(&work, first, rows, tile_rows));
        assert_int_equal(work.wrong, 0);
        assert_int_equal(work.control.rows_done, rows);
        for (unsigned row = 0; row < MOST_ROWS; row++)
            assert_int_equal(work.times[row], first <= row && row < first + rows);
    }
}

static void each_row_once(void **state)
{
    (void)state;
    for (unsigned rows = 1; rows <= MOST_ROWS - 12; rows += 1 + rows / 8)
        for (unsigned first = 0; first <= 12; first += LX_ROWS_AT_ONCE) {
            run_all(first, rows, 0, 0);
            run_all(first, rows, 4, 0);
            run_all(first, rows, 16, 0);
        }
}

static void threads_that_cannot_be_had(void **state)
{
    (void)state;
    for (unsigned refused = 1; refused < MOST_THREADS; refused++) {
        run_all(4, 61, 4, refused);
        run_all(0, 3, 0, refused);
    }
}

/* By one thread nothing comes after the block that stops the work, and the rows come in their order. */
static void stopped(void **state)
{
    struct work work = {.threads = 1, .stop_after = 11};
    (void)state;
    assert_false(run(&work, 0, 80, 4));
    assert_int_equal(work.control.rows_done, 12);
    for (unsigned row = 0; row < MOST_ROWS; row++)
        assert_int_equal(work.times[row], row < 12);
    for (unsigned threads = 2; threads <= MOST_THREADS; threads++) {
        work = (struct work){.threads = threads, .stop_after = 1};
        threads_left = threads;
        assert_false(run(&work, 0, 80, 0));
        /* Each thread may have been at a block. */
        assert_true(work.control.rows_done <= LX_ROWS_AT_ONCE * threads);
    }
}

/* Says to stop, and so late that it would be due again at once. */
static bool stop_at_once(double done, void *data)
{
    unsigned *times = data;
    assert_true(done == 0);
    ++*times;
    usleep(1000);
    return false;
}

/* Who said to stop is not asked again, however many shares of others there are. */
static void stopped_by_progress(void **state)
{
    unsigned times = 0;
    struct work work = {.threads = MOST_THREADS, .control = {.progress = stop_at_once, .data = &times}};
    (void)state;
    threads_left = 0;
    assert_false(run(&work, 0, 80, 0));
    assert_int_equal(times, 1);
    assert_int_equal(work.control.rows_done, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_row_once),
        cmocka_unit_test(threads_that_cannot_be_had),
        cmocka_unit_test(stopped),
        cmocka_unit_test(stopped_by_progress),
    };
    return cmocka_run_group_tests_name("rows", tests, NULL, NULL);
}
