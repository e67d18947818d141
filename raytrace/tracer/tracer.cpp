#include "raytrace/tracer/tracer.h"

#include "gw/stages/texgen.h"
#include "gw/stages/vertex.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace gw::raytrace {
namespace {

/// Reflected and transmitted parts and their directions at a surface.
struct Parting {
    dvec3 reflect{0}, transmit{0};
    dvec3 reflected{0}, transmitted{0};
};

/// A reflected ray of a smooth-shaded facet may point below its plane: then it grazes it.
dvec3 above(const dvec3& d, const dvec3& plane_normal) {
    constexpr double least = 1e-3;
    const double height = dot3(d, plane_normal);
    return height >= least ? d : normalized(d + (least - height) * plane_normal);
}

/// The direction behind the surface, eta = n1 / n2; none: total reflection.
std::optional<dvec3> bent(const dvec3& d, const dvec3& n, double eta) {
    const double c = -dot3(d, n), k = 1 - eta * eta * (1 - c * c);
    if (k < 0) return std::nullopt;
    return normalized(eta * d + (eta * c - std::sqrt(k)) * n);
}

/// Schlick 1994, from the cosine in the thinner medium.
dvec3 schlick(const dvec3& Ks, double cosine) {
    const double m = std::clamp(1 - cosine, 0.0, 1.0);
    return Ks + (dvec3(1) - Ks) * ((m * m) * (m * m) * m);
}

Parting parting(const TracedMaterial& material, const Surface& s) {
    Parting p{.reflect = material.reflect,
              .transmit = material.transmit,
              .reflected = above(reflected(s.direction, s.normal), s.plane_normal)};
    if (material.transmit == dvec3(0)) {
        if (material.fresnel) p.reflect = schlick(material.reflect, -dot3(s.direction, s.normal));
        return p;
    }
    const double eta = s.front ? 1 / material.Ni : material.Ni;
    const auto behind = bent(s.direction, s.normal, eta);
    if (material.fresnel) {
        const bool from_thin = eta <= 1;
        // The thinner medium's cosine is 0 at the critical angle, and beyond it nothing gets there.
        p.reflect = schlick(material.reflect, from_thin ? -dot3(s.direction, s.normal)
                                              : behind  ? -dot3(*behind, s.normal)
                                                        : 0);
        p.transmit = (dvec3(1) - p.reflect) * material.transmit;
    }
    if (!behind) {
        p.reflect += p.transmit;
        p.transmit = dvec3(0);
    } else {
        p.transmitted = -above(-*behind, s.plane_normal);
    }
    return p;
}

double largest(const dvec3& v) { return std::max({v.x, v.y, v.z}); }

}  // namespace

Tracer::Tracer(const scene::Scene& scene, const World& world, const scene::View& view,
               TraceOptions options)
    : world_(world),
      view_(view),
      drawn_(drawn_scene(scene)),
      options_(std::move(options)),
      materials_(scene.materials) {
    for (const scene::Material& m : materials_) traced_.push_back(traced_material(m));
    for (std::size_t i = 0; i < scene.lights.size() && !scene.reflection_in_shadow; ++i)
        if (!keeps_off_reflections_ && scene.lights[i].shadow != scene::Shadow::None)
            keeps_off_reflections_ = {scene::eye_light(scene.lights[i], view), i};
    std::map<std::vector<std::size_t>, std::shared_ptr<const std::vector<LightSource>>> lists;
    for (const scene::Object& object : scene.objects) {
        const TracedMaterial& traced = traced_[object.material];
        std::vector<std::size_t> numbers;
        for (std::size_t i = 0; i < scene.lights.size(); ++i)
            if (scene::lights_object(scene.lights[i], object)) numbers.push_back(i);
        // Most objects have the same lights.
        auto& lights = lists[numbers];
        if (!lights) lights = light_list(scene, numbers, view);
        looks_.push_back({&drawn_.materials[object.material], &traced, traced.any(), lights});
    }
}

std::shared_ptr<const std::vector<Tracer::LightSource>> Tracer::light_list(
    const scene::Scene& scene, const std::vector<std::size_t>& numbers, const scene::View& view) {
    std::vector<LightSource> list;
    for (const std::size_t i : numbers)
        list.push_back({scene::eye_light(scene.lights[i], view), i});
    return std::make_shared<const std::vector<LightSource>>(std::move(list));
}

bool Tracer::looks_up_maps(std::uint32_t triangle) const {
    const scene::Material& m = *look_of(triangle).drawn;
    return !(m.map_Ka.empty() && m.map_Kd.empty() && m.map_Ks.empty() && m.map_Ke.empty());
}

dvec3 Tracer::local(const Surface& surface, RayCounts& counts) const {
    return shaded(surface, true, counts);
}

dvec3 Tracer::traced(const Surface& surface, RayCounts& counts) const {
    return followed(surface, {options_.depth - 1, 1}, counts);
}

