/* SPDX-License-Identifier: MIT */
/* Measuring grids: their values and errors as views, what is read off them, and the extrema on their planes. */
#include "failure.h"
#include "work.h"

static void release_grid(void *grid)
{
    luxel_grid_free(grid);
}

static PyObject *extremum(const luxel_grid *grid, const luxel_grid_extremum *extremum)
{
    if (grid->measured == 0)
        return none();
    return Py_BuildValue("(dIIN)", extremum->value, extremum->column, extremum->row,
                         triple_or_none(true, extremum->position_mm));
}

static PyObject *cells(PyObject *module, PyObject *holder, const luxel_grid *grid, const void *data, const char *format)
{
    const struct view_layout layout = {.data = data, .format = format, .rows = grid->rows, .columns = grid->columns};

    return view_new(module, holder, &layout);
}

static PyObject *place(const luxel_grid *grid)
{
    return Py_BuildValue("(N(dd)NNN)", triple_or_none(true, grid->center_mm), grid->size_mm[0], grid->size_mm[1],
                         triple_or_none(true, grid->axis), triple_or_none(true, grid->up),
                         triple_or_none(true, grid->across));
}

static PyObject *plane(const luxel_grid *grid)
{
    if (!grid->has_mean)
        return none();
    return Py_BuildValue("(ddNdd)", grid->mean.value, grid->mean.error, text_or_none(grid->flux_unit), grid->flux.value,
                         grid->flux.error);
}

static PyObject *sampling(const luxel_grid *grid)
{
    if (!grid->has_sampling_error)
        return none();
    return Py_BuildValue("(dOO)", grid->sampling_error, grid->sampling_is_bound ? Py_True : Py_False,
                         grid->is_coarse ? Py_True : Py_False);
}

static PyObject *modelling(const luxel_grid *grid)
{
    if (!grid->has_modelling)
        return none();
    return Py_BuildValue("((dd)(dd)(dd))", grid->modelling.value, grid->modelling.error, grid->least_modelling.value,
                         grid->least_modelling.error, grid->greatest_modelling.value, grid->greatest_modelling.error);
}

/* An area around a plane. */
static PyObject *area(const luxel_grid *grid)
{
    if (!grid)
        return none();
    return Py_BuildValue("(nNNNNNN(ddd)(dd))", (Py_ssize_t)grid->measured,
                         number_or_none(grid->measured > 0, grid->average.value),
                         number_or_none(grid->measured > 0, grid->average.error), extremum(grid, &grid->minimum),
                         extremum(grid, &grid->maximum), number_or_none(grid->measured > 0, grid->error),
                         number_or_none(grid->has_evenness, grid->u0), grid->center_mm[0], grid->center_mm[1],
                         grid->center_mm[2], grid->size_mm[0], grid->size_mm[1]);
}

/* Takes the grid. */
static PyObject *grid_tuple(PyObject *module, luxel_grid *grid)
{
    PyObject *holder = holder_new(module, grid, release_grid);

    if (!holder)
        return NULL;
    const bool is_blocked = grid->measured + grid->enclosed < (size_t)grid->rows * grid->columns;
    PyObject *tuple = Py_BuildValue(
        "(NNNsNNNNnNdNNNNNNNNNOnsNNN)", Py_NewRef(holder), text_or_none(grid->name), place(grid), grid->unit,
        cells(module, holder, grid, grid->values, "d"), cells(module, holder, grid, grid->errors, "d"),
        cells(module, holder, grid, grid->mask, "?"), cells(module, holder, grid, grid->inside, "?"),
        (Py_ssize_t)grid->measured, is_blocked ? PyLong_FromSize_t(grid->blocking_light) : none(), grid->error,
        number_or_none(grid->measured > 0, grid->average.value),
        number_or_none(grid->measured > 0, grid->average.error), extremum(grid, &grid->minimum),
        extremum(grid, &grid->maximum), number_or_none(grid->has_evenness, grid->u0),
        number_or_none(grid->has_evenness, grid->ud), plane(grid), sampling(grid),
        grid->enclosed > 0 ? PyLong_FromSize_t(grid->enclosing_surface) : none(),
        grid->tolerance_reached && grid->reflected_reached ? Py_True : Py_False, (Py_ssize_t)grid->enclosed,
        grid->measure, modelling(grid), area(grid->surround), area(grid->background));

    Py_DECREF(holder);
    return tuple;
}

static PyObject *measure(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *settings;
    Py_ssize_t index;
    struct work work;
    luxel_grid *grid = NULL;
    const luxel_scene *scene;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OnO", &handle, &index, &settings) || !(scene = scene_of(module, handle)) ||
        !work_begin(&work, settings) || !(diagnostics = diagnostics_begin()))
        return NULL;
    work_leave(&work);
    const luxel_status status = luxel_find_grid(scene, &work.settings, (size_t)index, diagnostics, &grid);

    work_return(&work);
    if (diagnostics_end(&module_state(module)->language, status, diagnostics))
        return grid_tuple(module, grid);
    luxel_grid_free(grid);
    return NULL;
}

