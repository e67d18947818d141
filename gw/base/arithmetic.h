// The manual's scalar arithmetic: rounding, clamping, products of fractions.
// docs/manual/numbers.md. Contains nothing that belongs to one stage.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace gw {

/// The largest value of n bits, which represents 1.0; n <= 32.
constexpr std::uint32_t max_of_bits(int n) {
    return static_cast<std::uint32_t>((std::uint64_t{1} << n) - 1);
}

/// Nearest integer, ties to even: the IEEE rounding mode of every thread of a machine.
inline double round_even(double v) {
    constexpr double magic = 6755399441055744.0;  // 1.5 * 2^52: adding it leaves no fraction bits
    return v > -magic / 4 && v < magic / 4 ? (v + magic) - magic : std::nearbyint(v);
}

__extension__ using int128 = __int128;

/// Nearest integer to num / den, ties to even; den > 0.
constexpr int128 divide_round_even(int128 num, int128 den) {
    int128 q = num / den, r = num % den;
    if (r < 0) {  // towards minus infinity first
        q -= 1;
        r += den;
    }
    if (2 * r > den || (2 * r == den && (q & 1) != 0)) q += 1;
    return q;
}

/// v in [0, 1]; NaN becomes 0.
constexpr double clamp01(double v) { return v > 0 ? (v < 1 ? v : 1) : 0; }

/// v in [-limit, limit]; NaN becomes -limit.
constexpr double bounded(double v, double limit) {
    return v > -limit ? (v < limit ? v : limit) : -limit;
}

/// A fraction as an n-bit integer: nearest to v * (2^n - 1), v clamped to [0, 1].
inline std::uint32_t quantize(double v, int n) {
    return static_cast<std::uint32_t>(round_even(clamp01(v) * max_of_bits(n)));
}

/// Nearest integer to a * b / (2^n - 1), for n <= 16 and a, b <= 2^n - 1. No ties exist.
constexpr std::uint32_t mul(std::uint32_t a, std::uint32_t b, int n) {
    const std::uint64_t t = std::uint64_t{a} * b + (std::uint64_t{1} << (n - 1));
    return static_cast<std::uint32_t>((t + (t >> n)) >> n);
}

/// An n-bit fraction in m bits: nearest to v * (2^m - 1) / (2^n - 1), ties up.
constexpr std::uint32_t rescale(std::uint32_t v, int n, int m) {
    const std::uint64_t from = max_of_bits(n), to = max_of_bits(m);
    return static_cast<std::uint32_t>((v * to * 2 + from) / (from * 2));
}

/// A double clamped to [low, high], as an integer; NaN becomes low.
inline std::int64_t to_integer(double v, double low, double high) {
    return static_cast<std::int64_t>(v > low ? (v < high ? v : high) : low);
}

}  // namespace gw
