// Vectors of doubles for the vertex stages, in the order of operations of gw/base/types.h and
// gw/stages/vertex.h. Does not know the meaning of the values. Included once per Highway target
// that has vectors of doubles.
#if defined(GW_FAST_DOUBLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_DOUBLES_INL_H_
#undef GW_FAST_DOUBLES_INL_H_
#else
#define GW_FAST_DOUBLES_INL_H_
#endif

#include "gw/base/arithmetic.h"
#include "gw/base/types.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

#if HWY_HAVE_FLOAT64

namespace hn = hwy::HWY_NAMESPACE;
using D64 = hn::CappedTag<double, 8>;
using V64 = hn::Vec<D64>;
using I32ForD64 = hn::Rebind<std::int32_t, D64>;

inline V64 all(double v) { return hn::Set(D64(), v); }

/// Nearest integer, ties to even; |v| below 2^51.
inline V64 nearest(V64 v) {
    const auto magic = all(0x1.8p52);
    return hn::Sub(hn::Add(v, magic), magic);
}
/// v if v > 0, else 0 (NaN too).
inline V64 positive(V64 v) { return hn::IfThenElseZero(hn::Gt(v, hn::Zero(D64())), v); }
inline V64 at_most_one(V64 v) { return hn::IfThenElse(hn::Lt(v, all(1)), v, all(1)); }
/// quantize() of gw/base/arithmetic.h, before the conversion: clamped, scaled, rounded to even.
inline V64 quantized(V64 v, int bits) {
    return nearest(hn::Mul(at_most_one(positive(v)), all(max_of_bits(bits))));
}

struct Vec3 {
    V64 x, y, z;
};
inline Vec3 all3(const dvec3& v) { return {all(v.x), all(v.y), all(v.z)}; }

/// transform() of gw/stages/vertex.h, w = 1, and transform3(): one component.
inline V64 row(const dmat4& m, int i, const Vec3& p) {
    const auto xy = hn::Add(hn::Mul(all(m[0][i]), p.x), hn::Mul(all(m[1][i]), p.y));
    return hn::Add(xy, hn::Add(hn::Mul(all(m[2][i]), p.z), all(m[3][i])));
}
inline V64 row(const dmat3& m, int i, const Vec3& n) {
    return hn::Add(hn::Add(hn::Mul(all(m[0][i]), n.x), hn::Mul(all(m[1][i]), n.y)),
                   hn::Mul(all(m[2][i]), n.z));
}

#endif  // HWY_HAVE_FLOAT64

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
