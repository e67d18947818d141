#include "raytrace/tracer/render.h"

#include "gw/base/arithmetic.h"
#include "gw/base/cancel.h"
#include "gw/base/parallel.h"
#include "gw/stages/fog.h"
#include "gw/stages/vertex.h"
#include "scene/draw/view.h"

#include <algorithm>

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
    if (f.tracer.looks_up_maps(at.triangle))
        add_footprint(s, triangles, ray_of(f, x + 1, y), ray_of(f, x, y + 1));
    return seen_color(f.tracer, s, f.scene, f.profile, counts);
}

/// The identifier of the opaque polygon at the hit or behind it, as the item buffer has it. Finds it
/// for comparisons, so it counts no rays.
std::uint32_t opaque_id(const Frame& f, const scene::TrianglePoint& at, const Ray& ray) {
    const scene::WorldTriangles& triangles = f.tracer.world().triangles();
    if (!(f.tracer.opacity(at.triangle) < 1)) return triangles.id_of(at.triangle);
    RayCounts uncounted;
    const auto behind =
        f.tracer.behind(surface(triangles, at, normalized(ray.direction), f.view), uncounted);
    return behind ? opaque_id(f, behind->at, ray) : 0;
}

void trace_pixel(const Frame& f, int x, int y, RaytracedPicture& picture, RayCounts& counts) {
    const std::size_t i = f.view.index(x, y);
    const Ray ray = ray_of(f, x, y);
    ++counts.primary;
    const auto at = f.tracer.world().nearest(ray, 1, no_triangle, &counts.tests);
    const dvec3 color = at ? color_at(f, *at, x, y, ray, counts) : dvec3(f.scene.background);
    picture.ids[i] = at ? opaque_id(f, *at, ray) : 0;
    picture.color[i] = stored(color, f.profile.color_bits);
}

}  // namespace

Rgba stored(const dvec3& color, int bits) {
    const auto store = [bits](double v) { return static_cast<std::uint16_t>(quantize(v, bits)); };
    return {store(color.x), store(color.y), store(color.z), store(1)};
}

RaytracedPicture raytraced_picture(const Tracer& tracer, const scene::Scene& scene,
                                   const scene::View& view, const JitterState& jitter,
                                   const Profile& profile) {
    const std::size_t pixels = std::size_t(view.width) * std::size_t(view.height);
    RaytracedPicture picture{std::vector<Rgba>(pixels), std::vector<std::uint32_t>(pixels), {}};
    const Frame frame{tracer,
                      scene,
                      view,
                      profile,
                      scene::PixelRays(view),
                      scene::place_in_pixel(jitter, profile.subpixel_bits)};
    picture.counts = for_pixels(
        view, tracer.options().threads,
        [&](int x, int y, RayCounts& counts) { trace_pixel(frame, x, y, picture, counts); });
    return picture;
}

CommandList commands(const RaytracedPicture& picture, const scene::View& view) {
    CommandList list;
    list.add(BeginPass{.name = "ray tracing"});
    list.add(SetState{});
    list.add(WritePixels{.rect = {0, 0, view.width, view.height}, .colors = picture.color});
    return list;
}

dvec3 seen_color(const Tracer& tracer, const Surface& surface, const scene::Scene& scene,
                 const Profile& profile, RayCounts& counts) {
    dvec3 color = tracer.local(surface, counts) + tracer.traced(surface, counts);
    if (scene.fog) {
        const double seen = seen_through_fog(scene, surface.point.p, profile);
        color = seen * color + (1 - seen) * dvec3(scene.fog->color);
    }
    const double d = tracer.opacity(surface.at.triangle);
    if (!(d < 1)) return color;
    const auto behind = tracer.behind(surface, counts);
    return d * color + (1 - d) * (behind ? seen_color(tracer, *behind, scene, profile, counts)
                                         : dvec3(scene.background));
}

double seen_through_fog(const scene::Scene& scene, const dvec3& p_eye, const Profile& profile) {
    if (!scene.fog) return 1;
    const scene::Fog& fog = *scene.fog;
    const FogState state{.enable = true,
                         .mode = fog.mode,
                         .density = fog.density,
                         .start = fog.start,
                         .end = fog.end};
    return double(fog_factor(state, -p_eye.z, profile.color_bits)) /
           max_of_bits(profile.color_bits);
}

RayCounts for_pixels(const scene::View& view, int threads,
                     const std::function<void(int, int, RayCounts&)>& body) {
    constexpr int side = 16;
    const auto [first, end] = view.rows();
    const int columns = (view.width + side - 1) / side, rows = (end - first + side - 1) / side;
    std::vector<RayCounts> squares(std::size_t(columns) * std::size_t(rows));
    const CancelFlag cancel = cancel_flag();
    parallel_for(squares.size(), threads, [&, first = first, end = end](std::size_t i, int) {
        end_if_canceled(cancel);
        const int x0 = int(i) % columns * side, y0 = first + int(i) / columns * side;
        for (int y = y0; y < std::min(y0 + side, end); ++y)
            for (int x = x0; x < std::min(x0 + side, view.width); ++x) body(x, y, squares[i]);
    });
    RayCounts sum;
    for (const RayCounts& square : squares) sum.add(square);
    return sum;
}

}  // namespace gw::raytrace
