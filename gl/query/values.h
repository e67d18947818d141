// The values of a query, every state variable by its name, and their conversion to the type that the
// caller asks for. [GL11] 6.1.2
#pragma once

#include "gl/context/context.h"
#include "gw/base/types.h"

#include <GL/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>

namespace gw::gl {

/// Up to 16 values.
struct QueryValues {
    /// Units are numbers 0 .. 1 or -1 .. 1 that become all of an integer's range: colours, normals,
    /// depths.
    enum class Kind : unsigned char { Whole, Number, Unit };

    Kind kind = Kind::Whole;
    int count = 0;
    std::array<double, 16> value{};

    void add(double v) { value[std::size_t(count++)] = v; }
};

template <class T>
requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) QueryValues whole(T v) {
    QueryValues out;
    out.add(double(v));
    return out;
}
inline QueryValues number(double v) { return {QueryValues::Kind::Number, 1, {v}}; }
inline QueryValues unit_value(double v) { return {QueryValues::Kind::Unit, 1, {v}}; }
inline QueryValues units(const vec4& v) {
    return {QueryValues::Kind::Unit, 4, {v.x, v.y, v.z, v.w}};
}
inline QueryValues units(const vec3& v) { return {QueryValues::Kind::Unit, 3, {v.x, v.y, v.z}}; }
inline QueryValues numbers_of(const dvec4& v) {
    return {QueryValues::Kind::Number, 4, {v.x, v.y, v.z, v.w}};
}
inline QueryValues numbers_of(const vec4& v) { return numbers_of(dvec4(v)); }
inline QueryValues numbers_of(const vec3& v) {
    return {QueryValues::Kind::Number, 3, {v.x, v.y, v.z}};
}
inline QueryValues numbers_of(double a, double b) { return {QueryValues::Kind::Number, 2, {a, b}}; }
inline QueryValues wholes(double a, double b) { return {QueryValues::Kind::Whole, 2, {a, b}}; }
inline QueryValues wholes(const Rect& r) {
    return {
        QueryValues::Kind::Whole, 4, {double(r.x), double(r.y), double(r.width), double(r.height)}};
}
inline QueryValues numbers_of(const dmat4& m) {
    QueryValues out{QueryValues::Kind::Number, 0, {}};
    for (int i = 0; i < 16; ++i) out.add(m[i / 4][i % 4]);
    return out;
}

/// The values of a state variable; none: there is no such variable.
std::optional<QueryValues> state_variable(Context& context, GLenum pname);

/// A value as an integer. [GL11] table 4.7 and 6.1.2
inline double integer_value(QueryValues::Kind kind, double v) {
    if (kind == QueryValues::Kind::Unit) v = (4294967295.0 * v - 1) / 2;
    const double most = kind == QueryValues::Kind::Whole ? 4294967295.0 : 2147483647.0;  // masks
    return std::clamp(std::floor(v + 0.5), -2147483648.0, most);
}

template <class T>
void store(const QueryValues& values, T* params) {
    for (int i = 0; i < values.count; ++i) {
        const double v = values.value[std::size_t(i)];
        if constexpr (std::is_same_v<T, GLboolean>)
            params[i] = v != 0 ? GL_TRUE : GL_FALSE;
        else if constexpr (std::is_integral_v<T>)
            params[i] = T(static_cast<std::int64_t>(integer_value(values.kind, v)));
        else
            params[i] = T(v);
    }
}

/// Gives the program the values. None: INVALID_ENUM.
template <class T>
void get(Context& context, const std::optional<QueryValues>& values, T* params) {
    if (!values) return set_error(context, GL_INVALID_ENUM);
    if (params != nullptr) store(*values, params);
}

}  // namespace gw::gl
