/* SPDX-License-Identifier: MIT */
/* Rendering to a field or to files, without the interpreter's lock. */
#include "failure.h"
#include "work.h"

static PyObject *render(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *type, *settings;
    struct work work;
    const luxel_scene *scene;
    luxel_field *field = NULL;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OOO", &handle, &type, &settings) || !(scene = scene_of(module, handle)) ||
        !work_begin(&work, settings) || !(diagnostics = diagnostics_begin()))
        return NULL;
    work_leave(&work);
    const luxel_status status = luxel_render(scene, &work.settings, diagnostics, &field);

    work_return(&work);
    if (diagnostics_end(&module_state(module)->language, status, diagnostics))
        return field_handle(module, type, field, handle);
    luxel_field_free(field);
    return NULL;
}

/* The names of a list of bytes, which must live as long; the array is the caller's.  NULL: an exception is set. */
static const char **names_of(PyObject *list, size_t *count)
{
    const Py_ssize_t size = PyList_Size(list);
    const char **names = size < 0 ? NULL : PyMem_Calloc((size_t)size + 1, sizeof *names);

    if (size >= 0 && !names)
        PyErr_NoMemory();
    for (Py_ssize_t i = 0; names && i < size; i++) {
        names[i] = PyBytes_AsString(PyList_GetItem(list, i));
        if (!names[i]) {
            PyMem_Free((void *)names);
            return NULL;
        }
    }
    *count = (size_t)size;
    return names;
}

static PyObject *render_files(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *list, *settings;
    struct work work;
    luxel_field_output how = {0};
    luxel_statistics statistics;
    size_t count;
    const luxel_scene *scene;
    const char **names;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OOIO", &handle, &list, &how.bits, &settings) ||
        !(scene = scene_of(module, handle)) || !work_begin(&work, settings) || !(names = names_of(list, &count)))
        return NULL;
    if (!(diagnostics = diagnostics_begin())) {
        PyMem_Free((void *)names);
        return NULL;
    }
    work_leave(&work);
    const luxel_status status = luxel_render_files(scene, &work.settings, names, count, &how, diagnostics, &statistics);

    work_return(&work);
    PyMem_Free((void *)names);
    return diagnostics_end(&module_state(module)->language, status, diagnostics) ? statistics_tuple(&statistics) : NULL;
}

static PyObject *instruction_sets(PyObject *module, PyObject *unused)
{
    PyObject *list = PyList_New(0);

    (void)module;
    (void)unused;
    for (size_t i = 0; list && luxel_instruction_set_name(i); i++)
        if (luxel_instruction_set_runs(i) && append(list, text_or_none(luxel_instruction_set_name(i))) < 0)
            Py_CLEAR(list);
    return list;
}

const PyMethodDef render_functions[] = {
    FUNCTION("render", render, METH_VARARGS, "scene: SceneHandle, type: Type[_Field], settings: _Settings, /",
             "_Field"),
    FUNCTION("render_files", render_files, METH_VARARGS,
             "scene: SceneHandle, paths: List[bytes], bits: int, settings: _Settings, /", "Tuple[Any, ...]"),
    FUNCTION("instruction_sets", instruction_sets, METH_NOARGS, "", "List[str]"),
    {NULL, NULL, 0, NULL},
};
