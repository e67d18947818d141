// Arrays of the libraries as NumPy arrays and back. A view shares memory with the object that owns
// it; everything else is a copy.
#pragma once

#include "gw/error.h"
#include "python/binding/casters.h"

#include <cstring>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace gw::python {

namespace py = pybind11;

template <class T>
using Input = py::array_t<T, py::array::c_style | py::array::forcecast>;

/// A read-only view of `count` elements of `channels` numbers each, in `shape`; `owner` lives as
/// long as it does.
template <class Number>
py::array view_of(const void* data, const std::vector<py::ssize_t>& shape, py::handle owner) {
    py::array_t<Number> view(shape, static_cast<const Number*>(data), owner);
    view.attr("flags").attr("writeable") = false;
    return view;
}

/// An array that owns a vector's memory.
template <class Number, class Vector>
py::array array_of(Vector values, const std::vector<py::ssize_t>& shape) {
    auto* kept = new Vector(std::move(values));
    const py::capsule owner(kept, [](void* p) { delete static_cast<Vector*>(p); });
    return py::array_t<Number>(shape, reinterpret_cast<const Number*>(kept->data()), owner);
}

/// The shape of a picture's rows, with or without channels.
inline std::vector<py::ssize_t> rows(int height, int width, int channels = 0) {
    std::vector<py::ssize_t> shape{height, width};
    if (channels > 0) shape.push_back(channels);
    return shape;
}

inline std::string shape_text(const py::array& array) {
    return py::str(py::object(array.attr("shape"))).cast<std::string>();
}

/// An array of numpy.ma of which some elements are missing.
inline bool is_masked(const py::object& object) {
    return py::isinstance<py::array>(object) && py::hasattr(object, "mask") &&
           object.attr("mask").attr("any")().cast<bool>();
}

/// NumPy's array of an object; `name` is the argument's. Throws Error if it is none or is masked,
/// and MemoryError if NumPy has no memory for it.
template <class Array = py::array>
Array array_from(const py::object& object, const char* name) {
    if (is_masked(object))
        throw Error(std::string(name) + ": has masked elements; expected none, as filled() gives");
    try {
        return Array(object);
    } catch (py::error_already_set& error) {
        if (error.matches(PyExc_MemoryError)) throw;
        throw Error(std::string(name) + ": no array of numbers; expected one");
    }
}

/// A length along an axis of an image, as the machine counts. Throws Error if it does not fit.
inline int length_of(const py::array& array, int axis, const char* name) {
    const py::ssize_t length = array.shape(axis);
    if (length > std::numeric_limits<int>::max())
        throw Error(std::string(name) + ": an array of shape " + shape_text(array) +
                    "; expected at most " + std::to_string(std::numeric_limits<int>::max()) +
                    " along an axis");
    return int(length);
}

/// Elements of `channels` numbers each: an array of (n, channels), or of n if channels is 1. None:
/// no elements. Throws Error "positions: an array of shape (3,); expected (n, 3)".
template <class Element, class Number>
std::vector<Element> elements_of(const py::object& object, int channels, const char* name) {
    static_assert(std::is_standard_layout_v<Element>);
    if (object.is_none()) return {};
    const auto array = array_from<Input<Number>>(object, name);
    const bool fits =
        channels == 1 ? array.ndim() == 1 : array.ndim() == 2 && array.shape(1) == channels;
    if (!fits)
        throw Error(std::string(name) + ": an array of shape " + shape_text(array) +
                    "; expected (n" +
                    (channels == 1 ? ",)" : ", " + std::to_string(channels) + ")"));
    std::vector<Element> out(std::size_t(array.shape(0)));
    if (!out.empty())
        std::memcpy(static_cast<void*>(out.data()), array.data(), std::size_t(array.nbytes()));
    return out;
}

/// The same from whole numbers, which must fit: a fraction or a number below `least` is an error,
/// not another number.
template <class Number>
std::vector<Number> whole_numbers_of(const py::object& object, const char* name,
                                     std::int64_t least = 0) {
    if (object.is_none()) return {};
    const auto array = array_from(object, name);
    const char kind = array.dtype().kind();
    if (array.size() > 0 && kind != 'i' && kind != 'u' && kind != 'b')
        throw Error(std::string(name) + ": an array of type " +
                    py::str(py::object(array.dtype())).cast<std::string>() +
                    "; expected whole numbers");
    const auto wide = array_from<Input<std::int64_t>>(array, name);
    const std::int64_t most = std::int64_t(std::numeric_limits<Number>::max());
    std::vector<Number> out(std::size_t(wide.size()));
    for (std::size_t i = 0; i < out.size(); ++i) {
        const std::int64_t value = wide.data()[i];
        if (value < least || value > most)
            throw Error(std::string(name) + ": element " + std::to_string(i) + " is " +
                        std::to_string(value) + "; expected " + std::to_string(least) + " .. " +
                        std::to_string(most));
        out[i] = Number(value);
    }
    return out;
}

}  // namespace gw::python
