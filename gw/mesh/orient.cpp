#include "gw/mesh/orient.h"

#include "gw/base/exact_sum.h"

#include <cmath>

namespace gw {
namespace {

int sign(double x) { return (x > 0) - (x < 0); }

int exact(dvec2 a, dvec2 b, dvec2 c) {
    ExactSum<6> sum;
    for (const double product :
         {a.x * b.y, -(a.y * b.x), b.x * c.y, -(b.y * c.x), c.x * a.y, -(c.y * a.x)})
        sum.add(product);
    return sign(sum.value());
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
