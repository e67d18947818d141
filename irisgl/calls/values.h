// The arguments of calls, as an open object keeps them: arrays are read when the program calls.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "irisgl/state/tokens.h"

namespace gw::irisgl {

/// The numbers of an array argument.
using Values = std::span<const float>;

/// An array of a fixed size. Null: all 0.
template <std::size_t N>
struct OwnValues {
    std::array<float, N> value{};
    template <class T>
    explicit OwnValues(const T* from) {
        for (std::size_t i = 0; from != nullptr && i < N; ++i) value[i] = float(from[i]);
    }
    operator Values() const { return value; }
    float operator[](std::size_t i) const { return value[i]; }
};

/// Largest array that a call reads: more numbers are a mistake of the program.
inline constexpr long most_values = 1 << 22;

template <class T>
std::vector<float> keep(const T* from, long count) {
    if (from == nullptr || count <= 0 || count > most_values) return {};
    return {from, from + count};
}

/// The product of counts; -1 if it has more than 63 bits.
template <class... T>
long product(T... counts) {
    long all = 1;
    const bool fits = (!__builtin_mul_overflow(all, long(counts), &all) && ...);
    return fits ? all : -1;
}

/// The numbers of a point of a NURBS' type (N_XYZ): 2 to 5.
inline long nurbs_size(long type) { return type >> 2 & 15; }
/// Doubles from the first number of `n` control points to the last; a stride is in bytes. 0: nothing.
inline long curve_size(long n, long stride, long type) {
    const long size = n > 0 && stride > 0 ? product(n - 1, stride / 8) : -1;
    return size < 0 || size > most_values ? 0 : size + nurbs_size(type);
}
inline long surface_size(long s, long t, long s_stride, long t_stride, long type) {
    const long along = curve_size(s, s_stride, type), across = curve_size(t, t_stride, type);
    return along == 0 || across == 0 ? 0 : along + across - nurbs_size(type);
}

/// Pixels of 32 bits in the caller's memory, in words of its type.
struct Words {
    explicit Words(unsigned long* at) : wide(at) {}
    explicit Words(unsigned* at) : narrow(at) {}
    explicit Words(int* at) : narrow(reinterpret_cast<unsigned*>(at)) {}
    unsigned long* wide = nullptr;
    unsigned* narrow = nullptr;
    bool is_given() const { return wide != nullptr || narrow != nullptr; }
    std::uint32_t get(std::size_t i) const { return wide ? std::uint32_t(wide[i]) : narrow[i]; }
    void set(std::size_t i, std::uint32_t value) const {
        if (wide)
            wide[i] = value;
        else
            narrow[i] = value;
    }
};

/// The numbers of a definition of lmdef: `n`, or up to LMNULL if it is 0.
template <class T>
long light_size(long n, const T* props) {
    if (n > 0 || props == nullptr) return n;
    long at = 0;
    while (at < 256 && props[at] != T(0)) {
        const int token = int(props[at]);
        const bool is_one = token == SHININESS || token == ALPHA || token == LOCALVIEWER ||
                            token == TWOSIDE || token == ATTENUATION2;
        const bool is_two = token == ATTENUATION || token == SPOTLIGHT;
        at += is_one ? 2 : is_two ? 3 : token == POSITION ? 5 : 4;
    }
    return at;
}

/// Numbers after a property of a texture.
constexpr long texture_values(int property) {
    switch (property) {
        case TX_FAST_DEFINE: return 0;
        case TX_CONTROL_POINT: return 2;
        case TX_DETAIL: return 5;
        default: return 1;
    }
}
/// And of a texture environment.
constexpr long environment_values(int property) { return property == TV_COLOR ? 4 : 0; }

/// The numbers of a definition of texdef2d or tevdef: `n`, or up to the null word if it is 0.
template <class T>
long listed(long n, const T* props, long (*values)(int)) {
    if (n > 0 || props == nullptr) return n;
    long at = 0;
    while (at < 256 && props[at] != T(0)) at += 1 + values(int(props[at]));
    return at;
}

}  // namespace gw::irisgl
