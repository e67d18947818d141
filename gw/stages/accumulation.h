// The arithmetic of the accumulation buffer: integers in units of the frame buffer, wrapped.
// docs/manual/pixels.md, "Accumulation". Does not loop over pixels.
#pragma once

#include "gw/base/arithmetic.h"
#include "gw/command_list.h"
#include "gw/stages/resolve.h"

namespace gw {

/// The low `bits` of v as a signed number. Sets `overflow` if this differs from v.
constexpr std::int32_t wrap_accum(std::int64_t v, int bits, bool& overflow) {
    const int unused = 64 - bits;
    const std::int64_t wrapped =
        static_cast<std::int64_t>(static_cast<std::uint64_t>(v) << unused) >> unused;
    overflow = wrapped != v;
    return static_cast<std::int32_t>(wrapped);
}

/// Nearest integer to a * v, clamped to +-2^40: a larger value shows as an overflow only.
inline std::int64_t weighted(std::int64_t a, float v) {
    constexpr double limit = 1099511627776.0;
    return to_integer(round_even(double(a) * double(v)), -limit, limit);
}

/// Accum, Load, Add, Mult: the new value of one channel before it is wrapped.
inline std::int64_t accumulated(AccumOp op, std::int32_t stored, std::uint16_t color, float v,
                                int color_bits) {
    switch (op) {
        case AccumOp::Accum: return stored + weighted(color, v);
        case AccumOp::Load: return weighted(color, v);
        case AccumOp::Add: return stored + weighted(max_of_bits(color_bits), v);
        case AccumOp::Mult: return weighted(stored, v);
        case AccumOp::Return: return stored;
    }
    return stored;
}

/// Clear: a channel of value v in -1 .. 1, wrapped.
inline std::int32_t cleared_accum(float v, int color_bits, int accum_bits) {
    bool overflow = false;
    return wrap_accum(weighted(max_of_bits(color_bits), std::clamp(v, -1.0f, 1.0f)), accum_bits,
                      overflow);
}

/// Bytes of a pixel that Accumulate visits.
inline std::uint64_t accumulate_bytes(AccumOp op, const State& state, const Profile& profile) {
    const std::uint64_t color = op == AccumOp::Return ? written_bytes(Plane::Color, state, profile)
                                                      : plane_bytes(Plane::Color, profile);
    return plane_bytes(Plane::Accum, profile) + color;
}

/// Return: rounded once, then clamped to the range of a colour.
inline std::uint16_t returned(std::int32_t stored, float v, int color_bits) {
    return static_cast<std::uint16_t>(
        std::clamp<std::int64_t>(weighted(stored, v), 0, max_of_bits(color_bits)));
}

}  // namespace gw
