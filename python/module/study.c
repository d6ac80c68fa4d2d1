/* SPDX-License-Identifier: MIT */
/* Studies: many scenes that are made of one by rules. */
#include <luxel/study.h>

#include <string.h>

#include "failure.h"

static void release_study(void *study)
{
    luxel_study_free(study);
}

static const luxel_study *study_of(PyObject *module, PyObject *holder)
{
    if (PyObject_TypeCheck(holder, module_state(module)->holder_type) &&
        ((struct holder_object *)holder)->release == release_study)
        return ((struct holder_object *)holder)->thing;
    PyErr_SetString(PyExc_TypeError, "a study is expected");
    return NULL;
}

static PyObject *names_list(const luxel_study *study)
{
    PyObject *list = PyList_New(0);

    for (size_t p = 0; list && p < luxel_study_parameter_count(study); p++) {
        char *name = luxel_study_parameter_name(study, p);

        if (append(list, text_or_none(name)) < 0)
            Py_CLEAR(list);
        luxel_text_free(name);
    }
    return list;
}

/* What a study is: itself, how many scenes it has, and a shard of it, its parameters, and all that its numbers depend
 * on. */
static PyObject *study_tuple(PyObject *module, luxel_study *study)
{
    char *identity = luxel_study_identity(study);
    PyObject *made = Py_BuildValue("(NKINN)", holder_new(module, study, release_study), luxel_study_count(study),
                                   luxel_study_shard(study), names_list(study), text_or_none(identity));

    luxel_text_free(identity);
    return made;
}

/* read_study(path, NULL), or of a text: (name, text). */
static PyObject *read_study(PyObject *module, PyObject *arguments)
{
    const char *name, *text;
    Py_ssize_t length;
    luxel_study *study = NULL;
    luxel_diagnostics *diagnostics;
    luxel_status status;

    if (!PyArg_ParseTuple(arguments, "yz#", &name, &text, &length) || !(diagnostics = diagnostics_begin()))
        return NULL;
    status = text ? luxel_study_read_text(text, (size_t)length, name, diagnostics, &study)
                  : luxel_study_read_file(name, diagnostics, &study);
    if (!diagnostics_end(&module_state(module)->language, status, diagnostics))
        return NULL;
    return study_tuple(module, study);
}

/* The numbers of scene i, or their words where they are indices of these. */
static PyObject *study_values(PyObject *module, PyObject *arguments)
{
    PyObject *holder, *list = NULL;
    unsigned long long i;
    const luxel_study *study;
    double *numbers;

    if (!PyArg_ParseTuple(arguments, "OK", &holder, &i) || !(study = study_of(module, holder)))
        return NULL;
    numbers = PyMem_Calloc(luxel_study_parameter_count(study) + 1, sizeof *numbers);
    if (!numbers)
        return PyErr_NoMemory();
    luxel_study_parameters(study, i, numbers);
    list = PyList_New(0);
    for (size_t p = 0; list && p < luxel_study_parameter_count(study); p++) {
        const char *word = luxel_study_parameter_word(study, p, (size_t)numbers[p]);

        if (append(list, word ? text_or_none(word) : PyFloat_FromDouble(numbers[p])) < 0)
            Py_CLEAR(list);
    }
    PyMem_Free(numbers);
    return list;
}

static PyObject *study_scene(PyObject *module, PyObject *arguments)
{
    PyObject *holder;
    unsigned long long i;
    const luxel_study *study;
    luxel_scene *scene = NULL;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OK", &holder, &i) || !(study = study_of(module, holder)) ||
        !(diagnostics = diagnostics_begin()))
        return NULL;
    const luxel_status status = luxel_study_scene(study, i, diagnostics, &scene);

    if (!diagnostics_end(&module_state(module)->language, status, diagnostics))
        return NULL;
    return scene_handle(module, scene);
}

const PyMethodDef study_functions[] = {
    FUNCTION("read_study", read_study, METH_VARARGS, "name: bytes, text: Optional[bytes], /", "Tuple[Any, ...]"),
    FUNCTION("study_values", study_values, METH_VARARGS, "study: Any, i: int, /", "List[Any]"),
    FUNCTION("study_scene", study_scene, METH_VARARGS, "study: Any, i: int, /", "SceneHandle"),
    {NULL, NULL, 0, NULL},
};
