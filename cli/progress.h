/* SPDX-License-Identifier: MIT */
/* Long work: its progress on a terminal, and its end by Ctrl-C. */
#ifndef LUXEL_CLI_PROGRESS_H
#define LUXEL_CLI_PROGRESS_H

#include <pthread.h>
#include <stdbool.h>

/* What a thread of its own shows twice a second, as not all work tells how far it is. */
struct progress {
    bool wanted; /* standard error is a terminal that can erase, and the user did not ask for quiet */
    pthread_t thread;
    pthread_mutex_t lock; /* of all below */
    pthread_cond_t ends;
    bool has_ended;
    double start_s, part_s; /* when the work began, and the part of it that is under way */
    double done;            /* of that part; 0: not known */
    double told_s;          /* when that was told */
    double bound;           /* that reflected light has reached; infinite: none yet, 0: it is not known */
};

/*
 * From here on Ctrl-C ends the tool with EXIT_INTERRUPTED, at once: an output that is being written vanishes with the
 * process.
 */
void progress_catch_interrupt(void);

/*
 * From here on reflected light is refined for so many seconds at the latest, 0: without end; and, if `keeps` says so,
 * until the first Ctrl-C.
 */
void progress_wait(double seconds, bool keeps);
/* What is left of that for each of some parts; 0: no end. */
double progress_share(size_t parts);
/* The word of JSON for what ended refining before the bound was reached, where `reached` does not say that it was:
 * time, interrupt (Ctrl-C), or effort, of which there is only so much; else NULL. */
const char *progress_end_word(bool reached);
/* Says what bound there is where one of them was the end, unless `quiet`; true: it was Ctrl-C. */
bool progress_tell_end(bool quiet);

/* The progress must stay where it is until its end. */
void progress_begin(struct progress *progress, bool quiet);
/* The library's callback: `data` is the struct progress.  Always true. */
bool progress_report(double done, void *data);
/* So, too; whether refining is to end. */
bool progress_is_enough(double bound, void *data);
/* Wipes the line. */
void progress_end(struct progress *progress);

#endif
