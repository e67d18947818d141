// The comparison of shadow maps, on the host.
#include "multipass/polygon_planes.h"
#include "multipass/shadow_map.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace gw::multipass {
namespace {

/// Rounding of a vertex's Z and of the plane through three of them.
constexpr double bias_units = 2;

/// A map with what comparing needs of it.
struct Comparer {
    const ShadowMap& map;
    dmat4 clip_from_world;
    dmat4 clip_plane_from_world;  ///< inverse transpose: planes move by it
    double units;                 ///< of Z from -1 to 1
    double snap;                  ///< of a vertex, in texels

    Comparer(const ShadowMap& shadow_map, const Profile& profile)
        : map(shadow_map),
          clip_from_world(map.view.clip_from_eye * map.view.eye_from_world),
          clip_plane_from_world(glm::transpose(glm::inverse(clip_from_world))),
          units(std::ldexp(1.0, profile.depth_bits) - 1),
          snap(std::ldexp(0.5, -profile.subpixel_bits)) {}
};

/// Where a point lies in a map, in texels from its lower left corner; none: outside.
std::optional<dvec2> place_in(const Comparer& c, const dvec3& p) {
    const dvec4 clip = c.clip_from_world * dvec4(p, 1);
    if (!(clip.w > 0) || std::abs(clip.x) >= clip.w || std::abs(clip.y) >= clip.w) return std::nullopt;
    const double size = c.map.view.width;
    return dvec2((clip.x / clip.w + 1) / 2 * size, (clip.y / clip.w + 1) / 2 * size);
}

/// The plane of a face in a map's clip coordinates: z as a function of the texel, in units of Z.
struct FacePlane {
    double z = 0, dx = 0, dy = 0;
    bool edge_on = false;
};

FacePlane face_plane(const Comparer& c, const SurfacePoint& at) {
    const dvec4 plane = c.clip_plane_from_world * dvec4(at.normal, -dot3(at.normal, at.p));
    if (plane.z == 0) return {.edge_on = true};
    const double texel = 2.0 / c.map.view.width, half = c.units / 2;
    const double corner = (plane.x + plane.y - plane.w) / plane.z;  // z at x = y = -1
    return {(corner + 1) * half, -plane.x / plane.z * texel * half, -plane.y / plane.z * texel * half};
}

/// Whether the light's Z at texel (i, j) is nearer than the face there.
bool is_hidden(const Comparer& c, const FacePlane& face, int i, int j) {
    const int size = c.map.view.width;
    const int x = std::clamp(i, 0, size - 1), y = std::clamp(j, 0, size - 1);
    const double z = face.z + face.dx * (x + 0.5) + face.dy * (y + 0.5);
    const double bias = bias_units + (std::abs(face.dx) + std::abs(face.dy)) * c.snap;
    return double(c.map.depth[std::size_t(y) * std::size_t(size) + std::size_t(x)]) < z - bias;
}

/// The four texels around the point vote, each by its share in it: where two faces meet in a hollow edge, the
/// nearest texel may be the other face's.
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
    return light.kind == scene::LightKind::Directional ? -dvec3(light.direction) : dvec3(light.position) - p;
}

bool is_dark_side(const SurfacePoint& at, const scene::Light& light, const dvec3& ray) {
    return (dot3(at.normal, to_light(light, at.p)) > 0) != (dot3(at.normal, ray) < 0);
}

double length(const dvec3& v) { return std::sqrt(dot3(v, v)); }

/// What a pixel shows. A fragment's centre may lie a little beside its true triangle, in a hollow edge behind
/// the next face: so the point is lifted towards the light by `lift` pixels.
constexpr double lift = 0.25;

void lift_towards(SurfacePoint& at, const scene::Light& light, const PixelRay& ray, const PixelRay& next) {
    const double t = dot3(at.p - ray.o, ray.d) / dot3(ray.d, ray.d);
    const double pixel = length((next.o + next.d * t) - at.p);
    const dvec3 way = to_light(light, at.p);
    at.p += way * (lift * pixel / std::max(length(way), 1e-300));
}

bool in_shadow(const std::vector<Comparer>& maps, const SurfacePoint& at) {
    for (const Comparer& c : maps) {
        const auto place = place_in(c, at.p);
        if (!place) continue;
        const FacePlane face = face_plane(c, at);
        return face.edge_on || is_hidden(c, face, *place);
    }
    return false;
}

}  // namespace

std::vector<std::uint32_t> shadow_mask(const Model& model, const scene::Light& light,
                                       const std::vector<ShadowMap>& maps,
                                       const std::vector<std::uint32_t>& ids, const scene::View& view,
                                       const JitterState& jitter, const Profile& profile) {
    const PolygonTable polygons(model);
    const PixelRays rays(view);
    std::vector<Comparer> comparers;
    for (const ShadowMap& map : maps) comparers.emplace_back(map, profile);
    // The scene was moved by the jitter, so a pixel's centre sees what lies as much the other way.
    const double unit = std::ldexp(1.0, -profile.subpixel_bits), dx = 0.5 - jitter.x * unit,
                 dy = 0.5 - jitter.y * unit;
    std::vector<std::uint32_t> mask(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (ids[i] == 0) continue;
        const auto x = int(i % std::size_t(view.width)), y = int(i / std::size_t(view.width));
        const PixelRay ray = rays.through(x + dx, y + dy);
        auto at = polygons.meet(ids[i], ray.o, ray.d);
        if (!at) continue;
        const bool dark = is_dark_side(*at, light, ray.d);
        if (!dark) lift_towards(*at, light, ray, rays.through(x + dx + 1, y + dy));
        mask[i] = dark || in_shadow(comparers, *at) ? 1 : 0;
    }
    return mask;
}

}  // namespace gw::multipass
