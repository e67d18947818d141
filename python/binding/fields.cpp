#include "python/binding/fields.h"

namespace gw::python {
namespace {

std::string class_name(const py::object& object) {
    return py::type::of(object).attr("__name__").cast<std::string>();
}

std::string expectation(const py::object& old) {
    if (py::isinstance<py::bool_>(old)) return "bool";
    if (py::isinstance<py::tuple>(old)) return std::to_string(py::len(old)) + " numbers";
    return class_name(old);
}

}  // namespace

void set_fields(const py::object& object, const py::kwargs& values) {
    const py::object type = py::type::of(object);
    const auto known = type.attr("_fields").cast<py::tuple>();
    for (const auto& [key, value] : values) {
        if (!known.contains(key))
            throw py::type_error(
                py::str("{} has no '{}'; expected {}")
                    .format(type.attr("__name__"), key, py::str(", ").attr("join")(known)));
        try {
            object.attr(key) = value;
        } catch (py::error_already_set& error) {
            if (error.type().ptr() == PyExc_ValueError)  // a name that an enumeration lacks
                throw py::value_error(
                    py::str("{}.{}: {}").format(type.attr("__name__"), key, error.value()));
            if (!error.matches(PyExc_TypeError)) throw;
            throw py::type_error(
                py::str("{}.{}: got {!r}; expected {}")
                    .format(type.attr("__name__"), key, value, expectation(object.attr(key))));
        }
    }
}

std::string shown_fields(const py::object& object) {
    const py::object type = py::type::of(object), fresh = type();
    py::list parts;
    for (const auto name : type.attr("_fields")) {
        const py::object value = object.attr(name);
        const py::object text = py::repr(value);
        if (text.equal(py::repr(fresh.attr(name)))) continue;
        parts.append(py::str("{}={}").format(name, text));
    }
    return py::str("{}({})")
        .format(type.attr("__name__"), py::str(", ").attr("join")(parts))
        .cast<std::string>();
}

}  // namespace gw::python
