/* SPDX-License-Identifier: MIT */
/* Long work: its progress on a terminal, and its end by Ctrl-C. */
#ifndef LUXEL_CLI_PROGRESS_H
#define LUXEL_CLI_PROGRESS_H

#include <stdbool.h>

struct progress {
    bool wanted; /* standard error is a terminal that can erase, and the user did not ask for quiet */
    double start_s, last_s;
};

/*
 * From here on Ctrl-C ends the tool with EXIT_INTERRUPTED, at once: an output that is being written vanishes with the
 * process.
 */
void progress_catch_interrupt(void);

void progress_begin(struct progress *progress, bool quiet);
/* The library's callback: `data` is the struct progress.  Always true. */
bool progress_report(double done, void *data);
/* Wipes the line. */
void progress_end(struct progress *progress);

#endif
