/* SPDX-License-Identifier: MIT */
/* Luminaires: what their files say, their tables as views, what is read off them, and intensities in any direction. */
#include "failure.h"
#include "work.h"

static void release_photometry(void *photometry)
{
    luxel_photometry_free(photometry);
}

static const luxel_photometry *photometry_of(PyObject *module, PyObject *holder)
{
    if (PyObject_TypeCheck(holder, module_state(module)->holder_type) &&
        ((struct holder_object *)holder)->release == release_photometry)
        return ((struct holder_object *)holder)->thing;
    PyErr_SetString(PyExc_TypeError, "a luminaire is expected");
    return NULL;
}

/* Ends reading: the holder and the warnings about the file; takes the luminaire and the diagnostics. */
static PyObject *taken(PyObject *module, luxel_status status, luxel_photometry *photometry,
                       luxel_diagnostics *diagnostics)
{
    struct language *language = &module_state(module)->language;
    PyObject *warnings = status == LUXEL_OK ? diagnostics_list(language, diagnostics) : NULL;

    if (!diagnostics_end(language, status, diagnostics)) {
        Py_XDECREF(warnings);
        luxel_photometry_free(photometry);
        return NULL;
    }
    return Py_BuildValue("(NN)", holder_new(module, photometry, release_photometry), warnings);
}

static PyObject *read_file(PyObject *module, PyObject *path)
{
    const char *name = PyBytes_AsString(path);
    luxel_diagnostics *diagnostics = name ? diagnostics_begin() : NULL;
    luxel_photometry *photometry = NULL;
    luxel_status status;

    if (!diagnostics)
        return NULL;
    Py_BEGIN_ALLOW_THREADS
    status = luxel_photometry_read(name, diagnostics, &photometry);
    Py_END_ALLOW_THREADS
    return taken(module, status, photometry, diagnostics);
}

static PyObject *read_bytes(PyObject *module, PyObject *arguments)
{
    const char *bytes, *name;
    Py_ssize_t length;
    luxel_diagnostics *diagnostics;
    luxel_photometry *photometry = NULL;
    luxel_status status;

    if (!PyArg_ParseTuple(arguments, "y#s", &bytes, &length, &name) || !(diagnostics = diagnostics_begin()))
        return NULL;
    Py_BEGIN_ALLOW_THREADS
    status = luxel_photometry_read_bytes(bytes, (size_t)length, name, diagnostics, &photometry);
    Py_END_ALLOW_THREADS
    return taken(module, status, photometry, diagnostics);
}

static PyObject *number(double value)
{
    return number_or_none(value == value, value);
}

static PyObject *lamp_sets(const luxel_photometry *photometry)
{
    PyObject *list = PyList_New(0);

    for (size_t i = 0; list && i < photometry->lamp_set_count; i++) {
        const luxel_photometry_lamp_set *set = &photometry->lamp_sets[i];

        if (append(list, Py_BuildValue("(dsNssd)", set->count, set->type, number(set->lumens), set->temperature,
                                       set->rendering, set->watts)) < 0)
            Py_CLEAR(list);
    }
    return list;
}

static PyObject *texts(const luxel_photometry *photometry)
{
    PyObject *list = PyList_New(0);

    for (size_t i = 0; list && i < photometry->text_count; i++)
        if (append(list, Py_BuildValue("(ss)", photometry->texts[i].keyword, photometry->texts[i].text)) < 0)
            Py_CLEAR(list);
    return list;
}

static PyObject *table(PyObject *module, PyObject *holder, const double *numbers, size_t rows, size_t columns)
{
    const struct view_layout layout = {
        .data = numbers, .format = "d", .rows = (Py_ssize_t)rows, .columns = (Py_ssize_t)columns};

    return view_new(module, holder, &layout);
}

