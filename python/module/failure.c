/* SPDX-License-Identifier: MIT */
/*
 * Failures as exceptions.  What the library reports becomes a luxel.LuxelError, which luxel._errors makes of the status
 * and of a tuple for each entry; words are translated when it is raised.
 */
#include "failure.h"

#include <stdio.h>
#include <string.h>

/* The translation of a text, kept in the dictionary; a new reference, or NULL without an exception. */
static PyObject *translated(struct language *language, const char *english)
{
    PyObject *key = PyUnicode_FromFormat("%s:%s", language->code, english);
    PyObject *found = key ? PyDict_GetItemWithError(language->words, key) : NULL;

    Py_XINCREF(found);
    if (key && !found && !PyErr_Occurred()) {
        PyObject *translate = Py_NewRef(language->translate); /* another thread may set the language meanwhile */
        PyObject *words = PyObject_CallFunction(translate, "s", english);

        Py_DECREF(translate);
        found = words ? PyUnicode_AsUTF8String(words) : NULL;
        Py_XDECREF(words);
        if (found && PyDict_SetItem(language->words, key, found) < 0)
            Py_CLEAR(found);
    }
    Py_XDECREF(key);
    if (!found)
        PyErr_Clear();
    return found;
}

const char *language_translate(const char *english, void *data)
{
    struct language *language = data;
    const char *words = NULL;

    if (!*english)
        return english;
    PyGILState_STATE gil = PyGILState_Ensure();
    PyObject *found = language->translate ? translated(language, english) : NULL;

    if (found) {
        words = PyBytes_AsString(found); /* lives as long as the dictionary, which nothing is taken out of */
        Py_DECREF(found);
    }
    PyGILState_Release(gil);
    return words ? words : english;
}

/* In English, too, the library is handed a function, as by the tool: some words go by whether there is one. */
luxel_language language_of(struct language *language)
{
    return (luxel_language){.translate = language_translate, .data = language, .code = language->code};
}

PyObject *language_set(struct language *language, PyObject *arguments)
{
    const char *code;
    PyObject *translate;

    if (!PyArg_ParseTuple(arguments, "sO", &code, &translate))
        return NULL;
    if (!language->words && !(language->words = PyDict_New()))
        return NULL;
    PyObject *old = language->translate;

    snprintf(language->code, sizeof language->code, "%s", code);
    language->translate = translate == Py_None ? NULL : Py_NewRef(translate);
    Py_XDECREF(old);
    return none();
}

void language_clear(struct language *language)
{
    Py_CLEAR(language->translate);
    Py_CLEAR(language->words);
}

/* Takes a text of the library; NULL is a lack of memory. */
static PyObject *take_text(char *text)
{
    PyObject *taken = text ? PyUnicode_DecodeUTF8(text, (Py_ssize_t)strlen(text), "replace") : PyErr_NoMemory();

    luxel_text_free(text);
    return taken;
}

static PyObject *entry(struct language *language, const luxel_diagnostics *diagnostics, size_t i)
{
    const luxel_translate translate = language->translate ? language_translate : NULL;
    const luxel_diagnostic *one = luxel_diagnostics_get(diagnostics, i);
    PyObject *message = take_text(luxel_diagnostics_message(diagnostics, i, translate, language));
    PyObject *hint = message ? take_text(luxel_diagnostics_hint(diagnostics, i, translate, language)) : NULL;

    if (!hint) {
        Py_XDECREF(message);
        return NULL;
    }
    return Py_BuildValue("(sNNNNNIINII)", one->severity == LUXEL_SEVERITY_ERROR ? "error" : "advice",
                         text_or_none(one->id), message, hint, text_or_none(one->source), text_or_none(one->key),
                         one->line, one->column, text_or_none(one->excerpt), one->mark_offset, one->mark_length);
}

PyObject *diagnostics_list(struct language *language, const luxel_diagnostics *diagnostics)
{
    PyObject *list = PyList_New(0);

    for (size_t i = 0; list && i < luxel_diagnostics_count(diagnostics); i++)
        if (append(list, entry(language, diagnostics, i)) < 0)
            Py_CLEAR(list);
    return list;
}

luxel_diagnostics *diagnostics_begin(void)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();

    if (!diagnostics)
        PyErr_NoMemory();
    return diagnostics;
}

static void raise_failure(struct language *language, luxel_status status, const luxel_diagnostics *diagnostics)
{
    static const char *const words[] = {"", "argument", "path", "scene", "file", "memory", "range", "cancelled"};
    PyObject *errors = PyImport_ImportModule("luxel._errors");
    PyObject *list = errors ? diagnostics_list(language, diagnostics) : NULL;
    const size_t total = luxel_diagnostics_total(diagnostics, LUXEL_SEVERITY_ERROR);
    PyObject *error =
        list ? PyObject_CallMethod(errors, "make_error", "sNn", words[status], list, (Py_ssize_t)total) : NULL;

    if (error)
        PyErr_SetObject((PyObject *)Py_TYPE(error), error);
    Py_XDECREF(error);
    Py_XDECREF(errors);
}

/* Warns of bounds of reflected light that were missed, which is advice of the library. */
static void warn_of_bounds(struct language *language, const luxel_diagnostics *diagnostics)
{
    for (size_t i = 0; i < luxel_diagnostics_count(diagnostics) && !PyErr_Occurred(); i++) {
        const char *id = luxel_diagnostics_get(diagnostics, i)->id;

        if (strcmp(id, "reflected-error") != 0 && strcmp(id, "balance-error") != 0)
            continue;
        const luxel_translate translate = language->translate ? language_translate : NULL;
        PyObject *message = take_text(luxel_diagnostics_message(diagnostics, i, translate, language));
        PyObject *errors = message ? PyImport_ImportModule("luxel._errors") : NULL;
        PyObject *done = errors ? PyObject_CallMethod(errors, "warn", "O", message) : NULL;

        Py_XDECREF(done);
        Py_XDECREF(errors);
        Py_XDECREF(message);
    }
}

bool diagnostics_end(struct language *language, luxel_status status, luxel_diagnostics *diagnostics)
{
    if (status != LUXEL_OK && !PyErr_Occurred())
        raise_failure(language, status, diagnostics);
    if (status == LUXEL_OK)
        warn_of_bounds(language, diagnostics);
    luxel_diagnostics_free(diagnostics);
    return status == LUXEL_OK && !PyErr_Occurred();
}
