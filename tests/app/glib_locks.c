/* SPDX-License-Identifier: MIT */
/*
 * What the thread sanitizer must be told of GLib, whose locks, counts of users and main loop it cannot see into: these
 * functions stand before GLib's own of the same names, and say which of them hand memory from thread to thread.  Built
 * into the tests of the app where that sanitizer is, and itself without it.
 */
#include <dlfcn.h>
#include <glib.h>
#include <stdlib.h>

/* The sanitizer's own: all that was done before a release is seen behind an acquire of the same address. */
void __tsan_acquire(void *address);
void __tsan_release(void *address);

/* GLib's function of a name. */
#define GLIB(function) ((__typeof__(&(function)))dlsym(RTLD_NEXT, #function))

void g_mutex_lock(GMutex *mutex)
{
    GLIB(g_mutex_lock)(mutex);
    __tsan_acquire(mutex);
}

void g_mutex_unlock(GMutex *mutex)
{
    __tsan_release(mutex);
    GLIB(g_mutex_unlock)(mutex);
}

void g_cond_wait(GCond *condition, GMutex *mutex)
{
    __tsan_release(mutex);
    GLIB(g_cond_wait)(condition, mutex);
    __tsan_acquire(mutex);
}

gboolean g_cond_wait_until(GCond *condition, GMutex *mutex, gint64 end)
{
    __tsan_release(mutex);
    gboolean signalled = GLIB(g_cond_wait_until)(condition, mutex, end);
    __tsan_acquire(mutex);
    return signalled;
}

/* What GLib frees for itself is not watched (tests/races.txt); what the app frees is, since it is freed from here. */
void(g_free)(gpointer memory)
{
    free(memory);
}

/* ---- counts of users: who comes last sees what the others did ---- */

gboolean g_atomic_ref_count_dec(gatomicrefcount *count)
{
    __tsan_release(count);
    gboolean is_last = GLIB(g_atomic_ref_count_dec)(count);
    __tsan_acquire(count);
    return is_last;
}

/* `clear` is called within GLib's function, and may release others; one at a time, so that it acquires what all did. */
void g_atomic_rc_box_release_full(gpointer box, GDestroyNotify clear)
{
    static GMutex one_at_a_time;
    static _Thread_local unsigned depth;
    if (depth++ == 0)
        GLIB(g_mutex_lock)(&one_at_a_time);
    __tsan_acquire(box);
    __tsan_release(box);
    GLIB(g_atomic_rc_box_release_full)(box, clear);
    if (--depth == 0)
        GLIB(g_mutex_unlock)(&one_at_a_time);
}

/* ---- what is handed to the main loop ---- */

typedef struct Handed {
    GSourceFunc function;
    gpointer data;
    GDestroyNotify notify;
} Handed;

static GMutex handing; /* held until what GLib itself made for it is told of, too */

static gboolean take(gpointer data)
{
    Handed *handed = data;
    GLIB(g_mutex_lock)(&handing);
    GLIB(g_mutex_unlock)(&handing);
    __tsan_acquire(handed);
    return handed->function(handed->data);
}

static void drop(gpointer data)
{
    Handed *handed = data;
    __tsan_acquire(handed);
    if (handed->notify)
        handed->notify(handed->data);
    g_free(handed);
}

guint g_idle_add_full(gint priority, GSourceFunc function, gpointer data, GDestroyNotify notify)
{
    Handed *handed = g_new(Handed, 1);
    *handed = (Handed){function, data, notify};
    GLIB(g_mutex_lock)(&handing);
    guint id = GLIB(g_idle_add_full)(priority, take, handed, drop);
    __tsan_release(handed);
    GLIB(g_mutex_unlock)(&handing);
    return id;
}
