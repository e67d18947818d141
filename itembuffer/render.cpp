#include "itembuffer/render.h"

#include "itembuffer/traced_component.h"
#include "multipass/passes/catalogue.h"
#include "multipass/shadow/shadow_lookup.h"
#include "multipass/steps/pass_model.h"
#include "scene/draw/item_buffer.h"

#include <algorithm>
#include <memory>

namespace gw::itembuffer {
namespace {

using multipass::Pass;

/// Whether this pass must follow the traced component, which is added to the opaque picture.
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

/// Shadow maps for the hits of traced rays [K4i, K3.2 a], instead of shadow rays. The machine draws
/// the Z-buffers of all lights that cast shadows, as for the passes. They are valid for all views
/// while neither lights nor objects move. Does not shade first hits: the passes do.
class HitShadows {
public:
    /// `scene` is the drawn one. Overwrites the machine's planes.
    HitShadows(Machine& machine, const scene::Scene& scene, int width, int height);
    HitShadows(const HitShadows&) = delete;

    /// As in raytrace::TraceOptions.
    bool in_shadow(std::size_t light, const scene::TrianglePoint& at) const {
        return lookups_[light].in_shadow(at);
    }

    /// The side of a map for a picture of this size: the power of two that is at least its longer
    /// side. Half that of the passes' maps, since reflections mostly show things smaller.
    static int size(int width, int height);

private:
    std::vector<std::vector<multipass::ShadowMap>> maps_;  ///< by light; none without a shadow
    std::vector<multipass::ShadowLookup> lookups_;
};

int HitShadows::size(int width, int height) {
    return multipass::shadow_map_size(width, height) / 2;
}

HitShadows::HitShadows(Machine& machine, const scene::Scene& scene, int width, int height) {
    const multipass::PassModel model = multipass::make_pass_model(scene);
    for (const scene::Light& light : scene.lights) {
        maps_.emplace_back();
        if (light.shadow == scene::Shadow::None) continue;
        const auto views = multipass::light_views(light, scene, size(width, height));
        maps_.back() = multipass::draw_shadow_maps(machine, model, views, width, height);
    }
    for (const auto& maps : maps_) lookups_.emplace_back(maps, machine.profile());
}

/// What one sample leaves to the next.
struct TracingCache {
    scene::Scene scene;  ///< with the materials as the file has them
    Options options;
    std::shared_ptr<const raytrace::World> world;
    std::optional<HitShadows> shadows;  ///< if hits read shadow maps

    /// Makes both anew for a sample's moment if objects or lights have moved.
    void move_to(Machine& machine, const scene::Scene& now, const scene::View& view) {
        const bool same = world && same_places(scene, now), lit_the_same = same_lights(scene, now);
        scene.objects = now.objects;
        scene.lights = now.lights;
        if (!same) world = std::make_shared<raytrace::World>(scene, options.threads);
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
    const auto cache = std::make_shared<TracingCache>();
    cache->scene = scene;
    cache->options = options;
    cache->world = options.world;
    cache->scene.background = options.background.value_or(scene.background);
    return [cache](Machine& machine, const scene::Scene& now, const scene::View& view,
                   const JitterState& jitter) {
        cache->move_to(machine, now, view);
        const auto ids = scene::draw_item_buffer(machine, now, view, jitter);
        raytrace::TraceOptions rays{.depth = cache->options.depth,
                                    .threads = cache->options.threads};
        if (cache->shadows)
            rays.in_shadow = [&](std::size_t light, const scene::TrianglePoint& at) {
                return cache->shadows->in_shadow(light, at);
            };
        const raytrace::Tracer tracer(cache->scene, *cache->world, view, rays);
        TracedComponent traced =
            traced_component(tracer, now, view, ids, jitter, machine.profile());
        if (cache->options.counts) cache->options.counts->add(traced.counts);
        return std::move(traced.color);
    };
}

std::unique_ptr<multipass::Driver> make_driver(Machine& machine, const scene::Scene& scene,
                                               const multipass::Options& passes,
                                               const Options& options) {
    if (!raytrace::any_traced(scene))
        return std::make_unique<multipass::Driver>(machine, scene, passes);
    multipass::Options all = passes;
    if (!all.pass_list) all.pass_list = passes_with_tracing(scene, passes.translucency);
    all.trace = tracing(scene, options);
    return std::make_unique<multipass::Driver>(machine, raytrace::drawn_scene(scene), all);
}

multipass::Superposition render(Machine& machine, const scene::Scene& scene,
                                const scene::View& view, const multipass::Options& passes,
                                const Options& options) {
    return make_driver(machine, scene, passes, options)->draw(view);
}

}  // namespace gw::itembuffer
