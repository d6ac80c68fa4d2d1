/* SPDX-License-Identifier: MIT */
/*
 * What the files of the module share: its state, the handles that Python's classes hold, and the lists of functions.
 *
 * All is written against the limited interface of Python 3.11, so one file serves every later version; arrays go by the
 * buffer protocol.  A function takes plain arguments and returns plain tuples: names, defaults and documentation are in
 * the .py files beside.
 */
#ifndef LUXEL_PYTHON_MODULE_H
#define LUXEL_PYTHON_MODULE_H

#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include <stdbool.h>

#include <luxel/luxel.h>

/*
 * A function of a module: its arguments and its result in the words of Python's types, such as "key: str, /" and "int".
 * tools/make_stubs.py makes the stubs of them, and a test holds these and the function's own signature against it.
 */
#define FUNCTION(name, function, how, parameters, result)                                                              \
    {                                                                                                                  \
        name, function, how, name "(" parameters ")\n--\n\n-> " result                                                 \
    }

/* The language of messages. */
struct language {
    PyObject *translate; /* from English, a function of Python; NULL: English */
    PyObject *words;     /* a dictionary of what was translated, which keeps the texts alive that were handed out */
    char code[16];       /* such as "ru" */
};

/* A module's own memory: the only one that there is, so that interpreters do not meet. */
struct module_state {
    struct language language; /* of both modules */
    PyTypeObject *scene_type;
    PyTypeObject *field_type;
    PyTypeObject *view_type;
    PyTypeObject *holder_type;
};

struct module_state *module_state(PyObject *module);

/* A committed scene, which never changes: a change makes another one. */
struct scene_object {
    PyObject_HEAD luxel_scene *scene;
};

/* The names of the capsules by which the module that draws gets a scene and a luminaire. */
#define SCENE_CAPSULE "luxel._luxel.scene"
#define PHOTOMETRY_CAPSULE "luxel._luxel.photometry"

/* A picture, with the scene it shows or NULL; it hands its values out as a buffer. */
struct field_object {
    PyObject_HEAD luxel_field *field;
    PyObject *scene;
    Py_ssize_t shape[3], strides[3]; /* the third of a picture in colour, whose channels it hands out */
};

/* What a result of the library is kept in: freed with it. */
struct holder_object {
    PyObject_HEAD void *thing;
    void (*release)(void *thing);
};

/* The scene or field of an argument; NULL with an exception where it is none. */
luxel_scene *scene_of(PyObject *module, PyObject *handle);
luxel_field *field_of(PyObject *module, PyObject *handle);

/* A handle of a committed scene, which it takes; NULL: an exception is set, and the scene is freed. */
PyObject *scene_handle(PyObject *module, luxel_scene *scene);

/* A field of a type of Python's, which takes it; `scene` is its handle or NULL.  NULL: an exception is set. */
PyObject *field_handle(PyObject *module, PyObject *type, luxel_field *field, PyObject *scene);

/* What luxel._results makes classes of; None where there is no extremum. */
PyObject *extremum_tuple(const luxel_extremum *extremum);
PyObject *statistics_tuple(const luxel_statistics *statistics);

/* Takes the thing, which is released in any case; NULL: an exception is set. */
PyObject *holder_new(PyObject *module, void *thing, void (*release)(void *thing));

/* Numbers in the memory of `owner` as a buffer that cannot be written; `columns` 0: of one dimension. */
struct view_layout {
    const void *data;
    const char *format; /* of the struct module: "d", "f", "?", "B" */
    Py_ssize_t rows, columns;
    Py_ssize_t stride; /* bytes from row to row; 0: as they follow one another */
};
PyObject *view_new(PyObject *module, PyObject *owner, const struct view_layout *layout);

PyObject *none(void);
PyObject *text_or_none(const char *text);
PyObject *number_or_none(bool given, double number);
PyObject *triple_or_none(bool given, const double vector[3]);

/* What luxel._glare and luxel._room make classes of. */
PyObject *glare_tuple(const luxel_glare *glare);
PyObject *limits_list(const luxel_limit *limits, size_t count);

/* The bytes of a file that the library made in memory, which are freed; `good` false: an exception is set. */
PyObject *file_of(bool good, unsigned char *bytes, size_t length);

/* Whether an argument is a tuple; if not, an exception is set. */
bool is_tuple(PyObject *object);

/* Appends what is handed over; -1: an exception is set, as where `item` is NULL. */
int append(PyObject *list, PyObject *item);

extern const PyMethodDef scene_functions[], edit_functions[], render_functions[], field_functions[],
    reading_functions[], profile_functions[], probe_functions[], evaluate_functions[], grid_functions[],
    balance_functions[], document_functions[], exercise_functions[], photometry_functions[], geometry_functions[],
    glare_functions[], derive_functions[], room_functions[], fit_functions[], exchange_functions[],
    daylight_functions[], arrange_functions[], study_functions[];
extern PyType_Spec scene_spec, field_spec, view_spec, holder_spec;

#endif
