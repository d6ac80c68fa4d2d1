/* SPDX-License-Identifier: MIT */
/* The unified glare rating of observers in a scene. */
#include <luxel/glare.h>

#include "failure.h"
#include "work.h"

static PyObject *source_tuple(const luxel_glare_source *source)
{
    return Py_BuildValue("(nsNidddNdN)", (Py_ssize_t)source->light, source->type, text_or_none(source->name),
                         (int)source->reason, source->luminance, source->solid_angle, source->seen,
                         number_or_none(source->position_index == source->position_index, source->position_index),
                         source->share, source->places > 1 ? PyLong_FromSize_t(source->place) : none());
}

PyObject *glare_tuple(const luxel_glare *glare)
{
    PyObject *sources = PyList_New(0);

    for (size_t i = 0; sources && i < glare->source_count; i++)
        if (append(sources, source_tuple(&glare->sources[i])) < 0)
            Py_CLEAR(sources);
    if (!sources)
        return NULL;
    return Py_BuildValue("(NN(dd)NO)", number_or_none(glare->has_rating, glare->rating.value),
                         number_or_none(glare->has_rating, glare->rating.error), glare->background.value,
                         glare->background.error, sources, glare->reached ? Py_True : Py_False);
}

/* rate_glare(scene, (eye, view, up), settings): what an observer sees; `up` of 0, 0, 0 leaves it to the scene. */
static PyObject *rate_glare(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *settings;
    luxel_glare_sight sight = {.eye_mm = {0}};
    struct work work;
    luxel_glare *glare = NULL;
    const luxel_scene *scene;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "O((ddd)(ddd)(ddd))O", &handle, &sight.eye_mm[0], &sight.eye_mm[1],
                          &sight.eye_mm[2], &sight.view[0], &sight.view[1], &sight.view[2], &sight.up[0], &sight.up[1],
                          &sight.up[2], &settings) ||
        !(scene = scene_of(module, handle)) || !work_begin(&work, settings) || !(diagnostics = diagnostics_begin()))
        return NULL;
    work_leave(&work);
    const luxel_status status = luxel_find_glare(scene, &work.settings, &sight, diagnostics, &glare);

    work_return(&work);
    PyObject *found = NULL;

    if (diagnostics_end(&module_state(module)->language, status, diagnostics))
        found = glare_tuple(glare);
    luxel_glare_free(glare);
    return found;
}

/* The English words of each reason why a light counts or does not. */
static PyObject *glare_reasons(PyObject *module, PyObject *unused)
{
    PyObject *list = PyList_New(0);
    const char *words;

    (void)module;
    (void)unused;
    for (int i = 0; list && (words = luxel_glare_reason_words((luxel_glare_reason)i)) != NULL; i++)
        if (append(list, PyUnicode_FromString(words)) < 0)
            Py_CLEAR(list);
    return list;
}

const PyMethodDef glare_functions[] = {
    FUNCTION("rate_glare", rate_glare, METH_VARARGS,
             "scene: SceneHandle, sight: Tuple[Any, ...], settings: _Settings, /", "Tuple[Any, ...]"),
    FUNCTION("glare_reasons", glare_reasons, METH_NOARGS, "", "List[str]"),
    {NULL, NULL, 0, NULL},
};
