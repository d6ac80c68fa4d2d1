/* SPDX-License-Identifier: MIT */
/* The runner: the newest job is done, reports come in order, and after the end nothing comes. */
#include "../../app/base/runner.h"
#include "scenes.h"

/* What the jobs do and what came back; the thread has its own part of it. */
typedef struct Office {
    AppRunner *runner;
    GArray *reports; /* int, in the main loop */
    int jobs_freed;  /* atomic, as the next ones */
    int reports_freed;
    int is_waiting;   /* whether a job stands at its gate */
    int is_open;      /* the gate */
    gboolean is_gone; /* the state was freed */
} Office;

typedef struct Job {
    Office *office;
    int number;
} Job;

typedef struct Report {
    Office *office;
    int number;
} Report;

static void report(AppRunner *runner, Office *office, int number)
{
    Report *made = g_new(Report, 1);
    *made = (Report){office, number};
    app_runner_report(runner, made);
}

/* Job 0 waits at the gate until it is outdated or let through; 1000 rests; all report their number, and -number. */
static void work(AppRunner *runner, gpointer data, gpointer state)
{
    const Job *job = data;
    Office *office = state;
    if (job->number == 0) {
        g_atomic_int_set(&office->is_waiting, TRUE);
        while (!g_atomic_int_get(&office->is_open) && !app_runner_is_outdated(runner))
            g_usleep(100);
    }
    if (job->number == 1000) {
        g_atomic_int_set(&office->is_waiting, TRUE);
        report(runner, office, app_runner_rest(runner, 100000) ? 1001 : 1002);
        return;
    }
    report(runner, office, job->number);
    report(runner, office, -job->number);
}

static void free_job(gpointer data)
{
    Job *job = data;
    g_atomic_int_inc(&job->office->jobs_freed);
    g_free(job);
}

static void free_report(gpointer data)
{
    Report *made = data;
    g_atomic_int_inc(&made->office->reports_freed);
    g_free(made);
}

static void free_state(gpointer data)
{
    ((Office *)data)->is_gone = TRUE;
}

static void deliver(gpointer made, gpointer owner)
{
    Office *office = owner;
    g_array_append_val(office->reports, ((Report *)made)->number);
}

static const AppRunnerClass class = {"test", work, free_job, free_report, free_state, 0};

static Office *open_office(void)
{
    Office *office = g_new0(Office, 1);
    office->reports = g_array_new(FALSE, FALSE, sizeof(int));
    office->runner = app_runner_new(&class, office, deliver, office);
    return office;
}

static void close_office(Office *office)
{
    g_array_unref(office->reports);
    g_free(office);
}

static void post(Office *office, int number)
{
    Job *job = g_new(Job, 1);
    *job = (Job){office, number};
    app_runner_post(office->runner, job);
}

static gboolean is_waiting(gpointer office)
{
    return g_atomic_int_get(&((Office *)office)->is_waiting);
}

static gboolean is_idle(gpointer office)
{
    return !app_runner_is_busy(((Office *)office)->runner) && !g_main_context_pending(NULL);
}

static void does_the_newest_job(void **state)
{
    (void)state;
    enum { JOBS = 900 };
    Office *office = open_office();
    assert_false(app_runner_is_busy(office->runner));
    for (int i = 1; i <= JOBS; i++)
        post(office, i);
    wait_until(is_idle, office);
    assert_true(office->reports->len >= 2);
    assert_int_equal(office->reports->len % 2, 0);
    int last = 0;
    for (guint i = 0; i < office->reports->len; i += 2) {
        int number = g_array_index(office->reports, int, i);
        assert_true(number > last);
        assert_int_equal(g_array_index(office->reports, int, i + 1), -number);
        last = number;
    }
    assert_int_equal(last, JOBS);
    assert_int_equal(g_atomic_int_get(&office->jobs_freed), JOBS);
    assert_int_equal(office->reports_freed, office->reports->len);
    app_runner_stop(office->runner);
    assert_true(office->is_gone);
    close_office(office);
}

static void tells_the_work_that_it_is_outdated(void **state)
{
    (void)state;
    Office *office = open_office();
    post(office, 0);
    wait_until(is_waiting, office);
    assert_true(app_runner_is_busy(office->runner));
    post(office, 5); /* lets it through */
    wait_until(is_idle, office);
    assert_int_equal(office->reports->len, 4);
    assert_int_equal(g_array_index(office->reports, int, 2), 5);
    app_runner_stop(office->runner);
    close_office(office);
}

static void rests_until_there_is_more(void **state)
{
    (void)state;
    Office *office = open_office();
    post(office, 1000);
    wait_until(is_waiting, office);
    post(office, 7);
    wait_until(is_idle, office);
    assert_int_equal(g_array_index(office->reports, int, 0), 1001);
    app_runner_stop(office->runner);
    close_office(office);
}

/* While a job is at work, one waits, and reports are under way: all are freed, nothing is delivered. */
static void stops_at_any_time(void **state)
{
    (void)state;
    for (int i = 0; i < 200; i++) {
        Office *office = open_office();
        post(office, 3);
        if (i % 3 == 0)
            g_usleep(100);
        post(office, i % 2 ? 0 : 1000);
        if (i % 3 == 1)
            wait_until(is_waiting, office);
        if (i % 5 == 0)
            post(office, 4);
        const guint delivered = office->reports->len;
        const int posted = i % 5 == 0 ? 3 : 2;
        app_runner_stop(office->runner);
        assert_true(office->is_gone);
        assert_int_equal(office->jobs_freed, posted);
        run_for(0);
        while (g_main_context_iteration(NULL, FALSE))
            ;
        assert_int_equal(office->reports->len, delivered);
        close_office(office);
    }
    app_runner_stop(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(does_the_newest_job),
        cmocka_unit_test(tells_the_work_that_it_is_outdated),
        cmocka_unit_test(rests_until_there_is_more),
        cmocka_unit_test(stops_at_any_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
