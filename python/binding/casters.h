// Vectors, matrices and rectangles as Python has them: tuples and NumPy arrays. Included by every
// source of the module, so that all convert alike.
#pragma once

#include "gw/base/types.h"
#include "gw/profile.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <type_traits>

namespace pybind11::detail {

/// An enumeration or a profile. A wrong name raises the error of its class, which lists the names.
template <class Named>
struct named_caster : type_caster_base<Named> {
    bool load(handle source, bool convert) {
        if (type_caster_base<Named>::load(source, convert)) return true;
        if (convert && source && isinstance<str>(source)) type::of<Named>()(source);
        return false;
    }
};
template <>
struct type_caster<gw::Profile> : named_caster<gw::Profile> {};
template <class Enum>
struct type_caster<Enum, std::enable_if_t<std::is_enum_v<Enum>>> : named_caster<Enum> {};

/// A vector: from any sequence of as many numbers, to a tuple.
template <class Vector, class Number, int size>
struct vector_caster {
    static constexpr auto in_python() {
        if constexpr (size == 2) return const_name("Tuple[float, float]");
        if constexpr (size == 3) return const_name("Tuple[float, float, float]");
        if constexpr (size == 4) return const_name("Tuple[float, float, float, float]");
    }
    PYBIND11_TYPE_CASTER(Vector, in_python());

    bool load(handle source, bool) {
        if (!source || isinstance<str>(source) || !PySequence_Check(source.ptr())) return false;
        const auto numbers = reinterpret_borrow<sequence>(source);
        if (numbers.size() != std::size_t(size)) return false;
        for (int i = 0; i < size; ++i) {
            const double number = PyFloat_AsDouble(object(numbers[std::size_t(i)]).ptr());
            if (PyErr_Occurred()) {
                PyErr_Clear();
                return false;
            }
            value[i] = static_cast<Number>(number);
        }
        return true;
    }
    static handle cast(const Vector& vector, return_value_policy, handle) {
        tuple out(static_cast<std::size_t>(size));
        for (int i = 0; i < size; ++i) out[std::size_t(i)] = float_(double(vector[i]));
        return out.release();
    }
};
template <>
struct type_caster<gw::vec2> : vector_caster<gw::vec2, float, 2> {};
template <>
struct type_caster<gw::vec3> : vector_caster<gw::vec3, float, 3> {};
template <>
struct type_caster<gw::vec4> : vector_caster<gw::vec4, float, 4> {};
template <>
struct type_caster<gw::dvec2> : vector_caster<gw::dvec2, double, 2> {};
template <>
struct type_caster<gw::dvec3> : vector_caster<gw::dvec3, double, 3> {};
template <>
struct type_caster<gw::dvec4> : vector_caster<gw::dvec4, double, 4> {};

/// A matrix M[row, column] that multiplies columns: an array of 4 x 4.
template <>
struct type_caster<gw::dmat4> {
    PYBIND11_TYPE_CASTER(gw::dmat4, const_name("numpy.ndarray[numpy.float64]"));

    bool load(handle source, bool) {
        const auto array = array_t<double, array::c_style | array::forcecast>::ensure(source);
        if (!array || array.ndim() != 2 || array.shape(0) != 4 || array.shape(1) != 4) {
            PyErr_Clear();
            return false;
        }
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column) value[column][row] = array.at(row, column);
        return true;
    }
    static handle cast(const gw::dmat4& matrix, return_value_policy, handle) {
        array_t<double> out({4, 4});
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column)
                out.mutable_at(row, column) = matrix[column][row];
        return out.release();
    }
};

/// A rectangle: (x, y, width, height).
template <>
struct type_caster<gw::Rect> {
    PYBIND11_TYPE_CASTER(gw::Rect, const_name("Tuple[int, int, int, int]"));

    bool load(handle source, bool convert) {
        make_caster<std::array<int, 4>> numbers;
        if (isinstance<str>(source) || !numbers.load(source, convert)) return false;
        const auto& n = cast_op<std::array<int, 4>&>(numbers);
        value = {n[0], n[1], n[2], n[3]};
        return true;
    }
    static handle cast(const gw::Rect& rect, return_value_policy, handle) {
        return make_tuple(rect.x, rect.y, rect.width, rect.height).release();
    }
};

}  // namespace pybind11::detail