dvec3 Tracer::followed(const Surface& surface, const Path& path, RayCounts& counts) const {
    const Look& look = look_of(surface.at.triangle);
    if (!look.is_traced) return dvec3(0);
    const TracedMaterial& material = *look.traced;
    const Parting p = parting(material, surface);
    dvec3 sum(0);
    const auto follow = [&](const dvec3& part, const dvec3& direction, FarMaps far,
                            std::uint64_t& count) {
        const Path next{path.rays_left - 1, path.weight * largest(part)};
        if (next.weight < least_weight) return;
        if (path.rays_left > 0) ++count;
        sum += part * (path.rays_left > 0 ? arriving(surface, direction, far, next, counts)
                       : far              ? far_away(direction, far)
                                          : dvec3(0));
    };
    follow(p.reflect, p.reflected, material.reflection_far, counts.reflected);
    follow(p.transmit, p.transmitted, material.refraction_far, counts.transmitted);
    return sum;
}

dvec3 Tracer::arriving(const Surface& from, const dvec3& direction, FarMaps far, const Path& path,
                       RayCounts& counts) const {
    const auto at = world_.nearest({from.start, direction}, std::numeric_limits<double>::infinity(),
                                   from.at.triangle, &counts.tests);
    if (options_.followed)
        options_.followed({.from = from.start,
                           .direction = direction,
                           .hit = at,
                           .above = dot3(direction, from.plane_normal) > 0,
                           .number = options_.depth - path.rays_left,
                           .part = path.weight});
    if (!at) return far_away(direction, far);
    const Surface hit = surface(world_.triangles(), *at, direction, view_);
    const dvec3 color = shaded(hit, !options_.in_shadow, counts) + followed(hit, path, counts);
    const double d = opacity(at->triangle);
    const Path behind{path.rays_left, path.weight * (1 - d)};
    if (behind.weight < least_weight) return color;
    ++counts.transmitted;
    return d * color + (1 - d) * arriving(hit, direction, far, behind, counts);
}

std::optional<Surface> Tracer::behind(const Surface& translucent, RayCounts& counts) const {
    ++counts.transmitted;
    const auto at = world_.nearest({translucent.start, translucent.direction},
                                   std::numeric_limits<double>::infinity(), translucent.at.triangle,
                                   &counts.tests);
    if (!at) return std::nullopt;
    const Surface hit = surface(world_.triangles(), *at, translucent.direction, view_);
    if (-hit.point.p.z > view_.camera.far_plane) return std::nullopt;
    return hit;
}

dvec3 Tracer::far_away(const dvec3& direction, FarMaps far) const {
    if (!far) return dvec3(drawn_.background);
    return scene::far_color(*far, transform3(dmat3(view_.eye_from_world), direction));
}

dvec3 Tracer::shaded(const Surface& surface, bool by_rays, RayCounts& counts) const {
    ++counts.shaded;
    const Look& look = look_of(surface.at.triangle);
    const scene::Material& material = *look.drawn;
    scene::MapColors maps(material, surface.point);
    dvec3 sum = scene::own_color(material, surface.point);
    if (!material.refl.empty() && !reflects_map(surface, by_rays, counts))
        sum -= dvec3(scene::coefficient(material, scene::Component::Reflection)) *
               scene::map_color(material, scene::Component::Reflection, surface.point);
    const bool reflects_none = material.Kd == vec3(0) && material.Ks == vec3(0);
    for (const LightSource& light : *look.lights)
        sum +=
            scene::light_color(material, light.eye, surface.point, maps,
                               !reflects_none && arrives(light, surface, by_rays, counts) ? 1 : 0);
    return sum;
}

/// False: the light that keeps reflection maps out of its shadow does not arrive [K3.2].
bool Tracer::reflects_map(const Surface& s, bool by_rays, RayCounts& counts) const {
    return !keeps_off_reflections_ || opacity(s.at.triangle) < 1 ||
           arrives(*keeps_off_reflections_, s, by_rays, counts);
}

/// Light on a face whose plane looks away from it is in shadow although interpolated normals catch
/// it: as shadow volumes have it [K3.2].
bool Tracer::arrives(const LightSource& source, const Surface& s, bool by_rays,
                     RayCounts& counts) const {
    const scene::Light& light = drawn_.lights[source.number];
    const bool directional = light.kind == scene::LightKind::Directional;
    const dvec3 toward = directional ? -dvec3(light.direction) : dvec3(light.position) - s.at.p;
    if (!(dot3(toward, s.normal) > 0)) return false;
    if (light.shadow == scene::Shadow::None || opacity(s.at.triangle) < 1) return true;
    if (!(dot3(toward, s.plane_normal) > 0)) return false;
    if (!by_rays) return !options_.in_shadow(source.number, s.at);
    ++counts.shadow;
    const bool arrives = !world_.occluded({s.start, toward},
                                          directional ? std::numeric_limits<double>::infinity() : 1,
                                          s.at.triangle, &counts.tests);
    if (options_.followed)
        options_.followed(
            {.from = s.start, .direction = toward, .light = source.number, .arrives = arrives});
    return arrives;
}

}  // namespace gw::raytrace
