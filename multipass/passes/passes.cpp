#include "multipass/passes/passes.h"

#include "gw/base/arithmetic.h"
#include "gw/error.h"
#include "multipass/passes/catalogue.h"
#include "scene/draw/draw_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gw::multipass {
namespace {

/// Draws light of its own kind: Fig. 4 shows it as an image.
bool is_component(const Pass& pass) {
    return pass.blend.enable && pass.blend.src != BlendFactor::Zero;
}

/// The reflection map outside the shadow of the first light that casts one [K3.2].
void keep_reflection_out_of_shadow(PassList& list) {
    const auto reflection = std::find_if(
        list.begin(), list.end(), [](const Pass& p) { return p.name == reflection_pass.name; });
    reflection->stencil = outside_shadow;
    reflection->lights = PassLights::First;
    Pass shadow = shadow_pass;
    shadow.lights = PassLights::First;
    list.insert(reflection, shadow);
}

/// The passes of opaque objects.
PassList opaque_passes(const scene::Scene& scene) {
    PassList list{depth_pass,    shadow_pass,     ambient_pass,    diffuse_pass,
                  specular_pass, reflection_pass, refraction_pass, emission_pass};
    if (!scene.reflection_in_shadow) keep_reflection_out_of_shadow(list);
    list[0].color = scene.background != vec3(0);
    for (Pass& pass : list) {
        const bool draws_all = pass.action == PassAction::Draw && pass.objects == PassObjects::All;
        if (has_translucent(scene) && draws_all) pass.objects = PassObjects::Opaque;
        if (scene.fog && is_component(pass)) pass.fog = PassFog::Black;
    }
    return list;
}

Pass fog_pass_for(const scene::Scene& scene) {
    Pass pass = fog_pass;
    if (has_translucent(scene)) pass.objects = PassObjects::Opaque;
    return pass;
}

/// The same over each layer of the picture instead of over all of them at once.
Pass as_layer_pass(Pass pass) {
    pass.depth = seen;
    pass.stencil = in_layer;
    if (pass.blend == over) pass.blend.dst = BlendFactor::One;
    return pass;
}

/// The components of translucent objects, without their fog.
PassList translucent_components(const scene::Scene& scene) {
    PassList list{translucent_ambient_pass,    translucent_diffuse_pass,
                  translucent_specular_pass,   translucent_reflection_pass,
                  translucent_refraction_pass, translucent_emission_pass};
    for (Pass& pass : list)
        if (scene.fog) pass.fog = PassFog::Black;
    return list;
}

/// Each component an image of its own, added in the accumulation buffer.
void add_images(PassList& list, const scene::Scene& scene) {
    list.push_back(veil_pass);
    list.push_back(add_pass);
    for (const Pass& pass : translucent_components(scene)) {
        list.push_back(pass);
        list.push_back(add_pass);
        list.back().lights = pass.lights;
    }
    if (!scene.fog) return;
    list.push_back(fog_pass_for(scene));
    list.push_back(translucent_fog_pass);
    list.push_back(add_pass);
}

/// Layer after layer in the frame buffer: dim the picture behind, add the layer's components.
void add_layers(PassList& list, const scene::Scene& scene) {
    if (scene.fog) list.push_back(fog_pass_for(scene));
    list.push_back(as_layer_pass(veil_pass));
    for (const Pass& pass : translucent_components(scene)) list.push_back(as_layer_pass(pass));
    if (scene.fog) list.push_back(as_layer_pass(translucent_fog_pass));
}

/// Light around emitters, each time an image of its own: only the sum is more than white.
void add_glare(PassList& list, const scene::Scene& scene) {
    const int images = glare_images(scene);
    if (images == 0) return;
    Pass glare = glare_pass;
    if (scene.fog) glare.fog = PassFog::Black;
    if (list.back() != add_pass) list.push_back(add_pass);
    for (int i = 0; i < images; ++i) {
        list.push_back(glare);
        if (has_translucent(scene)) list.push_back(veil_pass);
        list.push_back(add_pass);
    }
}

PassList multipass_list(const scene::Scene& scene, Translucency translucency) {
    PassList list = opaque_passes(scene);
    if (!has_translucent(scene)) {
        if (scene.fog) list.push_back(fog_pass);
    } else if (translucency == Translucency::Layers) {
        add_layers(list, scene);
    } else {
        add_images(list, scene);
    }
    add_glare(list, scene);
    return list;
}

PassList hardware_list(const scene::Scene& scene) {
    PassList list{hardware_pass};
    if (has_translucent(scene)) {
        list[0].objects = PassObjects::Opaque;
        list.push_back(translucent_hardware_pass);
    }
    for (Pass& pass : list)
        if (scene.fog) pass.fog = PassFog::Scene;
    return list;
}

/// The passes that are no components, and the components that are wanted. Others still dim the
/// picture behind their objects, so a further component only adds.
template <class Wanted>
PassList without_components(const PassList& passes, const Wanted& wanted) {
    PassList list;
    for (const Pass& pass : passes) {
        const bool draws = !is_component(pass) || wanted(pass);
        if (!draws && pass.blend.dst == BlendFactor::One) continue;
        list.push_back(pass);
        if (!draws) list.back().blend.src = BlendFactor::Zero;
    }
    return list;
}

/// Whether two passes are one component: glare is repeated, its strength divided among all.
bool same_component(const Pass& a, const Pass& b) {
    return &a == &b || (a.objects == PassObjects::Glaring && a == b);
}

/// Without images in the accumulation buffer: a single component needs none, unless it is repeated.
PassList alone(const PassList& passes, const Pass* component) {
    PassList list = without_components(
        passes, [&](const Pass& p) { return component && same_component(p, *component); });
    if (!component || component->objects != PassObjects::Glaring)
        std::erase_if(list, [](const Pass& pass) { return pass.action == PassAction::Add; });
    return list;
}

/// Draws more than black by itself, and is no component: eq. 1.
const Pass* base_pass(const PassList& passes) {
    const auto base = std::find_if(passes.begin(), passes.end(), [](const Pass& pass) {
        return pass.action == PassAction::Draw && pass.color && !is_component(pass) &&
               pass.material != PassMaterial{.Map = pass.material.Map};
    });
    return base == passes.end() ? nullptr : &*base;
}

bool only_adds(const PassList& passes) {
    return std::all_of(passes.begin(), passes.end(), [](const Pass& pass) {
        return !pass.blend.enable ||
               (pass.blend.src == BlendFactor::One && pass.blend.dst == BlendFactor::One);
    });
}

/// Of colours: each image stays as opaque as it is drawn.
void subtract(std::vector<Rgba>& image, const std::vector<Rgba>& before) {
    for (std::size_t i = 0; i < image.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            image[i][c] = static_cast<std::uint16_t>(image[i][c] - before[i][c]);
}

std::size_t lights_on(const scene::Scene& scene, const scene::Object& object) {
    return std::size_t(std::count_if(
        scene.lights.begin(), scene.lights.end(),
        [&](const scene::Light& light) { return scene::lights_object(light, object); }));
}

}  // namespace

bool has_translucent(const scene::Scene& scene) {
    return std::any_of(scene.objects.begin(), scene.objects.end(), [&](const scene::Object& item) {
        return scene.materials[item.material].d < 1;
    });
}

int glare_images(const scene::Scene& scene) {
    int images = 0;
    for (const scene::Object& item : scene.objects) {
        if (!item.glare) continue;
        const vec3 light = scene.materials[item.material].Ke * item.glare->strength;
        const double most = std::max(std::max(light.x, light.y), light.z);
        images = std::max(images, static_cast<int>(std::ceil(std::clamp(most - 1e-6, 1.0, 1e6))));
    }
    return images;
}

PassList passes_for(const scene::Scene& scene, Renderer renderer, Translucency translucency) {
    return renderer == Renderer::Hardware ? hardware_list(scene)
                                          : multipass_list(scene, translucency);
}

std::vector<ComponentList> component_lists(const scene::Scene& scene, const PassList& passes) {
    std::vector<ComponentList> lists;
    const bool on_black = scene.background == vec3(0), adds = only_adds(passes);
    const Pass* base = base_pass(passes);
    if (!on_black || base)
        lists.push_back({on_black ? base->name.str() : "background",
                         adds ? alone(passes, nullptr)
                              : without_components(passes, [](const Pass&) { return false; }),
                         true});
    for (auto at = passes.begin(); at != passes.end(); ++at) {
        const Pass& pass = *at;
        const auto same = [&](const Pass& p) { return same_component(p, pass); };
        if (!is_component(pass) || std::any_of(at + 1, passes.end(), same)) continue;
        if (adds)
            lists.push_back({pass.name.str(), alone(passes, &pass), false});
        else
            lists.push_back({pass.name.str(),
                             without_components(passes, [&](const Pass& p) { return &p <= &pass; }),
                             true, true});
    }
    return lists;
}

std::vector<ComponentImage> component_images(
    const std::vector<ComponentList>& lists,
    const std::function<std::vector<Rgba>(const ComponentList&)>& draw) {
    std::vector<ComponentImage> images;
    std::vector<Rgba> before;
    for (const ComponentList& list : lists) {
        std::vector<Rgba> drawn = draw(list);
        images.push_back({list.name, drawn});
        if (list.difference && !before.empty()) subtract(images.back().color, before);
        before = std::move(drawn);
    }
    return images;
}

std::vector<Rgba> sum_of(const std::vector<ComponentImage>& images, const Profile& profile) {
    std::vector<Rgba> sum(images.empty() ? 0 : images.front().color.size());
    const std::uint32_t most = max_of_bits(profile.color_bits);
    for (const ComponentImage& image : images)
        for (std::size_t i = 0; i < sum.size(); ++i)
            for (std::size_t c = 0; c < 4; ++c)
                sum[i][c] = static_cast<std::uint16_t>(
                    std::min(most, std::uint32_t(sum[i][c]) + image.color[i][c]));
    return sum;
}

void check_glare(const scene::Scene& scene, const PassList& passes, int most) {
    const auto images = std::count_if(passes.begin(), passes.end(), [](const Pass& pass) {
        return pass.objects == PassObjects::Glaring;
    });
    if (images < most) return;
    for (const scene::Object& item : scene.objects)
        if (item.glare)
            throw Error(
                fmt::format("glare of object '{}': its strength times Ke takes {} images; "
                            "expected at most {}, which fit in the accumulation buffer",
                            item.name, images, most - 1));
}

void check_lights(const scene::Scene& scene, const PassList& passes, const Profile& profile) {
    const bool all = std::any_of(passes.begin(), passes.end(),
                                 [](const Pass& p) { return p.lights == PassLights::All; });
    if (!all) return;
    for (const scene::Object& item : scene.objects)
        if (lights_on(scene, item) > std::size_t(profile.max_lights))
            throw Error(
                fmt::format("{} lights on object '{}'; profile {} knows {} in one pass. "
                            "--renderer multipass has no limit",
                            lights_on(scene, item), item.name, profile.name, profile.max_lights));
}

}  // namespace gw::multipass
