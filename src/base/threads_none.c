/* SPDX-License-Identifier: MIT */
/* Threads where there are none: one processor, and no thread can be had, so that the caller does all rows itself. */
#include "threads.h"

unsigned lx_processor_count(void)
{
    return 1;
}

bool lx_thread_start(struct lx_thread *thread, void (*run)(void *data), void *data)
{
    (void)thread;
    (void)run;
    (void)data;
    return false;
}

void lx_thread_end(struct lx_thread *thread)
{
    (void)thread;
}
