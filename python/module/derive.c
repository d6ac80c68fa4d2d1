/* SPDX-License-Identifier: MIT */
/* Derivatives at whole arrays of places, written to arrays of Python without the interpreter's lock. */
#include <math.h>
#include <stdlib.h>
#ifndef _WIN32
#include <sys/mman.h>
#endif

#include "failure.h"
#include "inverse.h"
#include "work.h"

const char **keys_of(PyObject *list, size_t *count)
{
    const Py_ssize_t size = PyList_Check(list) ? PyList_Size(list) : -1;
    const char **keys = size < 0 ? NULL : PyMem_Calloc((size_t)size + 1, sizeof *keys);

    if (!keys) {
        PyErr_SetString(PyExc_TypeError, "keys: a list of texts is expected");
        return NULL;
    }
    for (Py_ssize_t i = 0; i < size; i++)
        if (!(keys[i] = PyUnicode_AsUTF8AndSize(PyList_GetItem(list, i), NULL))) {
            PyMem_Free(keys);
            return NULL;
        }
    *count = (size_t)size;
    return keys;
}

/* How many numbers each key takes. */
static PyObject *derive_numbers(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *list, *numbers = NULL;
    const luxel_scene *scene;
    luxel_derivatives *found = NULL;
    luxel_diagnostics *diagnostics;
    const char **keys;
    size_t count;

    if (!PyArg_ParseTuple(arguments, "OO", &handle, &list) || !(scene = scene_of(module, handle)) ||
        !(keys = keys_of(list, &count)))
        return NULL;
    if (!(diagnostics = diagnostics_begin())) {
        PyMem_Free(keys);
        return NULL;
    }
    const luxel_status status = luxel_derive_places(scene, NULL, NULL, NULL, 0, keys, count, diagnostics, &found);

    PyMem_Free(keys);
    if (diagnostics_end(&module_state(module)->language, status, diagnostics))
        numbers = PyList_New(0);
    for (size_t i = 0; numbers && i < count; i++)
        if (append(numbers, PyLong_FromSize_t(luxel_derivatives_numbers(found, i))) < 0)
            Py_CLEAR(numbers);
    luxel_derivatives_free(found);
    return numbers;
}

/* The arrays of a call: places, the value of each with its error, and their derivatives with errors and states, a
 * column for each number of a key; None for those that are not wanted. */
enum { PLACES, VALUES, VALUE_ERRORS, DERIVATIVES, ERRORS, STATES, ARRAYS };

static void release(struct strided *arrays)
{
    for (int i = 0; i < ARRAYS; i++)
        strided_release(&arrays[i]);
}

static bool take(PyObject *tuple, struct strided *arrays)
{
    static const char *const names[ARRAYS] = {"places", "values", "value_errors", "derivatives", "errors", "states"};
    static const int dimensions[ARRAYS] = {2, 1, 1, 2, 2, 2};
    PyObject *given[ARRAYS];

    if (!is_tuple(tuple) ||
        !PyArg_ParseTuple(tuple, "OOOOOO", &given[0], &given[1], &given[2], &given[3], &given[4], &given[5]))
        return false;
    for (int i = 0; i < ARRAYS; i++)
        if (i > PLACES && given[i] == Py_None)
            continue;
        else if (!strided_take(given[i], names[i], dimensions[i], i > 0, &arrays[i]) ||
            arrays[i].shape[0] != arrays[PLACES].shape[0]) {
            if (!PyErr_Occurred())
                PyErr_Format(PyExc_ValueError, "%s: as many rows as places are expected", names[i]);
            return false;
        }
    return true;
}

luxel_place *places_of(const struct strided *places, size_t surface)
{
    static const size_t page = 2 << 20; /* a large one: millions of places take long in small ones */
    const size_t bytes = (((size_t)places->shape[0] + 1) * sizeof(luxel_place) + page - 1) / page * page;
    luxel_place *list = bytes > page ? aligned_alloc(page, bytes) : malloc(bytes);

#ifdef MADV_HUGEPAGE
    if (list && bytes > page)
        (void)madvise(list, bytes, MADV_HUGEPAGE); /* a hint */
#endif
    for (Py_ssize_t i = 0; list && i < places->shape[0]; i++) {
        luxel_place *place = &list[i];
        double *const parts[] = {place->position_mm, place->normal, place->view};

        *place =
            (luxel_place){.is_element = places->shape[1] > 2, .has_view = places->shape[1] > 6, .surface = surface};
        for (Py_ssize_t k = 0; k < places->shape[1]; k++)
            *(place->is_element ? &parts[k / 3][k % 3] : &place->screen_mm[k]) = strided_get(places, i, k);
    }
    return list;
}

