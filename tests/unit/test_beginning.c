/* SPDX-License-Identifier: MIT */
/*
 * Threads begin on another processor than their caller's, may move to all of them from then on, and begin all the same
 * where there is no other one, or where that cannot be asked for.
 */
#include <errno.h>
#include <pthread.h>
#include <sched.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/rows.h"
#include "base/threads.h"
#include "wrapped.h"

/* What was asked of the system: how often for a thread, and how many processors it may begin on (0: any). */
static int started, allowed[2];
static int refusal; /* of attributes: an error, or 0 */
static bool refuses_all;
static int called_here; /* how often a thread was sent to a single processor */

WRAPPED(int, pthread_create, pthread_t *thread, const pthread_attr_t *attributes, void *(*run)(void *), void *argument)
{
    cpu_set_t set;
    CPU_ZERO(&set);
    if (attributes)
        assert_int_equal(pthread_attr_getaffinity_np(attributes, sizeof set, &set), 0);
    assert_true(started < 2);
    allowed[started++] = CPU_COUNT(&set);
    if (refuses_all)
        return EAGAIN;
    if (refusal != 0 && attributes)
        return refusal;
    return REAL(pthread_create)(thread, attributes, run, argument);
}

WRAPPED(int, pthread_setaffinity_np, pthread_t thread, size_t size, const cpu_set_t *set)
{
    called_here += CPU_COUNT(set) == 1;
    return REAL(pthread_setaffinity_np)(thread, size, set);
}

static cpu_set_t processors(void)
{
    cpu_set_t set;
    assert_int_equal(sched_getaffinity(0, sizeof set, &set), 0);
    return set;
}

/* Leaves the set of processors that it may run on. */
static void look_round(void *data)
{
    cpu_set_t *seen = data;
    *seen = processors();
}

static void run_one(void)
{
    struct lx_thread thread;
    cpu_set_t seen;
    const cpu_set_t all = processors();
    started = called_here = 0;
    assert_true(lx_thread_start(&thread, look_round, &seen));
    while (!atomic_load(&thread.has_begun))
        sched_yield();
    lx_thread_end(&thread);
    assert_true(CPU_EQUAL(&seen, &all));
    assert_int_equal(called_here, 0);
}

static void elsewhere(void **state)
{
    const cpu_set_t all = processors();
    (void)state;
    run_one();
    assert_int_equal(started, 1);
    assert_int_equal(allowed[0], CPU_COUNT(&all) - 1);
}

static void by_one_processor(void **state)
{
    const cpu_set_t all = processors();
    const int here = sched_getcpu();
    cpu_set_t one;
    (void)state;
    CPU_ZERO(&one);
    CPU_SET((size_t)here, &one);
    assert_int_equal(lx_processor_count(), CPU_COUNT(&all));
    if (sched_setaffinity(0, sizeof one, &one) != 0)
        skip();
    assert_int_equal(lx_processor_count(), 1); /* whatever the machine has */
    assert_int_equal(lx_thread_count(0, 1024), 1);
    assert_int_equal(lx_thread_count(3, 1024), 3);
    run_one();
    assert_int_equal(started, 1);
    assert_int_equal(allowed[0], 0);
    assert_int_equal(sched_setaffinity(0, sizeof all, &all), 0);
}

static void refused(void **state)
{
    const cpu_set_t all = processors();
    (void)state;
    const int refusals[] = {EINVAL, EPERM, ENOSYS};
    for (int i = 0; i < 3; i++) {
        refusal = refusals[i];
        run_one();
        assert_int_equal(started, CPU_COUNT(&all) > 1 ? 2 : 1);
        assert_int_equal(allowed[started - 1], 0);
    }
    refusal = 0;

    struct lx_thread thread;
    started = 0;
    refuses_all = true;
    assert_false(lx_thread_start(&thread, look_round, NULL));
    assert_int_equal(started, 1);
    refuses_all = false;
}

/* A caller that has nothing to do gives its processor to a thread that waits for another one. */
static void not_begun(void **state)
{
    struct lx_thread thread;
    cpu_set_t seen;
    (void)state;
    started = called_here = 0;
    assert_true(lx_thread_start(&thread, look_round, &seen));
    while (!atomic_load(&thread.has_begun))
        sched_yield();
    atomic_store(&thread.has_begun, false);
    lx_thread_end(&thread);
    assert_int_equal(called_here, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(elsewhere),
        cmocka_unit_test(by_one_processor),
        cmocka_unit_test(refused),
        cmocka_unit_test(not_begun),
    };
    return cmocka_run_group_tests_name("beginning", tests, NULL, NULL);
}