/* The contents of the file, in the order of luxel._photometry. */
static PyObject *about(PyObject *module, PyObject *holder)
{
    const luxel_photometry *lamp = photometry_of(module, holder);
    static const char *const types[] = {
        [LUXEL_PHOTOMETRY_TYPE_A] = "A", [LUXEL_PHOTOMETRY_TYPE_B] = "B", [LUXEL_PHOTOMETRY_TYPE_C] = "C"};

    if (!lamp)
        return NULL;
    return Py_BuildValue(
        "(ssssNNNONNNdd(sddd)(ddd)NN)", luxel_photometry_format_name(lamp), lamp->version, types[lamp->type],
        luxel_photometry_symmetry_name(lamp->symmetry), table(module, holder, lamp->planes, lamp->plane_count, 0),
        table(module, holder, lamp->angles, lamp->angle_count, 0),
        table(module, holder, lamp->intensities, lamp->plane_count, lamp->angle_count),
        lamp->is_absolute ? Py_True : Py_False, number(lamp->declared_lumens), number(lamp->declared_lorl),
        number(lamp->declared_dff), lamp->multiplier, lamp->watts, luxel_photometry_opening_name(&lamp->opening),
        lamp->opening.width_mm, lamp->opening.length_mm, lamp->opening.height_mm, lamp->housing_mm[0],
        lamp->housing_mm[1], lamp->housing_mm[2], lamp_sets(lamp), texts(lamp));
}

static PyObject *numbers(const double *values, size_t count)
{
    PyObject *list = PyList_New(0);

    for (size_t i = 0; list && i < count; i++)
        if (append(list, number(values[i])) < 0)
            Py_CLEAR(list);
    return list;
}

static PyObject *room_indices(void)
{
    double indices[LUXEL_ROOM_INDICES];

    for (size_t i = 0; i < LUXEL_ROOM_INDICES; i++)
        indices[i] = luxel_photometry_room_index(i);
    return numbers(indices, LUXEL_ROOM_INDICES);
}

/* Figures read off the table, in the order of luxel._photometry. */
static PyObject *measured(PyObject *module, PyObject *holder)
{
    const luxel_photometry *lamp = photometry_of(module, holder);
    luxel_photometry_figures f;
    luxel_status status;

    if (!lamp)
        return NULL;
    Py_BEGIN_ALLOW_THREADS
    status = luxel_photometry_find_figures(lamp, &f);
    Py_END_ALLOW_THREADS
    if (status != LUXEL_OK)
        return PyErr_NoMemory();
    return Py_BuildValue("(ddNN(ddd)NNNNNNNN)", f.zone_lumens, f.linear_lumens, number(f.lorl), number(f.dff),
                         f.greatest_cd, f.greatest_c_deg, f.greatest_gamma_deg, number(f.beam_deg), number(f.field_deg),
                         numbers(f.beam_sections_deg, 2), numbers(f.field_sections_deg, 2), numbers(f.flux_code, 5),
                         room_indices(), numbers(f.direct_ratios, LUXEL_ROOM_INDICES), numbers(f.spacing, 3));
}

/* ---- glare ---- */

static PyObject *ugr_rooms(void)
{
    PyObject *list = PyList_New(0);

    for (size_t i = 0; list && i < LUXEL_UGR_ROOMS; i++)
        if (append(list, Py_BuildValue("(dd)", luxel_ugr_room(i, 0), luxel_ugr_room(i, 1))) < 0)
            Py_CLEAR(list);
    return list;
}

static PyObject *ugr_reflectances(void)
{
    PyObject *list = PyList_New(0);

    for (size_t i = 0; list && i < LUXEL_UGR_REFLECTANCES; i++)
        if (append(list, Py_BuildValue("(ddd)", luxel_ugr_reflectance(i, 0), luxel_ugr_reflectance(i, 1),
                                       luxel_ugr_reflectance(i, 2))) < 0)
            Py_CLEAR(list);
    return list;
}

/* The table of a luminaire; false, with an exception: there is none. */
static bool rate_glare(const luxel_photometry *lamp, double spacing, luxel_ugr_table *table)
{
    luxel_status status;

    Py_BEGIN_ALLOW_THREADS
    status = luxel_photometry_find_ugr_table(lamp, spacing, table);
    Py_END_ALLOW_THREADS
    if (status == LUXEL_ERROR_MEMORY)
        PyErr_NoMemory();
    else if (status != LUXEL_OK)
        PyErr_SetString(PyExc_ValueError, "spacing: 1, 1/2, 1/3 ... 1/8 is expected");
    return status == LUXEL_OK;
}

