/* SPDX-License-Identifier: MIT */
/*
 * Pictures.  The type is the base of luxel.Field and hands out the values as they lie in the library, so that NumPy
 * shares them; the mask and the places are views.
 */
#include "failure.h"

static const void *channels_of(const luxel_field *field)
{
    const float *single = luxel_field_rgb_single(field);

    return single ? (const void *)single : luxel_field_rgb_double(field);
}

static int field_get(PyObject *self, Py_buffer *buffer, int flags)
{
    struct field_object *field = (struct field_object *)self;
    const bool is_single = field->field && luxel_field_precision(field->field) == LUXEL_SINGLE;
    const Py_ssize_t item = is_single ? (Py_ssize_t)sizeof(float) : (Py_ssize_t)sizeof(double);

    if (!field->field || flags & PyBUF_WRITABLE) {
        PyErr_SetString(PyExc_BufferError, field->field ? "a field cannot be written" : "an empty field has no values");
        return -1;
    }
    const bool in_color = luxel_field_channels(field->field) == 3;
    const void *values = in_color    ? channels_of(field->field)
                         : is_single ? (const void *)luxel_field_single(field->field)
                                     : luxel_field_double(field->field);

    *buffer = (Py_buffer){.buf = (void *)values,
                          .obj = Py_NewRef(self),
                          .len = field->shape[0] * field->strides[0],
                          .itemsize = item,
                          .readonly = 1,
                          .ndim = in_color ? 3 : 2,
                          .format = flags & PyBUF_FORMAT ? (is_single ? "f" : "d") : NULL,
                          .shape = flags & PyBUF_ND ? field->shape : NULL,
                          .strides = (flags & PyBUF_STRIDES) == PyBUF_STRIDES ? field->strides : NULL};
    return 0;
}

static void field_dealloc(PyObject *self)
{
    struct field_object *field = (struct field_object *)self;
    PyTypeObject *type = Py_TYPE(self);

    luxel_field_free(field->field);
    Py_XDECREF(field->scene);
    ((freefunc)PyType_GetSlot(type, Py_tp_free))(self);
    Py_DECREF(type);
}

static PyType_Slot field_slots[] = {
    {Py_tp_dealloc, field_dealloc},
    {Py_bf_getbuffer, field_get},
    {Py_tp_doc, "A picture: the base of luxel.Field."},
    {0, NULL},
};

PyType_Spec field_spec = {.name = "luxel._luxel.FieldHandle",
                          .basicsize = sizeof(struct field_object),
                          .flags = Py_TPFLAGS_DEFAULT | Py_TPFLAGS_BASETYPE,
                          .slots = field_slots};

luxel_field *field_of(PyObject *module, PyObject *handle)
{
    if (PyObject_TypeCheck(handle, module_state(module)->field_type) && ((struct field_object *)handle)->field)
        return ((struct field_object *)handle)->field;
    PyErr_SetString(PyExc_TypeError, "a field is expected");
    return NULL;
}

PyObject *field_handle(PyObject *module, PyObject *type, luxel_field *field, PyObject *scene)
{
    PyObject *made = PyObject_CallNoArgs(type);

    if (made && !PyObject_TypeCheck(made, module_state(module)->field_type)) {
        PyErr_SetString(PyExc_TypeError, "a type of fields is expected");
        Py_CLEAR(made);
    }
    if (!made) {
        luxel_field_free(field);
        return NULL;
    }
    struct field_object *object = (struct field_object *)made;
    const Py_ssize_t item =
        luxel_field_precision(field) == LUXEL_SINGLE ? (Py_ssize_t)sizeof(float) : (Py_ssize_t)sizeof(double);

    object->field = field;
    object->scene = scene ? Py_NewRef(scene) : NULL;
    object->shape[0] = luxel_field_rows(field);
    object->shape[1] = luxel_field_columns(field);
    object->shape[2] = luxel_field_channels(field);
    object->strides[0] = object->shape[1] * object->shape[2] * item;
    object->strides[1] = object->shape[2] * item;
    object->strides[2] = item;
    return made;
}

/* ---- what it says of itself ---- */

