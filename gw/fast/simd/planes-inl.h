// Planes on a block of 16 pixels: lanes, pixel coordinates, values of up to 16 and up to 32 bits,
// the division. docs/manual.md, "Planes", "Perspective"; scalar twin:
// gw/reference/plane_equation.cpp. Does not shade. Included once per Highway target.
#if defined(GW_FAST_PLANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_PLANES_INL_H_
#undef GW_FAST_PLANES_INL_H_
#else
#define GW_FAST_PLANES_INL_H_
#endif

#include "gw/fast/frame/tile_plane.h"
#include "gw/fast/simd/lanes-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

alignas(64) inline constexpr std::uint32_t lane_x[16] = {0, 1, 2, 3, 0, 1, 2, 3,
                                                         0, 1, 2, 3, 0, 1, 2, 3};
alignas(64) inline constexpr std::uint32_t lane_y[16] = {0, 0, 0, 0, 1, 1, 1, 1,
                                                         2, 2, 2, 2, 3, 3, 3, 3};

/// Pixel coordinates in the tile of lanes first .. of block (bx, by).
struct Pixels {
    V32 x, y;
};
HWY_INLINE Pixels pixels_of(int bx, int by, std::size_t first) {
    const D32 d;
    return {hn::Add(hn::Load(d, lane_x + first), hn::Set(d, std::uint32_t(bx * block_side))),
            hn::Add(hn::Load(d, lane_y + first), hn::Set(d, std::uint32_t(by * block_side)))};
}

/// A value of at most 16 bits: one chain modulo 2^32.
HWY_INLINE V32 narrow_value(V32 c, V32 gx, V32 gy, Pixels at) {
    return hn::ShiftRight<16>(hn::Add(hn::Add(c, hn::Mul(gx, at.x)), hn::Mul(gy, at.y)));
}
HWY_INLINE V32 narrow_plane(const TilePlane& p, Pixels at) {
    const auto all = [](auto v) { return hn::Set(D32(), std::uint32_t(v)); };
    return narrow_value(all(p.c), all(p.gx), all(p.gy), at);
}

/// A value of up to 32 bits, computed in two halves, exact modulo 2^32.
HWY_INLINE V32 wide_plane(const TilePlane& p, Pixels at) {
    const auto high = [](std::int64_t v) { return hn::Set(D32(), std::uint32_t(v >> 16)); };
    const auto low = [](std::int64_t v) { return hn::Set(D32(), std::uint32_t(v & 0xFFFF)); };
    const auto hi = hn::Add(hn::Add(high(std::int64_t(p.c)), hn::Mul(high(p.gx), at.x)),
                            hn::Mul(high(p.gy), at.y));
    const auto lo = hn::Add(hn::Add(low(std::int64_t(p.c)), hn::Mul(low(p.gx), at.x)),
                            hn::Mul(low(p.gy), at.y));
    return hn::Add(hi, hn::ShiftRight<16>(lo));
}

HWY_INLINE hn::Vec<F32> to_floats(V32 v) { return hn::ConvertTo(F32(), hn::BitCast(I32(), v)); }

/// The nearest integers. Numbers beyond 31 bits become 2^31 - 1 or more.
HWY_INLINE V32 to_nearest(hn::Vec<F32> v) {
#if HWY_TARGET == HWY_AVX2  // Highway also clamps
    return V32{_mm256_cvtps_epi32(v.raw)};
#else
    return hn::BitCast(D32(), hn::NearestInt(v));
#endif
}

HWY_INLINE hn::Vec<F32> reciprocal_lanes(const TilePlane& q, Pixels at) {
    if ((q.gx | q.gy) == 0)
        return hn::Set(F32(), 1.0f / static_cast<float>(static_cast<std::int32_t>(q.c >> 16)));
    return hn::Div(hn::Set(F32(), 1.0f), to_floats(wide_plane(q, at)));
}

/// Polygon offset: depths stay in [0, max_depth].
HWY_INLINE void offset_depths(std::int64_t offset, std::uint32_t max_depth, DepthBlock& depth) {
    for (std::uint32_t& z : depth.value)
        z = std::uint32_t(std::clamp<std::int64_t>(z + offset, 0, max_depth));
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
