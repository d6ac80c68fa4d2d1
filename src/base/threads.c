/* SPDX-License-Identifier: MIT */
/* Processors; starting a thread on another one than its caller's, and waiting for its end. */
#include "threads.h"

#include <errno.h>
#include <unistd.h>

/* Those of the system, for which it reads a file. */
static unsigned processors_online(void)
{
    const long count = sysconf(_SC_NPROCESSORS_ONLN);
    return count > 0 ? (unsigned)count : 1;
}

#ifdef __GLIBC__
#include <sched.h>

unsigned lx_processor_count(void)
{
    cpu_set_t allowed;
    /* more processors than fit in the set are told as an error */
    return sched_getaffinity(0, sizeof allowed, &allowed) == 0 ? (unsigned)CPU_COUNT(&allowed) : processors_online();
}

/* Lets attributes begin a thread on any of the caller's processors but the one that it is on.  False: there are none,
 * or it cannot be told. */
static bool begin_elsewhere(pthread_attr_t *attributes, int *caller_processor)
{
    cpu_set_t others;
    const int here = sched_getcpu();
    if (here < 0 || here >= CPU_SETSIZE || sched_getaffinity(0, sizeof others, &others) != 0)
        return false;
    CPU_CLR((size_t)here, &others);
    *caller_processor = here;
    return CPU_COUNT(&others) > 0 && pthread_attr_setaffinity_np(attributes, sizeof others, &others) == 0;
}

/* Lets the calling thread move to the processor that it was not to begin on. */
static void move_freely(int caller_processor)
{
    cpu_set_t all;
    if (sched_getaffinity(0, sizeof all, &all) != 0)
        return;
    CPU_SET((size_t)caller_processor, &all);
    (void)sched_setaffinity(0, sizeof all, &all);
}

static void come_here(struct lx_thread *thread)
{
    cpu_set_t one;
    const int here = sched_getcpu();
    if (here < 0 || here >= CPU_SETSIZE)
        return;
    CPU_ZERO(&one);
    CPU_SET((size_t)here, &one);
    (void)pthread_setaffinity_np(thread->handle, sizeof one, &one);
}
#else
unsigned lx_processor_count(void)
{
    return processors_online();
}

static bool begin_elsewhere(pthread_attr_t *attributes, int *caller_processor)
{
    (void)attributes;
    (void)caller_processor;
    return false;
}

static void move_freely(int caller_processor)
{
    (void)caller_processor;
}

static void come_here(struct lx_thread *thread)
{
    (void)thread;
}
#endif

static void *run_thread(void *argument)
{
    struct lx_thread *thread = argument;
    atomic_store(&thread->has_begun, true);
    if (thread->caller_processor >= 0)
        move_freely(thread->caller_processor);
    thread->run(thread->data);
    return NULL;
}

bool lx_thread_start(struct lx_thread *thread, void (*run)(void *data), void *data)
{
    pthread_attr_t attributes;
    int status = EINVAL;
    *thread = (struct lx_thread){.run = run, .data = data, .caller_processor = -1};
    if (pthread_attr_init(&attributes) == 0) {
        if (begin_elsewhere(&attributes, &thread->caller_processor))
            status = pthread_create(&thread->handle, &attributes, run_thread, thread);
        pthread_attr_destroy(&attributes);
    }
    if (status != 0 && status != EAGAIN) { /* EAGAIN: no thread at all; else the system forbids to choose processors */
        thread->caller_processor = -1;
        status = pthread_create(&thread->handle, NULL, run_thread, thread);
    }
    return status == 0;
}

void lx_thread_end(struct lx_thread *thread)
{
    if (!atomic_load(&thread->has_begun))
        come_here(thread);
    pthread_join(thread->handle, NULL);
}