/* ugr(lamp, spacing): None where the luminaire has no luminance; else spacing, rooms, reflectances and all ratings. */
static PyObject *ugr(PyObject *module, PyObject *arguments)
{
    PyObject *holder;
    double spacing;
    const luxel_photometry *lamp;
    luxel_ugr_table table;

    if (!PyArg_ParseTuple(arguments, "Od", &holder, &spacing) || !(lamp = photometry_of(module, holder)) ||
        !rate_glare(lamp, spacing, &table))
        return NULL;
    if (!table.exists)
        return none();

    PyObject *ratings = PyList_New(0);

    for (size_t i = 0; ratings && i < 2 * LUXEL_UGR_ROOMS; i++)
        if (append(ratings, numbers(table.ratings[i / 2][i % 2], LUXEL_UGR_REFLECTANCES)) < 0)
            Py_CLEAR(ratings);
    return ratings ? Py_BuildValue("(dNNN)", table.spacing, ugr_rooms(), ugr_reflectances(), ratings) : NULL;
}

/* Which room of the table has these heights across and along; LUXEL_UGR_ROOMS: none. */
static size_t room_of(double across, double along)
{
    size_t room = 0;

    while (room < LUXEL_UGR_ROOMS && (luxel_ugr_room(room, 0) != across || luxel_ugr_room(room, 1) != along))
        room++;
    return room;
}

/* Why a room cannot be rated with reflected light, as an exception; false: it can be. */
static bool refuses_room(const luxel_photometry *lamp, const luxel_ugr_table *table, size_t room)
{
    luxel_photometry_figures figures;
    const luxel_status status = luxel_photometry_find_figures(lamp, &figures);

    if (status != LUXEL_OK)
        PyErr_NoMemory();
    else if (!table->exists)
        PyErr_SetString(PyExc_ValueError, "the luminaire has no luminance towards an observer");
    else if (room == LUXEL_UGR_ROOMS)
        PyErr_SetString(PyExc_ValueError, "across, along: a room of the UGR table is expected, such as 4 and 8");
    else if (!(100 - figures.dff < LUXEL_ROOM_UPWARDS))
        PyErr_SetString(PyExc_ValueError, "part of the light goes upwards, and what it makes of the ceiling depends on "
                                          "how far below it the luminaire hangs: make a scene of the room, and ask "
                                          "Scene.glare()");
    else
        return false;
    return true;
}

/* One triple of reflectances: background, its error, crosswise, endwise, their error, whether all was reached. */
static PyObject *rate_triple(PyObject *module, const char *path, const luxel_ugr_table *table, size_t room,
                             size_t triple, PyObject *settings)
{
    struct work work;
    luxel_room_rating rating;
    luxel_diagnostics *diagnostics;

    if (!work_begin(&work, settings) || !(diagnostics = diagnostics_begin()))
        return NULL;
    work.before = (double)triple / LUXEL_UGR_REFLECTANCES;
    work.share = 1.0 / LUXEL_UGR_REFLECTANCES;
    work_leave(&work);
    const luxel_status status = luxel_find_room_rating(path, table, room, triple, &work.settings, diagnostics, &rating);

    work_return(&work);
    if (!diagnostics_end(&module_state(module)->language, status, diagnostics))
        return NULL;
    return Py_BuildValue("(dddddO)", rating.background.value, rating.background.error, rating.ratings[0],
                         rating.ratings[1], rating.error, rating.reached ? Py_True : Py_False);
}

