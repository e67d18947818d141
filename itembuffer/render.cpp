#include "itembuffer/render.h"

#include "itembuffer/hit_shadows.h"
#include "itembuffer/traced_component.h"
#include "multipass/passes/catalogue.h"
#include "scene/draw/item_buffer.h"

#include <algorithm>
#include <memory>

namespace gw::itembuffer {
namespace {

using multipass::Pass;

/// Whether what the traced component is added to must have been drawn before this pass.
bool comes_after(const Pass& pass) {
    return pass.objects == multipass::PassObjects::Translucent ||
           pass.fog == multipass::PassFog::Scene || pass.action == multipass::PassAction::Add;
}

bool same_places(const scene::Scene& a, const scene::Scene& b) {
    return std::equal(a.objects.begin(), a.objects.end(), b.objects.begin(), b.objects.end(),
                      [](const scene::Object& x, const scene::Object& y) {
                          return x.mesh == y.mesh && x.world_from_object == y.world_from_object;
                      });
}

/// As shadow maps see them.
bool same_lights(const scene::Scene& a, const scene::Scene& b) {
    return std::equal(a.lights.begin(), a.lights.end(), b.lights.begin(), b.lights.end(),
                      [](const scene::Light& x, const scene::Light& y) {
                          return x.kind == y.kind && x.position == y.position &&
                                 x.direction == y.direction && x.cone_angle == y.cone_angle &&
                                 x.shadow == y.shadow;
                      });
}

/// What one sample leaves for the next.
struct Kept {
    scene::Scene scene;  ///< with the materials as the file has them
    Options options;
    std::optional<raytrace::World> world;
    std::optional<HitShadows> shadows;  ///< where hits read shadow maps

    /// Makes both as of a sample's moment, where objects, or lights, are not where they were.
    void move_to(Machine& machine, const scene::Scene& now, const scene::View& view) {
        const bool same = world && same_places(scene, now), lit_the_same = same_lights(scene, now);
        scene.objects = now.objects;
        scene.lights = now.lights;
        if (!same) world.emplace(scene, options.threads);
        if (options.shadow_maps && !(shadows && same && lit_the_same))
            shadows.emplace(machine, now, view.width, view.height);
    }
};

}  // namespace

multipass::PassList passes_with_tracing(const scene::Scene& scene,
                                        multipass::Translucency translucency) {
    if (!raytrace::any_traced(scene))
        return multipass::passes_for(scene, multipass::Renderer::Multipass, translucency);
    const scene::Scene drawn = raytrace::drawn_scene(scene);
    multipass::PassList list =
        multipass::passes_for(drawn, multipass::Renderer::Multipass, translucency);
    Pass pass = multipass::trace_pass;
    if (scene.fog) pass.fog = multipass::PassFog::Black;
    list.insert(std::find_if(list.begin(), list.end(), comes_after), pass);
    return list;
}

multipass::Trace tracing(const scene::Scene& scene, const Options& options) {
    const auto kept = std::make_shared<Kept>();
    kept->scene = scene;
    kept->options = options;
    kept->scene.background = options.background.value_or(scene.background);
    return [kept](Machine& machine, const scene::Scene& now, const scene::View& view,
                  const JitterState& jitter) {
        kept->move_to(machine, now, view);
        const auto ids = scene::draw_item_buffer(machine, now, view, jitter);
        raytrace::TraceOptions rays{.depth = kept->options.depth, .threads = kept->options.threads};
        if (kept->shadows)
            rays.in_shadow = [&](std::size_t light, const scene::TrianglePoint& at) {
                return kept->shadows->in_shadow(light, at);
            };
        const raytrace::Tracer tracer(kept->scene, *kept->world, view, rays);
        TracedComponent traced =
            traced_component(tracer, now, view, ids, jitter, machine.profile());
        if (kept->options.counts) kept->options.counts->add(traced.counts);
        return std::move(traced.color);
    };
}

std::unique_ptr<multipass::Driver> make_driver(Machine& machine, const scene::Scene& scene,
                                               const multipass::Options& passes,
                                               const Options& options) {
    if (!raytrace::any_traced(scene))
        return std::make_unique<multipass::Driver>(machine, scene, passes);
    multipass::Options all = passes;
    if (!all.passes) all.passes = passes_with_tracing(scene, passes.translucency);
    all.trace = tracing(scene, options);
    return std::make_unique<multipass::Driver>(machine, raytrace::drawn_scene(scene), all);
}

multipass::Superposition render(Machine& machine, const scene::Scene& scene,
                                const scene::View& view, const multipass::Options& passes,
                                const Options& options) {
    return make_driver(machine, scene, passes, options)->draw(view);
}

}  // namespace gw::itembuffer
