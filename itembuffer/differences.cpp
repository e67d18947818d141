#include "itembuffer/differences.h"

#include "gw/stages/vertex.h"
#include "multipass/steps/schedule.h"
#include "raytrace/tracer/render.h"
#include "scene/draw/item_buffer.h"
#include "scene/draw/view.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace gw::itembuffer {
namespace {

/// Both pictures of a scene.
struct Pair {
    std::vector<Rgba> by_passes;
    raytrace::RaytracedPicture by_rays;
};

Pair draw_both(Machine& machine, const scene::Scene& scene, const scene::View& view,
               const Options& options, const raytrace::World& world) {
    Pair pair;
    render(machine, scene, view, {}, options);
    pair.by_passes = machine.planes().color;
    const raytrace::Tracer tracer(scene, world, view,
                                  {.depth = options.depth, .threads = options.threads});
    pair.by_rays = raytrace::raytraced_picture(tracer, scene, view, {}, machine.profile());
    return pair;
}

int largest_difference(const Rgba& a, const Rgba& b) {
    int most = 0;
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(int(a[c]) - int(b[c])));
    return most;
}

std::vector<int> units_of(const Pair& pair) {
    std::vector<int> units(pair.by_passes.size());
    for (std::size_t i = 0; i < units.size(); ++i)
        units[i] = largest_difference(pair.by_passes[i], pair.by_rays.color[i]);
    return units;
}

int adding_passes(const scene::Scene& scene) {
    const scene::Scene drawn = raytrace::drawn_scene(scene);
    const multipass::PassModel model = multipass::make_pass_model(drawn);
    const auto steps =
        multipass::schedule(passes_with_tracing(scene, multipass::Translucency::Sorted), model);
    return int(std::count_if(steps.begin(), steps.end(), [&](const multipass::Step& s) {
        return s.pass.color && s.pass.action != multipass::PassAction::Shadow &&
               multipass::is_needed(s, model);
    }));
}

/// The lights in whose shadow the first hit of a pixel lies, a bit each (the 65th shares the
/// first's).
std::uint64_t shadows_at(const scene::Scene& scene, const raytrace::World& world,
                         const scene::PixelRay& ray) {
    const auto at = world.nearest({ray.o, ray.d}, 1);
    if (!at) return 0;
    const dvec3 seen_side = dot3(at->normal, ray.d) < 0 ? at->normal : -at->normal;
    std::uint64_t shadows = 0;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const scene::Light& light = scene.lights[i];
        if (light.shadow == scene::Shadow::None) continue;
        const bool directional = light.kind == scene::LightKind::Directional;
        const dvec3 toward = directional ? -dvec3(light.direction) : dvec3(light.position) - at->p;
        if (!(dot3(toward, seen_side) > 0) ||
            world.occluded({at->p, toward},
                           directional ? std::numeric_limits<double>::infinity() : 1, at->triangle))
            shadows |= std::uint64_t{1} << (i % 64);
    }
    return shadows;
}

std::vector<std::uint64_t> shadows_of(const scene::Scene& scene, const raytrace::World& world,
                                      const scene::View& view, int threads) {
    const scene::PixelRays rays(view);
    std::vector<std::uint64_t> shadows(std::size_t(view.width) * std::size_t(view.height));
    raytrace::for_pixels(view, threads, [&](int x, int y, raytrace::RayCounts&) {
        shadows[view.index(x, y)] = shadows_at(scene, world, rays.through(x + 0.5, y + 0.5));
    });
    return shadows;
}

/// Whether a pixel and its neighbours inside the picture have the same value.
template <class Value>
bool is_even(const std::vector<Value>& values, const scene::View& view, std::size_t i,
             bool corners) {
    const int x = int(i % std::size_t(view.width)), y = int(i / std::size_t(view.width));
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            if (!corners && dx != 0 && dy != 0) continue;
            const int a = std::clamp(x + dx, 0, view.width - 1),
                      b = std::clamp(y + dy, 0, view.height - 1);
            if (values[view.index(a, b)] != values[i]) return false;
        }
    return true;
}

}  // namespace

scene::Scene compared_scene(scene::Scene scene) {
    if (scene.camera) scene.camera->aperture = 0;
    for (scene::Light& light : scene.lights) light.area = {};
    for (scene::Object& object : scene.objects) {
        object.move = dvec3(0);
        object.glare.reset();
    }
    return scene;
}

std::string_view name_of(Reason reason) {
    switch (reason) {
        case Reason::Same: return "the same";
        case Reason::Polygon: return "another polygon";
        case Reason::Shadow: return "shadow border";
        case Reason::Rounding: return "rounding of passes";
        case Reason::Fog: return "fog at vertices";
        case Reason::Lighting: return "light at vertices";
    }
    return "";
}

Differences differences(Machine& machine, const scene::Scene& moving, const scene::View& view,
                        const Options& options) {
    const scene::Scene scene = compared_scene(moving);
    const raytrace::World world(scene, options.threads);
    Pair pair = draw_both(machine, scene, view, options, world);
    Differences d{.units = units_of(pair), .passes = adding_passes(scene)};
    const auto ids = scene::draw_item_buffer(machine, raytrace::drawn_scene(scene), view, {});
    const auto shadows = shadows_of(scene, world, view, options.threads);
    std::vector<int> without_fog;
    if (scene.fog) {
        scene::Scene clear = scene;
        clear.fog.reset();
        without_fog = units_of(draw_both(machine, clear, view, options, world));
    }
    const auto reason_of = [&](std::size_t i) {
        if (d.units[i] == 0) return Reason::Same;
        if (ids[i] != pair.by_rays.ids[i]) return Reason::Polygon;
        if (!is_even(shadows, view, i, true)) return Reason::Shadow;
        if (d.units[i] <= d.passes) return Reason::Rounding;
        return !without_fog.empty() && without_fog[i] <= d.passes ? Reason::Fog : Reason::Lighting;
    };
    for (std::size_t i = 0; i < ids.size(); ++i) {
        d.reason.push_back(reason_of(i));
        if (!is_even(ids, view, i, false)) continue;
        ++d.away_from_edges;
        d.another_polygon_there += ids[i] != pair.by_rays.ids[i];
    }
    d.by_passes = std::move(pair.by_passes);
    d.by_rays = std::move(pair.by_rays.color);
    return d;
}

ReasonCount count_of(const Differences& d, Reason reason) {
    ReasonCount count;
    double sum = 0;
    for (std::size_t i = 0; i < d.reason.size(); ++i) {
        if (d.reason[i] != reason) continue;
        ++count.pixels;
        count.largest = std::max(count.largest, d.units[i]);
        sum += d.units[i];
    }
    if (count.pixels > 0) count.mean = sum / double(count.pixels);
    return count;
}

}  // namespace gw::itembuffer
