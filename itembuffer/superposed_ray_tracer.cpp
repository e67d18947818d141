#include "itembuffer/superposed_ray_tracer.h"

#include "multipass/frame/samples.h"
#include "multipass/frame/superpose.h"
#include "raytrace/tracer/render.h"
#include "scene/draw/nearest.h"

#include <algorithm>
#include <memory>

namespace gw::itembuffer {

multipass::Superposition superpose_ray_traced(Machine& machine, const scene::Scene& scene,
                                              const scene::View& view, int samples,
                                              const Options& options, bool weighted) {
    const scene::View seen = scene::view_for_rays(scene, view);
    scene::Scene now = scene;
    std::shared_ptr<const raytrace::World> world = options.world;
    const auto draw = [&](const multipass::Sample& sample) {
        multipass::move_to(now, scene, sample);
        if (!world || multipass::moves(scene))
            world = std::make_shared<raytrace::World>(now, options.threads);
        const scene::View through = multipass::view_at(seen, sample);
        const raytrace::Tracer tracer(now, *world, through,
                                      {.depth = options.depth, .threads = options.threads});
        const JitterState jitter = multipass::jitter_of(sample, machine.profile().subpixel_bits);
        const auto picture =
            raytrace::raytraced_picture(tracer, now, through, jitter, machine.profile());
        if (options.counts) options.counts->add(picture.counts);
        machine.execute(raytrace::commands(picture, through));
    };
    const int count = std::max(samples, multipass::samples_of(scene));
    return multipass::superpose(machine, count, 0, draw,
                                multipass::weights_of(count, weighted, machine.profile()));
}

}  // namespace gw::itembuffer