/* ---- the whole plane ---- */

static PyObject *peak(const luxel_grid_peak *peak)
{
    return peak->exists ? Py_BuildValue("(ddN(dd))", peak->value, peak->error, triple_or_none(true, peak->position_mm),
                                        peak->on_plane_mm[0], peak->on_plane_mm[1])
                        : none();
}

static PyObject *grid_extrema(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *settings;
    Py_ssize_t index;
    struct work work;
    luxel_grid_extrema extrema;
    const luxel_scene *scene;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OnO", &handle, &index, &settings) || !(scene = scene_of(module, handle)) ||
        !work_begin(&work, settings) || !(diagnostics = diagnostics_begin()))
        return NULL;
    work_leave(&work);
    const luxel_status status = luxel_find_grid_extrema(scene, &work.settings, (size_t)index, diagnostics, &extrema);

    work_return(&work);
    if (!diagnostics_end(&module_state(module)->language, status, diagnostics))
        return NULL;
    return Py_BuildValue("(NN)", peak(&extrema.maximum), peak(&extrema.minimum));
}

/* ---- the cells ---- */

static PyObject *grid_count(PyObject *module, PyObject *handle)
{
    const luxel_scene *scene = scene_of(module, handle);

    return scene ? PyLong_FromSize_t(luxel_scene_grid_count(scene)) : NULL;
}

static const luxel_grid *grid_of(PyObject *module, PyObject *holder)
{
    if (PyObject_TypeCheck(holder, module_state(module)->holder_type) &&
        ((struct holder_object *)holder)->release == release_grid)
        return ((struct holder_object *)holder)->thing;
    PyErr_SetString(PyExc_TypeError, "a grid is expected");
    return NULL;
}

/* judge_grid(scene, index, grid): its limits. */
static PyObject *judge_grid(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *holder;
    Py_ssize_t index;
    luxel_limit limits[2 * LUXEL_MOST_LIMITS];
    size_t count = 0;
    const luxel_scene *scene;
    const luxel_grid *grid;

    if (!PyArg_ParseTuple(arguments, "OnO", &handle, &index, &holder) || !(scene = scene_of(module, handle)) ||
        !(grid = grid_of(module, holder)))
        return NULL;
    luxel_judge_grid_and_areas(scene, (size_t)index, grid, limits, &count);
    return limits_list(limits, count);
}

/* Fills an array of rows x columns x 3 float64 with the centres of the cells. */
static PyObject *grid_positions(PyObject *module, PyObject *arguments)
{
    PyObject *holder, *target;
    const luxel_grid *grid;
    Py_buffer buffer;

    if (!PyArg_ParseTuple(arguments, "OO", &holder, &target) || !(grid = grid_of(module, holder)) ||
        PyObject_GetBuffer(target, &buffer, PyBUF_WRITABLE) < 0)
        return NULL;
    double(*places)[3] = buffer.buf;
    const bool fits = buffer.len == (Py_ssize_t)sizeof *places * grid->rows * grid->columns;

    for (unsigned row = 0; fits && row < grid->rows; row++)
        for (unsigned column = 0; column < grid->columns; column++)
            luxel_grid_position(grid, column, row, places[(size_t)row * grid->columns + column]);
    PyBuffer_Release(&buffer);
    if (fits)
        return none();
    PyErr_SetString(PyExc_ValueError, "three float64 for each cell are expected");
    return NULL;
}

static PyObject *grid_write(PyObject *module, PyObject *arguments)
{
    PyObject *holder;
    const char *path;
    const luxel_grid *grid;
    luxel_diagnostics *diagnostics;
    luxel_status status;

    if (!PyArg_ParseTuple(arguments, "Oy", &holder, &path) || !(grid = grid_of(module, holder)) ||
        !(diagnostics = diagnostics_begin()))
        return NULL;
    Py_BEGIN_ALLOW_THREADS
    status = luxel_grids_write(&grid, 1, path, diagnostics);
    Py_END_ALLOW_THREADS
    return diagnostics_end(&module_state(module)->language, status, diagnostics) ? none() : NULL;
}

const PyMethodDef grid_functions[] = {
    FUNCTION("measure", measure, METH_VARARGS, "scene: SceneHandle, index: int, settings: _Settings, /",
             "Tuple[Any, ...]"),
    FUNCTION("grid_extrema", grid_extrema, METH_VARARGS, "scene: SceneHandle, index: int, settings: _Settings, /",
             "Tuple[Any, Any]"),
    FUNCTION("grid_count", grid_count, METH_O, "scene: SceneHandle, /", "int"),
    FUNCTION("grid_positions", grid_positions, METH_VARARGS, "grid: Holder, places: Any, /", "None"),
    FUNCTION("judge_grid", judge_grid, METH_VARARGS, "scene: SceneHandle, index: int, grid: Holder, /",
             "List[Tuple[Any, ...]]"),
    FUNCTION("grid_write", grid_write, METH_VARARGS, "grid: Holder, path: bytes, /", "None"),
    {NULL, NULL, 0, NULL},
};
