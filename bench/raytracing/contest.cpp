#include "bench/raytracing/contest.h"

#include "bench/raytracing/ray_set.h"
#include "gw/machine.h"
#include "itembuffer/render.h"
#include "itembuffer/superposed_ray_tracer.h"
#include "raytrace/tracer/render.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>

namespace gw::bench {
namespace {

double seconds(const std::function<void()>& work) {
    const double start = processor_seconds();
    work();
    return processor_seconds() - start;
}

/// A frame of eq. 5. Data that no view changes is made before: hierarchy, shadow maps, shadow
/// volumes.
struct Frame {
    std::unique_ptr<Machine> machine = make_fast(vgx(), width, height, {.threads = 1});
    scene::Scene drawn;
    scene::View view;
    multipass::Options options;
    raytrace::RayCounts counts;
    double traced = 0, prepared = 0;
    std::optional<multipass::Driver> driver;

    Frame(const scene::Scene& scene, int samples, bool maps)
        : drawn(raytrace::drawn_scene(scene)), view(scene::make_view(scene, width, height)) {
        options.samples = samples;
        options.pass_list = itembuffer::passes_with_tracing(scene, options.translucency);
        const auto trace =
            itembuffer::tracing(scene, {.shadow_maps = maps, .threads = 1, .counts = &counts});
        options.trace = [this, trace](Machine& m, const scene::Scene& now, const scene::View& v,
                                      const JitterState& jitter) {
            std::vector<Rgba> color;
            traced += seconds([&] { color = trace(m, now, v, jitter); });
            return color;
        };
        prepared = seconds([&] { options.trace(*machine, drawn, view, {}); }) -
                   seconds([&] { options.trace(*machine, drawn, view, {}); });
        driver.emplace(*machine, drawn, options);
        driver->draw(view);
    }

    /// From another eye than the last, but so near that no picture changes. The next frame cannot
    /// reuse kept data.
    double draw() {
        view.eye_from_world[3][0] += 1e-12;
        traced = 0;
        counts = {};
        return seconds([&] { driver->draw(view); });
    }
};

void compare(const std::vector<Rgba>& a, const std::vector<Rgba>& b, Contest& c) {
    std::size_t differ = 0;
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        int most = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const int d = std::abs(int(a[i][k]) - int(b[i][k]));
            most = std::max(most, d);
            sum += d;
        }
        differ += most > 2;
    }
    c.maps_differ = double(differ) / double(a.size());
    c.maps_error = sum / double(3 * a.size());
}

void time_ray_tracing(const scene::Scene& scene, int samples, int runs, Contest& c) {
    const scene::View view = scene::make_view(scene, width, height);
    std::optional<raytrace::World> world;
    c.hierarchy = seconds([&] { world.emplace(scene, 1); });
    c.triangles = world->triangles().size();
    const raytrace::Tracer tracer(scene, *world, view, {.threads = 1});
    const auto machine = make_fast(vgx(), width, height, {.threads = 1});
    const auto frame = [&](const multipass::Sample& sample) {
        const auto jitter = multipass::jitter_of(sample, vgx().subpixel_bits);
        const auto picture = raytrace::raytraced_picture(tracer, scene, view, jitter, vgx());
        c.ray_tracing_rays.add(picture.counts);
        machine->execute(raytrace::commands(picture, view));
    };
    c.ray_tracing = 1e30;
    for (int run = 0; run < runs; ++run) {
        c.ray_tracing_rays = {};
        c.ray_tracing = std::min(
            c.ray_tracing, seconds([&] { multipass::superpose(*machine, samples, 0, frame); }));
    }
}

}  // namespace

Contest contest(const scene::Scene& scene, int samples, int runs) {
    Contest c{.item_buffer = 1e30, .item_buffer_maps = 1e30};
    Frame by_rays(scene, samples, false), by_maps(scene, samples, true);
    for (int run = 0; run < runs; ++run) {
        if (const double t = by_rays.draw(); t < c.item_buffer) {
            c.item_buffer = t;
            c.traced = by_rays.traced;
        }
        c.item_buffer_maps = std::min(c.item_buffer_maps, by_maps.draw());
    }
    c.maps_drawn = by_maps.prepared - by_rays.prepared;
    c.item_buffer_rays = by_rays.counts;
    c.share = double(by_rays.counts.primary) / (double(width) * height * samples);
    compare(by_rays.machine->planes().color, by_maps.machine->planes().color, c);
    time_ray_tracing(scene, samples, runs, c);
    return c;
}

}  // namespace gw::bench
