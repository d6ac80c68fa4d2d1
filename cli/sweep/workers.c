/* SPDX-License-Identifier: MIT */
/*
 * Threads that take one missing shard after the other, progress meanwhile, and the end by Ctrl-C: the scenes that are
 * being computed are finished, whole shards stay, and what was begun is cleared away.
 */
#include <malloc.h>
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "../cli.h"
#include "../clock.h"
#include "../json.h"
#include "../message.h"
#include "../text.h"
#include "sweep.h"

/* The shards to do, and whoever does them. */
struct crew {
    struct sweep *sweep;
    const struct sweep_run *how;
    uint64_t *missing;
    size_t count;
    atomic_size_t next;
    atomic_uint busy;
    pthread_cond_t ended;
    uint64_t scenes; /* to be computed */
    double start_s;
    int code;
};

static volatile sig_atomic_t is_interrupted;

/* The second time at once. */
static void on_interrupt(int signal_number)
{
    (void)signal_number;
    if (is_interrupted)
        _exit(EXIT_INTERRUPTED);
    is_interrupted = 1;
}

/* ---- saying how far it is ---- */

static double rate_of(const struct crew *crew)
{
    const double seconds = clock_seconds() - crew->start_s;

    return seconds > 0.0 ? (double)atomic_load(&crew->sweep->done) / seconds : 0.0;
}

/* A line for machines, at each shard. */
static void tell_shard(const struct crew *crew, uint64_t shard)
{
    struct json json = {.stream = stdout};

    json_open(&json, NULL, '{');
    json_text(&json, "event", "shard");
    json_whole(&json, "shard", shard);
    json_whole(&json, "done", atomic_load(&crew->sweep->done));
    json_whole(&json, "of", crew->scenes);
    json_number(&json, "scenes_per_second", rate_of(crew));
    json_close(&json, '}');
    fflush(stdout);
}

static void tell_terminal(const struct crew *crew)
{
    const double done = (double)atomic_load(&crew->sweep->done), rate = rate_of(crew);
    const double left_s = rate > 0.0 ? ((double)crew->scenes - done) / rate : 0.0;

    fputc('\r', stderr);
    fprintf(stderr, _("%3.0f %%, %.0f scenes/s, %.0f s left"), 100.0 * done / (double)crew->scenes, rate, ceil(left_s));
    fputs("\033[K", stderr);
}

static bool may_tell_terminal(const struct sweep_run *how)
{
    const char *terminal = getenv("TERM");

    return !how->quiet && !how->json && terminal && strcmp(terminal, "dumb") != 0 && isatty(STDERR_FILENO);
}

/* ---- working ---- */

static void *work(void *data)
{
    struct crew *crew = data;
    struct sweep_worker worker;
    int code = sweep_worker_init(&worker, crew->sweep);

    while (code == EXIT_DONE && !atomic_load(&crew->sweep->stop)) {
        const size_t next = atomic_fetch_add(&crew->next, 1);

        if (next >= crew->count)
            break;
        code = sweep_shard(&worker, crew->missing[next]);
        if (code == EXIT_DONE && crew->how->json && !atomic_load(&crew->sweep->stop)) {
            pthread_mutex_lock(&crew->sweep->mutex);
            tell_shard(crew, crew->missing[next]);
            pthread_mutex_unlock(&crew->sweep->mutex);
        }
    }
    sweep_worker_clear(&worker);
    pthread_mutex_lock(&crew->sweep->mutex);
    if (code != EXIT_DONE && crew->code == EXIT_DONE)
        crew->code = code;
    if (code != EXIT_DONE)
        atomic_store(&crew->sweep->stop, true);
    atomic_fetch_sub(&crew->busy, 1);
    pthread_cond_signal(&crew->ended);
    pthread_mutex_unlock(&crew->sweep->mutex);
    return NULL;
}

/* Waits for all threads, and looks at what happens ten times a second. */
static void watch(struct crew *crew)
{
    const bool tells = may_tell_terminal(crew->how);
    bool has_told = false;

    pthread_mutex_lock(&crew->sweep->mutex);
    while (atomic_load(&crew->busy) > 0) {
        struct timespec until;

        clock_gettime(CLOCK_REALTIME, &until);
        until.tv_nsec += 100000000;
        if (until.tv_nsec >= 1000000000) {
            until.tv_sec++;
            until.tv_nsec -= 1000000000;
        }
        pthread_cond_timedwait(&crew->ended, &crew->sweep->mutex, &until);
        if (is_interrupted)
            atomic_store(&crew->sweep->stop, true);
        if (tells && clock_seconds() - crew->start_s > 1.0) {
            tell_terminal(crew);
            has_told = true;
        }
    }
    pthread_mutex_unlock(&crew->sweep->mutex);
    if (has_told)
        fputs("\r\033[K", stderr);
}

