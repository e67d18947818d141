#include "multipass/shadow/shadow_lookup.h"

#include "scene/draw/view.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace gw::multipass {
namespace {

/// Rounding of a vertex's Z and of the plane through three of them.
constexpr double bias_units = 2;

using Comparer = ShadowLookup::Comparer;

/// The place of a point in a map, in texels from its lower left corner; none: outside.
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

dvec3 to_light(const scene::Light& light, const dvec3& p) {
    return light.kind == scene::LightKind::Directional ? -dvec3(light.direction)
                                                       : dvec3(light.position) - p;
}

bool is_dark_side(const scene::TrianglePoint& at, const scene::Light& light, const dvec3& ray) {
    return (dot3(at.normal, to_light(light, at.p)) > 0) != (dot3(at.normal, ray) < 0);
}

/// A fragment's centre may lie slightly outside its true triangle, and at a concave edge behind the
/// next face. So the point is lifted towards the light by this many pixels.
constexpr double lift = 0.25;

void lift_towards(scene::TrianglePoint& at, const scene::Light& light, const scene::PixelRay& ray,
                  const scene::PixelRay& next) {
    const double t = dot3(at.p - ray.o, ray.d) / dot3(ray.d, ray.d);
    const double pixel = length((next.o + next.d * t) - at.p);
    const dvec3 toward = to_light(light, at.p);
    at.p += toward * (lift * pixel / std::max(length(toward), 1e-300));
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

std::vector<std::uint32_t> shadow_mask(const scene::WorldTriangles& polygons,
                                       const scene::Light& light,
                                       const std::vector<ShadowMap>& maps,
                                       const std::vector<std::uint32_t>& ids,
                                       const scene::View& view, const JitterState& jitter,
                                       const Profile& profile) {
    const scene::PixelRays rays(view);
    const ShadowLookup lookup(maps, profile);
    const dvec2 place = scene::place_in_pixel(jitter, profile.subpixel_bits);
    std::vector<std::uint32_t> mask(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (ids[i] == 0) continue;
        const auto x = int(i % std::size_t(view.width)), y = int(i / std::size_t(view.width));
        const scene::PixelRay ray = rays.through(x + place.x, y + place.y);
        auto at = polygons.meet(ids[i], ray.o, ray.d);
        if (!at) continue;
        const bool dark = is_dark_side(*at, light, ray.d);
        if (!dark) lift_towards(*at, light, ray, rays.through(x + place.x + 1, y + place.y));
        mask[i] = dark || lookup.in_shadow(*at) ? 1 : 0;
    }
    return mask;
}

}  // namespace gw::multipass
