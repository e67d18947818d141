#include "itembuffer/adaptive.h"

#include "gw/stages/vertex.h"
#include "multipass/frame/samples.h"
#include "scene/draw/item_buffer.h"
#include "scene/draw/view.h"
#include "scene/draw/world_triangles.h"

#include <algorithm>
#include <optional>

namespace gw::itembuffer {
namespace {

/// Identifiers of a pixel and its neighbours, each once, in order.
std::vector<std::uint32_t> around(const std::vector<std::uint32_t>& ids, const scene::View& view,
                                  int x, int y) {
    std::vector<std::uint32_t> found;
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, view.height - 1); ++j)
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, view.width - 1); ++i)
            found.push_back(ids[view.index(i, j)]);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

struct Sampler {
    const raytrace::Tracer& tracer;
    const scene::Scene& scene;
    const scene::View& view;
    const Profile& profile;
    scene::PixelRays rays;

    /// How far along its direction, from the near plane to the far one, a ray is at p.
    static double depth(const scene::PixelRay& ray, const dvec3& p) {
        return dot3(p - ray.o, ray.d) / dot3(ray.d, ray.d);
    }
    bool goes_through(const scene::TrianglePoint& at, const scene::PixelRay& ray) const {
        const auto w =
            scene::weights_at(tracer.world().triangles().corners(at.triangle), ray.o, ray.d);
        return std::min({w[0], w[1], w[2]}) >= 0;
    }

    /// The nearest of these polygons that the ray goes through.
    std::optional<scene::TrianglePoint> nearest(const std::vector<std::uint32_t>& ids,
                                                const scene::PixelRay& ray) const {
        std::optional<scene::TrianglePoint> best;
        for (const std::uint32_t id : ids) {
            const auto at = tracer.world().triangles().meet(id, ray.o, ray.d);
            if (at && goes_through(*at, ray) && (!best || depth(ray, at->p) < depth(ray, best->p)))
                best = at;
        }
        return best;
    }

    dvec3 color(const std::optional<scene::TrianglePoint>& at, const scene::PixelRay& ray,
                raytrace::RayCounts& counts) const {
        ++counts.primary;
        if (!at) return dvec3(scene.background);
        const raytrace::Surface s =
            raytrace::surface(tracer.world().triangles(), *at, normalized(ray.d), view);
        return raytrace::seen_color(tracer, s, scene, profile, counts);
    }

    /// One polygon: the ray through the centre is cut with it wherever it lies.
    dvec3 at_centre(std::uint32_t id, int x, int y, raytrace::RayCounts& counts) const {
        const scene::PixelRay ray = rays.through(x + 0.5, y + 0.5);
        return color(tracer.world().triangles().meet(id, ray.o, ray.d), ray, counts);
    }

    dvec3 divided(const std::vector<std::uint32_t>& ids, int x, int y, int samples,
                  raytrace::RayCounts& counts) const {
        dvec3 sum(0);
        for (int k = 0; k < samples; ++k) {
            const JitterState jitter =
                multipass::jitter_of({std::size_t(k), std::size_t(samples)}, profile.subpixel_bits);
            const dvec2 place = scene::place_in_pixel(jitter, profile.subpixel_bits);
            const scene::PixelRay ray = rays.through(x + place.x, y + place.y);
            sum += color(nearest(ids, ray), ray, counts);
        }
        return sum / double(samples);
    }
};

}  // namespace

AdaptivePicture adaptive_picture(const raytrace::Tracer& tracer, const scene::Scene& scene,
                                 const scene::View& view, const std::vector<std::uint32_t>& ids,
                                 int samples, const Profile& profile) {
    AdaptivePicture out{{std::vector<Rgba>(ids.size()), ids, {}},
                        std::vector<std::uint8_t>(ids.size())};
    const Sampler sampler{tracer, scene, view, profile, scene::PixelRays(view)};
    const auto draw = [&](int x, int y, raytrace::RayCounts& counts) {
        const std::size_t i = view.index(x, y);
        const std::vector<std::uint32_t> near_ids = around(ids, view, x, y);
        out.divided[i] = near_ids.size() > 1 && samples > 1;
        const dvec3 color = out.divided[i] ? sampler.divided(near_ids, x, y, samples, counts)
                                           : sampler.at_centre(ids[i], x, y, counts);
        out.picture.color[i] = raytrace::stored(color, profile.color_bits);
    };
    out.picture.counts = raytrace::for_pixels(view, tracer.options().threads, draw);
    return out;
}

void render_adaptive(Machine& machine, const scene::Scene& scene, const scene::View& view,
                     int samples, const Options& options) {
    const raytrace::World world(scene, options.threads);
    const raytrace::Tracer tracer(scene, world, view,
                                  {.depth = options.depth, .threads = options.threads});
    // All rows: a pixel looks at its neighbours.
    scene::View whole = view;
    whole.only_rows.reset();
    const auto ids = scene::draw_item_buffer(machine, raytrace::drawn_scene(scene), whole, {});
    const AdaptivePicture drawn =
        adaptive_picture(tracer, scene, view, ids, samples, machine.profile());
    if (options.counts) options.counts->add(drawn.picture.counts);
    machine.execute(raytrace::commands(drawn.picture, view));
}

}  // namespace gw::itembuffer
