#include "multipass/shadow/shadow_lookup.h"
#include "multipass/shadow/shadow_map.h"
#include "scene/draw/pixel_rays.h"

#include <algorithm>
#include <cmath>

namespace gw::multipass {
namespace {

dvec3 to_light(const scene::Light& light, const dvec3& p) {
    return light.kind == scene::LightKind::Directional ? -dvec3(light.direction)
                                                       : dvec3(light.position) - p;
}

bool is_dark_side(const scene::TrianglePoint& at, const scene::Light& light, const dvec3& ray) {
    return (dot3(at.normal, to_light(light, at.p)) > 0) != (dot3(at.normal, ray) < 0);
}

/// A fragment's centre may lie slightly outside its true triangle, and at a concave edge behind the
/// next face: so the point is lifted towards the light by this many pixels.
constexpr double lift = 0.25;

void lift_towards(scene::TrianglePoint& at, const scene::Light& light, const scene::PixelRay& ray,
                  const scene::PixelRay& next) {
    const double t = dot3(at.p - ray.o, ray.d) / dot3(ray.d, ray.d);
    const double pixel = length((next.o + next.d * t) - at.p);
    const dvec3 toward = to_light(light, at.p);
    at.p += toward * (lift * pixel / std::max(length(toward), 1e-300));
}

}  // namespace

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