static void write_one(const struct strided *array, Py_ssize_t i, Py_ssize_t k, double number)
{
    if (array->is_held)
        strided_set(array, i, k, number);
}

static void write_all(const struct strided *arrays, const luxel_derivatives *found, size_t key_count)
{
    for (Py_ssize_t i = 0; i < arrays[PLACES].shape[0]; i++) {
        luxel_bounded value = {(double)NAN, (double)NAN};
        Py_ssize_t column = 0;

        luxel_derivatives_value(found, (size_t)i, &value);
        write_one(&arrays[VALUES], i, 0, value.value);
        write_one(&arrays[VALUE_ERRORS], i, 0, value.error);
        for (size_t key = 0; key < key_count; key++)
            for (size_t k = 0; k < luxel_derivatives_numbers(found, key); k++, column++) {
                const luxel_derivative *one = luxel_derivatives_get(found, (size_t)i, key, k);

                write_one(&arrays[DERIVATIVES], i, column, one->value);
                write_one(&arrays[ERRORS], i, column, one->error);
                write_one(&arrays[STATES], i, column, (double)one->state);
            }
    }
}

static luxel_status derive_cells(const luxel_scene *scene, const struct strided *arrays, size_t grid,
                                 const char *const *keys, size_t count, struct work *work,
                                 luxel_diagnostics *diagnostics)
{
    luxel_derivatives *found = NULL;
    const luxel_status status = luxel_derive_grid(scene, &work->settings, grid, keys, count, diagnostics, &found);

    if (status == LUXEL_OK)
        write_all(arrays, found, count);
    luxel_derivatives_free(found);
    return status;
}

static luxel_status derive_all(const luxel_scene *scene, const struct strided *arrays, size_t surface,
                               const char *const *keys, size_t count, struct work *work, luxel_diagnostics *diagnostics)
{
    luxel_derivatives *found = NULL;
    luxel_place *places = places_of(&arrays[PLACES], surface);
    const luxel_status status =
        places ? luxel_derive_places(scene, &work->settings, places, NULL, (size_t)arrays[PLACES].shape[0], keys, count,
                                     diagnostics, &found)
               : LUXEL_ERROR_MEMORY;

    free(places);
    if (status == LUXEL_OK)
        write_all(arrays, found, count);
    luxel_derivatives_free(found);
    return status;
}

static PyObject *derive(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *tuple, *list, *settings;
    Py_ssize_t surface, grid;
    struct strided arrays[ARRAYS] = {{.is_held = false}};
    struct work work;
    const luxel_scene *scene;
    luxel_diagnostics *diagnostics;
    luxel_status status = LUXEL_OK;
    const char **keys;
    size_t count;

    if (!PyArg_ParseTuple(arguments, "OOOnnO", &handle, &list, &tuple, &surface, &grid, &settings) ||
        !(scene = scene_of(module, handle)) || !(keys = keys_of(list, &count)))
        return NULL;
    if (!work_begin(&work, settings) || !(diagnostics = diagnostics_begin())) {
        PyMem_Free(keys);
        return NULL;
    }
    if (take(tuple, arrays)) {
        work_leave(&work);
        status = grid < 0 ? derive_all(scene, arrays, (size_t)surface, keys, count, &work, diagnostics)
                          : derive_cells(scene, arrays, (size_t)grid, keys, count, &work, diagnostics);
        work_return(&work);
    }
    release(arrays);
    PyMem_Free(keys);
    return diagnostics_end(&module_state(module)->language, status, diagnostics) ? none() : NULL;
}

const PyMethodDef derive_functions[] = {
    FUNCTION("derive_numbers", derive_numbers, METH_VARARGS, "scene: SceneHandle, keys: List[str], /", "List[int]"),
    FUNCTION("derive", derive, METH_VARARGS,
             "scene: SceneHandle, keys: List[str], arrays: Tuple[Any, ...], surface: int, grid: int, "
             "settings: _Settings, /",
             "None"),
    {NULL, NULL, 0, NULL},
};
