/* SPDX-License-Identifier: MIT */
/*
 * Staged files: a file that is made beside its place, without a name where the file system can do that, and
 * put there in one step.  The lower half of the sink; the rules are told in sink.h.
 */
#ifndef LX_BASE_STAGED_H
#define LX_BASE_STAGED_H

#include <stdbool.h>

#include "sink.h"

enum { LX_HIDDEN_SIZE = 48 };

struct lx_staged {
    const struct lx_sink_system *system;
    int file;                    /* what is written to */
    int folder;                  /* where the target stands; -1 for a direct one */
    char *target;                /* its name there */
    bool direct;                 /* not staged at all: a device, a pipe */
    char hidden[LX_HIDDEN_SIZE]; /* the name that the file has now, "" for none */
};

/* Both return 0 or an errno value.  Whatever they return, lx_staged_close() must follow. */
int lx_staged_open(struct lx_staged *staged, const char *path, const struct lx_sink_system *system);
int lx_staged_publish(struct lx_staged *staged);

/* Closes the file, and removes it if it was not published. */
void lx_staged_close(struct lx_staged *staged);

/* The hidden name number `slot` of a target's name; its length does not depend on the target's. */
void lx_staged_hidden_name(const char *target, unsigned slot, char name[LX_HIDDEN_SIZE]);

/* Standard output by its name, which may have an extension to say the format: /dev/stdout.png. */
bool lx_staged_is_standard_output(const char *path);

#endif
