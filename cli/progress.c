/* SPDX-License-Identifier: MIT */
/*
 * Progress and Ctrl-C.  Signals are the one place where the tool needs state of its own: whether a line of progress
 * stands on the terminal.
 */
#include "progress.h"

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "cli.h"
#include "clock.h"
#include "message.h"

#define ERASE "\r\033[K"

static volatile sig_atomic_t is_shown;

/* When refining ends, and that of the part that is being done: at a time, or by Ctrl-C where it is not to end the tool
 * at once. */
static double end_s = HUGE_VAL, part_end_s = HUGE_VAL;
static volatile sig_atomic_t keeps_what_is_known, is_refining, is_wished;
/* The greatest bound that was reached where it ended so; 0: it did not. */
static double ended_with;

/* At once, whatever is being done: what is not finished vanishes with the process. */
static void on_interrupt(int signal_number)
{
    (void)signal_number;
    if (keeps_what_is_known && is_refining && !is_wished) {
        is_wished = 1;
        return;
    }
    if (is_shown && write(STDERR_FILENO, ERASE, strlen(ERASE)) < 0)
        _exit(EXIT_INTERRUPTED); /* the terminal is gone, too */
    _exit(EXIT_INTERRUPTED);
}

void progress_catch_interrupt(void)
{
    const struct sigaction action = {.sa_handler = on_interrupt};

    sigaction(SIGINT, &action, NULL);
}

void progress_wait(double seconds, bool keeps)
{
    const double for_good_s = 1e9; /* an end that never comes, which asks for something to keep soon */

    end_s = seconds > 0.0 ? clock_seconds() + seconds : keeps ? clock_seconds() + for_good_s : HUGE_VAL;
    part_end_s = end_s;
    keeps_what_is_known = keeps;
}

double progress_share(size_t parts)
{
    const double least_s = 1e-3;

    if (!isfinite(end_s))
        return 0.0;
    const double now = clock_seconds(), share = fmax((end_s - now) / (double)parts, least_s);
    part_end_s = now + share;
    return share;
}

const char *progress_end_word(bool reached)
{
    return reached ? NULL : is_wished ? "interrupt" : ended_with > 0.0 ? "time" : "effort";
}

bool progress_tell_end(bool quiet)
{
    char bound[32];

    snprintf(bound, sizeof bound, "%.1e", ended_with);
    if (ended_with > 0.0 && !quiet && isinf(ended_with))
        message_note(_("%s was the end, before reflected light had any bound but the greatest"),
                     is_wished ? "Ctrl-C" : _("the time"));
    else if (ended_with > 0.0 && !quiet)
        message_note(_("%s was the end: the bound of reflected light is %s where it is worst"),
                     is_wished ? "Ctrl-C" : _("the time"), bound);
    return is_wished;
}

/* The moment a pause after now, as waiting counts it. */
static struct timespec after(double pause_s)
{
    struct timespec moment;

    clock_gettime(CLOCK_MONOTONIC, &moment);
    moment.tv_nsec += (long)(pause_s * 1e9);
    moment.tv_sec += moment.tv_nsec / 1000000000;
    moment.tv_nsec %= 1000000000;
    return moment;
}

/* What is left is told while the work tells how far it is; else how long it has been going on. */
static void show(const struct progress *progress)
{
    const double fresh_s = 2.0, now = clock_seconds(), done = progress->done;

    is_shown = 1;
    fputc('\r', stderr);
    if (done > 0.0 && done < 1.0 && now - progress->told_s < fresh_s)
        fprintf(stderr, _("%3.0f %%, %.0f s left"), 100.0 * done,
                ceil(fmin((now - progress->part_s) * (1.0 - done) / done, fmax(end_s - now, 0.0))));
    else
        fprintf(stderr, _("computing for %.0f s"), floor(now - progress->start_s));
    if (progress->bound > 0.0 && isfinite(progress->bound))
        fprintf(stderr, _(", reflected light within %.1e"), progress->bound);
    fputs("\033[K", stderr);
    fflush(stderr);
}

static void *show_until_the_end(void *data)
{
    const double patience_s = 1.0, pause_s = 0.5;
    struct progress *progress = data;
    struct timespec moment = after(pause_s);

    pthread_mutex_lock(&progress->lock);
    while (!progress->has_ended)
        if (pthread_cond_timedwait(&progress->ends, &progress->lock, &moment) == ETIMEDOUT) {
            if (clock_seconds() - progress->start_s >= patience_s)
                show(progress);
            moment = after(pause_s);
        }
    pthread_mutex_unlock(&progress->lock);
    return NULL;
}

void progress_begin(struct progress *progress, bool quiet)
{
    const char *terminal = getenv("TERM");
    const bool erases = terminal && strcmp(terminal, "dumb") != 0;
    const double now = clock_seconds();
    pthread_condattr_t by_clock;

    *progress = (struct progress){.wanted = !quiet && erases && isatty(STDERR_FILENO), .start_s = now, .part_s = now};
    if (!progress->wanted)
        return;
    pthread_mutex_init(&progress->lock, NULL);
    pthread_condattr_init(&by_clock);
    pthread_condattr_setclock(&by_clock, CLOCK_MONOTONIC);
    pthread_cond_init(&progress->ends, &by_clock);
    pthread_condattr_destroy(&by_clock);
    progress->wanted = pthread_create(&progress->thread, NULL, show_until_the_end, progress) == 0;
}

bool progress_report(double done, void *data)
{
    struct progress *progress = data;

    if (!progress->wanted)
        return true;
    pthread_mutex_lock(&progress->lock);
    progress->told_s = clock_seconds();
    if (done < progress->done) /* another part has begun */
        progress->part_s = progress->told_s;
    progress->done = done;
    pthread_mutex_unlock(&progress->lock);
    return true;
}

bool progress_is_enough(double bound, void *data)
{
    struct progress *progress = data;
    const bool is_enough = is_wished || clock_seconds() >= part_end_s;

    is_refining = 1;
    if (is_enough)
        ended_with = fmax(ended_with, bound);
    if (progress->wanted) {
        pthread_mutex_lock(&progress->lock);
        progress->bound = bound;
        pthread_mutex_unlock(&progress->lock);
    }
    return is_enough;
}

void progress_end(struct progress *progress)
{
    is_refining = 0;
    if (!progress->wanted)
        return;
    pthread_mutex_lock(&progress->lock);
    progress->has_ended = true;
    pthread_cond_signal(&progress->ends);
    pthread_mutex_unlock(&progress->lock);
    pthread_join(progress->thread, NULL);
    pthread_cond_destroy(&progress->ends);
    pthread_mutex_destroy(&progress->lock);
    if (is_shown)
        fputs(ERASE, stderr);
    is_shown = 0;
}
