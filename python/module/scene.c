/* SPDX-License-Identifier: MIT */
/* Handles of scenes: opening them, and what can be asked of them.  Every handle holds a committed scene. */
#include "failure.h"

#include <string.h>

static void scene_dealloc(PyObject *self)
{
    PyTypeObject *type = Py_TYPE(self);

    luxel_scene_free(((struct scene_object *)self)->scene);
    PyObject_Free(self);
    Py_DECREF(type);
}

static PyType_Slot scene_slots[] = {
    {Py_tp_dealloc, scene_dealloc},
    {Py_tp_doc, "A scene that is right and never changes."},
    {0, NULL},
};

PyType_Spec scene_spec = {.name = "luxel._luxel.SceneHandle",
                          .basicsize = sizeof(struct scene_object),
                          .flags = Py_TPFLAGS_DEFAULT | Py_TPFLAGS_DISALLOW_INSTANTIATION,
                          .slots = scene_slots};

luxel_scene *scene_of(PyObject *module, PyObject *handle)
{
    if (PyObject_TypeCheck(handle, module_state(module)->scene_type))
        return ((struct scene_object *)handle)->scene;
    PyErr_SetString(PyExc_TypeError, "a scene is expected");
    return NULL;
}

PyObject *scene_handle(PyObject *module, luxel_scene *scene)
{
    struct scene_object *handle = PyObject_New(struct scene_object, module_state(module)->scene_type);

    if (!handle)
        luxel_scene_free(scene);
    else
        handle->scene = scene;
    return (PyObject *)handle;
}

/* ---- opening ---- */

/* Commits the scene that was opened with this status.  Files are read without the interpreter's lock. */
static PyObject *finish(PyObject *module, luxel_status status, luxel_scene *scene, luxel_diagnostics *diagnostics)
{
    if (status == LUXEL_OK) {
        Py_BEGIN_ALLOW_THREADS
        status = luxel_scene_commit(scene, diagnostics);
        Py_END_ALLOW_THREADS
    }
    if (diagnostics_end(&module_state(module)->language, status, diagnostics))
        return scene_handle(module, scene);
    luxel_scene_free(scene);
    return NULL;
}

static PyObject *open_builtin(PyObject *module, PyObject *arguments)
{
    const char *name;
    luxel_scene *scene = NULL;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "s", &name) || !(diagnostics = diagnostics_begin()))
        return NULL;
    const luxel_status status = luxel_scene_open_builtin(name, diagnostics, &scene);

    return finish(module, status, scene, diagnostics);
}

/* The name is as it was given, for messages; files are found wherever the program goes from here. */
static PyObject *open_file(PyObject *module, PyObject *arguments)
{
    const char *path, *beside;
    luxel_status status;
    luxel_scene *scene = NULL;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "yy", &path, &beside) || !(diagnostics = diagnostics_begin()))
        return NULL;
    Py_BEGIN_ALLOW_THREADS
    status = luxel_scene_read_file(path, diagnostics, &scene);
    Py_END_ALLOW_THREADS
    if (status == LUXEL_OK)
        status = luxel_scene_set_folder_of(scene, beside);
    return finish(module, status, scene, diagnostics);
}

static PyObject *open_text(PyObject *module, PyObject *arguments)
{
    const char *text, *source, *beside;
    Py_ssize_t length;
    luxel_status status;
    luxel_scene *scene = NULL;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "y#sz", &text, &length, &source, &beside) || !(diagnostics = diagnostics_begin()))
        return NULL;
    Py_BEGIN_ALLOW_THREADS
    status = luxel_scene_read_text(text, (size_t)length, source, diagnostics, &scene);
    Py_END_ALLOW_THREADS
    if (status == LUXEL_OK && beside)
        status = luxel_scene_set_folder_of(scene, beside);
    return finish(module, status, scene, diagnostics);
}

static PyObject *builtin_scenes(PyObject *module, PyObject *unused)
{
    PyObject *list = PyList_New(0);

    (void)module;
    (void)unused;
    for (size_t i = 0; list && i < luxel_builtin_scene_count(); i++)
        if (append(list, Py_BuildValue("(ss)", luxel_builtin_scene_name(i), luxel_builtin_scene_title(i))) < 0)
            Py_CLEAR(list);
    return list;
}

/* ---- asking ---- */

