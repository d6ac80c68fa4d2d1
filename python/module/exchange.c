/* SPDX-License-Identifier: MIT */
/* The form factors between the sides of surfaces. */
#include <luxel/exchange.h>

#include "failure.h"
#include "work.h"

static void release_exchange(void *exchange)
{
    luxel_exchange_free(exchange);
}

static PyObject *side_tuple(const luxel_exchange_side *side)
{
    return Py_BuildValue("(nNNsd)", (Py_ssize_t)side->surface, text_or_none(side->surface_name),
                         text_or_none(side->part_name), luxel_surface_side_name(side->side), side->area_m2);
}

/* The sides, and the factors with their errors as a view: rows x columns x 2 in rows of pairs.  Takes the exchange. */
static PyObject *exchange_tuple(PyObject *module, luxel_exchange *exchange)
{
    PyObject *holder = holder_new(module, exchange, release_exchange), *sides = PyList_New(0);

    for (size_t i = 0; holder && sides && i < exchange->count; i++)
        if (append(sides, side_tuple(&exchange->sides[i])) < 0)
            Py_CLEAR(sides);
    if (!holder || !sides) {
        Py_XDECREF(holder);
        Py_XDECREF(sides);
        return NULL;
    }
    const struct view_layout layout = {.data = exchange->factors,
                                       .format = "d",
                                       .rows = (Py_ssize_t)exchange->count,
                                       .columns = 2 * (Py_ssize_t)exchange->count};
    PyObject *tuple =
        Py_BuildValue("(NNO)", sides, view_new(module, holder, &layout), exchange->reached ? Py_True : Py_False);

    Py_DECREF(holder);
    return tuple;
}

static PyObject *find_exchange(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *settings;
    struct work work;
    luxel_exchange *exchange = NULL;
    const luxel_scene *scene;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OO", &handle, &settings) || !(scene = scene_of(module, handle)) ||
        !work_begin(&work, settings) || !(diagnostics = diagnostics_begin()))
        return NULL;
    work_leave(&work);
    const luxel_status status = luxel_find_exchange(scene, &work.settings, diagnostics, &exchange);

    work_return(&work);
    if (diagnostics_end(&module_state(module)->language, status, diagnostics))
        return exchange_tuple(module, exchange);
    luxel_exchange_free(exchange);
    return NULL;
}

const PyMethodDef exchange_functions[] = {
    FUNCTION("find_exchange", find_exchange, METH_VARARGS, "scene: SceneHandle, settings: _Settings, /",
             "Tuple[Any, ...]"),
    {NULL, NULL, 0, NULL},
};
