/* SPDX-License-Identifier: MIT */
/* Explanations of values as documents in the user's language. */
#include "failure.h"
#include "work.h"

static void release_document(void *document)
{
    luxel_document_free(document);
}

static PyObject *explain(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *settings;
    double x, y;
    struct work work;
    struct language *language = &module_state(module)->language;
    luxel_document *document = NULL;
    const luxel_scene *scene;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OddO", &handle, &x, &y, &settings) || !(scene = scene_of(module, handle)) ||
        !work_begin(&work, settings) || !(diagnostics = diagnostics_begin()))
        return NULL;
    const luxel_language words = language_of(language);

    work_leave(&work);
    const luxel_status status = luxel_explain(scene, &work.settings, x, y, &words, diagnostics, &document);

    work_return(&work);
    if (diagnostics_end(language, status, diagnostics))
        return holder_new(module, document, release_document);
    luxel_document_free(document);
    return NULL;
}

static luxel_document *document_of(PyObject *module, PyObject *holder)
{
    if (PyObject_TypeCheck(holder, module_state(module)->holder_type) &&
        ((struct holder_object *)holder)->release == release_document)
        return ((struct holder_object *)holder)->thing;
    PyErr_SetString(PyExc_TypeError, "a document is expected");
    return NULL;
}

/* As text, Markdown, LaTeX or HTML: 0 to 3. */
static PyObject *document_text(PyObject *module, PyObject *arguments)
{
    PyObject *holder;
    int format;
    const luxel_document *document;

    if (!PyArg_ParseTuple(arguments, "Oi", &holder, &format) || !(document = document_of(module, holder)))
        return NULL;
    char *text = luxel_document_write_text(document, (luxel_document_format)format);

    if (!text)
        return PyErr_NoMemory();
    PyObject *words = text_or_none(text);

    luxel_text_free(text);
    return words;
}

static PyObject *document_write(PyObject *module, PyObject *arguments)
{
    PyObject *holder;
    const char *path;
    const luxel_document *document;
    luxel_diagnostics *diagnostics;
    luxel_status status;

    if (!PyArg_ParseTuple(arguments, "Oy", &holder, &path) || !(document = document_of(module, holder)) ||
        !(diagnostics = diagnostics_begin()))
        return NULL;
    Py_BEGIN_ALLOW_THREADS
    status = luxel_document_write(document, path, diagnostics);
    Py_END_ALLOW_THREADS
    return diagnostics_end(&module_state(module)->language, status, diagnostics) ? none() : NULL;
}

const PyMethodDef document_functions[] = {
    FUNCTION("explain", explain, METH_VARARGS, "scene: SceneHandle, x: float, y: float, settings: _Settings, /",
             "Holder"),
    FUNCTION("document_text", document_text, METH_VARARGS, "document: Holder, format: int, /", "str"),
    FUNCTION("document_write", document_write, METH_VARARGS, "document: Holder, path: bytes, /", "None"),
    {NULL, NULL, 0, NULL},
};
