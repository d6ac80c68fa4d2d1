/* SPDX-License-Identifier: MIT */
/* Scenes of rooms to begin a lighting design with, and the observers of a scene judged by their limits. */
#include <luxel/limits.h>
#include <luxel/room.h>

#include "failure.h"
#include "work.h"

/* ---- limits ---- */

PyObject *limits_list(const luxel_limit *limits, size_t count)
{
    PyObject *list = PyList_New(0);

    for (size_t i = 0; list && i < count; i++) {
        const luxel_limit *limit = &limits[i];

        if (append(list, Py_BuildValue("(sdNNs)", limit->name, limit->wanted,
                                       number_or_none(limit->has_value, limit->value.value),
                                       number_or_none(limit->has_value, limit->value.error),
                                       luxel_verdict_word(limit->verdict))) < 0)
            Py_CLEAR(list);
    }
    return list;
}

/* The observers of a scene: name, eye and view. */
static PyObject *observers(PyObject *module, PyObject *handle)
{
    const luxel_scene *scene = scene_of(module, handle);
    PyObject *list = scene ? PyList_New(0) : NULL;

    for (size_t i = 0; list && i < luxel_scene_observer_count(scene); i++) {
        const char *name = NULL;
        luxel_glare_sight sight;

        luxel_scene_observer(scene, i, &name, &sight);
        if (append(list, Py_BuildValue("(NNN)", text_or_none(name), triple_or_none(true, sight.eye_mm),
                                       triple_or_none(true, sight.view))) < 0)
            Py_CLEAR(list);
    }
    return list;
}

/* rate_observer(scene, index, settings): the rating, and the limits. */
static PyObject *rate_observer(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *settings, *found = NULL;
    Py_ssize_t index;
    luxel_glare_sight sight;
    luxel_limit limits[LUXEL_MOST_LIMITS];
    size_t count = 0;
    struct work work;
    luxel_glare *glare = NULL;
    const luxel_scene *scene;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OnO", &handle, &index, &settings) || !(scene = scene_of(module, handle)) ||
        !work_begin(&work, settings) || !(diagnostics = diagnostics_begin()))
        return NULL;
    work_leave(&work);
    luxel_status status = luxel_scene_observer(scene, (size_t)index, NULL, &sight);
    if (status == LUXEL_OK)
        status = luxel_find_glare(scene, &work.settings, &sight, diagnostics, &glare);
    if (status == LUXEL_OK)
        status = luxel_judge_glare(scene, (size_t)index, glare, limits, &count);

    work_return(&work);
    if (diagnostics_end(&module_state(module)->language, status, diagnostics))
        found = Py_BuildValue("(NN)", glare_tuple(glare), limits_list(limits, count));
    luxel_glare_free(glare);
    return found;
}

/* ---- rooms ---- */

static PyObject *array_tuple(const luxel_room_array *array)
{
    if (array->n[0] == 0)
        return none();
    return Py_BuildValue("((II)ddd)", array->n[0], array->n[1], array->average.value, array->average.error,
                         array->uniformity);
}

/* design_room((size, file, array, target, reflectances, plane, maintenance), settings): the text, what it has, and the
 * next smaller array. */
static PyObject *design_room(PyObject *module, PyObject *arguments)
{
    PyObject *settings, *found = NULL;
    luxel_room room;
    luxel_room_design design = {.text = NULL};
    struct work work;
    luxel_diagnostics *diagnostics;

    luxel_room_init(&room);
    if (!PyArg_ParseTuple(arguments, "((ddd)z(II)d(ddd)dd)O", &room.size_m[0], &room.size_m[1], &room.size_m[2],
                          &room.file, &room.array[0], &room.array[1], &room.target, &room.reflectances[0],
                          &room.reflectances[1], &room.reflectances[2], &room.plane_m, &room.maintenance, &settings) ||
        !work_begin(&work, settings) || !(diagnostics = diagnostics_begin()))
        return NULL;
    work_leave(&work);
    const luxel_status status = luxel_design_room(&room, NULL, &work.settings, diagnostics, &design);

    work_return(&work);
    if (diagnostics_end(&module_state(module)->language, status, diagnostics))
        found = Py_BuildValue("(sNN)", design.text, array_tuple(&design.chosen), array_tuple(&design.smaller));
    luxel_text_free(design.text);
    return found;
}

const PyMethodDef room_functions[] = {
    FUNCTION("observers", observers, METH_O, "scene: SceneHandle, /", "List[Tuple[Any, ...]]"),
    FUNCTION("rate_observer", rate_observer, METH_VARARGS, "scene: SceneHandle, index: int, settings: _Settings, /",
             "Tuple[Any, Any]"),
    FUNCTION("design_room", design_room, METH_VARARGS, "room: Tuple[Any, ...], settings: _Settings, /",
             "Tuple[str, Any, Any]"),
    {NULL, NULL, 0, NULL},
};