static PyObject *field_about(PyObject *module, PyObject *handle)
{
    const luxel_field *field = field_of(module, handle);

    if (!field)
        return NULL;
    return Py_BuildValue("(IIiiNNN)", luxel_field_columns(field), luxel_field_rows(field), luxel_field_quantity(field),
                         luxel_field_precision(field), text_or_none(luxel_field_quantity_word(field)),
                         text_or_none(luxel_field_unit(field)), text_or_none(luxel_field_instruction_set(field)));
}

/* By itself, as a rendered field writes it when it is first asked for. */
static PyObject *field_text(PyObject *module, PyObject *handle)
{
    const luxel_field *field = field_of(module, handle);

    return field ? text_or_none(luxel_field_scene(field)) : NULL;
}

static PyObject *field_scene(PyObject *module, PyObject *handle)
{
    if (!field_of(module, handle))
        return NULL;
    PyObject *scene = ((struct field_object *)handle)->scene;

    return Py_NewRef(scene ? scene : Py_None);
}

static PyObject *field_mask(PyObject *module, PyObject *handle)
{
    const luxel_field *field = field_of(module, handle);

    if (!field)
        return NULL;
    const struct view_layout layout = {.data = luxel_field_mask(field),
                                       .format = "?",
                                       .rows = luxel_field_rows(field),
                                       .columns = luxel_field_columns(field)};

    return view_new(module, handle, &layout);
}

/* The luminance of a picture in colour, and the values of another one. */
static PyObject *field_luminance(PyObject *module, PyObject *handle)
{
    const luxel_field *field = field_of(module, handle);

    if (!field)
        return NULL;
    const bool is_single = luxel_field_precision(field) == LUXEL_SINGLE;
    const struct view_layout layout = {.data = is_single ? (const void *)luxel_field_single(field)
                                                         : luxel_field_double(field),
                                       .format = is_single ? "f" : "d",
                                       .rows = luxel_field_rows(field),
                                       .columns = luxel_field_columns(field)};

    return view_new(module, handle, &layout);
}

static PyObject *field_places(PyObject *module, PyObject *handle)
{
    const luxel_field *field = field_of(module, handle);

    if (!field)
        return NULL;
    const struct view_layout x = {.data = luxel_field_x_mm(field), .format = "d", .rows = luxel_field_columns(field)};
    const struct view_layout y = {.data = luxel_field_y_mm(field), .format = "d", .rows = luxel_field_rows(field)};

    return Py_BuildValue("(NN)", x.data ? view_new(module, handle, &x) : none(),
                         y.data ? view_new(module, handle, &y) : none());
}

PyObject *extremum_tuple(const luxel_extremum *extremum)
{
    if (!extremum->exists)
        return none();
    return Py_BuildValue("(dIIdd)", extremum->value, extremum->column, extremum->row, extremum->x_mm, extremum->y_mm);
}

PyObject *statistics_tuple(const luxel_statistics *statistics)
{
    return Py_BuildValue("(NNNNnNNd)", extremum_tuple(&statistics->maximum), extremum_tuple(&statistics->minimum),
                         number_or_none(statistics->has_surface, statistics->mean),
                         number_or_none(statistics->has_surface, statistics->lit),
                         (Py_ssize_t)statistics->surface_pixels, extremum_tuple(&statistics->minimum_reached),
                         number_or_none(statistics->has_reflected, statistics->reflected_error),
                         statistics->mirrored_error);
}

static PyObject *field_statistics(PyObject *module, PyObject *handle)
{
    const luxel_field *field = field_of(module, handle);

    return field ? statistics_tuple(luxel_field_statistics(field)) : NULL;
}

/* ---- grey levels, files ---- */

/* Fills a buffer of Python with grey levels: its size tells of how many bits they are. */
static PyObject *field_grey(PyObject *module, PyObject *arguments)
{
    PyObject *handle, *target;
    const luxel_field *field;
    Py_buffer buffer;

    if (!PyArg_ParseTuple(arguments, "OO", &handle, &target) || !(field = field_of(module, handle)) ||
        PyObject_GetBuffer(target, &buffer, PyBUF_WRITABLE) < 0)
        return NULL;
    const Py_ssize_t pixels = (Py_ssize_t)luxel_field_rows(field) * luxel_field_columns(field);
    const bool fits = buffer.len == pixels || buffer.len == 2 * pixels;

    if (buffer.len == pixels)
        luxel_field_grey(field, buffer.buf);
    else if (fits)
        luxel_field_grey16(field, buffer.buf);
    PyBuffer_Release(&buffer);
    if (fits)
        return none();
    PyErr_SetString(PyExc_ValueError, "one or two bytes for each pixel are expected");
    return NULL;
}

