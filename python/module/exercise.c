/* SPDX-License-Identifier: MIT */
/* The exercise: its variants, the values that other conventions give, and the judgement of answers. */
#include "failure.h"
#include "work.h"

static PyObject *variant_text(PyObject *module, PyObject *arguments)
{
    unsigned number;
    char *text = NULL;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "I", &number) || !(diagnostics = diagnostics_begin()))
        return NULL;
    const luxel_status status = luxel_variant_text(number, diagnostics, &text);
    PyObject *words = NULL;

    if (diagnostics_end(&module_state(module)->language, status, diagnostics))
        words = text_or_none(text);
    luxel_text_free(text);
    return words;
}

static PyObject *scene_schema(PyObject *module, PyObject *unused)
{
    char *text = NULL;

    (void)module;
    (void)unused;
    if (luxel_scene_schema(&text) != LUXEL_OK)
        return PyErr_NoMemory();
    PyObject *words = text_or_none(text);

    luxel_text_free(text);
    return words;
}

/* In words of the user's language. */
static PyObject *words(struct language *language, const char *english)
{
    return text_or_none(english && language->translate ? language_translate(english, language) : english);
}

static PyObject *alternatives_list(struct language *language, const luxel_alternative *alternatives, size_t count)
{
    PyObject *list = PyList_New(0);

    for (size_t i = 0; list && i < count; i++) {
        const luxel_alternative *one = &alternatives[i];

        if (append(list, Py_BuildValue("(NNNNONN)", words(language, one->convention), words(language, one->choice),
                                       words(language, one->meaning), text_or_none(one->assignment),
                                       one->is_present ? Py_True : Py_False, number_or_none(one->has_value, one->value),
                                       number_or_none(one->has_value, one->error))) < 0)
            Py_CLEAR(list);
    }
    return list;
}

static PyObject *find_alternatives(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *settings;
    double x, y;
    struct work work;
    struct language *language = &module_state(module)->language;
    luxel_alternatives *alternatives = NULL;
    const luxel_scene *scene;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OddO", &handle, &x, &y, &settings) || !(scene = scene_of(module, handle)) ||
        !work_begin(&work, settings) || !(diagnostics = diagnostics_begin()))
        return NULL;
    work_leave(&work);
    const luxel_status status = luxel_find_alternatives(scene, &work.settings, x, y, diagnostics, &alternatives);

    work_return(&work);
    PyObject *list = NULL;

    if (diagnostics_end(language, status, diagnostics))
        list = alternatives_list(language, alternatives->list, alternatives->count);
    luxel_alternatives_free(alternatives);
    return list;
}

static PyObject *judge(PyObject *module, PyObject *arguments)
{
    static const char *const verdicts[] = {"right", "convention", "wrong", "coarse"};
    PyObject *handle, *settings;
    double x, y, answer, tolerance, rounding;
    struct work work;
    struct language *language = &module_state(module)->language;
    luxel_judgement *judgement = NULL;
    const luxel_scene *scene;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OdddddO", &handle, &x, &y, &answer, &tolerance, &rounding, &settings) ||
        !(scene = scene_of(module, handle)) || !work_begin(&work, settings) || !(diagnostics = diagnostics_begin()))
        return NULL;
    work_leave(&work);
    const luxel_status status =
        luxel_judge_answer(scene, &work.settings, x, y, answer, tolerance, rounding, diagnostics, &judgement);

    work_return(&work);
    PyObject *tuple = NULL;

    if (diagnostics_end(language, status, diagnostics)) {
        PyObject *reasons = alternatives_list(language, judgement->explanations, judgement->explanation_count);

        if (reasons)
            tuple = Py_BuildValue("(sNNN)", verdicts[judgement->verdict],
                                  number_or_none(judgement->has_value, judgement->value),
                                  number_or_none(judgement->has_value, judgement->error), reasons);
    }
    luxel_judgement_free(judgement);
    return tuple;
}

const PyMethodDef exercise_functions[] = {
    FUNCTION("variant_text", variant_text, METH_VARARGS, "number: int, /", "str"),
    FUNCTION("scene_schema", scene_schema, METH_NOARGS, "", "str"),
    FUNCTION("find_alternatives", find_alternatives, METH_VARARGS,
             "scene: SceneHandle, x: float, y: float, settings: _Settings, /", "List[Tuple[Any, ...]]"),
    FUNCTION("judge", judge, METH_VARARGS,
             "scene: SceneHandle, x: float, y: float, answer: float, tolerance: float, rounding: float, "
             "settings: _Settings, /",
             "Tuple[str, Optional[float], Optional[float], List[Tuple[Any, ...]]]"),
    {NULL, NULL, 0, NULL},
};
