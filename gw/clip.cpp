// Sutherland-Hodgman against the planes in order; new vertices always start from the inside one.
#include "gw/clip.h"

#include "gw/arithmetic.h"

#include <cmath>

namespace gw {

double clip_distance(const Vertex& v, int i, const ViewportTransform& vp) {
    const dvec4& c = v.clip;
    switch (i) {
        case 0: return c.z + c.w;
        case 1: return c.w - c.z;
        case 8: return vp.half_width * c.x + (vp.center_x - guard_low) * c.w;
        case 9: return (guard_high - vp.center_x) * c.w - vp.half_width * c.x;
        case 10: return vp.half_height * c.y + (vp.center_y - guard_low) * c.w;
        case 11: return (guard_high - vp.center_y) * c.w - vp.half_height * c.y;
        default: return v.distance[static_cast<std::size_t>(i - 2)];
    }
}

Vertex interpolate(const Vertex& in, const Vertex& out, double t) {
    const auto mix = [t](double a, double b) { return a + t * (b - a); };
    Vertex v;
    for (int i = 0; i < 4; ++i) {
        const auto c = static_cast<std::size_t>(i);
        v.clip[i] = mix(in.clip[i], out.clip[i]);
        v.texcoord[i] = mix(in.texcoord[i], out.texcoord[i]);
        v.color[c] = round_even(mix(in.color[c], out.color[c]));
        v.back_color[c] = round_even(mix(in.back_color[c], out.back_color[c]));
    }
    for (std::size_t i = 0; i < v.distance.size(); ++i) v.distance[i] = mix(in.distance[i], out.distance[i]);
    v.fog = mix(in.fog, out.fog);
    return v;
}

namespace {

bool is_finite(const Vertex& v) {
    return std::isfinite(v.clip.x) && std::isfinite(v.clip.y) && std::isfinite(v.clip.z) &&
           std::isfinite(v.clip.w);
}

std::vector<double> distances(const std::vector<Vertex>& vertices, int plane,
                              const ViewportTransform& viewport, bool& all_inside) {
    std::vector<double> d;
    all_inside = true;
    for (const Vertex& v : vertices) {
        d.push_back(clip_distance(v, plane, viewport));
        all_inside = all_inside && d.back() >= 0;
    }
    return d;
}

Vertex crossing(const Vertex& a, const Vertex& b, double da, double db) {
    return da >= 0 ? interpolate(a, b, da / (da - db)) : interpolate(b, a, db / (db - da));
}

/// One plane. A line or point is an open chain: it has no side from the last vertex to the first.
std::vector<Vertex> clip_plane(const std::vector<Vertex>& in, const std::vector<double>& d) {
    const std::size_t sides = in.size() < 3 ? in.size() - 1 : in.size();
    std::vector<Vertex> out;
    for (std::size_t i = 0; i < in.size(); ++i) {
        const std::size_t next = (i + 1) % in.size();
        if (d[i] >= 0) out.push_back(in[i]);
        if (i < sides && (d[i] >= 0) != (d[next] >= 0))
            out.push_back(crossing(in[i], in[next], d[i], d[next]));
    }
    return out;
}

}  // namespace

Clipped clip(std::vector<Vertex> vertices, const ViewportTransform& viewport) {
    Clipped result;
    const std::size_t least = vertices.size() < 3 ? vertices.size() : 3;
    for (const Vertex& v : vertices)
        if (!is_finite(v)) return result;
    for (int plane = 0; plane < clip_plane_count; ++plane) {
        bool all_inside = true;
        const std::vector<double> d = distances(vertices, plane, viewport, all_inside);
        if (all_inside) continue;
        result.cut = true;
        vertices = clip_plane(vertices, d);
        if (vertices.size() < least) return {{}, true};
    }
    for (const Vertex& v : vertices)
        if (!(v.clip.w > 0) || !is_finite(v)) return {{}, true};
    result.vertices = std::move(vertices);
    return result;
}

}  // namespace gw
