#include "itembuffer/traced_component.h"

#include "gw/stages/vertex.h"
#include "raytrace/tracer/render.h"
#include "scene/draw/view.h"

namespace gw::itembuffer {

TracedComponent traced_component(const raytrace::Tracer& tracer, const scene::Scene& scene,
                                 const scene::View& view, const std::vector<std::uint32_t>& ids,
                                 const JitterState& jitter, const Profile& profile) {
    const scene::WorldTriangles& triangles = tracer.world().triangles();
    const scene::PixelRays rays(view);
    const dvec2 place = scene::place_in_pixel(jitter, profile.subpixel_bits);
    TracedComponent component{std::vector<Rgba>(ids.size()), {}};
    const auto is_traced = [&](std::uint32_t id) {
        const auto triangle = triangles.first_of(id);
        return triangle && tracer.is_traced(*triangle);
    };
    const auto trace = [&](int x, int y, raytrace::RayCounts& counts) {
        const std::size_t i = view.index(x, y);
        if (!is_traced(ids[i])) return;
        const scene::PixelRay ray = rays.through(x + place.x, y + place.y);
        ++counts.primary;
        ++counts.tests.triangles;
        const auto at = triangles.meet(ids[i], ray.o, ray.d);
        if (!at) return;
        const raytrace::Surface s = raytrace::surface(triangles, *at, normalized(ray.d), view);
        const double seen = raytrace::seen_through_fog(scene, s.point.p, profile);
        Rgba& color = component.color[i];
        color = raytrace::stored(seen * tracer.traced(s, counts), profile.color_bits);
        color[3] = 0;
    };
    component.counts = raytrace::for_pixels(view, tracer.options().threads, trace);
    return component;
}

}  // namespace gw::itembuffer