static PyObject *scene_text(PyObject *module, PyObject *handle)
{
    const luxel_scene *scene = scene_of(module, handle);
    char *text = NULL;

    if (!scene)
        return NULL;
    if (luxel_scene_write_text(scene, &text) != LUXEL_OK)
        return PyErr_NoMemory();
    PyObject *words = PyUnicode_DecodeUTF8(text, (Py_ssize_t)strlen(text), "surrogateescape");

    luxel_text_free(text);
    return words;
}

static PyObject *scene_get(PyObject *module, PyObject *arguments)
{
    PyObject *handle;
    const char *key;
    char *text = NULL;
    bool written = false;
    const luxel_scene *scene;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "Os", &handle, &key) || !(scene = scene_of(module, handle)) ||
        !(diagnostics = diagnostics_begin()))
        return NULL;
    const luxel_status status = luxel_scene_get(scene, key, diagnostics, &written, &text);
    PyObject *found = NULL;

    if (diagnostics_end(&module_state(module)->language, status, diagnostics))
        found = Py_BuildValue("(NO)", text_or_none(text), written ? Py_True : Py_False);
    luxel_text_free(text);
    return found;
}

static PyObject *scene_size(PyObject *module, PyObject *arguments)
{
    PyObject *handle;
    const char *list;
    size_t count = 0;
    const luxel_scene *scene;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "Os", &handle, &list) || !(scene = scene_of(module, handle)) ||
        !(diagnostics = diagnostics_begin()))
        return NULL;
    const luxel_status status = luxel_scene_list_size(scene, list, diagnostics, &count);

    return diagnostics_end(&module_state(module)->language, status, diagnostics) ? PyLong_FromSize_t(count) : NULL;
}

static PyObject *scene_points(PyObject *module, PyObject *handle)
{
    const luxel_scene *scene = scene_of(module, handle);
    PyObject *list = scene ? PyList_New(0) : NULL;

    for (size_t i = 0; list && i < luxel_scene_point_count(scene); i++) {
        double x = 0, y = 0;

        luxel_scene_point(scene, i, &x, &y);
        if (append(list, Py_BuildValue("(dd)", x, y)) < 0)
            Py_CLEAR(list);
    }
    return list;
}

static PyObject *scene_resolution(PyObject *module, PyObject *handle)
{
    const luxel_scene *scene = scene_of(module, handle);
    unsigned columns = 0, rows = 0;

    if (!scene)
        return NULL;
    luxel_scene_resolution(scene, &columns, &rows);
    return Py_BuildValue("(II)", columns, rows);
}

static PyObject *scene_conventions(PyObject *module, PyObject *handle)
{
    const luxel_scene *scene = scene_of(module, handle);
    PyObject *list = scene ? PyList_New(0) : NULL;
    luxel_conventions *all = NULL;

    if (list && luxel_find_conventions(scene, NULL, &all) == LUXEL_ERROR_MEMORY) {
        PyErr_NoMemory();
        Py_CLEAR(list);
    }
    for (size_t i = 0; list && all && i < all->count; i++)
        if (append(list, Py_BuildValue("(ss)", all->list[i].key, all->list[i].value)) < 0)
            Py_CLEAR(list);
    luxel_conventions_free(all);
    return list;
}

static PyObject *scene_unit(PyObject *module, PyObject *arguments)
{
    PyObject *handle;
    int quantity;
    const char *lights;
    Py_ssize_t size;
    luxel_settings settings;
    const luxel_scene *scene;

    if (!PyArg_ParseTuple(arguments, "Oiz#", &handle, &quantity, &lights, &size) || !(scene = scene_of(module, handle)))
        return NULL;
    luxel_settings_init(&settings);
    settings.quantity = (luxel_quantity)quantity;
    settings.lights = (const size_t *)(const void *)lights;
    settings.light_count = (size_t)size / sizeof(size_t);
    return Py_BuildValue("(ss)", luxel_settings_unit(scene, &settings),
                         luxel_scene_quantity_word(scene, settings.quantity));
}

/* The settings that a scene from a picture was made with, else None. */
static PyObject *scene_carried(PyObject *module, PyObject *handle)
{
    const luxel_scene *scene = scene_of(module, handle);
    luxel_settings settings;

    if (!scene)
        return NULL;
    luxel_settings_init(&settings);
    if (!luxel_scene_settings(scene, &settings))
        return none();
    return Py_BuildValue("(iiddd)", settings.quantity, settings.precision, settings.tolerance, settings.light_error,
                         settings.reflected_error);
}