/* room(lamp, path of a file of it, (across, along), spacing, settings): one room of the table by reflected light. */
static PyObject *rate_room(PyObject *module, PyObject *arguments)
{
    PyObject *holder, *settings;
    const char *path;
    double across, along, spacing;
    const luxel_photometry *lamp;
    luxel_ugr_table table;

    if (!PyArg_ParseTuple(arguments, "Oy(dd)dO", &holder, &path, &across, &along, &spacing, &settings) ||
        !(lamp = photometry_of(module, holder)) || !rate_glare(lamp, spacing, &table))
        return NULL;

    const size_t room = room_of(across, along);

    if (refuses_room(lamp, &table, room))
        return NULL;

    PyObject *ratings = PyList_New(0);

    for (size_t i = 0; ratings && i < LUXEL_UGR_REFLECTANCES; i++)
        if (append(ratings, rate_triple(module, path, &table, room, i, settings)) < 0)
            Py_CLEAR(ratings);
    return ratings ? Py_BuildValue("(dNNN)", table.spacing, ugr_reflectances(),
                                   numbers(table.backgrounds[room], LUXEL_UGR_REFLECTANCES), ratings)
                   : NULL;
}

/* ---- directions ---- */

enum { MOST_ARRAYS = 3 };

/* Arrays of float64 without gaps, of so many numbers each for every element. */
struct arrays {
    Py_buffer buffers[MOST_ARRAYS];
    int count;
    double *data[MOST_ARRAYS];
    size_t elements;
};

static void arrays_release(struct arrays *arrays)
{
    while (arrays->count > 0)
        PyBuffer_Release(&arrays->buffers[--arrays->count]);
}

/* False: an exception is set, and nothing is left to release. */
static bool arrays_take(struct arrays *arrays, PyObject *const objects[], const int widths[], int written)
{
    *arrays = (struct arrays){0};
    for (int i = 0; i < MOST_ARRAYS && objects[i]; i++) {
        Py_buffer *buffer = &arrays->buffers[i];

        if (PyObject_GetBuffer(objects[i], buffer, i >= written ? PyBUF_CONTIG : PyBUF_CONTIG_RO) < 0) {
            arrays_release(arrays);
            return false;
        }
        arrays->count++;
        arrays->data[i] = buffer->buf;
        const size_t elements = (size_t)buffer->len / sizeof(double) / (size_t)widths[i];
        if (buffer->itemsize != sizeof(double) || (i > 0 && elements != arrays->elements) ||
            elements * sizeof(double) * (size_t)widths[i] != (size_t)buffer->len) {
            arrays_release(arrays);
            PyErr_SetString(PyExc_ValueError, "arrays of float64 of the same number of elements are expected");
            return false;
        }
        arrays->elements = elements;
    }
    return true;
}

/* intensities(lamp, interpolation, planes, angles, target): cd, one for each pair of angles. */
static PyObject *intensities(PyObject *module, PyObject *arguments)
{
    PyObject *holder, *objects[MOST_ARRAYS];
    int interpolation;
    const luxel_photometry *lamp;
    struct arrays arrays;

    if (!PyArg_ParseTuple(arguments, "OiOOO", &holder, &interpolation, &objects[0], &objects[1], &objects[2]) ||
        !(lamp = photometry_of(module, holder)) || !arrays_take(&arrays, objects, (const int[]){1, 1, 1}, 2))
        return NULL;
    Py_BEGIN_ALLOW_THREADS
    for (size_t i = 0; i < arrays.elements; i++)
        arrays.data[2][i] = luxel_photometry_intensity(lamp, (luxel_photometry_interpolation)interpolation,
                                                       arrays.data[0][i], arrays.data[1][i]);
    Py_END_ALLOW_THREADS
    arrays_release(&arrays);
    return none();
}

/* directions(lamp, planes, angles, target): unit vectors along the axis, c0 and c0 x axis. */
static PyObject *directions(PyObject *module, PyObject *arguments)
{
    PyObject *holder, *objects[MOST_ARRAYS];
    const luxel_photometry *lamp;
    struct arrays arrays;

    if (!PyArg_ParseTuple(arguments, "OOOO", &holder, &objects[0], &objects[1], &objects[2]) ||
        !(lamp = photometry_of(module, holder)) || !arrays_take(&arrays, objects, (const int[]){1, 1, 3}, 2))
        return NULL;
    for (size_t i = 0; i < arrays.elements; i++)
        luxel_photometry_direction(lamp, arrays.data[0][i], arrays.data[1][i], arrays.data[2] + 3 * i);
    arrays_release(&arrays);
    return none();
}

