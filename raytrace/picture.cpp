#include "raytrace/picture.h"

#include "gw/arithmetic.h"
#include "gw/fog.h"
#include "gw/parallel.h"
#include "gw/vertex.h"
#include "scene/pixel_rays.h"

namespace gw::raytrace {
namespace {

/// Everything that one pixel needs.
struct Frame {
    const Tracer& tracer;
    const scene::Scene& scene;
    const scene::View& view;
    const Profile& profile;
    scene::PixelRays rays;
    dvec2 place;
};

Ray ray_of(const Frame& f, double x, double y) {
    const scene::PixelRay ray = f.rays.through(x + f.place.x, y + f.place.y);
    return {ray.o, ray.d};
}

dvec3 color_at(const Frame& f, const scene::TrianglePoint& at, int x, int y, const Ray& ray,
               RayCounts& counts) {
    const scene::WorldTriangles& triangles = f.tracer.world().triangles();
    Surface s = surface(triangles, at, normalized(ray.direction), f.view);
    add_footprint(s, triangles, ray_of(f, x + 1, y), ray_of(f, x, y + 1));
    const dvec3 color = f.tracer.local(s, counts) + f.tracer.traced(s, counts);
    const double seen = seen_through_fog(f.scene, s.point.p, f.profile);
    return f.scene.fog ? seen * color + (1 - seen) * dvec3(f.scene.fog->color) : color;
}

void trace_row(const Frame& f, int y, RaytracedPicture& picture, RayCounts& counts) {
    for (int x = 0; x < f.view.width; ++x) {
        const std::size_t i = std::size_t(y) * std::size_t(f.view.width) + std::size_t(x);
        const Ray ray = ray_of(f, x, y);
        ++counts.primary;
        const auto at = f.tracer.world().nearest(ray, 1);
        const dvec3 color = at ? color_at(f, *at, x, y, ray, counts) : dvec3(f.scene.background);
        picture.ids[i] = at ? f.tracer.world().triangles().id_of(at->triangle) : 0;
        picture.color[i] = stored(color, f.profile.color_bits);
    }
}

}  // namespace

Rgba stored(const dvec3& color, int bits) {
    const auto store = [bits](double v) { return static_cast<std::uint16_t>(quantize(v, bits)); };
    return {store(color.x), store(color.y), store(color.z), store(1)};
}

RaytracedPicture raytraced_picture(const Tracer& tracer, const scene::Scene& scene, const scene::View& view,
                                   const JitterState& jitter, const Profile& profile) {
    const std::size_t pixels = std::size_t(view.width) * std::size_t(view.height);
    RaytracedPicture picture{std::vector<Rgba>(pixels), std::vector<std::uint32_t>(pixels), {}};
    const Frame frame{tracer,
                      scene,
                      view,
                      profile,
                      scene::PixelRays(view),
                      scene::place_in_pixel(jitter, profile.subpixel_bits)};
    picture.counts = for_rows(view.height, tracer.options().threads,
                              [&](int y, RayCounts& counts) { trace_row(frame, y, picture, counts); });
    return picture;
}

CommandList commands(const RaytracedPicture& picture, const scene::View& view) {
    CommandList list;
    list.add(BeginPass{.name = "ray tracing"});
    list.add(SetState{});
    list.add(WritePixels{.rect = {0, 0, view.width, view.height}, .colors = picture.color});
    return list;
}

double seen_through_fog(const scene::Scene& scene, const dvec3& p_eye, const Profile& profile) {
    if (!scene.fog) return 1;
    const scene::Fog& fog = *scene.fog;
    const FogState state{
        .enable = true, .mode = fog.mode, .density = fog.density, .start = fog.start, .end = fog.end};
    return double(fog_factor(state, -p_eye.z, profile.color_bits)) / max_of_bits(profile.color_bits);
}

RayCounts for_rows(int height, int threads, const std::function<void(int, RayCounts&)>& body) {
    std::vector<RayCounts> rows(static_cast<std::size_t>(height));
    parallel_for(rows.size(), threads, [&](std::size_t y, int) { body(int(y), rows[y]); });
    RayCounts sum;
    for (const RayCounts& row : rows) sum.add(row);
    return sum;
}

}  // namespace gw::raytrace
