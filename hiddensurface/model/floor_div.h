// Division of integers that rounds down, also below 0.
#pragma once

namespace gw::hiddensurface {

/// Floor of a / b, b > 0.
template <class Integer>
constexpr Integer floor_div(Integer a, Integer b) {
    const Integer q = a / b;
    return q * b > a ? q - 1 : q;
}

}  // namespace gw::hiddensurface
