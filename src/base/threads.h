/* SPDX-License-Identifier: MIT */
/*
 * Threads that begin at once.  A scheduler may leave a new thread on the processor of the one that started it, where it
 * waits until that one sleeps, though another processor is idle: then two threads take as long as one.  So these begin
 * on another processor than their caller's, where the system lets a program say so, and are free to move from then on.
 * More of them than there are processors that they may run on would gain nothing.
 */
#ifndef LX_BASE_THREADS_H
#define LX_BASE_THREADS_H

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>

/* How many processors the calling thread may run on, from 1 on. */
unsigned lx_processor_count(void);

struct lx_thread {
    pthread_t handle;
    void (*run)(void *data);
    void *data;
    int caller_processor; /* which the thread does not begin on; -1: any */
    atomic_bool has_begun;
};

/* Starts a thread that calls run(data); `thread` stays where it is until it has ended.  False: none could be had. */
bool lx_thread_start(struct lx_thread *thread, void (*run)(void *data), void *data);

/* Waits until the thread has ended.  The caller has nothing to do any more: a thread that has not begun until now, as
 * all other processors are busy, gets the caller's. */
void lx_thread_end(struct lx_thread *thread);

#endif