/* angles(lamp, directions, target): pairs of angles of the table. */
static PyObject *angles(PyObject *module, PyObject *arguments)
{
    PyObject *holder, *objects[MOST_ARRAYS] = {NULL};
    const luxel_photometry *lamp;
    struct arrays arrays;

    if (!PyArg_ParseTuple(arguments, "OOO", &holder, &objects[0], &objects[1]) ||
        !(lamp = photometry_of(module, holder)) || !arrays_take(&arrays, objects, (const int[]){3, 2}, 1))
        return NULL;
    for (size_t i = 0; i < arrays.elements; i++)
        luxel_photometry_angles(lamp, arrays.data[0] + 3 * i, arrays.data[1] + 2 * i, arrays.data[1] + 2 * i + 1);
    arrays_release(&arrays);
    return none();
}

/* ---- files ---- */

static PyObject *write_file(PyObject *module, PyObject *arguments)
{
    PyObject *holder;
    const char *path;
    const luxel_photometry *lamp;
    luxel_diagnostics *diagnostics;
    luxel_status status;

    if (!PyArg_ParseTuple(arguments, "Oy", &holder, &path) || !(lamp = photometry_of(module, holder)) ||
        !(diagnostics = diagnostics_begin()))
        return NULL;
    Py_BEGIN_ALLOW_THREADS
    status = luxel_photometry_write(lamp, path, diagnostics);
    Py_END_ALLOW_THREADS
    return diagnostics_end(&module_state(module)->language, status, diagnostics) ? none() : NULL;
}

static void capsule_release(PyObject *capsule)
{
    Py_XDECREF((PyObject *)PyCapsule_GetContext(capsule));
}

/* The luminaire as a capsule, which keeps its holder alive. */
static PyObject *capsule(PyObject *module, PyObject *holder)
{
    const luxel_photometry *lamp = photometry_of(module, holder);
    PyObject *made = lamp ? PyCapsule_New((void *)lamp, PHOTOMETRY_CAPSULE, capsule_release) : NULL;

    if (made && PyCapsule_SetContext(made, Py_NewRef(holder)) < 0) {
        Py_DECREF(holder);
        Py_CLEAR(made);
    }
    return made;
}

const PyMethodDef photometry_functions[] = {
    FUNCTION("photometry_read", read_file, METH_O, "path: bytes, /", "Tuple[Holder, List[Tuple[Any, ...]]]"),
    FUNCTION("photometry_read_bytes", read_bytes, METH_VARARGS, "bytes: bytes, name: str, /",
             "Tuple[Holder, List[Tuple[Any, ...]]]"),
    FUNCTION("photometry_about", about, METH_O, "luminaire: Holder, /", "Tuple[Any, ...]"),
    FUNCTION("photometry_measured", measured, METH_O, "luminaire: Holder, /", "Tuple[Any, ...]"),
    FUNCTION("photometry_room", rate_room, METH_VARARGS,
             "luminaire: Holder, path: bytes, size: Tuple[float, float], spacing: float, settings: _Settings, /",
             "Tuple[Any, ...]"),
    FUNCTION("photometry_ugr", ugr, METH_VARARGS, "luminaire: Holder, spacing: float, /", "Optional[Tuple[Any, ...]]"),
    FUNCTION("photometry_intensities", intensities, METH_VARARGS,
             "luminaire: Holder, interpolation: int, planes: Any, angles: Any, target: Any, /", "None"),
    FUNCTION("photometry_directions", directions, METH_VARARGS,
             "luminaire: Holder, planes: Any, angles: Any, target: Any, /", "None"),
    FUNCTION("photometry_angles", angles, METH_VARARGS, "luminaire: Holder, directions: Any, target: Any, /", "None"),
    FUNCTION("photometry_write", write_file, METH_VARARGS, "luminaire: Holder, path: bytes, /", "None"),
    FUNCTION("photometry_capsule", capsule, METH_O, "luminaire: Holder, /", "object"),
    {NULL, NULL, 0, NULL},
};
