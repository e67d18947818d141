#include "itembuffer/traced_component.h"

#include "gw/vertex.h"
#include "raytrace/picture.h"
#include "scene/pixel_rays.h"

namespace gw::itembuffer {
namespace {

/// Whether a polygon is traced, by identifier.
std::vector<bool> traced_ids(const raytrace::Tracer& tracer) {
    const scene::WorldTriangles& triangles = tracer.world().triangles();
    std::vector<bool> traced;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const std::uint32_t id = triangles.id_of(i);
        if (traced.size() <= id) traced.resize(std::size_t(id) + 1);
        traced[id] = tracer.is_traced(i);
    }
    return traced;
}

}  // namespace

TracedComponent traced_component(const raytrace::Tracer& tracer, const scene::Scene& scene,
                                 const scene::View& view, const std::vector<std::uint32_t>& ids,
                                 const JitterState& jitter, const Profile& profile) {
    const std::vector<bool> wanted = traced_ids(tracer);
    const scene::WorldTriangles& triangles = tracer.world().triangles();
    const scene::PixelRays rays(view);
    const dvec2 place = scene::place_in_pixel(jitter, profile.subpixel_bits);
    TracedComponent component{std::vector<Rgba>(ids.size()), {}};
    const auto trace = [&](std::size_t i, int x, int y, raytrace::RayCounts& counts) {
        const scene::PixelRay ray = rays.through(x + place.x, y + place.y);
        ++counts.primary;
        const auto at = triangles.meet(ids[i], ray.o, ray.d);
        if (!at) return;
        const raytrace::Surface s = raytrace::surface(triangles, *at, normalized(ray.d), view);
        const double seen = raytrace::seen_through_fog(scene, s.point.p, profile);
        Rgba& color = component.color[i];
        color = raytrace::stored(seen * tracer.traced(s, counts), profile.color_bits);
        color[3] = 0;
    };
    component.counts =
        raytrace::for_rows(view.height, tracer.options().threads, [&](int y, raytrace::RayCounts& counts) {
            for (int x = 0; x < view.width; ++x) {
                const std::size_t i = std::size_t(y) * std::size_t(view.width) + std::size_t(x);
                if (ids[i] < wanted.size() && wanted[ids[i]]) trace(i, x, y, counts);
            }
        });
    return component;
}

}  // namespace gw::itembuffer
