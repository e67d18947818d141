#include "gw/mesh/orient.h"

#include <cmath>

namespace gw {
namespace {

int sign(double x) { return (x > 0) - (x < 0); }

// Adds b to an expansion (a sum of non-overlapping doubles, smallest first) without rounding:
// Shewchuk's Grow-Expansion. The largest component that is not 0 has the sign of the sum.
template <std::size_t N>
void grow(std::array<double, N>& expansion, std::size_t size, double b) {
    for (std::size_t i = 0; i < size; ++i) {
        const double a = expansion[i];
        const double sum = a + b;
        const double b_part = sum - a;
        expansion[i] = (a - (sum - b_part)) + (b - b_part);
        b = sum;
    }
    expansion[size] = b;
}

template <std::size_t N>
int sign_of(const std::array<double, N>& expansion) {
    for (std::size_t i = N; i-- > 0;)
        if (expansion[i] != 0) return sign(expansion[i]);
    return 0;
}

int exact(dvec2 a, dvec2 b, dvec2 c) {
    const std::array<double, 6> products{a.x * b.y,    -(a.y * b.x), b.x * c.y,
                                         -(b.y * c.x), c.x * a.y,    -(c.y * a.x)};
    std::array<double, 6> sum{};
    for (std::size_t i = 0; i < products.size(); ++i) grow(sum, i, products[i]);
    return sign_of(sum);
}

}  // namespace

int orient(vec2 a, vec2 b, vec2 c) {
    const dvec2 u = dvec2(b) - dvec2(a), v = dvec2(c) - dvec2(a);
    const double left = u.x * v.y, right = u.y * v.x;
    // Each product has three roundings of 2^-53 and their difference one more: 4 would suffice.
    const double error = 8 * 0x1p-53 * (std::abs(left) + std::abs(right));
    if (std::abs(left - right) > error) return sign(left - right);
    return exact(a, b, c);
}

}  // namespace gw
