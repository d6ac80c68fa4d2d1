/* SPDX-License-Identifier: MIT */
/*
 * Exact values of whole arrays of surface elements: read from arrays of Python and written to such, in parts that fit
 * in the cache, by the library's threads and without the interpreter's lock.
 */
#include <math.h>
#include <unistd.h>

#include "failure.h"
#include "strided.h"
#include "work.h"

/* Elements for each thread that are handed to the library at once: they fit in its cache, and take long enough that
 * beginning the threads does not count. */
enum { PART = 4096, MOST_THREADS = 64 };

struct arrays {
    struct strided places, normals, views; /* n x 3; views may be missing */
    struct strided values, errors;         /* n */
    struct strided shares;                 /* n x lights; may be missing */
    struct strided tolerances, moved;      /* n, of places that may lie off their surface; may both be missing */
};

struct evaluating {
    struct arrays arrays;
    luxel_evaluator *evaluator;
    size_t surface;
    Py_ssize_t part;     /* elements at once */
    luxel_place *places; /* so many of each */
    luxel_value *found;
    double *shares;
    double *tolerances, *moved;
    bool is_too_large;
};

static bool has_rows(const struct strided *array, const char *name, Py_ssize_t rows, Py_ssize_t columns)
{
    if (!array->is_held || (array->shape[0] == rows && array->shape[1] == columns))
        return true;
    PyErr_Format(PyExc_ValueError, "%s: the shape (%zd, %zd) is expected, not (%zd, %zd)", name, rows, columns,
                 array->shape[0], array->shape[1]);
    return false;
}

static void arrays_release(struct arrays *arrays)
{
    struct strided *const all[] = {&arrays->places, &arrays->normals, &arrays->views,      &arrays->values,
                                   &arrays->errors, &arrays->shares,  &arrays->tolerances, &arrays->moved};

    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        strided_release(all[i]);
}

/* From a tuple of six or eight, where views, shares, and tolerances with what was moved may be None.  False: an
 * exception is set. */
static bool arrays_take(PyObject *tuple, size_t lights, struct arrays *arrays)
{
    PyObject *places, *normals, *views, *values, *errors, *shares, *tolerances = Py_None, *moved = Py_None;

    *arrays = (struct arrays){0};
    if (!is_tuple(tuple) || !PyArg_ParseTuple(tuple, "OOOOOO|OO", &places, &normals, &views, &values, &errors, &shares,
                                              &tolerances, &moved))
        return false;
    bool good =
        strided_take(places, "places", 2, false, &arrays->places) &&
        strided_take(normals, "normals", 2, false, &arrays->normals) &&
        (views == Py_None || strided_take(views, "views", 2, false, &arrays->views)) &&
        strided_take(values, "value", 1, true, &arrays->values) &&
        strided_take(errors, "error", 1, true, &arrays->errors) &&
        (shares == Py_None || strided_take(shares, "shares", 2, true, &arrays->shares)) &&
        (tolerances == Py_None || (strided_take(tolerances, "surface_tolerance", 1, false, &arrays->tolerances) &&
                                   strided_take(moved, "moved_mm", 1, true, &arrays->moved)));
    const Py_ssize_t rows = arrays->places.shape[0];

    good = good && has_rows(&arrays->places, "places", rows, 3) && has_rows(&arrays->normals, "normals", rows, 3) &&
           has_rows(&arrays->views, "views", rows, 3) && has_rows(&arrays->values, "value", rows, 1) &&
           has_rows(&arrays->errors, "error", rows, 1) &&
           has_rows(&arrays->shares, "shares", rows, (Py_ssize_t)lights) &&
           has_rows(&arrays->tolerances, "surface_tolerance", rows, 1) && has_rows(&arrays->moved, "moved_mm", rows, 1);
    if (!good)
        arrays_release(arrays);
    return good;
}

static void read_part(const struct evaluating *work, Py_ssize_t first, size_t count)
{
    const struct arrays *arrays = &work->arrays;

    for (size_t i = 0; i < count; i++) {
        luxel_place *place = &work->places[i];
        const Py_ssize_t row = first + (Py_ssize_t)i;

        *place = (luxel_place){.is_element = true, .has_view = arrays->views.is_held, .surface = work->surface};
        for (int k = 0; k < 3; k++) {
            place->position_mm[k] = strided_get(&arrays->places, row, k);
            place->normal[k] = strided_get(&arrays->normals, row, k);
            if (place->has_view)
                place->view[k] = strided_get(&arrays->views, row, k);
        }
        if (work->tolerances)
            work->tolerances[i] = strided_get(&arrays->tolerances, row, 0);
    }
}

