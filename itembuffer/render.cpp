#include "itembuffer/render.h"

#include "itembuffer/hit_shadows.h"
#include "itembuffer/item_buffer.h"
#include "itembuffer/traced_component.h"
#include "multipass/catalogue.h"

#include <algorithm>
#include <memory>

namespace gw::itembuffer {
namespace {

using multipass::Pass;

/// Whether what the traced component is added to must have been drawn before this pass.
bool comes_after(const Pass& pass) {
    return pass.objects == multipass::PassObjects::Translucent || pass.fog == multipass::PassFog::Scene ||
           pass.action == multipass::PassAction::Add;
}

bool same_places(const scene::Scene& a, const scene::Scene& b) {
    return std::equal(a.objects.begin(), a.objects.end(), b.objects.begin(), b.objects.end(),
                      [](const scene::Object& x, const scene::Object& y) {
                          return x.mesh == y.mesh && x.world_from_object == y.world_from_object;
                      });
}

/// What one sample leaves for the next.
struct Kept {
    scene::Scene scene;  ///< with the materials as the file has them
    Options options;
    std::optional<raytrace::World> world;

    /// The world of a sample: objects and lights at its moment.
    const raytrace::World& at(const scene::Scene& now) {
        const bool same = world && same_places(scene, now);
        scene.objects = now.objects;
        scene.lights = now.lights;
        if (!same) world.emplace(scene, options.threads);
        return *world;
    }
};

}  // namespace

multipass::PassList passes_with_tracing(const scene::Scene& scene, multipass::Translucency translucency) {
    if (!raytrace::any_traced(scene))
        return multipass::passes_for(scene, multipass::Renderer::Multipass, translucency);
    const scene::Scene drawn = raytrace::drawn_scene(scene);
    multipass::PassList list = multipass::passes_for(drawn, multipass::Renderer::Multipass, translucency);
    Pass pass = multipass::trace_pass;
    if (scene.fog) pass.fog = multipass::PassFog::Black;
    list.insert(std::find_if(list.begin(), list.end(), comes_after), pass);
    return list;
}

multipass::Trace tracing(const scene::Scene& scene, const Options& options) {
    const auto kept = std::make_shared<Kept>(Kept{scene, options, std::nullopt});
    kept->scene.background = options.background.value_or(scene.background);
    return [kept](Machine& machine, const scene::Scene& now, const scene::View& view,
                  const JitterState& jitter) {
        const raytrace::World& world = kept->at(now);
        const auto ids = draw_item_buffer(machine, now, view, jitter);
        raytrace::TraceOptions rays{.depth = kept->options.depth, .threads = kept->options.threads};
        if (kept->options.shadow_maps) rays.in_shadow = hit_shadows(machine, now, view.width, view.height);
        const raytrace::Tracer tracer(kept->scene, world, view, rays);
        TracedComponent traced = traced_component(tracer, now, view, ids, jitter, machine.profile());
        if (kept->options.counts) kept->options.counts->add(traced.counts);
        return std::move(traced.color);
    };
}

multipass::Superposition render(Machine& machine, const scene::Scene& scene, const scene::View& view,
                                const multipass::Options& passes, const Options& options) {
    if (!raytrace::any_traced(scene)) return multipass::render(machine, scene, view, passes);
    multipass::Options all = passes;
    if (!all.passes) all.passes = passes_with_tracing(scene, passes.translucency);
    all.trace = tracing(scene, options);
    return multipass::render(machine, raytrace::drawn_scene(scene), view, all);
}

}  // namespace gw::itembuffer