static PyObject *scene_advice(PyObject *module, PyObject *handle)
{
    const luxel_scene *scene = scene_of(module, handle);
    luxel_diagnostics *diagnostics = scene ? diagnostics_begin() : NULL;
    struct language *language = &module_state(module)->language;
    luxel_status status;

    if (!diagnostics)
        return NULL;
    Py_BEGIN_ALLOW_THREADS
    status = luxel_scene_advise(scene, diagnostics);
    if (status == LUXEL_OK)
        status = luxel_scene_advise_peak(scene, diagnostics);
    Py_END_ALLOW_THREADS
    PyObject *list = status == LUXEL_OK ? diagnostics_list(language, diagnostics) : NULL;

    if (diagnostics_end(language, status, diagnostics))
        return list;
    Py_XDECREF(list);
    return NULL;
}

static bool known(luxel_status status, double number)
{
    return status == LUXEL_OK && number == number;
}

static PyObject *light(const luxel_scene *scene, size_t i)
{
    double flux = 0, intensity = 0, place[3], direction[3];
    const luxel_status flux_status = luxel_scene_light_flux(scene, i, &flux);
    const luxel_status intensity_status = luxel_scene_light_intensity(scene, i, &intensity);

    return Py_BuildValue("(sNONNNN)", luxel_scene_light_type(scene, i), text_or_none(luxel_scene_light_name(scene, i)),
                         luxel_scene_light_enabled(scene, i) ? Py_True : Py_False,
                         number_or_none(known(flux_status, flux), flux),
                         number_or_none(known(intensity_status, intensity), intensity),
                         triple_or_none(luxel_scene_light_place(scene, i, place), place),
                         triple_or_none(luxel_scene_light_direction(scene, i, direction), direction));
}

static PyObject *scene_lights(PyObject *module, PyObject *handle)
{
    const luxel_scene *scene = scene_of(module, handle);
    PyObject *list = scene ? PyList_New(0) : NULL;

    for (size_t i = 0; list && i < luxel_scene_light_count(scene); i++)
        if (append(list, light(scene, i)) < 0)
            Py_CLEAR(list);
    return list;
}

/* A mesh whose key is that of item i of a list. */
static PyObject *mesh(const char *list, size_t i, const luxel_mesh_survey *survey)
{
    PyObject *key = PyUnicode_FromFormat("%s[%zu].%s", list, i, survey->key);
    const double volume = survey->volume_mm3;

    return Py_BuildValue("(NNnnnnnOlnnONdN)", key, text_or_none(survey->file), (Py_ssize_t)survey->triangles,
                         (Py_ssize_t)survey->corners, (Py_ssize_t)survey->edges, (Py_ssize_t)survey->open_edges,
                         (Py_ssize_t)survey->crowded_edges, survey->is_closed ? Py_True : Py_False,
                         survey->euler_number, (Py_ssize_t)survey->parts, (Py_ssize_t)survey->flipped_faces,
                         survey->is_one_sided ? Py_True : Py_False, number_or_none(volume == volume, volume),
                         survey->scale_mm, triple_or_none(true, survey->size_mm));
}

static PyObject *scene_meshes(PyObject *module, PyObject *handle)
{
    const luxel_scene *scene = scene_of(module, handle);
    PyObject *list = scene ? PyList_New(0) : NULL;
    const size_t surfaces = list ? luxel_scene_surface_count(scene) : 0;
    const size_t count = list ? surfaces + luxel_scene_light_count(scene) : 0;
    luxel_mesh_survey survey;

    for (size_t i = 0; list && i < count; i++) {
        const bool of_surface = i < surfaces;
        const size_t at = of_surface ? i : i - surfaces;
        bool is_mesh = false;
        const luxel_status status = of_surface ? luxel_scene_surface_mesh(scene, at, &is_mesh, &survey)
                                               : luxel_scene_light_mesh(scene, at, &is_mesh, &survey);

        if (status != LUXEL_OK) {
            Py_CLEAR(list);
            PyErr_NoMemory();
        } else if (is_mesh && append(list, mesh(of_surface ? "surfaces" : "lights", at, &survey)) < 0) {
            Py_CLEAR(list);
        }
    }
    return list;
}

static PyObject *scene_project(PyObject *module, PyObject *arguments)
{
    PyObject *handle;
    double place[3], screen[2];
    const luxel_scene *scene;

    if (!PyArg_ParseTuple(arguments, "Oddd", &handle, &place[0], &place[1], &place[2]) ||
        !(scene = scene_of(module, handle)))
        return NULL;
    return luxel_scene_project(scene, place, screen) ? Py_BuildValue("(dd)", screen[0], screen[1]) : none();
}

