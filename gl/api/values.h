// The values that calls take in place of pointers.
#pragma once

#include "gl/state/state.h"

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace gw::gl {

/// One to four parameters of a function like Lightfv.
struct Params {
    std::array<double, 4> value{};
    int count = 0;  ///< given; 1: by a function for one parameter, like Lightf

    double operator[](int i) const { return value[std::size_t(i)]; }
    GLenum token() const { return to_token(value[0]); }
    vec4 as_vec4() const {
        return {float(value[0]), float(value[1]), float(value[2]), float(value[3])};
    }
    /// A number as an enumeration; 0 if it is none.
    static GLenum to_token(double v) { return v >= 0 && v <= 0xFFFFFF ? GLenum(v) : 0; }
};

/// An array of numbers that the call read from the caller's memory, and keeps.
using Numbers = std::shared_ptr<const std::vector<double>>;

/// Pixels from the caller's memory: rows from the bottom without padding, in the host's byte
/// order. A bitmap's rows begin with a byte's highest bit.
struct HostImage {
    std::span<const std::byte> bytes;
    /// Owns the bytes, so that a display list may keep them; null: they are in the caller's memory.
    std::shared_ptr<const std::vector<std::byte>> kept;
    bool is_refused = false;  ///< an error was set: the call changes nothing

    bool is_given() const { return bytes.data() != nullptr; }
};

}  // namespace gw::gl
