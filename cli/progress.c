/* SPDX-License-Identifier: MIT */
/*
 * Progress and Ctrl-C.  Signals are the one place where the tool needs state of its own: whether a line of progress
 * stands on the terminal.
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

#define ERASE "\r\033[K"

static volatile sig_atomic_t is_shown;

/* At once, whatever is being done: what is not finished vanishes with the process. */
static void on_interrupt(int signal_number)
{
    (void)signal_number;
    if (is_shown && write(STDERR_FILENO, ERASE, strlen(ERASE)) < 0)
        _exit(EXIT_INTERRUPTED); /* the terminal is gone, too */
    _exit(EXIT_INTERRUPTED);
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
}

bool progress_report(double done, void *data)
{
    const double patience_s = 1.0, pause_s = 0.1;
    struct progress *progress = data;
    double now, left_s;

    if (!progress->wanted)
        return true;
    now = machine_seconds();
    if (now - progress->start_s < patience_s || now - progress->last_s < pause_s || !(done > 0.0))
        return true;
    left_s = (now - progress->start_s) * (1.0 - done) / done;
    is_shown = 1;
    fputc('\r', stderr);
    fprintf(stderr, _("%3.0f %%, %.0f s left"), 100.0 * done, ceil(left_s));
    fputs("\033[K", stderr);
    progress->last_s = now;
    return true;
}

void progress_end(struct progress *progress)
{
    if (progress->last_s > 0.0)
        fputs(ERASE, stderr);
    is_shown = 0;
}
