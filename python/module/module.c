/* SPDX-License-Identifier: MIT */
/*
 * The module luxel._luxel: its types and functions, put together from the other files.  It is initialised in phases and
 * keeps all that it has in its state.
 */
#include "module.h"

#include "failure.h"

struct module_state *module_state(PyObject *module)
{
    return PyModule_GetState(module);
}

static PyObject *set_language(PyObject *module, PyObject *arguments)
{
    return language_set(&module_state(module)->language, arguments);
}

static PyObject *version(PyObject *module, PyObject *unused)
{
    (void)module;
    (void)unused;
    return text_or_none(luxel_version());
}

static PyMethodDef own_functions[] = {
    FUNCTION("set_language", set_language, METH_VARARGS, "code: str, translate: Optional[Callable[[str], str]], /",
             "None"),
    FUNCTION("version", version, METH_NOARGS, "", "str"),
    {NULL, NULL, 0, NULL},
};

static int add_functions(PyObject *module)
{
    static const PyMethodDef *const lists[] = {
        scene_functions,    edit_functions,     render_functions,     field_functions,    reading_functions,
        profile_functions,  probe_functions,    evaluate_functions,   grid_functions,     balance_functions,
        document_functions, exercise_functions, photometry_functions, geometry_functions, glare_functions,
        derive_functions,   room_functions,     fit_functions,        exchange_functions, daylight_functions,
        arrange_functions,  study_functions};

    for (size_t i = 0; i < sizeof lists / sizeof *lists; i++)
        if (PyModule_AddFunctions(module, (PyMethodDef *)lists[i]) < 0)
            return -1;
    return 0;
}

static int add_type(PyObject *module, PyType_Spec *spec, PyTypeObject **type)
{
    *type = (PyTypeObject *)PyType_FromModuleAndSpec(module, spec, NULL);
    return *type ? PyModule_AddType(module, *type) : -1;
}

static int execute(PyObject *module)
{
    struct module_state *state = module_state(module);

    if (add_functions(module) < 0 || add_type(module, &scene_spec, &state->scene_type) < 0 ||
        add_type(module, &field_spec, &state->field_type) < 0 || add_type(module, &view_spec, &state->view_type) < 0)
        return -1;
    if (add_type(module, &holder_spec, &state->holder_type) < 0)
        return -1;
    return PyModule_AddStringConstant(module, "LOCALEDIR", LUXEL_PYTHON_LOCALEDIR);
}

static int traverse(PyObject *module, visitproc visit, void *arg)
{
    struct module_state *state = module_state(module);

    Py_VISIT(state->language.translate);
    Py_VISIT(state->language.words);
    Py_VISIT(state->scene_type);
    Py_VISIT(state->field_type);
    Py_VISIT(state->view_type);
    Py_VISIT(state->holder_type);
    return 0;
}

static int clear(PyObject *module)
{
    struct module_state *state = module_state(module);

    language_clear(&state->language);
    Py_CLEAR(state->scene_type);
    Py_CLEAR(state->field_type);
    Py_CLEAR(state->view_type);
    Py_CLEAR(state->holder_type);
    return 0;
}

static void release(void *module)
{
    clear(module);
}

PyMODINIT_FUNC PyInit__luxel(void);

PyMODINIT_FUNC PyInit__luxel(void)
{
    static PyModuleDef_Slot slots[] = {{Py_mod_exec, execute}, {0, NULL}};
    static struct PyModuleDef definition = {
        PyModuleDef_HEAD_INIT,
        .m_name = "_luxel",
        .m_doc = "The library Luxel as it is: handles, tuples and buffers for the classes of the package luxel.",
        .m_size = sizeof(struct module_state),
        .m_methods = own_functions,
        .m_slots = slots,
        .m_traverse = traverse,
        .m_clear = clear,
        .m_free = release,
    };

    return PyModuleDef_Init(&definition);
}
