// Sutherland and Hodgman's algorithm, plane by plane.
#include "gw/stages/clip.h"

#include "gw/stages/resolve.h"

#include "gw/base/arithmetic.h"

#include <bit>
#include <cmath>

namespace gw {

double clip_distance(const ClipPosition& v, int i, const ViewportTransform& vp) {
    const dvec4& c = v.clip;
    switch (i) {
        case 0: return vp.zero_to_one ? c.z : c.z + c.w;
        case 1: return c.w - c.z;
        case 8: return vp.half_width * c.x + (vp.center_x - guard_low) * c.w;
        case 9: return (guard_high - vp.center_x) * c.w - vp.half_width * c.x;
        case 10: return vp.half_height * c.y + (vp.center_y - guard_low) * c.w;
        case 11: return (guard_high - vp.center_y) * c.w - vp.half_height * c.y;
        default: return v.distance[std::size_t(i - 2)];
    }
}

namespace {

double mix(double a, double b, double t) { return a + t * (b - a); }

/// Writes directly to the vector's element: copying a vertex stalls until its stores have retired.
void interpolate(const ClipPosition& in, const ClipPosition& out, double t, ClipPosition& v) {
    for (int i = 0; i < 4; ++i) v.clip[i] = mix(in.clip[i], out.clip[i], t);
    for (std::size_t i = 0; i < v.distance.size(); ++i)
        v.distance[i] = mix(in.distance[i], out.distance[i], t);
}
void interpolate(const Vertex& in, const Vertex& out, double t, Vertex& v) {
    v = gw::interpolate(in, out, t);
}

}  // namespace

Vertex interpolate(const Vertex& in, const Vertex& out, double t) {
    Vertex v;
    interpolate(in, out, t, static_cast<ClipPosition&>(v));
    for (int i = 0; i < 4; ++i) {
        const auto c = std::size_t(i);
        v.texcoord[i] = mix(in.texcoord[i], out.texcoord[i], t);
        v.color[c] = round_even(mix(in.color[c], out.color[c], t));
        v.back_color[c] = round_even(mix(in.back_color[c], out.back_color[c], t));
        v.secondary[c] = round_even(mix(in.secondary[c], out.secondary[c], t));
        v.back_secondary[c] = round_even(mix(in.back_secondary[c], out.back_secondary[c], t));
    }
    for (std::size_t unit = 0; unit < v.more_texcoords.size(); ++unit)
        for (int i = 0; i < 4; ++i)
            v.more_texcoords[unit][i] =
                mix(in.more_texcoords[unit][i], out.more_texcoords[unit][i], t);
    v.fog = mix(in.fog, out.fog, t);
    return v;
}

namespace {

bool is_finite(const ClipPosition& v) {
    return std::isfinite(v.clip.x) && std::isfinite(v.clip.y) && std::isfinite(v.clip.z) &&
           std::isfinite(v.clip.w);
}

/// Writes the distances to a plane to d. Returns whether all vertices are inside.
template <class V>
bool measure(const std::vector<V>& vertices, int plane, const ViewportTransform& viewport,
             std::vector<double>& d) {
    d.resize(vertices.size());
    bool all_inside = true;
    for (std::size_t i = 0; i < d.size(); ++i) {
        d[i] = clip_distance(vertices[i], plane, viewport);
        all_inside = all_inside && d[i] >= 0;
    }
    return all_inside;
}

template <class V>
void crossing(const V& a, const V& b, double da, double db, V& v) {
    if (da >= 0)
        interpolate(a, b, da / (da - db), v);
    else
        interpolate(b, a, db / (db - da), v);
}

/// Clips by one plane. A line or point is an open chain, without a side from last to first vertex.
template <class V>
void clip_plane(const std::vector<V>& in, const std::vector<double>& d, std::vector<V>& out) {
    const std::size_t sides = in.size() < 3 ? in.size() - 1 : in.size();
    out.clear();
    for (std::size_t i = 0; i < in.size(); ++i) {
        const std::size_t next = i + 1 < in.size() ? i + 1 : 0;
        if (d[i] >= 0) out.push_back(in[i]);
        if (i < sides && (d[i] >= 0) != (d[next] >= 0))
            crossing(in[i], in[next], d[i], d[next], out.emplace_back());
    }
}

/// Clears `vertices` if the primitive is rejected. Returns whether anything was cut. `d` and `left`
/// are scratch memory.
template <class V>
bool clip_by_planes(std::vector<V>& vertices, const ViewportTransform& viewport,
                    std::uint32_t planes, std::vector<double>& d, std::vector<V>& left) {
    const std::size_t least = vertices.size() < 3 ? vertices.size() : 3;
    const auto reject = [&](bool cut) {
        vertices.clear();
        return cut;
    };
    for (const V& v : vertices)
        if (!is_finite(v)) return reject(false);
    bool cut = false;
    for (; planes != 0; planes &= planes - 1) {
        const int plane = std::countr_zero(planes);
        if (measure(vertices, plane, viewport, d)) continue;
        cut = true;
        clip_plane(vertices, d, left);
        vertices.swap(left);
        if (vertices.size() < least) return reject(true);
    }
    for (const V& v : vertices)
        if (!(v.clip.w > 0) || !is_finite(v)) return reject(true);
    return cut;
}

}  // namespace

Clipped clip(std::vector<Vertex> vertices, const ViewportTransform& viewport) {
    std::vector<double> d;
    std::vector<Vertex> left;
    const bool cut = clip_by_planes(vertices, viewport, all_clip_planes, d, left);
    return {std::move(vertices), cut};
}

bool PositionClipper::clip(const ViewportTransform& viewport, std::uint32_t planes) {
    return clip_by_planes(vertices, viewport, planes, distances, left);
}

}  // namespace gw