/* Writes a file of this name, or makes the bytes that it would have. */
static PyObject *make_file(PyObject *module, PyObject *arguments, bool in_memory)
{
    PyObject *handle;
    const char *name;
    const luxel_field *field;
    luxel_field_output how = {0};
    luxel_diagnostics *diagnostics;
    luxel_status status;
    unsigned char *bytes = NULL;
    size_t length = 0;

    if (!PyArg_ParseTuple(arguments, in_memory ? "OsI" : "OyI", &handle, &name, &how.bits) ||
        !(field = field_of(module, handle)) || !(diagnostics = diagnostics_begin()))
        return NULL;
    Py_BEGIN_ALLOW_THREADS
    status = in_memory ? luxel_field_write_memory(field, name, &how, diagnostics, &bytes, &length)
                       : luxel_field_write_as(field, name, &how, diagnostics);
    Py_END_ALLOW_THREADS
    const bool good = diagnostics_end(&module_state(module)->language, status, diagnostics);
    return good && !in_memory ? none() : file_of(good, bytes, length);
}

static PyObject *field_write(PyObject *module, PyObject *arguments)
{
    return make_file(module, arguments, false);
}

static PyObject *field_bytes(PyObject *module, PyObject *arguments)
{
    return make_file(module, arguments, true);
}

static PyObject *field_read(PyObject *module, PyObject *arguments)
{
    PyObject *type;
    const char *path;
    luxel_field *field = NULL;
    luxel_diagnostics *diagnostics;
    luxel_status status;

    if (!PyArg_ParseTuple(arguments, "Oy", &type, &path) || !(diagnostics = diagnostics_begin()))
        return NULL;
    Py_BEGIN_ALLOW_THREADS
    status = luxel_field_read(path, diagnostics, &field);
    Py_END_ALLOW_THREADS
    if (!diagnostics_end(&module_state(module)->language, status, diagnostics)) {
        luxel_field_free(field);
        return NULL;
    }
    return field_handle(module, type, field, NULL);
}

static PyObject *field_view(PyObject *module, PyObject *arguments)
{
    PyObject *type, *handle;
    int view;
    luxel_field *shown = NULL;
    luxel_diagnostics *diagnostics;

    if (!PyArg_ParseTuple(arguments, "OOi", &type, &handle, &view))
        return NULL;
    const luxel_field *field = field_of(module, handle);

    if (!field || !(diagnostics = diagnostics_begin()))
        return NULL;
    const luxel_status status = luxel_field_of_view(field, (luxel_color_view)view, diagnostics, &shown);
    if (!diagnostics_end(&module_state(module)->language, status, diagnostics)) {
        luxel_field_free(shown);
        return NULL;
    }
    return field_handle(module, type, shown, NULL);
}

/* The buffers that a field is made of, in this order; None where there is none. */
enum { VALUES, MASK, X_MM, Y_MM, PARTS };

/* Takes the buffers: contiguous, values of float or double, the mask of bytes, places of double, each as long as the
 * picture is large.  False: an exception is set.  Those that were taken are to be released in any case. */
static bool take_parts(PyObject *const objects[PARTS], Py_buffer buffers[PARTS], luxel_field_content *content)
{
    const Py_ssize_t pixels = (Py_ssize_t)content->columns * content->rows;
    const Py_ssize_t width =
        content->precision == LUXEL_DOUBLE ? (Py_ssize_t)sizeof(double) : (Py_ssize_t)sizeof(float);
    const Py_ssize_t place = (Py_ssize_t)sizeof(double);
    const Py_ssize_t lengths[PARTS] = {pixels * width, pixels, content->columns * place, content->rows * place};

    for (int i = 0; i < PARTS; i++) {
        if (objects[i] == Py_None && i != VALUES)
            continue;
        if (PyObject_GetBuffer(objects[i], &buffers[i], PyBUF_C_CONTIGUOUS) < 0)
            return false;
        if (buffers[i].len != lengths[i]) {
            PyErr_SetString(PyExc_ValueError, "an array has another size than the picture");
            return false;
        }
    }
    content->values = buffers[VALUES].buf;
    content->mask = buffers[MASK].buf;
    content->x_mm = buffers[X_MM].buf;
    content->y_mm = buffers[Y_MM].buf;
    return true;
}

