// The arithmetic of the accumulation buffer: wrapped integers in units of 2^-fraction_bits of a colour
// level.
// docs/manual/pixels.md, "Accumulation". Does not loop over pixels.
#pragma once

#include "gw/base/arithmetic.h"
#include "gw/command_list.h"
#include "gw/stages/resolve.h"

#include <algorithm>
#include <cmath>

namespace gw {

/// R13.19: the bits of an accumulated value below a colour level. Programs of OpenGL add fractions; the
/// rest of accum_bits is 128 pictures and the sign.
constexpr int accum_fraction_bits(const Profile& profile) {
    if (!profile.extensions.draw_pixels) return 0;
    return std::max(0, profile.accum_bits - profile.color_bits - 8);
}

/// The low `bits` of v as a signed number. Sets `overflow` if this differs from v.
constexpr std::int32_t wrap_accum(std::int64_t v, int bits, bool& overflow) {
    const int unused = 64 - bits;
    const std::int64_t wrapped =
        static_cast<std::int64_t>(static_cast<std::uint64_t>(v) << unused) >> unused;
    overflow = wrapped != v;
    return static_cast<std::int32_t>(wrapped);
}

/// Nearest integer to a * v * 2^shift, clamped to +-2^40: a larger value shows as an overflow only.
inline std::int64_t weighted(std::int64_t a, float v, int shift = 0) {
    constexpr double limit = 1099511627776.0;
    return to_integer(round_even(double(a) * std::ldexp(double(v), shift)), -limit, limit);
}

/// Accum, Load, Add, Mult: the new value of one channel before it is wrapped.
inline std::int64_t accumulated(AccumOp op, std::int32_t stored, std::uint16_t color, float v,
                                const Profile& profile) {
    const int fraction = accum_fraction_bits(profile);
    switch (op) {
        case AccumOp::Accum: return stored + weighted(color, v, fraction);
        case AccumOp::Load: return weighted(color, v, fraction);
        case AccumOp::Add: return stored + weighted(max_of_bits(profile.color_bits), v, fraction);
        case AccumOp::Mult: return weighted(stored, v);
        case AccumOp::Return: return stored;
    }
    return stored;
}

/// Clear: a channel of value v in -1 .. 1, wrapped.
inline std::int32_t cleared_accum(float v, const Profile& profile) {
    bool overflow = false;
    return wrap_accum(weighted(max_of_bits(profile.color_bits), std::clamp(v, -1.0f, 1.0f),
                               accum_fraction_bits(profile)),
                      profile.accum_bits, overflow);
}

/// Bytes of a pixel that Accumulate visits.
inline std::uint64_t accumulate_bytes(AccumOp op, const State& state, const Profile& profile) {
    const std::uint64_t color = op == AccumOp::Return ? written_bytes(Plane::Color, state, profile)
                                                      : plane_bytes(Plane::Color, profile);
    return plane_bytes(Plane::Accum, profile) + color;
}

/// Return: rounded once, then clamped to the range of a colour.
inline std::uint16_t returned(std::int32_t stored, float v, const Profile& profile) {
    return static_cast<std::uint16_t>(std::clamp<std::int64_t>(
        weighted(stored, v, -accum_fraction_bits(profile)), 0, max_of_bits(profile.color_bits)));
}

}  // namespace gw
