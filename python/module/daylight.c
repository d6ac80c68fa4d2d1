/* SPDX-License-Identifier: MIT */
/* The daylight factors and the hours of sun of a scene's measuring grids, and of free elements. */
#include <luxel/daylight.h>
#include <luxel/grid.h>
#include <luxel/sunlight.h>

#include "failure.h"
#include "work.h"

/* Value and error of the whole and of its parts; None where there is no value. */
static PyObject *factor_tuple(const luxel_daylight_factor *factor)
{
    if (!factor->has_value)
        return none();
    return Py_BuildValue("((dd)(dd)(dd)(dd))", factor->value.value, factor->value.error, factor->sky.value,
                         factor->sky.error, factor->external.value, factor->external.error, factor->internal.value,
                         factor->internal.error);
}

static PyObject *factor_list(const luxel_daylight_factor *factors, size_t count)
{
    PyObject *list = PyList_New(0);

    for (size_t i = 0; list && i < count; i++)
        if (append(list, factor_tuple(&factors[i])) < 0)
            Py_CLEAR(list);
    return list;
}

static PyObject *grid_tuple(const luxel_daylight_grid *grid)
{
    PyObject *cells = factor_list(grid->cells, (size_t)grid->columns * grid->rows);

    if (!cells)
        return NULL;
    return Py_BuildValue("(NIIN(dd)(dd)(dddd)O)", text_or_none(grid->name), grid->rows, grid->columns, cells,
                         grid->mean.value, grid->mean.error, grid->median.value, grid->median.error, grid->shares[0],
                         grid->shares[1], grid->shares[2], grid->shares[3], grid->measured > 0 ? Py_True : Py_False);
}

static PyObject *daylight_tuple(const luxel_daylight *found)
{
    PyObject *grids = PyList_New(0), *elements;

    for (size_t i = 0; grids && i < found->grid_count; i++)
        if (append(grids, grid_tuple(&found->grids[i])) < 0)
            Py_CLEAR(grids);
    elements = grids ? factor_list(found->elements, found->element_count) : NULL;
    if (!elements) {
        Py_XDECREF(grids);
        return NULL;
    }
    return Py_BuildValue("((dd)NNNO)", found->horizontal.value, found->horizontal.error,
                         number_or_none(found->outdoor == found->outdoor, found->outdoor), grids, elements,
                         found->reached ? Py_True : Py_False);
}

/* The elements of a list of tuples of six numbers, the caller's; NULL: an exception is set. */
static luxel_place *elements_of(PyObject *list, size_t *count)
{
    const Py_ssize_t size = PyList_Size(list);
    luxel_place *places = size < 0 ? NULL : PyMem_Calloc((size_t)size + 1, sizeof *places);

    if (size >= 0 && !places)
        PyErr_NoMemory();
    for (Py_ssize_t i = 0; places && i < size; i++) {
        luxel_place *place = &places[i];

        place->is_element = true;
        if (!is_tuple(PyList_GetItem(list, i)) ||
            !PyArg_ParseTuple(PyList_GetItem(list, i), "dddddd", &place->position_mm[0], &place->position_mm[1],
                              &place->position_mm[2], &place->normal[0], &place->normal[1], &place->normal[2])) {
            PyMem_Free(places);
            return NULL;
        }
    }
    *count = (size_t)size;
    return places;
}

/* find_daylight(scene, elements, outdoor, settings): daylight factors; `outdoor` 0 leaves it to the sky. */
static PyObject *find_daylight(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *list, *settings, *found = NULL;
    struct work work;
    double outdoor;
    size_t count;
    luxel_daylight *result = NULL;
    const luxel_scene *scene;
    luxel_place *places;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OOdO", &handle, &list, &outdoor, &settings) ||
        !(scene = scene_of(module, handle)) || !work_begin(&work, settings) || !(places = elements_of(list, &count)))
        return NULL;
    if (!(diagnostics = diagnostics_begin())) {
        PyMem_Free(places);
        return NULL;
    }
    work_leave(&work);
    const luxel_status status =
        luxel_find_daylight(scene, &work.settings, places, count, outdoor, diagnostics, &result);

    work_return(&work);
    if (diagnostics_end(&module_state(module)->language, status, diagnostics))
        found = daylight_tuple(result);
    luxel_daylight_free(result);
    PyMem_Free(places);
    return found;
}

/* Seconds in all, the level of EN 17037, and beginnings and ends. */
static PyObject *hours_tuple(const luxel_sun_hours *hours)
{
    PyObject *spans = PyList_New(0);

    for (size_t i = 0; spans && i < hours->span_count; i++)
        if (append(spans, Py_BuildValue("(dd)", hours->spans[i].from_s, hours->spans[i].to_s)) < 0)
            Py_CLEAR(spans);
    return spans ? Py_BuildValue("(diN)", hours->total_s, (int)hours->level, spans) : NULL;
}

static PyObject *hours_list(const luxel_sun_hours *hours, size_t count)
{
    PyObject *list = PyList_New(0);

    for (size_t i = 0; list && i < count; i++)
        if (append(list, hours_tuple(&hours[i])) < 0)
            Py_CLEAR(list);
    return list;
}

