/* SPDX-License-Identifier: MIT */
/*
 * What is read off pictures: summaries, histograms, extrema, lines of equal value, profiles, differences.  What is
 * exact is found with an evaluator of the settings given; None in their place reads it off the picture alone.
 */
#include "failure.h"
#include "work.h"

/* A region from None, (x, y, width, height) or (x, y, radius); *given is NULL for None.  False: an exception is set. */
static bool region_of(PyObject *tuple, luxel_region *region, const luxel_region **given)
{
    *region = (luxel_region){0};
    *given = tuple == Py_None ? NULL : region;
    if (tuple == Py_None)
        return true;
    if (!is_tuple(tuple))
        return false;
    if (PyTuple_Size(tuple) == 3) {
        region->type = LUXEL_REGION_CIRCLE;
        return PyArg_ParseTuple(tuple, "ddd", &region->center_mm[0], &region->center_mm[1], &region->radius_mm);
    }
    region->type = LUXEL_REGION_RECTANGLE;
    return PyArg_ParseTuple(tuple, "dddd", &region->center_mm[0], &region->center_mm[1], &region->size_mm[0],
                            &region->size_mm[1]);
}

static PyObject *field_summary(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *tuple;
    luxel_region region;
    const luxel_region *given;
    luxel_summary summary;
    const luxel_field *field;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OO", &handle, &tuple) || !(field = field_of(module, handle)) ||
        !region_of(tuple, &region, &given) || !(diagnostics = diagnostics_begin()))
        return NULL;
    const luxel_status status = luxel_field_summary(field, given, diagnostics, &summary);

    if (!diagnostics_end(&module_state(module)->language, status, diagnostics))
        return NULL;
    return Py_BuildValue("(nNNddddNN)", (Py_ssize_t)summary.pixels, extremum_tuple(&summary.maximum),
                         extremum_tuple(&summary.minimum), summary.mean, summary.median, summary.standard_deviation,
                         summary.lit, number_or_none(summary.has_evenness, summary.u0),
                         number_or_none(summary.has_evenness, summary.ud));
}

static PyObject *histogram_lists(const luxel_histogram *histogram)
{
    PyObject *edges = PyList_New(0), *counts = PyList_New(0);

    for (size_t i = 0; edges && counts && i <= histogram->bins; i++)
        if (append(edges, PyFloat_FromDouble(histogram->edges[i])) < 0 ||
            (i < histogram->bins && append(counts, PyLong_FromSize_t(histogram->counts[i])) < 0))
            Py_CLEAR(edges);
    if (edges && counts)
        return Py_BuildValue("(NNnnn)", edges, counts, (Py_ssize_t)histogram->below, (Py_ssize_t)histogram->above,
                             (Py_ssize_t)histogram->pixels);
    Py_XDECREF(edges);
    Py_XDECREF(counts);
    return NULL;
}

static PyObject *field_histogram(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *tuple;
    int logarithmic;
    double low, high;
    Py_ssize_t bins;
    luxel_region region;
    const luxel_region *given;
    luxel_histogram *histogram = NULL;
    const luxel_field *field;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OOpddn", &handle, &tuple, &logarithmic, &low, &high, &bins) ||
        !(field = field_of(module, handle)) || !region_of(tuple, &region, &given) ||
        !(diagnostics = diagnostics_begin()))
        return NULL;
    const luxel_status status =
        luxel_field_histogram(field, given, logarithmic ? LUXEL_HISTOGRAM_LOGARITHMIC : LUXEL_HISTOGRAM_LINEAR, low,
                              high, bins < 0 ? 0 : (size_t)bins, diagnostics, &histogram);
    PyObject *lists = NULL;

    if (diagnostics_end(&module_state(module)->language, status, diagnostics))
        lists = histogram_lists(histogram);
    luxel_histogram_free(histogram);
    return lists;
}

/* ---- extrema ---- */

static PyObject *peak_tuple(const luxel_scene *scene, const luxel_peak *peak)
{
    static const char *const places[] = {"inside", "limb", "border", "jump", "plateau"};

    if (!peak->exists)
        return none();
    return Py_BuildValue("(ddddnNNNs)", peak->value, peak->error, peak->x_mm, peak->y_mm, (Py_ssize_t)peak->surface,
                         text_or_none(luxel_scene_part_name(scene, peak->surface, peak->part)),
                         triple_or_none(true, peak->position_mm), triple_or_none(true, peak->normal),
                         places[peak->place]);
}

static PyObject *field_extrema(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *field_handle, *tuple, *settings;
    struct work work;
    luxel_region region;
    const luxel_region *given;
    luxel_extrema extrema;
    luxel_evaluator *evaluator = NULL;
    const luxel_scene *scene;
    const luxel_field *field;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OOOO", &handle, &field_handle, &tuple, &settings) ||
        !(scene = scene_of(module, handle)) || !(field = field_of(module, field_handle)) ||
        !region_of(tuple, &region, &given) || !work_begin(&work, settings) || !(diagnostics = diagnostics_begin()))
        return NULL;
    work_leave(&work);
    luxel_status status = luxel_evaluator_new(scene, &work.settings, diagnostics, &evaluator);

    if (status == LUXEL_OK)
        status = luxel_find_extrema(evaluator, field, given, diagnostics, &extrema);
    luxel_evaluator_free(evaluator);
    work_return(&work);
    if (!diagnostics_end(&module_state(module)->language, status, diagnostics))
        return NULL;
    return Py_BuildValue("(NN)", peak_tuple(scene, &extrema.maximum), peak_tuple(scene, &extrema.minimum));
}

