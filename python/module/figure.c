/* SPDX-License-Identifier: MIT */
/*
 * The module luxel._figure: figures, reports and diagrams.  It is a module of its own, loaded when something is drawn,
 * because it brings cairo and pango with it.  Scenes and luminaires come as capsules of luxel._luxel.
 */
#include <luxel/figure.h>

#include "failure.h"
#include "work.h"

struct figure_state {
    struct language language;
};

static struct language *language_here(PyObject *module)
{
    return &((struct figure_state *)PyModule_GetState(module))->language;
}

static PyObject *set_language(PyObject *module, PyObject *arguments)
{
    return language_set(language_here(module), arguments);
}

static const luxel_scene *scene_in(PyObject *capsule)
{
    return PyCapsule_GetPointer(capsule, SCENE_CAPSULE);
}

/* ---- figures ---- */

enum { MOST_LEVELS = 50 };

/* False: an exception is set. */
static bool levels_of(PyObject *list, double levels[MOST_LEVELS], luxel_figure_settings *figure)
{
    if (list == Py_None)
        return true;
    const Py_ssize_t size = PyList_Size(list);

    if (size > MOST_LEVELS)
        PyErr_Format(PyExc_ValueError, "a figure has at most %d levels", MOST_LEVELS);
    if (size < 0 || size > MOST_LEVELS)
        return false;
    for (Py_ssize_t i = 0; i < size; i++) {
        levels[i] = PyFloat_AsDouble(PyList_GetItem(list, i));
        if (PyErr_Occurred())
            return false;
    }
    figure->level_list = levels;
    figure->level_list_count = (size_t)size;
    return true;
}

static bool figure_of(PyObject *tuple, double levels[MOST_LEVELS], luxel_figure_settings *figure)
{
    int logarithmic, bands, extrema, points, section, stacked, dark, small_print, shows_daylight;
    Py_ssize_t wanted, grid;
    PyObject *list;

    luxel_figure_settings_init(figure);
    if (!is_tuple(tuple) ||
        !PyArg_ParseTuple(tuple, "zddpinOppi(dd)pzzddppnp", &figure->palette, &figure->low, &figure->high, &logarithmic,
                          &bands, &wanted, &list, &extrema, &points, &section, &figure->section_mm[0],
                          &figure->section_mm[1], &stacked, &figure->title, &figure->label, &figure->width_mm,
                          &figure->dots_per_inch, &dark, &small_print, &grid, &shows_daylight))
        return false;
    figure->logarithmic = logarithmic != 0;
    figure->bands = (luxel_figure_bands)bands;
    figure->levels = wanted < 0 ? 0 : (size_t)wanted;
    figure->extrema = extrema != 0;
    figure->points = points != 0;
    figure->section = (luxel_figure_section)section;
    figure->stacked = stacked != 0;
    figure->dark = dark != 0;
    figure->small_print = small_print != 0;
    figure->grid = (size_t)grid;
    figure->daylight = shows_daylight != 0;
    return levels_of(list, levels, figure);
}

/* Draws to a file of this name, or to the bytes that it would have. */
static PyObject *draw_figure(PyObject *module, PyObject *arguments, bool in_memory)
{
    PyObject *capsule, *settings, *tuple;
    const char *name;
    unsigned char *bytes = NULL;
    size_t length = 0;
    struct work work;
    double levels[MOST_LEVELS];
    luxel_figure_settings figure;
    const luxel_scene *scene;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, in_memory ? "OOOs" : "OOOy", &capsule, &settings, &tuple, &name) ||
        !(scene = scene_in(capsule)) || !work_begin(&work, settings) || !figure_of(tuple, levels, &figure) ||
        !(diagnostics = diagnostics_begin()))
        return NULL;
    const luxel_language language = language_of(language_here(module));

    figure.language = &language;
    work_leave(&work);
    const luxel_status status =
        in_memory ? luxel_figure_write_memory(scene, &work.settings, &figure, name, diagnostics, &bytes, &length)
                  : luxel_figure_write(scene, &work.settings, &figure, name, diagnostics);

    work_return(&work);
    const bool good = diagnostics_end(language_here(module), status, diagnostics);
    return good && !in_memory ? none() : file_of(good, bytes, length);
}

static PyObject *write_figure(PyObject *module, PyObject *arguments)
{
    return draw_figure(module, arguments, false);
}

static PyObject *figure_bytes(PyObject *module, PyObject *arguments)
{
    return draw_figure(module, arguments, true);
}

/* ---- diagrams of luminaires ---- */