static PyObject *sunlight_tuple(const luxel_sunlight *found)
{
    PyObject *grids = PyList_New(0);

    for (size_t i = 0; grids && i < found->grid_count; i++) {
        const luxel_sun_grid *grid = &found->grids[i];
        PyObject *cells = hours_list(grid->cells, (size_t)grid->columns * grid->rows);

        if (!cells ||
            append(grids, Py_BuildValue("(NIIN)", text_or_none(grid->name), grid->rows, grid->columns, cells)) < 0)
            Py_CLEAR(grids);
    }
    if (!grids)
        return NULL;
    return Py_BuildValue("(ddiNNN)", found->latitude_deg, found->longitude_deg, found->zone_minutes,
                         hours_tuple(&found->open), grids, hours_list(found->elements, found->element_count));
}

/* find_sunlight(scene, elements, date, place, least_altitude, settings): hours of sun; `place`: None or two numbers. */
static PyObject *find_sunlight(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *list, *place, *settings, *found = NULL;
    luxel_sun_day day = {.date = NULL};
    struct work work;
    size_t count;
    luxel_sunlight *result = NULL;
    const luxel_scene *scene;
    luxel_place *places;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OOsOdO", &handle, &list, &day.date, &place, &day.least_altitude_deg, &settings) ||
        !(scene = scene_of(module, handle)))
        return NULL;
    day.has_place = place != Py_None;
    if (day.has_place && !PyArg_ParseTuple(place, "dd", &day.latitude_deg, &day.longitude_deg))
        return NULL;
    if (!work_begin(&work, settings) || !(places = elements_of(list, &count)))
        return NULL;
    if (!(diagnostics = diagnostics_begin())) {
        PyMem_Free(places);
        return NULL;
    }
    work_leave(&work);
    const luxel_status status = luxel_find_sunlight(scene, &work.settings, &day, places, count, diagnostics, &result);

    work_return(&work);
    if (diagnostics_end(&module_state(module)->language, status, diagnostics))
        found = sunlight_tuple(result);
    luxel_sunlight_free(result);
    PyMem_Free(places);
    return found;
}

static PyObject *corners_list(const luxel_sun_patch *patch)
{
    PyObject *list = PyList_New(0);

    for (size_t i = 0; list && i < patch->corner_count; i++)
        if (append(list, Py_BuildValue("(ddd)", patch->corners_mm[i][0], patch->corners_mm[i][1],
                                       patch->corners_mm[i][2])) < 0)
            Py_CLEAR(list);
    return list;
}

static PyObject *others_list(const luxel_sun_patch *patch)
{
    PyObject *list = PyList_New(0);

    for (size_t i = 0; list && i < patch->other_count; i++)
        if (append(list, PyLong_FromSize_t(patch->others[i])) < 0)
            Py_CLEAR(list);
    return list;
}

/* find_sun_patches(scene): the way to the sun, and the patches. */
static PyObject *find_sun_patches(PyObject *module, PyObject *handle)
{
    luxel_sun_patches *result = NULL;
    PyObject *list = NULL;
    const luxel_scene *scene = scene_of(module, handle);
    luxel_diagnostics *diagnostics = scene ? diagnostics_begin() : NULL;

    if (!diagnostics)
        return NULL;
    const luxel_status status = luxel_find_sun_patches(scene, diagnostics, &result);

    if (diagnostics_end(&module_state(module)->language, status, diagnostics))
        list = PyList_New(0);
    for (size_t i = 0; list && i < result->count; i++) {
        const luxel_sun_patch *patch = &result->list[i];

        if (append(list, Py_BuildValue("(nNNNNdNN)", (Py_ssize_t)patch->surface, text_or_none(patch->surface_name),
                                       text_or_none(patch->part),
                                       patch->has_opening ? PyLong_FromSize_t(patch->room) : none(),
                                       patch->has_opening ? PyLong_FromSize_t(patch->opening) : none(), patch->area_mm2,
                                       corners_list(patch), others_list(patch))) < 0)
            Py_CLEAR(list);
    }
    PyObject *found =
        list ? Py_BuildValue("((ddd)N)", result->towards[0], result->towards[1], result->towards[2], list) : NULL;

    luxel_sun_patches_free(result);
    return found;
}

const PyMethodDef daylight_functions[] = {
    FUNCTION("find_daylight", find_daylight, METH_VARARGS,
             "scene: SceneHandle, elements: List[Tuple[float, ...]], outdoor: float, settings: _Settings, /",
             "Tuple[Any, ...]"),
    FUNCTION("find_sunlight", find_sunlight, METH_VARARGS,
             "scene: SceneHandle, elements: List[Tuple[float, ...]], date: str, place: Optional[Tuple[float, float]], "
             "least_altitude: float, settings: _Settings, /",
             "Tuple[Any, ...]"),
    FUNCTION("find_sun_patches", find_sun_patches, METH_O, "scene: SceneHandle, /", "Tuple[Any, ...]"),
    {NULL, NULL, 0, NULL},
};
