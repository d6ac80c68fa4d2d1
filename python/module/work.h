/* SPDX-License-Identifier: MIT */
/* A piece of work of the library: its settings, the interpreter's lock released meanwhile, Ctrl-C and progress. */
#ifndef LUXEL_PYTHON_WORK_H
#define LUXEL_PYTHON_WORK_H

#include <time.h>

#include "module.h"

struct work {
    luxel_settings settings;
    PyObject *progress;    /* called with the share done, or NULL */
    PyThreadState *thread; /* while the lock is released */
    struct timespec asked; /* when signals were last looked for */
    double before, share;  /* of a work in parts: what was done before this one, and how much this one is */
    bool failed;           /* an exception was raised meanwhile */
};

/*
 * Reads the settings of a tuple (quantity, precision, threads, instruction set, tolerance, light_error,
 * reflected_error, stride, minimum_reached, skip_reflected_pixels, lights, within, progress), which must live as long
 * as the work.  `lights` is None or bytes that are numbers of type size_t.  False: an exception is set.
 */
bool work_begin(struct work *work, PyObject *settings);

/* Releases the interpreter's lock, and takes it again. */
void work_leave(struct work *work);
void work_return(struct work *work);

#endif
