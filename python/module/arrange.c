/* SPDX-License-Identifier: MIT */
/* Layouts of luminaires that reach goals. */
#include <luxel/arrange.h>

#include "failure.h"
#include "inverse.h"
#include "work.h"

static PyObject *limits_of(const luxel_layout *layout)
{
    PyObject *list = PyList_New(0);

    for (size_t i = 0; list && i < layout->limit_count; i++) {
        const luxel_layout_limit *of = &layout->limits[i];

        if (append(list, Py_BuildValue("(NnN)", PyBool_FromLong(of->is_observer), (Py_ssize_t)of->index,
                                       limits_list(&of->limit, 1))) < 0)
            Py_CLEAR(list);
    }
    return list;
}

/* The numbers of keys by their names; empty where there are none. */
static PyObject *numbers_of(const luxel_arrangement *found, const luxel_layout *layout)
{
    PyObject *numbers = PyDict_New();

    for (size_t k = 0; numbers && k < found->number_count; k++) {
        PyObject *number = PyFloat_FromDouble(layout->numbers[k]);

        if (!number || PyDict_SetItemString(numbers, found->names[k], number) < 0)
            Py_CLEAR(numbers);
        Py_XDECREF(number);
    }
    return numbers;
}

static PyObject *layouts_list(PyObject *module, const luxel_arrangement *found, const luxel_layout *layouts,
                              size_t count)
{
    PyObject *list = PyList_New(0);

    for (size_t i = 0; list && i < count; i++) {
        const luxel_layout *layout = &layouts[i];

        if (append(list, Py_BuildValue("((II)(dd)ddNNN)", layout->n[0], layout->n[1], layout->spacing_mm[0],
                                       layout->spacing_mm[1], layout->dimming, layout->reserve, limits_of(layout),
                                       scene_handle(module, luxel_scene_copy(luxel_arrangement_scene(found, layout))),
                                       numbers_of(found, layout))) < 0)
            Py_CLEAR(list);
    }
    return list;
}

/* arrange(scene, goals, keys, (light, dims, is_even, most), settings): the light, what was found, what was missed, how
 * many were tried. */
static PyObject *arrange(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *list, *key_list, *settings, *result = NULL;
    luxel_arranging wanted = {.goals = NULL};
    int dims, even;
    struct work work;
    luxel_arrangement *found = NULL;
    luxel_diagnostics *diagnostics;
    const luxel_scene *scene;
    const char **goals, **keys = NULL;

    if (!PyArg_ParseTuple(arguments, "OOO(zppI)O", &handle, &list, &key_list, &wanted.light, &dims, &even, &wanted.most,
                          &settings) ||
        !(scene = scene_of(module, handle)) || !(goals = keys_of(list, &wanted.goal_count)))
        return NULL;
    if (!(keys = keys_of(key_list, &wanted.key_count))) {
        PyMem_Free(goals);
        return NULL;
    }
    wanted.goals = goals;
    wanted.keys = keys;
    wanted.dims = dims;
    wanted.is_even = even;
    if (!work_begin(&work, settings) || !(diagnostics = diagnostics_begin())) {
        PyMem_Free(goals);
        PyMem_Free(keys);
        return NULL;
    }
    work_leave(&work);
    const luxel_status status = luxel_arrange(scene, &work.settings, &wanted, diagnostics, &found);

    work_return(&work);
    PyMem_Free(goals);
    PyMem_Free(keys);
    if (diagnostics_end(&module_state(module)->language, status, diagnostics))
        result =
            Py_BuildValue("(nNNInn)", (Py_ssize_t)found->light, layouts_list(module, found, found->found, found->count),
                          layouts_list(module, found, found->missed, found->missed_count), found->fewest,
                          (Py_ssize_t)found->tried, (Py_ssize_t)found->computed);
    luxel_arrangement_free(found);
    return result;
}

const PyMethodDef arrange_functions[] = {
    FUNCTION("arrange", arrange, METH_VARARGS,
             "scene: SceneHandle, goals: List[str], keys: List[str], how: Tuple[Optional[str], bool, bool, int], "
             "settings: _Settings, /",
             "Tuple[Any, ...]"),
    {NULL, NULL, 0, NULL},
};
