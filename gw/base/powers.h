// Powers of two as doubles, exactly.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace gw {

/// 2^e for -1022 <= e <= 1023.
constexpr double power_of_two(int e) noexcept {
    return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52);
}

/// v 2^e, rounded once.
inline double times_power_of_two(double v, int e) noexcept {
    return e >= -1022 && e <= 1023 ? v * power_of_two(e) : std::ldexp(v, e);
}

/// Least e in [low, high] with 2^e >= v; `high` if there is none.
inline int exponent_above(double v, int low, int high) noexcept {
    if (!(v > power_of_two(low))) return low;
    if (v > power_of_two(high)) return high;
    int e = 0;
    return std::frexp(v, &e) == 0.5 ? e - 1 : e;
}

}  // namespace gw
