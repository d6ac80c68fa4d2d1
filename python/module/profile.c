/* SPDX-License-Identifier: MIT */
/* Profiles along lines of the screen and great circles, and the difference of two pictures. */
#include <stddef.h>

#include "failure.h"
#include "work.h"

static PyObject *line_across(PyObject *module, PyObject *arguments)
{
    PyObject *handle;
    double through[2], degrees, from[2], to[2];
    const luxel_scene *scene;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "Oddd", &handle, &through[0], &through[1], &degrees) ||
        !(scene = scene_of(module, handle)) || !(diagnostics = diagnostics_begin()))
        return NULL;
    const luxel_status status = luxel_profile_line(scene, through, degrees, diagnostics, from, to);

    if (!diagnostics_end(&module_state(module)->language, status, diagnostics))
        return NULL;
    return Py_BuildValue("(dddd)", from[0], from[1], to[0], to[1]);
}

static void release_profile(void *profile)
{
    luxel_profile_free(profile);
}

/* A member of the samples as a view. */
static PyObject *column(PyObject *module, PyObject *holder, const luxel_profile *profile, const char *format,
                        size_t offset)
{
    const struct view_layout layout = {.data = (const char *)profile->samples + offset,
                                       .format = format,
                                       .rows = (Py_ssize_t)profile->count,
                                       .stride = (Py_ssize_t)sizeof *profile->samples};

    return view_new(module, holder, &layout);
}

/* Takes the profile. */
static PyObject *profile_tuple(PyObject *module, luxel_profile *profile)
{
    PyObject *holder = holder_new(module, profile, release_profile);

    if (!holder)
        return NULL;
    const struct view_layout shares = {.data = profile->shares,
                                       .format = "d",
                                       .rows = (Py_ssize_t)profile->count,
                                       .columns = (Py_ssize_t)profile->lights};
    PyObject *tuple =
        Py_BuildValue("(NNNNNNN)", column(module, holder, profile, "d", offsetof(luxel_profile_sample, abscissa)),
                      column(module, holder, profile, "d", offsetof(luxel_profile_sample, x_mm)),
                      column(module, holder, profile, "d", offsetof(luxel_profile_sample, y_mm)),
                      column(module, holder, profile, "?", offsetof(luxel_profile_sample, has_value)),
                      column(module, holder, profile, "d", offsetof(luxel_profile_sample, value)),
                      column(module, holder, profile, "d", offsetof(luxel_profile_sample, error)),
                      profile->lights > 0 ? view_new(module, holder, &shares) : none());

    Py_DECREF(holder);
    return tuple;
}

static PyObject *finish(PyObject *module, luxel_status status, luxel_profile *profile, luxel_diagnostics *diagnostics)
{
    if (diagnostics_end(&module_state(module)->language, status, diagnostics))
        return profile_tuple(module, profile);
    luxel_profile_free(profile);
    return NULL;
}

/* False: an exception is set. */
static bool path_of(PyObject *tuple, luxel_profile_path *path)
{
    int arc;
    Py_ssize_t samples;

    if (!is_tuple(tuple) || !PyArg_ParseTuple(tuple, "pddddn", &arc, &path->from_mm[0], &path->from_mm[1],
                                              &path->to_mm[0], &path->to_mm[1], &samples))
        return false;
    path->type = arc ? LUXEL_PATH_ARC : LUXEL_PATH_LINE;
    path->samples = samples < 0 ? 0 : (size_t)samples;
    return true;
}

static PyObject *scene_profile(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *tuple, *settings;
    struct work work;
    luxel_profile_path path = {.samples = 0};
    luxel_evaluator *evaluator = NULL;
    luxel_profile *profile = NULL;
    const luxel_scene *scene;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OOO", &handle, &tuple, &settings) || !(scene = scene_of(module, handle)) ||
        !path_of(tuple, &path) || !work_begin(&work, settings) || !(diagnostics = diagnostics_begin()))
        return NULL;
    work_leave(&work);
    luxel_status status = luxel_evaluator_new(scene, &work.settings, diagnostics, &evaluator);

    if (status == LUXEL_OK)
        status = luxel_find_profile(evaluator, &path, diagnostics, &profile);
    luxel_evaluator_free(evaluator);
    work_return(&work);
    return finish(module, status, profile, diagnostics);
}

static PyObject *field_profile(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *tuple;
    luxel_profile_path path = {.samples = 0};
    luxel_profile *profile = NULL;
    const luxel_field *field;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OO", &handle, &tuple) || !(field = field_of(module, handle)) ||
        !path_of(tuple, &path) || !(diagnostics = diagnostics_begin()))
        return NULL;
    const luxel_status status = luxel_field_profile(field, &path, diagnostics, &profile);

    return finish(module, status, profile, diagnostics);
}

static PyObject *compare(PyObject *module, PyObject *arguments)
{
    PyObject *first, *second, *type;
    luxel_comparison found;
    luxel_field *difference = NULL;
    const luxel_field *a, *b;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OOO", &first, &second, &type) || !(a = field_of(module, first)) ||
        !(b = field_of(module, second)) || !(diagnostics = diagnostics_begin()))
        return NULL;
    const luxel_status status = luxel_compare(a, b, diagnostics, &found, &difference);

    if (!diagnostics_end(&module_state(module)->language, status, diagnostics)) {
        luxel_field_free(difference);
        return NULL;
    }
    PyObject *field = field_handle(module, type, difference, NULL);

    if (!field)
        return NULL;
    return Py_BuildValue("(nnnNddddddddN)", (Py_ssize_t)found.pixels, (Py_ssize_t)found.only_a,
                         (Py_ssize_t)found.only_b, extremum_tuple(&found.largest), found.a, found.b, found.mean,
                         found.mean_magnitude, found.rms, found.scale, found.largest_relative, found.rms_relative,
                         field);
}

const PyMethodDef profile_functions[] = {
    FUNCTION("line_across", line_across, METH_VARARGS, "scene: SceneHandle, x: float, y: float, degrees: float, /",
             "Tuple[float, float, float, float]"),
    FUNCTION("scene_profile", scene_profile, METH_VARARGS,
             "scene: SceneHandle, path: Tuple[bool, float, float, float, float, int], settings: _Settings, /",
             "Tuple[Any, ...]"),
    FUNCTION("field_profile", field_profile, METH_VARARGS,
             "field: FieldHandle, path: Tuple[bool, float, float, float, float, int], /", "Tuple[Any, ...]"),
    FUNCTION("compare", compare, METH_VARARGS, "a: FieldHandle, b: FieldHandle, type: Type[FieldHandle], /",
             "Tuple[Any, ...]"),
    {NULL, NULL, 0, NULL},
};
