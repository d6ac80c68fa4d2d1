/* SPDX-License-Identifier: MIT */
/* The daylight factors of a scene's measuring grids, and of free elements. */
#include <luxel/daylight.h>
#include <luxel/grid.h>

#include "failure.h"
#include "work.h"

/* Value and error of the whole and of its parts; None where there is no value. */
static PyObject *factor_tuple(const luxel_daylight_factor *factor)
{
    if (!factor->has_value)
        return none();
    return Py_BuildValue("((dd)(dd)(dd)(dd))", factor->value.value, factor->value.error, factor->sky.value,
                         factor->sky.error, factor->external.value, factor->external.error, factor->internal.value,
                         factor->internal.error);
}

static PyObject *factor_list(const luxel_daylight_factor *factors, size_t count)
{
    PyObject *list = PyList_New(0);

    for (size_t i = 0; list && i < count; i++)
        if (append(list, factor_tuple(&factors[i])) < 0)
            Py_CLEAR(list);
    return list;
}

static PyObject *grid_tuple(const luxel_daylight_grid *grid)
{
    PyObject *cells = factor_list(grid->cells, (size_t)grid->columns * grid->rows);

    if (!cells)
        return NULL;
    return Py_BuildValue("(NIIN(dd)(dd)(dddd)O)", text_or_none(grid->name), grid->rows, grid->columns, cells,
                         grid->mean.value, grid->mean.error, grid->median.value, grid->median.error, grid->shares[0],
                         grid->shares[1], grid->shares[2], grid->shares[3], grid->measured > 0 ? Py_True : Py_False);
}

static PyObject *daylight_tuple(const luxel_daylight *found)
{
    PyObject *grids = PyList_New(0), *elements;

    for (size_t i = 0; grids && i < found->grid_count; i++)
        if (append(grids, grid_tuple(&found->grids[i])) < 0)
            Py_CLEAR(grids);
    elements = grids ? factor_list(found->elements, found->element_count) : NULL;
    if (!elements) {
        Py_XDECREF(grids);
        return NULL;
    }
    return Py_BuildValue("((dd)NNNO)", found->horizontal.value, found->horizontal.error,
                         number_or_none(found->outdoor == found->outdoor, found->outdoor), grids, elements,
                         found->reached ? Py_True : Py_False);
}

/* The elements of a list of tuples of six numbers, the caller's; NULL: an exception is set. */
static luxel_place *elements_of(PyObject *list, size_t *count)
{
    const Py_ssize_t size = PyList_Size(list);
    luxel_place *places = size < 0 ? NULL : PyMem_Calloc((size_t)size + 1, sizeof *places);

    if (size >= 0 && !places)
        PyErr_NoMemory();
    for (Py_ssize_t i = 0; places && i < size; i++) {
        luxel_place *place = &places[i];

        place->is_element = true;
        if (!is_tuple(PyList_GetItem(list, i)) ||
            !PyArg_ParseTuple(PyList_GetItem(list, i), "dddddd", &place->position_mm[0], &place->position_mm[1],
                              &place->position_mm[2], &place->normal[0], &place->normal[1], &place->normal[2])) {
            PyMem_Free(places);
            return NULL;
        }
    }
    *count = (size_t)size;
    return places;
}

/* find_daylight(scene, elements, outdoor, settings): daylight factors; `outdoor` 0 leaves it to the sky. */
static PyObject *find_daylight(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *list, *settings, *found = NULL;
    struct work work;
    double outdoor;
    size_t count;
    luxel_daylight *result = NULL;
    const luxel_scene *scene;
    luxel_place *places;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OOdO", &handle, &list, &outdoor, &settings) ||
        !(scene = scene_of(module, handle)) || !work_begin(&work, settings) || !(places = elements_of(list, &count)))
        return NULL;
    if (!(diagnostics = diagnostics_begin())) {
        PyMem_Free(places);
        return NULL;
    }
    work_leave(&work);
    const luxel_status status =
        luxel_find_daylight(scene, &work.settings, places, count, outdoor, diagnostics, &result);

    work_return(&work);
    if (diagnostics_end(&module_state(module)->language, status, diagnostics))
        found = daylight_tuple(result);
    luxel_daylight_free(result);
    PyMem_Free(places);
    return found;
}

const PyMethodDef daylight_functions[] = {
    FUNCTION("find_daylight", find_daylight, METH_VARARGS,
             "scene: SceneHandle, elements: List[Tuple[float, ...]], outdoor: float, settings: _Settings, /",
             "Tuple[Any, ...]"),
    {NULL, NULL, 0, NULL},
};
