#include "python/binding/interpreter/sealed.h"

namespace gw::python {
namespace {

namespace py = pybind11;

PyTypeObject* base_of_all() {
    return reinterpret_cast<PyTypeObject*>(py::detail::get_internals().instance_base);
}

PyObject* refuse(const PyTypeObject* type) {
    PyErr_Format(PyExc_TypeError, "%s: no object without its constructor; expected %s(...)",
                 type->tp_name, type->tp_name);
    return nullptr;
}

bool is_class(PyObject* object) {
    return PyType_Check(object) != 0 &&
           PyType_IsSubtype(reinterpret_cast<PyTypeObject*>(object), base_of_all()) != 0;
}

/// `__new__` of the sealed classes.
PyObject* refuse_new(PyObject*, PyObject* arguments) {
    PyObject* first = PyTuple_Size(arguments) > 0 ? PyTuple_GetItem(arguments, 0) : nullptr;
    return refuse(first != nullptr && is_class(first) ? reinterpret_cast<PyTypeObject*>(first)
                                                      : base_of_all());
}
PyMethodDef new_method = {"__new__", &refuse_new, METH_VARARGS, nullptr};

/// pybind11's own, of the base class that all its modules share.
newfunc new_by_pybind = nullptr;

/// The same without the base itself, of which pybind11 ends the process.
PyObject* new_of_derived(PyTypeObject* type, PyObject* arguments, PyObject* keywords) {
    if (type == base_of_all()) return refuse(type);
    return new_by_pybind(type, arguments, keywords);
}

/// The base's `__new__`: other modules' classes stay as they are.
PyObject* new_of_others(PyObject*, PyObject* arguments, PyObject* keywords) {
    PyObject* first = PyTuple_Size(arguments) > 0 ? PyTuple_GetItem(arguments, 0) : nullptr;
    if (first == nullptr || !is_class(first)) return refuse(base_of_all());
    auto* type = reinterpret_cast<PyTypeObject*>(first);
    if (PyDict_GetItemString(type->tp_dict, "__new__") != nullptr) return refuse(type);
    const auto rest =
        py::reinterpret_steal<py::tuple>(PyTuple_GetSlice(arguments, 1, PyTuple_Size(arguments)));
    return rest ? new_of_derived(type, rest.ptr(), keywords) : nullptr;
}
PyMethodDef base_new_method = {
    "__new__", reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(&new_of_others)),
    METH_VARARGS | METH_KEYWORDS, nullptr};

void set_new(PyTypeObject* type, PyMethodDef& method) {
    // Into the dictionary, not as an attribute: the slot that the constructor uses stays.
    // It belongs to the class, so that pickle finds no other way to make an object.
    auto* self = reinterpret_cast<PyObject*>(type);
    const auto function = py::reinterpret_steal<py::object>(PyCFunction_New(&method, self));
    if (!function || PyDict_SetItemString(type->tp_dict, "__new__", function.ptr()) != 0)
        throw py::error_already_set();
    PyType_Modified(type);
}

void seal_base() {
    PyTypeObject* base = base_of_all();
    new_by_pybind = base->tp_new;
    base->tp_new = &new_of_derived;
    set_new(base, base_new_method);
}

void seal(PyTypeObject* type) {
    set_new(type, new_method);
    type->tp_flags &= ~Py_TPFLAGS_BASETYPE;
#ifdef Py_TPFLAGS_IMMUTABLETYPE  // since Python 3.10; no object's class can be assigned either
    type->tp_flags |= Py_TPFLAGS_IMMUTABLETYPE;
#endif
}

}  // namespace

void seal_classes(const py::module_& module) {
    seal_base();
    for (const auto& [name, value] : module.attr("__dict__").cast<py::dict>())
        if (is_class(value.ptr())) seal(reinterpret_cast<PyTypeObject*>(value.ptr()));
}

}  // namespace gw::python
