#include "multipass/shadow/shadow_lookup.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace gw::multipass {
namespace {

/// Rounding of a vertex's Z and of the plane through three of them.
constexpr double bias_units = 2;

using Comparer = ShadowLookup::Comparer;

/// Where a point lies in a map, in texels from its lower left corner; none: outside.
std::optional<dvec2> place_in(const Comparer& c, const dvec3& p) {
    // A point is in one of a cube's six maps: reject the other five early.
    const dmat4& m = c.clip_from_world;
    const auto clip = [&](int row) {
        return (m[0][row] * p.x + m[1][row] * p.y) + (m[2][row] * p.z + m[3][row]);
    };
    const double w = clip(3);
    if (!(w > 0)) return std::nullopt;
    const double x = clip(0);
    if (std::abs(x) >= w) return std::nullopt;
    const double y = clip(1);
    if (std::abs(y) >= w) return std::nullopt;
    const double size = c.map.view.width;
    return dvec2((x / w + 1) / 2 * size, (y / w + 1) / 2 * size);
}

/// The plane of a face in a map's clip coordinates: z as a function of the texel, in units of Z.
struct FacePlane {
    double z = 0, dx = 0, dy = 0;
    bool edge_on = false;
};

FacePlane face_plane(const Comparer& c, const scene::TrianglePoint& at) {
    const dvec4 plane = c.clip_plane_from_world * dvec4(at.normal, -dot3(at.normal, at.p));
    if (plane.z == 0) return {.edge_on = true};
    const double texel = 2.0 / c.map.view.width, half = c.units / 2;
    const double corner = (plane.x + plane.y - plane.w) / plane.z;  // z at x = y = -1
    return {(corner + 1) * half, -plane.x / plane.z * texel * half,
            -plane.y / plane.z * texel * half};
}

/// Whether the light's Z at texel (i, j) is nearer than the face there.
bool is_hidden(const Comparer& c, const FacePlane& face, int i, int j) {
    const int size = c.map.view.width;
    const int x = std::clamp(i, 0, size - 1), y = std::clamp(j, 0, size - 1);
    const double z = face.z + face.dx * (x + 0.5) + face.dy * (y + 0.5);
    const double bias = bias_units + (std::abs(face.dx) + std::abs(face.dy)) * c.snap;
    return double(c.map.depth[std::size_t(y) * std::size_t(size) + std::size_t(x)]) < z - bias;
}

/// The four texels around the point vote, each with its bilinear weight: at a concave edge the
/// nearest texel may belong to the other face.
bool is_hidden(const Comparer& c, const FacePlane& face, const dvec2& place) {
    const double x = place.x - 0.5, y = place.y - 0.5;
    const int i = int(std::floor(x)), j = int(std::floor(y));
    const double fx = x - i, fy = y - j;
    const auto vote = [&](int k, int l, double share) {
        return is_hidden(c, face, i + k, j + l) ? share : 0;
    };
    return (vote(0, 0, (1 - fx) * (1 - fy)) + vote(1, 0, fx * (1 - fy))) +
               (vote(0, 1, (1 - fx) * fy) + vote(1, 1, fx * fy)) >
           0.5;
}

}  // namespace

ShadowLookup::ShadowLookup(const std::vector<ShadowMap>& maps, const Profile& profile) {
    for (const ShadowMap& map : maps) {
        const dmat4 clip_from_world = map.view.clip_from_eye * map.view.eye_from_world;
        comparers_.push_back({map, clip_from_world, glm::transpose(glm::inverse(clip_from_world)),
                              std::ldexp(1.0, profile.depth_bits) - 1,
                              std::ldexp(0.5, -profile.subpixel_bits)});
    }
}

bool ShadowLookup::in_shadow(const scene::TrianglePoint& at) const {
    for (const Comparer& c : comparers_) {
        const auto place = place_in(c, at.p);
        if (!place) continue;
        const FacePlane face = face_plane(c, at);
        return face.edge_on || is_hidden(c, face, *place);
    }
    return false;
}

}  // namespace gw::multipass
