/* SPDX-License-Identifier: MIT */
/* Fits of scenes to readings, without the interpreter's lock. */
#include <stdlib.h>

#include "failure.h"
#include "inverse.h"
#include "work.h"

static PyObject *parameters_list(const luxel_fit *fit)
{
    PyObject *list = PyList_New(0);

    for (size_t i = 0; list && i < fit->count; i++) {
        const luxel_fit_parameter *parameter = &fit->parameters[i];

        if (append(list, Py_BuildValue("(ssNNNNN)", parameter->key, parameter->unit,
                                       number_or_none(parameter->is_determined, parameter->value),
                                       number_or_none(parameter->has_errors, parameter->sd),
                                       number_or_none(parameter->has_errors, parameter->low),
                                       number_or_none(parameter->has_errors, parameter->high),
                                       PyBool_FromLong(parameter->is_at_limit))) < 0)
            Py_CLEAR(list);
    }
    return list;
}

static PyObject *numbers_list(const double *numbers, size_t count)
{
    PyObject *list = PyList_New(0);

    for (size_t i = 0; list && i < count; i++)
        if (append(list, PyFloat_FromDouble(numbers[i])) < 0)
            Py_CLEAR(list);
    return list;
}

static PyObject *undetermined_list(const luxel_fit *fit, struct language *language)
{
    PyObject *list = PyList_New(0);

    for (size_t i = 0; list && i < fit->undetermined; i++) {
        char *words = luxel_fit_undetermined(fit, i, language_translate, language);

        if (append(list, PyUnicode_FromString(words ? words : "")) < 0)
            Py_CLEAR(list);
        luxel_text_free(words);
    }
    return list;
}

static PyObject *fit_tuple(PyObject *module, const luxel_fit *fit)
{
    return Py_BuildValue("(NnnnnnNddnNnnNNN)", parameters_list(fit), (Py_ssize_t)fit->rank, (Py_ssize_t)fit->readings,
                         (Py_ssize_t)fit->saturated, (Py_ssize_t)fit->without_derivative, (Py_ssize_t)fit->outliers,
                         PyBool_FromLong(fit->noise_is_estimated), fit->noise, fit->chi2, (Py_ssize_t)fit->dof,
                         numbers_list(fit->correlation, fit->count * fit->count), (Py_ssize_t)fit->starts,
                         (Py_ssize_t)fit->agreed, PyBool_FromLong(fit->has_converged),
                         undetermined_list(fit, &module_state(module)->language),
                         scene_handle(module, luxel_scene_copy(luxel_fit_scene(fit))));
}

/* The arrays of a call: places, or None for the pixels of a picture; a value of each, and what is left of it. */
enum { PLACES, VALUES, RESIDUALS, ARRAYS };

static bool take(PyObject *tuple, struct strided *arrays)
{
    static const char *const names[ARRAYS] = {"places", "values", "residuals"};
    PyObject *given[ARRAYS];

    if (!is_tuple(tuple) || !PyArg_ParseTuple(tuple, "OOO", &given[0], &given[1], &given[2]))
        return false;
    const bool is_picture = given[PLACES] == Py_None;

    for (int i = is_picture ? VALUES : PLACES; i < ARRAYS; i++) {
        if (!strided_take(given[i], names[i], i == PLACES || is_picture ? 2 : 1, i == RESIDUALS, &arrays[i]))
            return false;
        if (arrays[i].shape[0] != arrays[is_picture ? VALUES : PLACES].shape[0]) {
            PyErr_Format(PyExc_ValueError, "%s: as many rows as places are expected", names[i]);
            return false;
        }
    }
    return true;
}

/* noise, relative_noise, saturated, quantum, is_truncated, is_relative, loss, starts */
static bool take_how(PyObject *tuple, luxel_readings *readings)
{
    int truncated, relative, loss;

    if (!is_tuple(tuple) ||
        !PyArg_ParseTuple(tuple, "ddddppiI", &readings->noise, &readings->relative_noise, &readings->saturated,
                          &readings->quantum, &truncated, &relative, &loss, &readings->starts))
        return false;
    readings->is_truncated = truncated;
    readings->is_relative = relative;
    readings->loss = (luxel_loss)loss;
    return true;
}

/* What a fit works with, all of it plain C: the interpreter's lock is released. */
struct fitting {
    const luxel_scene *scene;
    const luxel_settings *settings;
    const struct strided *arrays;
    luxel_readings readings;
    const char *const *keys;
    size_t key_count;
    luxel_diagnostics *diagnostics;
    luxel_fit *found;
};

