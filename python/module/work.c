/* SPDX-License-Identifier: MIT */
/*
 * Work without the interpreter's lock.  The library asks for leave to go on far more often than the lock should change
 * hands: where other threads of Python compute, taking it can last 5 ms.  So signals are looked for every 50 ms.
 */
#include "work.h"

static const double PAUSE = 0.05; /* seconds */

static bool is_time(struct work *work)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    const double seconds =
        difftime(now.tv_sec, work->asked.tv_sec) + (double)(now.tv_nsec - work->asked.tv_nsec) * 1e-9;

    if (seconds < PAUSE)
        return false;
    work->asked = now;
    return true;
}

/* Calls the user's function; false stops the work, as an exception does. */
static bool report(struct work *work, double done)
{
    PyObject *answer = PyObject_CallFunction(work->progress, "d", work->before + work->share * done);
    const bool goes_on = answer && answer != Py_False;

    if (!answer)
        work->failed = true;
    Py_XDECREF(answer);
    return goes_on;
}

static bool ask(double done, void *data)
{
    struct work *work = data;
    bool goes_on = true;

    if (work->failed)
        return false;
    if (!is_time(work))
        return true;
    PyEval_RestoreThread(work->thread);
    if (PyErr_CheckSignals() < 0) {
        work->failed = true;
        goes_on = false;
    }
    if (goes_on && work->progress)
        goes_on = report(work, done);
    work->thread = PyEval_SaveThread();
    return goes_on;
}

bool work_begin(struct work *work, PyObject *settings)
{
    int quantity, precision, reached, skips;
    const char *lights;
    Py_ssize_t size;
    PyObject *progress;

    *work = (struct work){.share = 1};
    luxel_settings_init(&work->settings);
    if (!is_tuple(settings) ||
        !PyArg_ParseTuple(settings, "iiIzdddIppz#dO", &quantity, &precision, &work->settings.threads,
                          &work->settings.instruction_set, &work->settings.tolerance, &work->settings.light_error,
                          &work->settings.reflected_error, &work->settings.stride, &reached, &skips, &lights, &size,
                          &work->settings.within, &progress))
        return false;
    work->settings.quantity = (luxel_quantity)quantity;
    work->settings.precision = (luxel_precision)precision;
    work->settings.minimum_reached = reached != 0;
    work->settings.skip_reflected_pixels = skips != 0;
    work->settings.lights = (const size_t *)(const void *)lights; /* bytes begin where numbers may */
    work->settings.light_count = (size_t)size / sizeof(size_t);
    work->settings.progress = ask;
    work->settings.progress_data = work;
    work->progress = progress == Py_None ? NULL : progress;
    clock_gettime(CLOCK_MONOTONIC, &work->asked);
    return true;
}

void work_leave(struct work *work)
{
    work->thread = PyEval_SaveThread();
}

void work_return(struct work *work)
{
    PyEval_RestoreThread(work->thread);
}
