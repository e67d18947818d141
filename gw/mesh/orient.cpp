#include "gw/mesh/orient.h"

#include "gw/base/exact_sum.h"

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
    if (turns_left(a, b, c)) return 1;
    return turns_left(a, c, b) ? -1 : exact(a, b, c);
}

}  // namespace gw
