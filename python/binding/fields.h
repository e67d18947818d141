// Structs and enumerations of the libraries as Python classes: constructed by keyword, compared and
// printed by value. Does not know any of them.
#pragma once

#include "python/binding/casters.h"

#include <concepts>
#include <string>
#include <vector>

namespace gw::python {

namespace py = pybind11;

/// Sets the members that keywords name. Throws TypeError that names the class, the member and what
/// was expected.
void set_fields(const py::object& object, const py::kwargs& values);
/// "DepthState(test=True, func=CompareFunc.Less)": the members that differ from a new object's.
std::string shown_fields(const py::object& object);

template <class Member>
inline constexpr bool is_list = false;
template <class Element>
inline constexpr bool is_list<std::vector<Element>> = true;
template <class Element, std::size_t size>
inline constexpr bool is_list<std::array<Element, size>> = true;

/// A struct of plain data. Its members are given to `field` one by one.
template <class T>
class Fields {
public:
    Fields(py::module_& module, const char* name, const char* doc) : class_(module, name, doc) {
        class_.def(py::init([](const py::kwargs& values) {
            T value{};
            set_fields(py::cast(&value, py::return_value_policy::reference), values);
            return value;
        }));
        class_.def(
            "copy", [](const T& value) { return T(value); }, "A copy.");
        class_.def("__copy__", [](const T& value) { return T(value); });
        class_.def("__deepcopy__", [](const T& value, const py::dict&) { return T(value); });
        class_.def("__repr__", [](const py::object& self) { return shown_fields(self); });
        if constexpr (std::equality_comparable<T>)
            class_.def(
                "__eq__", [](const T& a, const T& b) { return a == b; }, py::is_operator());
        class_.attr("__hash__") = py::none();
    }
    ~Fields() { class_.attr("_fields") = py::tuple(names_); }
    Fields(const Fields&) = delete;

    template <class Member>
    Fields& field(const char* name, Member T::*member, const char* doc) {
        if constexpr (is_list<Member>)  // else its elements would point into this object
            class_.def_property(
                name, [member](const T& value) { return Member(value.*member); },
                [member](T& value, const Member& elements) { value.*member = elements; }, doc);
        else
            class_.def_readwrite(name, member, doc);
        names_.append(name);
        return *this;
    }
    template <class Get, class Set>
    Fields& property(const char* name, const Get& get, const Set& set, const char* doc) {
        class_.def_property(name, get, set, doc);
        names_.append(name);
        return *this;
    }
    py::class_<T>& type() { return class_; }

private:
    py::class_<T> class_;
    py::list names_;
};

/// An enumeration. Where one is expected, its name as a str does as well.
template <class Enum>
void add_enum(py::module_& module, const std::string& name, const char* doc,
              const std::vector<std::pair<std::string, Enum>>& values) {
    py::enum_<Enum> type(module, name.c_str(), doc);
    for (const auto& [text, value] : values) type.value(text.c_str(), value);
    type.def(py::init([values, name](const std::string& word) {
        std::string known;
        for (const auto& [text, value] : values) {
            if (word == text) return value;
            known += known.empty() ? text : ", " + text;
        }
        throw py::value_error(name + " has no '" + word + "'; expected " + known);
    }));
    // Pickled and copied by its name.
    type.def("__reduce_ex__", [](const py::object& self, int) {
        return py::make_tuple(py::type::of(self), py::make_tuple(self.attr("name")));
    });
    py::implicitly_convertible<py::str, Enum>();
}

}  // namespace gw::python