/* Draws to a file of this name, or to the bytes that it would have. */
static PyObject *draw_diagram(PyObject *module, PyObject *arguments, bool in_memory)
{
    PyObject *capsule;
    const char *name;
    unsigned char *bytes = NULL;
    size_t length = 0;
    int diagram, dark;
    luxel_diagram_settings look;
    const luxel_photometry *lamp;
    luxel_diagnostics *diagnostics;
    luxel_status status;

    luxel_diagram_settings_init(&look);
    if (!PyArg_ParseTuple(arguments, in_memory ? "O(izddp)s" : "O(izddp)y", &capsule, &diagram, &look.title,
                          &look.width_mm, &look.dots_per_inch, &dark, &name) ||
        !(lamp = PyCapsule_GetPointer(capsule, PHOTOMETRY_CAPSULE)) || !(diagnostics = diagnostics_begin()))
        return NULL;
    const luxel_language language = language_of(language_here(module));

    look.diagram = (luxel_diagram)diagram;
    look.dark = dark != 0;
    look.language = &language;
    Py_BEGIN_ALLOW_THREADS
    status = in_memory ? luxel_diagram_write_memory(lamp, &look, name, diagnostics, &bytes, &length)
                       : luxel_diagram_write(lamp, &look, name, diagnostics);
    Py_END_ALLOW_THREADS
    const bool good = diagnostics_end(language_here(module), status, diagnostics);
    return good && !in_memory ? none() : file_of(good, bytes, length);
}

static PyObject *write_diagram(PyObject *module, PyObject *arguments)
{
    return draw_diagram(module, arguments, false);
}

static PyObject *diagram_bytes(PyObject *module, PyObject *arguments)
{
    return draw_diagram(module, arguments, true);
}

/* ---- reports ---- */

static PyObject *write_report(PyObject *module, PyObject *arguments)
{
    PyObject *capsule, *settings;
    const char *path;
    struct work work;
    luxel_report_settings report = {0};
    int purpose;
    const luxel_scene *scene;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OO(zzzzzzzzzzzi)y", &capsule, &settings, &report.title, &report.author,
                          &report.group, &report.date, &report.palette, &report.institution, &report.faculty,
                          &report.course, &report.teacher, &report.place, &report.aim, &purpose, &path) ||
        !(scene = scene_in(capsule)) || !work_begin(&work, settings) || !(diagnostics = diagnostics_begin()))
        return NULL;
    const luxel_language language = language_of(language_here(module));

    report.language = &language;
    report.purpose = (luxel_report_purpose)purpose;
    work_leave(&work);
    const luxel_status status = luxel_report_write(scene, &work.settings, &report, path, diagnostics);

    work_return(&work);
    return diagnostics_end(language_here(module), status, diagnostics) ? none() : NULL;
}

static PyObject *palettes(PyObject *module, PyObject *unused)
{
    PyObject *list = PyList_New(0);

    (void)module;
    (void)unused;
    for (size_t i = 0; list && luxel_palette_name(i); i++)
        if (append(list, text_or_none(luxel_palette_name(i))) < 0)
            Py_CLEAR(list);
    return list;
}

static PyMethodDef functions[] = {
    FUNCTION("set_language", set_language, METH_VARARGS, "code: str, translate: Optional[Callable[[str], str]], /",
             "None"),
    FUNCTION("write_figure", write_figure, METH_VARARGS,
             "capsule: object, settings: Tuple[Any, ...], figure: Tuple[Any, ...], path: bytes, /", "None"),
    FUNCTION("figure_bytes", figure_bytes, METH_VARARGS,
             "capsule: object, settings: Tuple[Any, ...], figure: Tuple[Any, ...], name: str, /", "bytes"),
    FUNCTION("write_diagram", write_diagram, METH_VARARGS, "capsule: object, look: Tuple[Any, ...], path: bytes, /",
             "None"),
    FUNCTION("diagram_bytes", diagram_bytes, METH_VARARGS, "capsule: object, look: Tuple[Any, ...], name: str, /",
             "bytes"),
    FUNCTION("write_report", write_report, METH_VARARGS,
             "capsule: object, settings: Tuple[Any, ...], texts: Tuple[Union[str, int, None], ...], path: bytes, /",
             "None"),
    FUNCTION("palettes", palettes, METH_NOARGS, "", "List[str]"),
    {NULL, NULL, 0, NULL},
};

static int traverse(PyObject *module, visitproc visit, void *arg)
{
    Py_VISIT(language_here(module)->translate);
    Py_VISIT(language_here(module)->words);
    return 0;
}

static int clear(PyObject *module)
{
    language_clear(language_here(module));
    return 0;
}

static void release(void *module)
{
    clear(module);
}

PyMODINIT_FUNC PyInit__figure(void);

PyMODINIT_FUNC PyInit__figure(void)
{
    static PyModuleDef_Slot slots[] = {{0, NULL}};
    static struct PyModuleDef definition = {
        PyModuleDef_HEAD_INIT,
        .m_name = "_figure",
        .m_doc = "Figures, reports and diagrams for the package luxel.",
        .m_size = sizeof(struct figure_state),
        .m_methods = functions,
        .m_slots = slots,
        .m_traverse = traverse,
        .m_clear = clear,
        .m_free = release,
    };

    return PyModuleDef_Init(&definition);
}
