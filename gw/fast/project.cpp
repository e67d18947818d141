// Projection, a vector of vertices at a time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gw/fast/project.cpp"
#include <hwy/foreach_target.h>

#include "gw/arithmetic.h"
#include "gw/fast/doubles-inl.h"
#include "gw/fast/project.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

#if HWY_HAVE_FLOAT64

/// floor(v 2^s + 1/2) kept inside the guard band; to_integer() of gw/arithmetic.h puts NaN at the low end.
inline V64 snapped(V64 v, int s) {
    const double scale = double(1 << s);
    const auto low = all(guard_low * scale), high = all(guard_high * scale - 1);
    const auto f = hn::Floor(hn::Add(hn::Mul(v, all(scale)), all(0.5)));
    return hn::IfThenElse(hn::Gt(f, low), hn::IfThenElse(hn::Lt(f, high), f, high), low);
}

struct ClipLanes {
    V64 x, y, z, w;
};

using U64 = hn::RebindToUnsigned<D64>;

/// Outcodes, plane by plane; a distance that is no number is outside.
struct OutcodeLanes {
    hn::Vec<U64> bits;

    void add(hn::Mask<D64> inside, Outcode bit) {
        bits = hn::Or(bits, hn::IfThenZeroElse(hn::RebindMask(U64(), inside), hn::Set(U64(), bit)));
    }
    void plane(int i, V64 distance) { add(hn::Ge(distance, hn::Zero(D64())), Outcode{1} << i); }
};

/// clip_distance() of gw/clip.h: near, far, guard band.
inline void classify_fixed(const ClipLanes& c, const ViewportTransform& v, OutcodeLanes& out) {
    const auto times = [](double a, V64 b) { return hn::Mul(all(a), b); };
    out.plane(0, hn::Add(c.z, c.w));
    out.plane(1, hn::Sub(c.w, c.z));
    out.plane(8, hn::Add(times(v.half_width, c.x), times(v.center_x - guard_low, c.w)));
    out.plane(9, hn::Sub(times(guard_high - v.center_x, c.w), times(v.half_width, c.x)));
    out.plane(10, hn::Add(times(v.half_height, c.y), times(v.center_y - guard_low, c.w)));
    out.plane(11, hn::Sub(times(guard_high - v.center_y, c.w), times(v.half_height, c.y)));
}

/// The user planes that are on: the distances of run_vertex().
inline void classify_user(const Projection& p, const Vec3& at, OutcodeLanes& out) {
    const dmat4& m = p.eye_from_object;
    for (int k = 0; k < max_clip_planes; ++k) {
        const ClipPlane& plane = p.clip_planes[std::size_t(k)];
        if (!plane.enable) continue;
        const dvec4& n = plane.plane;
        const auto xy = hn::Add(hn::Mul(all(n.x), row(m, 0, at)), hn::Mul(all(n.y), row(m, 1, at)));
        const auto zw = hn::Add(hn::Mul(all(n.z), row(m, 2, at)), hn::Mul(all(n.w), row(m, 3, at)));
        out.plane(2 + k, hn::Add(xy, zw));
    }
}

inline hn::Vec<U64> outcodes(const Projection& p, const Vec3& at, const ClipLanes& c) {
    const D64 d;
    OutcodeLanes out{hn::Zero(U64())};
    classify_fixed(c, p.viewport, out);
    classify_user(p, at, out);
    out.add(hn::Gt(c.w, hn::Zero(d)), not_in_front);
    auto finite = hn::Eq(hn::Sub(c.x, c.x), hn::Zero(d));
    for (const V64 component : {c.y, c.z, c.w})
        finite = hn::And(finite, hn::Eq(hn::Sub(component, component), hn::Zero(d)));
    return hn::IfThenElse(hn::RebindMask(U64(), finite), out.bits, hn::Set(U64(), not_finite));
}

Projected project_all(const Projection& p, std::span<const vec3> positions) {
    const D64 d;
    const double n = clamp01(p.depth_range.near_value), f = clamp01(p.depth_range.far_value);
    alignas(64) std::uint64_t codes[project_batch];
    alignas(64) double in[3][project_batch], x[project_batch], y[project_batch], z[project_batch],
        w[project_batch];
    for (std::size_t i = 0; i < project_batch; ++i)
        for (int c = 0; c < 3; ++c) in[c][i] = positions[i < positions.size() ? i : 0][c];

    Projected out;
    for (std::size_t first = 0; first < project_batch; first += hn::Lanes(d)) {
        const Vec3 at{hn::Load(d, in[0] + first), hn::Load(d, in[1] + first), hn::Load(d, in[2] + first)};
        const dmat4& m = p.clip_from_object;
        const ClipLanes c{row(m, 0, at), row(m, 1, at), row(m, 2, at), row(m, 3, at)};
        hn::Store(outcodes(p, at, c), U64(), codes + first);

        const auto window = [](V64 v, V64 by, double half, double center) {
            return hn::Add(hn::Mul(hn::Div(v, by), all(half)), all(center));
        };
        hn::Store(
            snapped(window(c.x, c.w, p.viewport.half_width, p.viewport.center_x), p.profile.subpixel_bits), d,
            x + first);
        hn::Store(
            snapped(window(c.y, c.w, p.viewport.half_height, p.viewport.center_y), p.profile.subpixel_bits),
            d, y + first);
        hn::Store(quantized(window(c.z, c.w, (f - n) / 2, (f + n) / 2), p.profile.depth_bits), d, z + first);
        hn::Store(c.w, d, w + first);
    }
    for (std::size_t i = 0; i < project_batch; ++i) {
        out.x[i] = static_cast<std::int32_t>(x[i]), out.y[i] = static_cast<std::int32_t>(y[i]);
        out.z[i] = static_cast<std::uint32_t>(static_cast<std::int64_t>(z[i]));
        out.w[i] = w[i];
        out.outcode[i] = static_cast<Outcode>(codes[i]);
    }
    out.made = true;
    return out;
}

#else  // no vectors of doubles here: every vertex goes the scalar way

Projected project_all(const Projection&, std::span<const vec3>) { return {}; }

#endif

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::fast {

HWY_EXPORT(project_all);

Projected project(const Projection& projection, std::span<const vec3> positions) {
    return HWY_DYNAMIC_DISPATCH(project_all)(projection, positions);
}

}  // namespace gw::fast
#endif  // HWY_ONCE
