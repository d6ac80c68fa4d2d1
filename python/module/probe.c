/* SPDX-License-Identifier: MIT */
/* Probes: exact values at points of the screen, with all that belongs to them. */
#include <math.h>

#include "failure.h"
#include "work.h"

static PyObject *index_or_none(bool given, size_t index)
{
    return given ? PyLong_FromSize_t(index) : none();
}

static PyObject *pair_or_none(bool given, double x, double y)
{
    return given ? Py_BuildValue("(dd)", x, y) : none();
}

static PyObject *color_or_none(const luxel_color *color)
{
    luxel_chromaticity seen;

    if (!color->exists)
        return none();
    luxel_find_chromaticity(color->rgb, &seen);
    return Py_BuildValue("(NNNNN)", triple_or_none(true, color->rgb), triple_or_none(true, color->error),
                         pair_or_none(seen.has_xy, seen.xy[0], seen.xy[1]), number_or_none(seen.has_cct, seen.cct_k),
                         number_or_none(seen.has_cct, seen.duv));
}

static PyObject *share_tuple(const luxel_light_share *share)
{
    return Py_BuildValue("(nsNddddnN)", (Py_ssize_t)share->light, share->type, text_or_none(share->name),
                         share->irradiance, share->diffuse, share->specular, share->error, (Py_ssize_t)share->parts,
                         share->color ? color_or_none(share->color) : none());
}

static PyObject *shares_list(const luxel_probe *probe)
{
    PyObject *list = PyList_New(0);

    for (size_t i = 0; list && i < probe->share_count; i++)
        if (append(list, share_tuple(&probe->shares[i])) < 0)
            Py_CLEAR(list);
    return list;
}

/* `albedo`: NaN, or what is not told. */
static PyObject *probe_tuple(const luxel_probe *probe, double albedo)
{
    PyObject *shares = probe->has_value ? shares_list(probe) : PyList_New(0);

    if (!shares)
        return NULL;
    return Py_BuildValue(
        "(NNONNONNNNNNNNONNNNN)", pair_or_none(probe->has_screen, probe->x_mm, probe->y_mm),
        probe->has_pixel ? Py_BuildValue("(II)", probe->column, probe->row) : none(),
        probe->on_surface ? Py_True : Py_False, number_or_none(probe->has_value, probe->value),
        number_or_none(probe->has_value, probe->error),
        probe->tolerance_reached && probe->reflected_reached ? Py_True : Py_False,
        number_or_none(probe->has_pixel_value, probe->pixel_value),
        triple_or_none(probe->on_surface, probe->position_mm), triple_or_none(probe->on_surface, probe->normal),
        triple_or_none(probe->on_surface, probe->view), number_or_none(albedo >= 0, albedo),
        index_or_none(probe->on_surface && probe->surface != SIZE_MAX, probe->surface),
        text_or_none(probe->on_surface ? probe->surface_name : NULL),
        text_or_none(probe->on_surface ? probe->part_name : NULL), probe->lies_on_surface ? Py_True : Py_False,
        index_or_none(probe->is_enclosed, probe->enclosing_surface),
        index_or_none(probe->source_on_element, probe->blocking_light),
        probe->has_reflected
            ? Py_BuildValue("(ddd)", probe->reflected_irradiance, probe->reflected.value, probe->reflected.error)
            : none(),
        color_or_none(&probe->color), shares);
}

/* From (x, y) on the screen, or (x, y, z, nx, ny, nz, view or None, surface).  False: an exception is set. */
static bool place_of(PyObject *tuple, luxel_place *place)
{
    PyObject *view;
    Py_ssize_t surface;

    if (!is_tuple(tuple))
        return false;
    if (PyTuple_Size(tuple) == 2)
        return PyArg_ParseTuple(tuple, "dd", &place->screen_mm[0], &place->screen_mm[1]);
    if (!PyArg_ParseTuple(tuple, "ddddddOn", &place->position_mm[0], &place->position_mm[1], &place->position_mm[2],
                          &place->normal[0], &place->normal[1], &place->normal[2], &view, &surface))
        return false;
    place->is_element = true;
    place->surface = (size_t)surface;
    place->has_view = view != Py_None;
    return !place->has_view ||
           (is_tuple(view) && PyArg_ParseTuple(view, "ddd", &place->view[0], &place->view[1], &place->view[2]));
}

/* The places of a list, the caller's; NULL: an exception is set. */
static luxel_place *places_of(PyObject *list, size_t *count)
{
    const Py_ssize_t size = PyList_Size(list);
    luxel_place *places = size < 0 ? NULL : PyMem_Calloc((size_t)size + 1, sizeof *places);

    if (size >= 0 && !places)
        PyErr_NoMemory();
    for (Py_ssize_t i = 0; places && i < size; i++)
        if (!place_of(PyList_GetItem(list, i), &places[i])) {
            PyMem_Free(places);
            return NULL;
        }
    *count = (size_t)size;
    return places;
}

/* The most places whose albedo is told, as it is an integral for each; of more, none is. */
enum { MOST_ALBEDOS = 1000 };

static void find_albedos(const luxel_scene *scene, const luxel_probes *probes, double albedos[MOST_ALBEDOS])
{
    const size_t count = luxel_probes_count(probes);

    for (size_t i = 0; i < MOST_ALBEDOS; i++)
        albedos[i] =
            i < count && count <= MOST_ALBEDOS ? luxel_probe_albedo(scene, luxel_probes_get(probes, i)) : (double)NAN;
}

static PyObject *probes_list(const luxel_probes *probes, const double albedos[MOST_ALBEDOS])
{
    PyObject *list = PyList_New(0);

    for (size_t i = 0; list && i < luxel_probes_count(probes); i++)
        if (append(list, probe_tuple(luxel_probes_get(probes, i), i < MOST_ALBEDOS ? albedos[i] : (double)NAN)) < 0)
            Py_CLEAR(list);
    return list;
}

static PyObject *probe(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *list, *settings;
    struct work work;
    size_t count;
    const luxel_scene *scene;
    luxel_place *places;
    luxel_probes *probes = NULL;
    luxel_diagnostics *diagnostics;
    double albedos[MOST_ALBEDOS];

    if (!PyArg_ParseTuple(arguments, "OOO", &handle, &list, &settings) || !(scene = scene_of(module, handle)) ||
        !work_begin(&work, settings) || !(places = places_of(list, &count)))
        return NULL;
    if (!(diagnostics = diagnostics_begin())) {
        PyMem_Free(places);
        return NULL;
    }
    work_leave(&work);
    const luxel_status status = luxel_probe_places(scene, &work.settings, places, count, diagnostics, &probes);

    find_albedos(scene, probes, albedos);
    work_return(&work);
    PyMem_Free(places);
    PyObject *found = NULL;

    if (diagnostics_end(&module_state(module)->language, status, diagnostics))
        found = probes_list(probes, albedos);
    luxel_probes_free(probes);
    return found;
}

const PyMethodDef probe_functions[] = {
    FUNCTION("probe", probe, METH_VARARGS, "scene: SceneHandle, places: List[Tuple[Any, ...]], settings: _Settings, /",
             "List[Tuple[Any, ...]]"),
    {NULL, NULL, 0, NULL},
};