/* The missing shards of this part: those whose number is the part's, modulo the number of parts. */
static void find_missing(struct crew *crew)
{
    const struct sweep *sweep = crew->sweep;

    crew->missing = message_allocate((size_t)sweep->shards, sizeof *crew->missing);
    for (uint64_t shard = sweep->folder.part; shard < sweep->shards; shard += sweep->folder.parts) {
        if (sweep_has(sweep, shard))
            continue;
        folder_retract(&crew->sweep->folder, shard);
        crew->missing[crew->count++] = shard;
        crew->scenes += sweep_scenes_of(sweep, shard);
    }
}

/* A disk that cannot hold it is told before the work. */
static int check_room(const struct crew *crew)
{
    const uint64_t there = folder_free_bytes(&crew->sweep->folder);
    uint64_t needed = 0;

    for (size_t i = 0; i < crew->count; i++)
        needed += sweep_bytes_of(crew->sweep, sweep_scenes_of(crew->sweep, crew->missing[i]));
    if (needed <= there)
        return EXIT_DONE;
    message_error(_("%s has no room: what is missing takes %.1f MB, and %.1f MB are free"), crew->sweep->folder.path,
                  (double)needed * 1e-6, (double)there * 1e-6);
    message_hint(_("float16 halves the pictures; what is done is kept"));
    return EXIT_FILE;
}

static void start(struct crew *crew)
{
    const unsigned most = crew->count < crew->how->workers ? (unsigned)crew->count : crew->how->workers;
    pthread_t *threads = message_allocate(most, sizeof *threads);
    unsigned started = 0;

    crew->start_s = clock_seconds();
    for (; started < most; started++) {
        atomic_fetch_add(&crew->busy, 1);
        if (pthread_create(&threads[started], NULL, work, crew) != 0) {
            atomic_fetch_sub(&crew->busy, 1);
            break;
        }
    }
    if (started == 0) { /* no thread can be had: then by itself */
        atomic_fetch_add(&crew->busy, 1);
        work(crew);
    }
    watch(crew);
    for (unsigned i = 0; i < started; i++)
        pthread_join(threads[i], NULL);
    free(threads);
}

static void tell_end(const struct crew *crew, uint64_t whole)
{
    const struct sweep *sweep = crew->sweep;
    const unsigned long long done = atomic_load(&sweep->done);

    if (crew->how->json) {
        struct json json = {.stream = stdout};

        json_open(&json, NULL, '{');
        json_text(&json, "event", "end");
        json_whole(&json, "done", done);
        json_whole(&json, "of", crew->scenes);
        json_whole(&json, "shards_whole", whole);
        json_whole(&json, "shards", sweep->shards);
        json_number(&json, "scenes_per_second", rate_of(crew));
        json_bool(&json, "complete", whole == sweep->shards);
        json_whole(&json, "reflected_missed", sweep->missed);
        json_close(&json, '}');
    } else if (!crew->how->quiet) {
        text_print_escaped(stdout, sweep->folder.path);
        printf(_(": scenes computed now: %llu, %.0f a second; whole shards: %llu of %llu\n"), done, rate_of(crew),
               (unsigned long long)whole, (unsigned long long)sweep->shards);
    }
}

int sweep_work(struct sweep *sweep, const struct sweep_run *how)
{
    struct crew crew = {.sweep = sweep, .how = how};
    const struct sigaction action = {.sa_handler = on_interrupt};
    uint64_t whole = 0;
    int code;

    /* what a picture takes is given back to the same thread, not to the system */
    mallopt(M_MMAP_THRESHOLD, 1 << 30);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    sigaction(SIGINT, &action, NULL);
    pthread_cond_init(&crew.ended, NULL);
    find_missing(&crew);
    code = check_room(&crew);
    if (code == EXIT_DONE && crew.count > 0)
        start(&crew);
    crew.code = crew.code ? crew.code : code;
    code = sweep_write_manifest(sweep, &whole);
    if (crew.code == EXIT_DONE)
        crew.code = code;
    if (is_interrupted && crew.code == EXIT_DONE)
        crew.code = EXIT_INTERRUPTED;
    if (crew.code == EXIT_DONE)
        tell_end(&crew, whole);
    code = sweep_tell_missed(sweep);
    crew.code = crew.code ? crew.code : code;
    pthread_cond_destroy(&crew.ended);
    free(crew.missing);
    return crew.code;
}
