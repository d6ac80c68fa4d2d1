/* SPDX-License-Identifier: MIT */
/* Changing scenes: each change makes a new handle, so whoever computes with the old one is not disturbed. */
#include "failure.h"

/*
 * One edit, a tuple of five: "set" and an assignment, "remove" and a key, "insert" with list, index and value, "move"
 * with list, from and to; what an edit does not have is 0 or None.
 */
static luxel_status apply(luxel_scene *scene, PyObject *edit, luxel_diagnostics *diagnostics)
{
    const char *kind, *key, *value = NULL;
    Py_ssize_t from = 0, to = 0;

    if (!is_tuple(edit) || !PyArg_ParseTuple(edit, "ssnnz", &kind, &key, &from, &to, &value))
        return LUXEL_ERROR_ARGUMENT;
    if (from < 0 || to < 0) {
        PyErr_SetString(PyExc_IndexError, "an index is negative");
        return LUXEL_ERROR_ARGUMENT;
    }
    switch (*kind) {
    case 's': return luxel_scene_set(scene, key, diagnostics);
    case 'r': return luxel_scene_remove(scene, key, diagnostics);
    case 'i': return luxel_scene_insert(scene, key, (size_t)from, value, diagnostics);
    default: return luxel_scene_move(scene, key, (size_t)from, (size_t)to, diagnostics);
    }
}

/* Goes on after an error, to report all of them; a path that names nothing weighs most. */
static luxel_status apply_all(luxel_scene *scene, PyObject *edits, luxel_diagnostics *diagnostics)
{
    luxel_status worst = LUXEL_OK;

    for (Py_ssize_t i = 0; i < PyList_Size(edits) && !PyErr_Occurred(); i++) {
        const luxel_status status = apply(scene, PyList_GetItem(edits, i), diagnostics);

        if (status != LUXEL_OK && (worst == LUXEL_OK || status == LUXEL_ERROR_PATH))
            worst = status;
    }
    if (PyErr_Occurred())
        return LUXEL_ERROR_ARGUMENT;
    luxel_status status;

    Py_BEGIN_ALLOW_THREADS
    status = luxel_scene_commit(scene, diagnostics);
    Py_END_ALLOW_THREADS
    return worst == LUXEL_OK ? status : worst;
}

static PyObject *scene_change(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *edits;
    const luxel_scene *scene;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OO", &handle, &edits) || !(scene = scene_of(module, handle)))
        return NULL;
    if (!PyList_Check(edits)) {
        PyErr_SetString(PyExc_TypeError, "edits are a list");
        return NULL;
    }
    luxel_scene *copy = luxel_scene_copy(scene);

    if (!copy)
        return PyErr_NoMemory();
    if (!(diagnostics = diagnostics_begin())) {
        luxel_scene_free(copy);
        return NULL;
    }
    const luxel_status status = apply_all(copy, edits, diagnostics);

    if (diagnostics_end(&module_state(module)->language, status, diagnostics))
        return scene_handle(module, copy);
    luxel_scene_free(copy);
    return NULL;
}

static PyObject *scene_write(PyObject *module, PyObject *arguments)
{
    PyObject *handle;
    const char *path;
    const luxel_scene *scene;
    luxel_diagnostics *diagnostics;
    luxel_status status;

    if (!PyArg_ParseTuple(arguments, "Oy", &handle, &path) || !(scene = scene_of(module, handle)) ||
        !(diagnostics = diagnostics_begin()))
        return NULL;
    Py_BEGIN_ALLOW_THREADS
    status = luxel_scene_write_file(scene, path, diagnostics);
    Py_END_ALLOW_THREADS
    return diagnostics_end(&module_state(module)->language, status, diagnostics) ? none() : NULL;
}

const PyMethodDef edit_functions[] = {
    FUNCTION("scene_change", scene_change, METH_VARARGS,
             "scene: SceneHandle, edits: List[Tuple[str, str, int, int, Optional[str]]], /", "SceneHandle"),
    FUNCTION("scene_write", scene_write, METH_VARARGS, "scene: SceneHandle, path: bytes, /", "None"),
    {NULL, NULL, 0, NULL},
};
