// Whether many numbers are finite, without a branch for each. Does not say which one is not.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace gw {

/// T is float or double. Adding one to an exponent of all ones carries into the sign's bit.
template <class T>
bool all_finite(const T* first, std::size_t count) {
    using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    constexpr Bits sign = Bits{1} << (8 * sizeof(T) - 1);
    constexpr Bits one_exponent = Bits{1} << (sizeof(T) == 4 ? 23 : 52);
    Bits any = 0;
    for (std::size_t i = 0; i < count; ++i)
        any |= (std::bit_cast<Bits>(first[i]) & ~sign) + one_exponent;
    return (any & sign) == 0;
}

}  // namespace gw
