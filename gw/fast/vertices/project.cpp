#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gw/fast/vertices/project.cpp"
#include <hwy/foreach_target.h>

#include "gw/base/arithmetic.h"
#include "gw/fast/simd/doubles-inl.h"
#include "gw/fast/vertices/project.h"

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#ifndef GW_FAST_PROJECT_CPP_
#define GW_FAST_PROJECT_CPP_
namespace gw::fast {
namespace {

[[maybe_unused]] Outcode outcode_of(const ClipPosition& v, const ViewportTransform& viewport) {
    const dvec4& c = v.clip;
    for (int i = 0; i < 4; ++i)
        if (!std::isfinite(c[i])) return not_finite;
    Outcode code = c.w > 0 ? 0 : not_in_front;
    for (int plane = 0; plane < clip_plane_count; ++plane)
        if (!(clip_distance(v, plane, viewport) >= 0)) code |= Outcode{1} << plane;
    return code;
}

[[maybe_unused]] SnappedVertex window_of(const Projection& p, const ClipPosition& v) {
    const WindowVertex at = gw::to_window(v, p.viewport, p.depth_range, p.profile);
    return {std::int32_t(at.x), std::int32_t(at.y), at.z};
}

/// Positions of any w.
[[maybe_unused]] void project_one_by_one(const Projection& p, const ProjectedVertices& v) {
    for (std::size_t i = 0; i < v.positions.size(); ++i) {
        ClipPosition at;
        place_position(p, dvec4(dvec3(v.positions[i]), v.fourth.empty() ? 1.0 : v.fourth[i]), at);
        v.outcode[i] = outcode_of(at, p.viewport);
        v.w[i] = 1;
        if (v.outcode[i] != 0) continue;
        v.at[i] = window_of(p, at);
        v.w[i] = at.clip.w;
    }
}

}  // namespace
}  // namespace gw::fast
#endif

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

#if HWY_HAVE_FLOAT64

constexpr std::size_t most_lanes = 8;

/// floor(v 2^s + 1/2), clamped to the guard band; to_integer() of gw/base/arithmetic.h turns NaN
/// into its low end.
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

/// Outcodes, plane by plane. A distance that is NaN counts as outside.
struct OutcodeLanes {
    hn::Vec<U64> bits;

    void add(hn::Mask<D64> inside, Outcode bit) {
        bits = hn::Or(bits, hn::IfThenZeroElse(hn::RebindMask(U64(), inside), hn::Set(U64(), bit)));
    }
    void plane(int i, V64 distance) { add(hn::Ge(distance, hn::Zero(D64())), Outcode{1} << i); }
};

/// clip_distance() of gw/stages/clip.h: near, far, guard band.
inline void classify_fixed(const ClipLanes& c, const ViewportTransform& v, OutcodeLanes& out) {
    const auto times = [](double a, V64 b) { return hn::Mul(all(a), b); };
    out.plane(0, v.zero_to_one ? c.z : hn::Add(c.z, c.w));
    out.plane(1, hn::Sub(c.w, c.z));
    out.plane(8, hn::Add(times(v.half_width, c.x), times(v.center_x - guard_low, c.w)));
    out.plane(9, hn::Sub(times(guard_high - v.center_x, c.w), times(v.half_width, c.x)));
    out.plane(10, hn::Add(times(v.half_height, c.y), times(v.center_y - guard_low, c.w)));
    out.plane(11, hn::Sub(times(guard_high - v.center_y, c.w), times(v.half_height, c.y)));
}

/// The distances to the enabled user planes, as in run_vertex().
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

/// Stores integers as up to a vector of vertices.
HWY_INLINE void put_vertices(V64 x, V64 y, V64 z, SnappedVertex* at, std::size_t count) {
    static_assert(sizeof(SnappedVertex) == 4 * sizeof(std::int32_t));
    const hn::Rebind<std::int32_t, D64> d;
    // The conversion is signed, so that the depth's top bit is flipped.
    const auto depth = hn::Xor(hn::DemoteTo(d, hn::Sub(z, all(2147483648.0))),
                               hn::Set(d, std::numeric_limits<std::int32_t>::min()));
    const auto store = [&](SnappedVertex* to) {
        hn::StoreInterleaved4(hn::DemoteTo(d, x), hn::DemoteTo(d, y), depth, hn::Zero(d), d,
                              &to->x);
    };
    if (count == hn::Lanes(d)) return store(at);
    std::array<SnappedVertex, most_lanes> lanes;
    store(lanes.data());
    std::copy_n(lanes.data(), count, at);
}

