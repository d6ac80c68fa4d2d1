/* SPDX-License-Identifier: MIT */
/* The balance of the flux where surfaces reflect light to each other, and the mean irradiance of their sides. */
#include <luxel/balance.h>

#include "failure.h"
#include "work.h"

static PyObject *amount(const luxel_bounded *amount)
{
    return Py_BuildValue("(dd)", amount->value, amount->error);
}

static PyObject *side_tuple(const luxel_balance_side *side)
{
    return Py_BuildValue("(nNNsddNN)", (Py_ssize_t)side->surface, text_or_none(side->surface_name),
                         text_or_none(side->part_name), luxel_surface_side_name(side->side), side->area_m2,
                         side->reflectance, amount(&side->direct), amount(&side->irradiance));
}

static PyObject *sides_list(const luxel_balance *balance)
{
    PyObject *list = PyList_New(0);

    for (size_t i = 0; list && i < balance->side_count; i++)
        if (append(list, side_tuple(&balance->sides[i])) < 0)
            Py_CLEAR(list);
    return list;
}

static PyObject *balance_tuple(const luxel_balance *balance)
{
    PyObject *sides = sides_list(balance);

    if (!sides)
        return NULL;
    return Py_BuildValue("(ssNNNNNNNNOO)", balance->unit, balance->flux_unit, sides,
                         balance->has_emitted ? amount(&balance->emitted) : none(),
                         balance->has_emitted ? amount(&balance->missed) : none(), amount(&balance->arrives),
                         amount(&balance->absorbed), amount(&balance->escaped), amount(&balance->pending),
                         amount(&balance->difference), balance->closes ? Py_True : Py_False,
                         balance->reached ? Py_True : Py_False);
}

/* None where the scene wants no reflected light. */
static PyObject *find_balance(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *settings;
    struct work work;
    luxel_balance *balance = NULL;
    const luxel_scene *scene;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OO", &handle, &settings) || !(scene = scene_of(module, handle)) ||
        !work_begin(&work, settings) || !(diagnostics = diagnostics_begin()))
        return NULL;
    work_leave(&work);
    const luxel_status status = luxel_find_balance(scene, &work.settings, diagnostics, &balance);

    work_return(&work);
    PyObject *found = NULL;

    if (diagnostics_end(&module_state(module)->language, status, diagnostics))
        found = balance ? balance_tuple(balance) : none();
    luxel_balance_free(balance);
    return found;
}

const PyMethodDef balance_functions[] = {
    FUNCTION("find_balance", find_balance, METH_VARARGS, "scene: SceneHandle, settings: _Settings, /",
             "Optional[Tuple[Any, ...]]"),
    {NULL, NULL, 0, NULL},
};