/* An element without a value has NaN. */
static void write_part(struct evaluating *work, Py_ssize_t first, size_t count)
{
    const struct arrays *arrays = &work->arrays;
    const size_t lights = luxel_evaluator_light_count(work->evaluator);

    for (size_t i = 0; i < count; i++) {
        const luxel_value *found = &work->found[i];
        const Py_ssize_t row = first + (Py_ssize_t)i;

        strided_set(&arrays->values, row, 0, found->has_value ? found->value : (double)NAN);
        strided_set(&arrays->errors, row, 0, found->has_value ? found->error : (double)NAN);
        if (work->moved)
            strided_set(&arrays->moved, row, 0, work->moved[i]);
        work->is_too_large = work->is_too_large || (found->has_value && !isfinite(found->value));
        for (size_t k = 0; work->shares && k < lights; k++)
            strided_set(&arrays->shares, row, (Py_ssize_t)k,
                        found->has_value ? work->shares[i * lights + k] : (double)NAN);
    }
}

/* Without the lock. */
static luxel_status evaluate_all(struct evaluating *evaluating, struct work *work)
{
    const Py_ssize_t rows = evaluating->arrays.places.shape[0];
    luxel_status status = LUXEL_OK;

    for (Py_ssize_t first = 0; status == LUXEL_OK && first < rows; first += evaluating->part) {
        const size_t count = (size_t)(rows - first < evaluating->part ? rows - first : evaluating->part);

        work->before = (double)first / (double)rows;
        work->share = (double)count / (double)rows;
        read_part(evaluating, first, count);
        if (evaluating->tolerances)
            status = luxel_evaluator_settle_places(evaluating->evaluator, evaluating->places, count,
                                                   evaluating->tolerances, evaluating->moved);
        if (status != LUXEL_OK)
            break;
        status = luxel_evaluate_places(evaluating->evaluator, evaluating->places, count, evaluating->found,
                                       evaluating->shares);
        if (status == LUXEL_OK)
            write_part(evaluating, first, count);
    }
    return status == LUXEL_OK && evaluating->is_too_large ? LUXEL_ERROR_RANGE : status;
}

static Py_ssize_t part_for(unsigned threads)
{
    const long wanted = threads > 0 ? (long)threads : sysconf(_SC_NPROCESSORS_ONLN);

    return PART * (wanted < 1 ? 1 : wanted < MOST_THREADS ? wanted : MOST_THREADS);
}

/* Room for a part.  False: an exception is set. */
static bool make_room(struct evaluating *work)
{
    const bool wants_shares = work->arrays.shares.is_held, may_be_off = work->arrays.tolerances.is_held;
    const Py_ssize_t rows = work->arrays.places.shape[0];
    const size_t most = (size_t)(rows < work->part ? rows + 1 : work->part);
    const size_t lights = luxel_evaluator_light_count(work->evaluator);

    work->places = PyMem_Malloc(most * sizeof *work->places);
    work->found = PyMem_Malloc(most * sizeof *work->found);
    work->shares = wants_shares ? PyMem_Calloc(most * lights + 1, sizeof *work->shares) : NULL;
    work->tolerances = may_be_off ? PyMem_Malloc(2 * most * sizeof *work->tolerances) : NULL;
    work->moved = work->tolerances ? work->tolerances + most : NULL;
    if (work->places && work->found && (work->shares || !wants_shares) && (work->tolerances || !may_be_off))
        return true;
    PyErr_NoMemory();
    return false;
}

static PyObject *evaluate(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *tuple, *settings;
    Py_ssize_t surface;
    struct work work;
    struct evaluating evaluating = {0};
    const luxel_scene *scene;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OOnO", &handle, &tuple, &surface, &settings) ||
        !(scene = scene_of(module, handle)) || !work_begin(&work, settings) || !(diagnostics = diagnostics_begin()))
        return NULL;
    work_leave(&work);
    luxel_status status = luxel_evaluator_new(scene, &work.settings, diagnostics, &evaluating.evaluator);

    work_return(&work);
    evaluating.surface = (size_t)surface;
    evaluating.part = part_for(work.settings.threads);
    if (status == LUXEL_OK &&
        arrays_take(tuple, luxel_evaluator_light_count(evaluating.evaluator), &evaluating.arrays) &&
        make_room(&evaluating)) {
        work_leave(&work);
        status = evaluate_all(&evaluating, &work);
        work_return(&work);
    }
    arrays_release(&evaluating.arrays);
    luxel_evaluator_free(evaluating.evaluator);
    PyMem_Free(evaluating.places);
    PyMem_Free(evaluating.found);
    PyMem_Free(evaluating.shares);
    PyMem_Free(evaluating.tolerances);
    return diagnostics_end(&module_state(module)->language, status, diagnostics) ? none() : NULL;
}

const PyMethodDef evaluate_functions[] = {
    FUNCTION("evaluate", evaluate, METH_VARARGS,
             "scene: SceneHandle, arrays: Tuple[Any, ...], surface: int, settings: _Settings, /", "None"),
    {NULL, NULL, 0, NULL},
};