/// Window coordinates of up to a vector of vertices.
HWY_INLINE void put_window(const Projection& p, const ClipLanes& c, SnappedVertex* at,
                           std::size_t count) {
    const DepthMap depth = depth_map(p.viewport, p.depth_range);
    const auto window = [&](V64 v, double half, double center) {
        return hn::Add(hn::Mul(hn::Div(v, c.w), all(half)), all(center));
    };
    const int bits = p.profile.subpixel_bits;
    put_vertices(snapped(window(c.x, p.viewport.half_width, p.viewport.center_x), bits),
                 snapped(window(c.y, p.viewport.half_height, p.viewport.center_y), bits),
                 quantized(window(c.z, depth.scale, depth.center), p.profile.depth_bits), at,
                 count);
}

/// Component c of up to a vector of points. Lanes beyond the last point repeat the first.
template <class Point>
HWY_INLINE V64 component(std::span<const Point> points, const auto& component_of) {
    alignas(64) double values[most_lanes];
    for (std::size_t i = 0; i < hn::Lanes(D64()); ++i)
        values[i] = component_of(points[i < points.size() ? i : 0]);
    return hn::Load(D64(), values);
}
HWY_INLINE Vec3 lanes_of(std::span<const vec3> points) {
    const auto at = [&](int c) { return component(points, [c](const vec3& p) { return p[c]; }); };
    if (points.size() == hn::Lanes(D64())) return points_at(points.data());
    return {at(0), at(1), at(2)};
}
HWY_INLINE ClipLanes lanes_of(std::span<const ClipPosition> points) {
    const auto at = [&](int c) {
        return component(points, [c](const ClipPosition& p) { return p.clip[c]; });
    };
    return {at(0), at(1), at(2), at(3)};
}

template <class D>
HWY_INLINE void store_some(hn::Vec<D> v, D d, hn::TFromD<D>* to, std::size_t count) {
    if (count == hn::Lanes(d)) return hn::StoreU(v, d, to);
    std::array<hn::TFromD<D>, most_lanes> lanes;
    hn::StoreU(v, d, lanes.data());
    std::copy_n(lanes.data(), count, to);
}

void project_all(const Projection& p, const ProjectedVertices& v) {
    const D64 d;
    const hn::Rebind<Outcode, D64> d32;
    const dmat4& m = p.clip_from_object;
    for (std::size_t first = 0; first < v.positions.size(); first += hn::Lanes(d)) {
        const std::size_t count = HWY_MIN(hn::Lanes(d), v.positions.size() - first);
        const Vec3 at = lanes_of(v.positions.subspan(first, count));
        const ClipLanes c{row(m, 0, at), row(m, 1, at), row(m, 2, at), row(m, 3, at)};
        const auto outside = outcodes(p, at, c);
        const auto drawable = hn::RebindMask(d, hn::Eq(outside, hn::Zero(U64())));
        put_window(p, c, v.at + first, count);
        store_some(hn::TruncateTo(d32, outside), d32, v.outcode + first, count);
        store_some(hn::IfThenElse(drawable, c.w, all(1)), d, v.w + first, count);
    }
}

void window_all(const Projection& p, std::span<const ClipPosition> vertices, SnappedVertex* at) {
    for (std::size_t first = 0; first < vertices.size(); first += hn::Lanes(D64())) {
        const auto points =
            vertices.subspan(first, HWY_MIN(hn::Lanes(D64()), vertices.size() - first));
        put_window(p, lanes_of(points), at + first, points.size());
    }
}

#else  // no vectors of doubles here

void project_all(const Projection& p, const ProjectedVertices& v) { project_one_by_one(p, v); }

void window_all(const Projection& p, std::span<const ClipPosition> vertices, SnappedVertex* at) {
    for (std::size_t i = 0; i < vertices.size(); ++i) at[i] = window_of(p, vertices[i]);
}

#endif

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::fast {

HWY_EXPORT(project_all);
HWY_EXPORT(window_all);

void project(const Projection& projection, const ProjectedVertices& vertices) {
    if (!vertices.fourth.empty()) return project_one_by_one(projection, vertices);
    HWY_DYNAMIC_DISPATCH(project_all)(projection, vertices);
}

void to_window(const Projection& projection, std::span<const ClipPosition> vertices,
               SnappedVertex* at) {
    HWY_DYNAMIC_DISPATCH(window_all)(projection, vertices, at);
}

}  // namespace gw::fast
#endif  // HWY_ONCE