static PyObject *scene_unproject(PyObject *module, PyObject *arguments)
{
    PyObject *handle;
    double place[3], screen[2], z;
    const luxel_scene *scene;

    if (!PyArg_ParseTuple(arguments, "Oddd", &handle, &screen[0], &screen[1], &z) ||
        !(scene = scene_of(module, handle)))
        return NULL;
    return triple_or_none(luxel_scene_unproject(scene, screen, z, place), place);
}

static PyObject *scene_height(PyObject *module, PyObject *arguments)
{
    PyObject *handle;
    double place[3], z;
    const luxel_scene *scene;

    if (!PyArg_ParseTuple(arguments, "Oddd", &handle, &place[0], &place[1], &place[2]) ||
        !(scene = scene_of(module, handle)))
        return NULL;
    return luxel_scene_height(scene, place, &z) ? PyFloat_FromDouble(z) : none();
}

/* ---- for the module that draws ---- */

static void capsule_release(PyObject *capsule)
{
    Py_XDECREF((PyObject *)PyCapsule_GetContext(capsule));
}

/* The scene as a capsule, which keeps the handle alive. */
static PyObject *scene_capsule(PyObject *module, PyObject *handle)
{
    luxel_scene *scene = scene_of(module, handle);
    PyObject *capsule = scene ? PyCapsule_New(scene, SCENE_CAPSULE, capsule_release) : NULL;

    if (capsule && PyCapsule_SetContext(capsule, Py_NewRef(handle)) < 0) {
        Py_DECREF(handle);
        Py_CLEAR(capsule);
    }
    return capsule;
}

const PyMethodDef scene_functions[] = {
    FUNCTION("open_builtin", open_builtin, METH_VARARGS, "name: str, /", "SceneHandle"),
    FUNCTION("open_file", open_file, METH_VARARGS, "path: bytes, beside: bytes, /", "SceneHandle"),
    FUNCTION("open_text", open_text, METH_VARARGS, "text: bytes, source: str, beside: Optional[str], /", "SceneHandle"),
    FUNCTION("builtin_scenes", builtin_scenes, METH_NOARGS, "", "List[Tuple[str, str]]"),
    FUNCTION("scene_text", scene_text, METH_O, "scene: SceneHandle, /", "str"),
    FUNCTION("scene_get", scene_get, METH_VARARGS, "scene: SceneHandle, key: str, /", "Tuple[Optional[str], bool]"),
    FUNCTION("scene_size", scene_size, METH_VARARGS, "scene: SceneHandle, list: str, /", "int"),
    FUNCTION("scene_points", scene_points, METH_O, "scene: SceneHandle, /", "List[Tuple[float, float]]"),
    FUNCTION("scene_resolution", scene_resolution, METH_O, "scene: SceneHandle, /", "Tuple[int, int]"),
    FUNCTION("scene_conventions", scene_conventions, METH_O, "scene: SceneHandle, /", "List[Tuple[str, str]]"),
    FUNCTION("scene_unit", scene_unit, METH_VARARGS, "scene: SceneHandle, quantity: int, lights: Optional[bytes], /",
             "Tuple[str, str]"),
    FUNCTION("scene_carried", scene_carried, METH_O, "scene: SceneHandle, /",
             "Optional[Tuple[int, int, float, float, float]]"),
    FUNCTION("scene_advice", scene_advice, METH_O, "scene: SceneHandle, /", "List[Tuple[Any, ...]]"),
    FUNCTION("scene_lights", scene_lights, METH_O, "scene: SceneHandle, /", "List[Tuple[Any, ...]]"),
    FUNCTION("scene_meshes", scene_meshes, METH_O, "scene: SceneHandle, /", "List[Tuple[Any, ...]]"),
    FUNCTION("scene_capsule", scene_capsule, METH_O, "scene: SceneHandle, /", "object"),
    FUNCTION("scene_project", scene_project, METH_VARARGS, "scene: SceneHandle, x: float, y: float, z: float, /",
             "Optional[Tuple[float, float]]"),
    FUNCTION("scene_unproject", scene_unproject, METH_VARARGS, "scene: SceneHandle, x: float, y: float, z: float, /",
             "Optional[Tuple[float, float, float]]"),
    FUNCTION("scene_height", scene_height, METH_VARARGS, "scene: SceneHandle, x: float, y: float, z: float, /",
             "Optional[float]"),
    {NULL, NULL, 0, NULL},
};
