/* SPDX-License-Identifier: MIT */
/*
 * Progress and Ctrl-C.  Signals are the one place where the tool needs state of its own: whether an interrupt
 * came, and whether the computation will look.
 */
#include "progress.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli.h"
#include "machine.h"

static volatile sig_atomic_t interrupted, cancellable;

static void on_interrupt(int signal_number)
{
    (void)signal_number;
    if (!cancellable || interrupted)
        _exit(EXIT_INTERRUPTED);
    interrupted = 1;
}

void progress_catch_interrupt(void)
{
    const struct sigaction action = {.sa_handler = on_interrupt};

    sigaction(SIGINT, &action, NULL);
}

void progress_begin(struct progress *progress, bool quiet)
{
    const char *terminal = getenv("TERM");
    const bool erases = terminal && strcmp(terminal, "dumb") != 0;

    *progress = (struct progress){.wanted = !quiet && erases && isatty(STDERR_FILENO), .start_s = machine_seconds()};
    cancellable = 1;
}

bool progress_report(double done, void *data)
{
    const double patience_s = 1.0, pause_s = 0.1;
    struct progress *progress = data;
    double now, left_s;

    if (interrupted)
        return false;
    if (!progress->wanted)
        return true;
    now = machine_seconds();
    if (now - progress->start_s < patience_s || now - progress->last_s < pause_s || !(done > 0.0))
        return true;
    left_s = (now - progress->start_s) * (1.0 - done) / done;
    fputc('\r', stderr);
    fprintf(stderr, _("%3.0f %%, %.0f s left"), 100.0 * done, ceil(left_s));
    fputs("\033[K", stderr);
    progress->last_s = now;
    return true;
}

bool progress_end(struct progress *progress)
{
    cancellable = 0;
    if (progress->last_s > 0.0)
        fputs("\r\033[K", stderr);
    return interrupted;
}