static PyObject *field_of_values(PyObject *module, PyObject *arguments)
{
    PyObject *type, *parts[PARTS], *made = NULL;
    Py_buffer buffers[PARTS] = {0};
    luxel_field_content content = {0};
    luxel_field *field = NULL;
    luxel_diagnostics *diagnostics;
    unsigned precision;
    int quantity; /* below 0: not known */

    if (!PyArg_ParseTuple(arguments, "OIIIizOOOO", &type, &content.columns, &content.rows, &precision, &quantity,
                          &content.unit, &parts[VALUES], &parts[MASK], &parts[X_MM], &parts[Y_MM]))
        return NULL;
    content.precision = (luxel_precision)precision;
    content.quantity_known = quantity >= 0;
    content.quantity = quantity > 0 ? (luxel_quantity)quantity : LUXEL_BRIGHTNESS;
    if (take_parts(parts, buffers, &content) && (diagnostics = diagnostics_begin())) {
        luxel_status status;
        Py_BEGIN_ALLOW_THREADS
        status = luxel_field_of_values(&content, diagnostics, &field);
        Py_END_ALLOW_THREADS
        if (diagnostics_end(&module_state(module)->language, status, diagnostics))
            made = field_handle(module, type, field, NULL);
    }
    for (int i = 0; i < PARTS; i++)
        PyBuffer_Release(&buffers[i]);
    return made;
}

static PyObject *field_read_bytes(PyObject *module, PyObject *arguments)
{
    PyObject *type;
    const char *bytes, *name;
    Py_ssize_t length;
    luxel_field *field = NULL;
    luxel_diagnostics *diagnostics;
    luxel_status status;

    if (!PyArg_ParseTuple(arguments, "Oy#s", &type, &bytes, &length, &name) || !(diagnostics = diagnostics_begin()))
        return NULL;
    Py_BEGIN_ALLOW_THREADS
    status = luxel_field_read_memory(bytes, (size_t)length, name, diagnostics, &field);
    Py_END_ALLOW_THREADS
    return diagnostics_end(&module_state(module)->language, status, diagnostics)
               ? field_handle(module, type, field, NULL)
               : NULL;
}

const PyMethodDef field_functions[] = {
    FUNCTION("field_about", field_about, METH_O, "field: FieldHandle, /", "Tuple[int, int, int, int, str, str, str]"),
    FUNCTION("field_text", field_text, METH_O, "field: FieldHandle, /", "Optional[str]"),
    FUNCTION("field_scene", field_scene, METH_O, "field: FieldHandle, /", "Optional[SceneHandle]"),
    FUNCTION("field_mask", field_mask, METH_O, "field: FieldHandle, /", "View"),
    FUNCTION("field_luminance", field_luminance, METH_O, "field: FieldHandle, /", "View"),
    FUNCTION("field_places", field_places, METH_O, "field: FieldHandle, /", "Tuple[Optional[View], Optional[View]]"),
    FUNCTION("field_statistics", field_statistics, METH_O, "field: FieldHandle, /", "Tuple[Any, ...]"),
    FUNCTION("field_grey", field_grey, METH_VARARGS, "field: FieldHandle, levels: Any, /", "None"),
    FUNCTION("field_write", field_write, METH_VARARGS, "field: FieldHandle, path: bytes, bits: int, /", "None"),
    FUNCTION("field_bytes", field_bytes, METH_VARARGS, "field: FieldHandle, name: str, bits: int, /", "bytes"),
    FUNCTION("field_view", field_view, METH_VARARGS, "type: Type[_Field], field: FieldHandle, view: int, /", "_Field"),
    FUNCTION("field_read", field_read, METH_VARARGS, "type: Type[_Field], path: bytes, /", "_Field"),
    FUNCTION("field_read_bytes", field_read_bytes, METH_VARARGS, "type: Type[_Field], bytes: bytes, name: str, /",
             "_Field"),
    FUNCTION("field_of_values", field_of_values, METH_VARARGS,
             "type: Type[_Field], columns: int, rows: int, precision: int, quantity: int, unit: Optional[str], "
             "values: Any, mask: Any, x_mm: Any, y_mm: Any, /",
             "_Field"),
    {NULL, NULL, 0, NULL},
};
