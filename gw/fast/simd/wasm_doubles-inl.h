// Operations on vectors of two doubles for WebAssembly, which Highway before 1.1 lacks though the processor
// has them. Each means the same as Highway's operation of that name on other targets. Empty for
// other targets and for a Highway that has them. Included once per Highway target.
#if defined(GW_FAST_WASM_DOUBLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_WASM_DOUBLES_INL_H_
#undef GW_FAST_WASM_DOUBLES_INL_H_
#else
#define GW_FAST_WASM_DOUBLES_INL_H_
#endif

#include <hwy/highway.h>

#if HWY_TARGET == HWY_WASM && !HWY_HAVE_FLOAT64
#undef HWY_HAVE_FLOAT64
#define HWY_HAVE_FLOAT64 1

HWY_BEFORE_NAMESPACE();
namespace hwy::HWY_NAMESPACE {

template <std::size_t N>
using Doubles = Vec128<double, N>;

template <std::size_t N, HWY_IF_LE128(double, N)>
HWY_API Doubles<N> Set(Simd<double, N, 0>, double v) {
    return {wasm_f64x2_splat(v)};
}

template <std::size_t N>
HWY_API Doubles<N> operator+(Doubles<N> a, Doubles<N> b) {
    return {wasm_f64x2_add(a.raw, b.raw)};
}
template <std::size_t N>
HWY_API Doubles<N> operator-(Doubles<N> a, Doubles<N> b) {
    return {wasm_f64x2_sub(a.raw, b.raw)};
}
template <std::size_t N>
HWY_API Doubles<N> operator*(Doubles<N> a, Doubles<N> b) {
    return {wasm_f64x2_mul(a.raw, b.raw)};
}
template <std::size_t N>
HWY_API Doubles<N> operator/(Doubles<N> a, Doubles<N> b) {
    return {wasm_f64x2_div(a.raw, b.raw)};
}
template <std::size_t N>
HWY_API Doubles<N> Abs(Doubles<N> v) {
    return {wasm_f64x2_abs(v.raw)};
}
template <std::size_t N>
HWY_API Doubles<N> Sqrt(Doubles<N> v) {
    return {wasm_f64x2_sqrt(v.raw)};
}
template <std::size_t N>
HWY_API Doubles<N> Floor(Doubles<N> v) {
    return {wasm_f64x2_floor(v.raw)};
}
/// b unless a < b, as x86 has it.
template <std::size_t N>
HWY_API Doubles<N> Min(Doubles<N> a, Doubles<N> b) {
    return {wasm_f64x2_pmin(b.raw, a.raw)};
}
/// b unless a > b.
template <std::size_t N>
HWY_API Doubles<N> Max(Doubles<N> a, Doubles<N> b) {
    return {wasm_f64x2_pmax(b.raw, a.raw)};
}

template <std::size_t N>
HWY_API Mask128<double, N> operator==(Doubles<N> a, Doubles<N> b) {
    return {wasm_f64x2_eq(a.raw, b.raw)};
}
template <std::size_t N>
HWY_API Mask128<double, N> operator!=(Doubles<N> a, Doubles<N> b) {
    return {wasm_f64x2_ne(a.raw, b.raw)};
}
template <std::size_t N>
HWY_API Mask128<double, N> operator>(Doubles<N> a, Doubles<N> b) {
    return {wasm_f64x2_gt(a.raw, b.raw)};
}
template <std::size_t N>
HWY_API Mask128<double, N> operator<=(Doubles<N> a, Doubles<N> b) {
    return {wasm_f64x2_le(a.raw, b.raw)};
}
template <std::size_t N>
HWY_API Mask128<double, N> operator>=(Doubles<N> a, Doubles<N> b) {
    return {wasm_f64x2_ge(a.raw, b.raw)};
}

/// Towards 0; saturates.
template <std::size_t N>
HWY_API Vec128<std::int64_t, N> ConvertTo(Simd<std::int64_t, N, 0>, Doubles<N> v) {
    const auto integer = [](double x) { return __builtin_wasm_trunc_saturate_s_i64_f64(x); };
    return {wasm_i64x2_make(integer(wasm_f64x2_extract_lane(v.raw, 0)),
                            integer(wasm_f64x2_extract_lane(v.raw, 1)))};
}
/// To nearest, ties to even.
template <std::size_t N>
HWY_API Doubles<N> ConvertTo(Simd<double, N, 0>, Vec128<std::int64_t, N> v) {
    return {wasm_f64x2_make(double(wasm_i64x2_extract_lane(v.raw, 0)),
                            double(wasm_i64x2_extract_lane(v.raw, 1)))};
}
/// The lower lanes.
template <std::size_t N, HWY_IF_LE128(double, N)>
HWY_API Doubles<N> PromoteTo(Simd<double, N, 0>, Vec128<float, N> v) {
    return {wasm_f64x2_promote_low_f32x4(v.raw)};
}
/// In the lower lanes.
template <std::size_t N>
HWY_API Vec128<float, N> DemoteTo(Simd<float, N, 0>, Doubles<N> v) {
    return {wasm_f32x4_demote_f64x2_zero(v.raw)};
}
/// Modulo 2^64.
template <std::size_t N>
HWY_API Vec128<std::int64_t, N> operator*(Vec128<std::int64_t, N> a, Vec128<std::int64_t, N> b) {
    return {wasm_i64x2_mul(a.raw, b.raw)};
}

}  // namespace hwy::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // WebAssembly without doubles

#endif  // include guard per target
