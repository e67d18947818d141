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
#include "gw/fast/simd/wasm_doubles-inl.h"

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
template <class V>
V nearest(V v) {
    const auto magic = hn::Set(hn::DFromV<V>(), 0x1.8p52);
    return hn::Sub(hn::Add(v, magic), magic);
}
/// The integer v; |v| below 2^51.
inline hn::Vec<hn::Rebind<std::int64_t, D64>> integers(V64 v) {
    const hn::Rebind<std::int64_t, D64> d;
    const auto magic = all(0x1.8p52);
    return hn::Sub(hn::BitCast(d, hn::Add(v, magic)), hn::BitCast(d, magic));
}
/// Its reverse.
inline V64 doubles(hn::Vec<hn::Rebind<std::int64_t, D64>> v) {
    const hn::Rebind<std::int64_t, D64> d;
    const auto magic = all(0x1.8p52);
    return hn::Sub(hn::BitCast(D64(), hn::Add(v, hn::BitCast(d, magic))), magic);
}
/// v if v > 0, else 0 (NaN too).
template <class V>
V positive(V v) {
    return hn::IfThenElseZero(hn::Gt(v, hn::Zero(hn::DFromV<V>())), v);
}
template <class V>
V at_most_one(V v) {
    const auto one = hn::Set(hn::DFromV<V>(), 1);
    return hn::IfThenElse(hn::Lt(v, one), v, one);
}
/// quantize() of gw/base/arithmetic.h, before the conversion: clamped, scaled, rounded to even.
template <class V>
V quantized(V v, int bits) {
    return nearest(hn::Mul(at_most_one(positive(v)), hn::Set(hn::DFromV<V>(), max_of_bits(bits))));
}

/// bounded() of gw/base/arithmetic.h.
inline V64 bounded(V64 v, double limit) {
    return hn::IfThenElse(hn::Gt(v, all(-limit)),
                          hn::IfThenElse(hn::Lt(v, all(limit)), v, all(limit)), all(-limit));
}

struct Vec3 {
    V64 x, y, z;
};
inline Vec3 all3(const dvec3& v) { return {all(v.x), all(v.y), all(v.z)}; }

/// A vector of points that are adjacent in memory.
inline Vec3 points_at(const vec3* first) {
    const hn::Rebind<float, D64> d;
    hn::Vec<decltype(d)> x, y, z;
    hn::LoadInterleaved3(d, &first->x, x, y, z);
    return {hn::PromoteTo(D64(), x), hn::PromoteTo(D64(), y), hn::PromoteTo(D64(), z)};
}

/// dot4() and transform() of gw/stages/vertex.h for a point p of w = 1.
inline V64 dot(const dvec4& a, const Vec3& p) {
    return hn::Add(hn::Add(hn::Mul(all(a.x), p.x), hn::Mul(all(a.y), p.y)),
                   hn::Add(hn::Mul(all(a.z), p.z), all(a.w)));
}
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