/* ---- isophotes ---- */

enum { MOST_LEVELS = 1000 };

static void release_isophotes(void *isophotes)
{
    luxel_isophotes_free(isophotes);
}

static PyObject *line_tuple(PyObject *module, PyObject *holder, const luxel_isophote *line)
{
    const struct view_layout x = {.data = line->x_mm, .format = "d", .rows = (Py_ssize_t)line->count};
    const struct view_layout y = {.data = line->y_mm, .format = "d", .rows = (Py_ssize_t)line->count};

    return Py_BuildValue("(dONN)", line->level, line->closed ? Py_True : Py_False, view_new(module, holder, &x),
                         view_new(module, holder, &y));
}

/* Takes the isophotes. */
static PyObject *lines_list(PyObject *module, luxel_isophotes *isophotes)
{
    PyObject *holder = holder_new(module, isophotes, release_isophotes);
    PyObject *list = holder ? PyList_New(0) : NULL;

    for (size_t i = 0; list && i < isophotes->count; i++)
        if (append(list, line_tuple(module, holder, &isophotes->lines[i])) < 0)
            Py_CLEAR(list);
    Py_XDECREF(holder);
    return list;
}

/* False: an exception is set. */
static bool levels_of(PyObject *list, double levels[MOST_LEVELS], size_t *count)
{
    const Py_ssize_t size = PyList_Size(list);

    if (size > MOST_LEVELS)
        PyErr_Format(PyExc_ValueError, "at most %d levels can be found at once", MOST_LEVELS);
    if (size < 0 || size > MOST_LEVELS)
        return false;
    for (Py_ssize_t i = 0; i < size; i++) {
        levels[i] = PyFloat_AsDouble(PyList_GetItem(list, i));
        if (PyErr_Occurred())
            return false;
    }
    *count = (size_t)size;
    return true;
}

static PyObject *field_isophotes(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *scene_handle, *list, *settings;
    struct work work;
    double levels[MOST_LEVELS];
    size_t count;
    const bool read_settings = PyArg_ParseTuple(arguments, "OOOO", &handle, &scene_handle, &list, &settings);
    const luxel_field *field = read_settings ? field_of(module, handle) : NULL;
    const luxel_scene *scene = NULL;
    luxel_evaluator *evaluator = NULL;
    luxel_isophotes *isophotes = NULL;
    luxel_diagnostics *diagnostics;
    luxel_status status = LUXEL_OK;

    if (!field || (scene_handle != Py_None && !(scene = scene_of(module, scene_handle))) ||
        !levels_of(list, levels, &count) || !work_begin(&work, settings) || !(diagnostics = diagnostics_begin()))
        return NULL;
    work_leave(&work);
    if (scene)
        status = luxel_evaluator_new(scene, &work.settings, diagnostics, &evaluator);
    if (status == LUXEL_OK)
        status = luxel_find_isophotes(field, evaluator, levels, count, diagnostics, &isophotes);
    luxel_evaluator_free(evaluator);
    work_return(&work);
    if (diagnostics_end(&module_state(module)->language, status, diagnostics))
        return lines_list(module, isophotes);
    luxel_isophotes_free(isophotes);
    return NULL;
}

static PyObject *round_levels(PyObject *module, PyObject *arguments)
{
    double low, high, levels[MOST_LEVELS];
    int logarithmic;
    Py_ssize_t wanted;

    (void)module;
    if (!PyArg_ParseTuple(arguments, "ddpn", &low, &high, &logarithmic, &wanted))
        return NULL;
    const size_t count =
        luxel_round_levels(low, high, logarithmic, wanted < 1 ? 1 : (size_t)wanted, levels, MOST_LEVELS);
    PyObject *list = PyList_New(0);

    for (size_t i = 0; list && i < count; i++)
        if (append(list, PyFloat_FromDouble(levels[i])) < 0)
            Py_CLEAR(list);
    return list;
}

const PyMethodDef reading_functions[] = {
    FUNCTION("field_summary", field_summary, METH_VARARGS, "field: FieldHandle, region: Optional[Tuple[float, ...]], /",
             "Tuple[Any, ...]"),
    FUNCTION("field_histogram", field_histogram, METH_VARARGS,
             "field: FieldHandle, region: Optional[Tuple[float, ...]], log: bool, low: float, high: float, "
             "bins: int, /",
             "Tuple[Any, ...]"),
    FUNCTION("field_extrema", field_extrema, METH_VARARGS,
             "scene: SceneHandle, field: FieldHandle, region: Optional[Tuple[float, ...]], settings: _Settings, /",
             "Tuple[Any, Any]"),
    FUNCTION("field_isophotes", field_isophotes, METH_VARARGS,
             "field: FieldHandle, scene: Optional[SceneHandle], levels: List[float], settings: _Settings, /",
             "List[Tuple[float, bool, View, View]]"),
    FUNCTION("round_levels", round_levels, METH_VARARGS, "low: float, high: float, log: bool, wanted: int, /",
             "List[float]"),
    {NULL, NULL, 0, NULL},
};