static luxel_status fit_places(struct fitting *fitting, size_t surface, double *values)
{
    luxel_place *places = places_of(&fitting->arrays[PLACES], surface);
    luxel_status status = LUXEL_ERROR_MEMORY;

    fitting->readings.places = places;
    fitting->readings.values = values;
    fitting->readings.count = (size_t)fitting->arrays[PLACES].shape[0];
    if (places)
        status = luxel_fit_readings(fitting->scene, fitting->settings, &fitting->readings, fitting->keys,
                                    fitting->key_count, fitting->diagnostics, &fitting->found);
    free(places);
    return status;
}

static luxel_status fit_picture(struct fitting *fitting, const double *values)
{
    const struct strided *array = &fitting->arrays[VALUES];
    const size_t count = (size_t)(array->shape[0] * array->shape[1]);
    unsigned char *mask = calloc(count + 1, 1);
    luxel_field *picture = NULL;

    if (!mask)
        return LUXEL_ERROR_MEMORY;
    memset(mask, 1, count);
    const luxel_field_content content = {.columns = (unsigned)array->shape[1],
                                         .rows = (unsigned)array->shape[0],
                                         .precision = LUXEL_DOUBLE,
                                         .values = values,
                                         .mask = mask};
    luxel_status status = luxel_field_of_values(&content, fitting->diagnostics, &picture);

    free(mask);
    if (status == LUXEL_OK)
        status = luxel_fit_picture(fitting->scene, fitting->settings, picture, &fitting->readings, fitting->keys,
                                   fitting->key_count, fitting->diagnostics, &fitting->found);
    luxel_field_free(picture);
    return status;
}

static luxel_status fit_all(struct fitting *fitting, size_t surface)
{
    const struct strided *from = &fitting->arrays[VALUES], *to = &fitting->arrays[RESIDUALS];
    const Py_ssize_t columns = from->shape[1], count = from->shape[0] * columns;
    double *values = calloc((size_t)count + 1, sizeof *values);
    luxel_status status = LUXEL_ERROR_MEMORY;

    for (Py_ssize_t i = 0; values && i < count; i++)
        values[i] = strided_get(from, i / columns, i % columns);
    if (values)
        status = fitting->arrays[PLACES].is_held ? fit_places(fitting, surface, values) : fit_picture(fitting, values);
    for (Py_ssize_t i = 0; status == LUXEL_OK && i < count; i++)
        strided_set(to, i / columns, i % columns, fitting->found->residuals[i]);
    free(values);
    return status;
}

static PyObject *fit(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *tuple, *list, *how, *settings, *result = NULL;
    Py_ssize_t surface;
    struct strided arrays[ARRAYS] = {{.is_held = false}};
    struct fitting fitting = {.arrays = arrays};
    struct work work;
    const luxel_scene *scene;
    luxel_diagnostics *diagnostics;
    luxel_status status = LUXEL_OK;
    const char **keys;

    if (!PyArg_ParseTuple(arguments, "OOOnOO", &handle, &list, &tuple, &surface, &how, &settings) ||
        !(scene = scene_of(module, handle)) || !take_how(how, &fitting.readings) ||
        !(keys = keys_of(list, &fitting.key_count)))
        return NULL;
    if (!work_begin(&work, settings) || !(diagnostics = diagnostics_begin())) {
        PyMem_Free(keys);
        return NULL;
    }
    if (take(tuple, arrays)) {
        fitting.scene = scene;
        fitting.settings = &work.settings;
        fitting.keys = keys;
        fitting.diagnostics = diagnostics;
        work_leave(&work);
        status = fit_all(&fitting, (size_t)surface);
        work_return(&work);
    }
    for (int i = 0; i < ARRAYS; i++)
        strided_release(&arrays[i]);
    PyMem_Free(keys);
    if (diagnostics_end(&module_state(module)->language, status, diagnostics))
        result = fit_tuple(module, fitting.found);
    luxel_fit_free(fitting.found);
    return result;
}

const PyMethodDef fit_functions[] = {
    FUNCTION("fit", fit, METH_VARARGS,
             "scene: SceneHandle, keys: List[str], arrays: Tuple[Any, ...], surface: int, how: Tuple[Any, ...], "
             "settings: _Settings, /",
             "Tuple[Any, ...]"),
    {NULL, NULL, 0, NULL},
};
