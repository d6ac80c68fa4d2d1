/* SPDX-License-Identifier: MIT */
/* The thread, its one place for a job, and the way back into the main loop. */
#include "runner.h"

#include <sys/resource.h>

struct AppRunner {
    const AppRunnerClass *class;
    gpointer state, owner;
    AppDeliver deliver;
    GThread *thread;
    GMutex mutex;
    GCond news;
    gpointer waiting; /* the job that is next */
    gboolean is_working, is_stopping;
    int is_outdated; /* atomic, so that asking costs nothing */
    gatomicrefcount references;
};

typedef struct Parcel {
    AppRunner *runner;
    gpointer report;
} Parcel;

static void let_go(AppRunner *self)
{
    if (!g_atomic_ref_count_dec(&self->references))
        return;
    g_mutex_clear(&self->mutex);
    g_cond_clear(&self->news);
    g_free(self);
}

static gpointer next_job(AppRunner *self)
{
    g_mutex_lock(&self->mutex);
    self->is_working = FALSE;
    while (!self->waiting && !self->is_stopping)
        g_cond_wait(&self->news, &self->mutex);
    gpointer job = self->is_stopping ? NULL : g_steal_pointer(&self->waiting);
    self->is_working = job != NULL;
    g_atomic_int_set(&self->is_outdated, self->is_stopping);
    g_mutex_unlock(&self->mutex);
    return job;
}

static gpointer run(gpointer data)
{
    AppRunner *self = data;
    /* on Linux that is the thread's own, and that of the threads that it starts */
    setpriority(PRIO_PROCESS, 0, self->class->nice);
    for (gpointer job; (job = next_job(self));) {
        self->class->work(self, job, self->state);
        self->class->free_job(job);
    }
    return NULL;
}

AppRunner *app_runner_new(const AppRunnerClass *class, gpointer state, AppDeliver deliver, gpointer owner)
{
    AppRunner *self = g_new0(AppRunner, 1);
    self->class = class;
    self->state = state;
    self->deliver = deliver;
    self->owner = owner;
    g_mutex_init(&self->mutex);
    g_cond_init(&self->news);
    g_atomic_ref_count_init(&self->references);
    self->thread = g_thread_new(class->name, run, self);
    return self;
}

void app_runner_stop(AppRunner *self)
{
    if (!self)
        return;
    g_mutex_lock(&self->mutex);
    self->is_stopping = TRUE;
    g_atomic_int_set(&self->is_outdated, TRUE);
    g_cond_broadcast(&self->news);
    g_mutex_unlock(&self->mutex);
    g_thread_join(self->thread);
    if (self->waiting)
        self->class->free_job(self->waiting);
    if (self->class->free_state)
        self->class->free_state(self->state);
    let_go(self);
}

void app_runner_post(AppRunner *self, gpointer job)
{
    g_mutex_lock(&self->mutex);
    gpointer old = self->waiting;
    self->waiting = job;
    g_atomic_int_set(&self->is_outdated, TRUE);
    g_cond_broadcast(&self->news);
    g_mutex_unlock(&self->mutex);
    if (old)
        self->class->free_job(old);
}

gboolean app_runner_is_busy(AppRunner *self)
{
    g_mutex_lock(&self->mutex);
    gboolean busy = self->is_working || self->waiting;
    g_mutex_unlock(&self->mutex);
    return busy;
}

gboolean app_runner_is_outdated(AppRunner *self)
{
    return g_atomic_int_get(&self->is_outdated);
}

gpointer app_runner_take(AppRunner *self, gboolean (*fits)(gconstpointer job, gconstpointer data), gconstpointer data)
{
    gpointer job = NULL;
    g_mutex_lock(&self->mutex);
    if (self->waiting && !self->is_stopping && fits(self->waiting, data)) {
        job = g_steal_pointer(&self->waiting);
        g_atomic_int_set(&self->is_outdated, FALSE);
    }
    g_mutex_unlock(&self->mutex);
    return job;
}

gboolean app_runner_rest(AppRunner *self, guint milliseconds)
{
    gint64 until = g_get_monotonic_time() + (gint64)milliseconds * 1000;
    g_mutex_lock(&self->mutex);
    while (!self->waiting && !self->is_stopping && g_cond_wait_until(&self->news, &self->mutex, until))
        ;
    gboolean outdated = self->waiting || self->is_stopping;
    g_mutex_unlock(&self->mutex);
    return outdated;
}

/* ---- back in the main loop ---- */

static gboolean unpack(gpointer data)
{
    Parcel *parcel = data;
    /* only the main loop stops a runner, so that it cannot happen meanwhile */
    if (!parcel->runner->is_stopping)
        parcel->runner->deliver(parcel->report, parcel->runner->owner);
    return G_SOURCE_REMOVE;
}

static void free_parcel(gpointer data)
{
    Parcel *parcel = data;
    parcel->runner->class->free_report(parcel->report);
    let_go(parcel->runner);
    g_free(parcel);
}

void app_runner_report(AppRunner *self, gpointer report)
{
    Parcel *parcel = g_new(Parcel, 1);
    *parcel = (Parcel){self, report};
    g_atomic_ref_count_inc(&self->references);
    g_idle_add_full(G_PRIORITY_DEFAULT, unpack, parcel, free_parcel);
}
