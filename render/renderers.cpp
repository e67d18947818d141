#include "render/renderers.h"

#include "hiddensurface/run/scan_line_renderer.h"
#include "itembuffer/adaptive.h"
#include "itembuffer/superposed_ray_tracer.h"
#include "multipass/frame/driver.h"
#include "multipass/frame/superpose.h"
#include "raytrace/tracer/traced_material.h"
#include "render/words/option_values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace gw::render {
namespace {

void draw_hardware(Machine& machine, const scene::Scene& scene, const scene::View& view,
                   const DrawOptions& options) {
    multipass::Options hardware = options.multipass;
    hardware.renderer = multipass::Renderer::Hardware;
    multipass::render(machine, scene, view, hardware);
}

void draw_multipass(Machine& machine, const scene::Scene& scene, const scene::View& view,
                    const DrawOptions& options) {
    if (options.traced)
        itembuffer::render(machine, scene, view, options.multipass, options.rays);
    else
        multipass::render(machine, scene, view, options.multipass);
}

void draw_scan_lines(Machine& machine, const scene::Scene& scene, const scene::View& view,
                     const DrawOptions& options) {
    scene::Scene drawn = scene;
    for (scene::Object& object : drawn.objects) object.glare.reset();
    scene::Scene now = drawn;
    const auto draw = [&](const multipass::Sample& sample) {
        multipass::move_to(now, drawn, sample);
        machine.execute(hiddensurface::scan_line_picture(
            now, multipass::view_at(view, sample), machine.profile(),
            multipass::jitter_of(sample, machine.profile().subpixel_bits)));
    };
    const int samples = std::max(options.multipass.samples, multipass::samples_of(drawn));
    multipass::superpose(
        machine, samples, 0, draw,
        multipass::weights_of(samples, options.multipass.weighted, machine.profile()));
}

void draw_rays(Machine& machine, const scene::Scene& scene, const scene::View& view,
               const DrawOptions& options) {
    itembuffer::superpose_ray_traced(machine, scene, view, options.multipass.samples, options.rays,
                                     options.multipass.weighted);
}

void draw_adaptive(Machine& machine, const scene::Scene& scene, const scene::View& view,
                   const DrawOptions& options) {
    itembuffer::render_adaptive(machine, scene, view, options.multipass.samples, options.rays);
}

bool has_map(const scene::Material& m) {
    const auto maps = {&m.map_Ka, &m.map_Kd, &m.map_Ks, &m.map_Ke, &m.refl, &m.refraction};
    return std::ranges::any_of(maps, [](const auto* list) { return !list->empty(); });
}

bool has_effect(const std::string& name, const scene::Scene& scene) {
    if (name == "translucency") return multipass::has_translucent(scene);
    if (name == "fog") return scene.fog.has_value();
    if (name == "reflections") return raytrace::any_traced(scene);
    if (name == "maps") return std::ranges::any_of(scene.materials, has_map);
    if (name == "glare")
        return std::ranges::any_of(scene.objects,
                                   [](const scene::Object& o) { return o.glare.has_value(); });
    if (name == "motion")
        return std::ranges::any_of(scene.objects,
                                   [](const scene::Object& o) { return o.move != dvec3(0); });
    if (name == "aperture") return scene.camera && scene.camera->aperture > 0;
    if (name == "soft lights")
        return std::ranges::any_of(scene.lights, [](const scene::Light& light) {
            return light.area.shape != scene::AreaLight::Shape::None;
        });
    if (name == "shadows")
        return std::ranges::any_of(scene.lights, [](const scene::Light& light) {
            return light.shadow != scene::Shadow::None;
        });
    return !scene.reflection_in_shadow;
}

}  // namespace

const std::vector<Renderer>& renderers() {
    static const std::vector<Renderer> all{
        {"hardware",
         "equation 1, everything in one pass; no shadows",
         draw_hardware,
         multipass::Renderer::Hardware,
         {"shadows", "reflections", "glare", "reflection_in_shadow = false"}},
        {"multipass",
         "equations 2, 4 and 5, a pass for each component, reflections by rays (default)",
         draw_multipass, multipass::Renderer::Multipass},
        {"scanline",
         "equation 3 at every pixel of a scan line's spans; no shadows",
         draw_scan_lines,
         {},
         {"shadows", "reflections", "translucency", "fog", "glare", "reflection_in_shadow = false"},
         scene::DrawnBy::Depth},
        {"raytrace", "the ordinary ray tracer", draw_rays, {}, {"glare"}, scene::DrawnBy::Rays},
        {"adaptive",
         "one item buffer, and more rays only at pixels that differ from their neighbours",
         draw_adaptive,
         {},
         {"translucency", "motion", "aperture", "soft lights", "glare"},
         scene::DrawnBy::Depth},
    };
    return all;
}

const Renderer& renderer_named(const std::string& name) {
    one_of("renderer", name, renderer_names());
    return *std::ranges::find(renderers(), name, &Renderer::name);
}

std::vector<std::string> renderer_names() {
    std::vector<std::string> names;
    for (const Renderer& renderer : renderers()) names.push_back(renderer.name);
    return names;
}

std::string left_out(const std::string& who, const std::vector<std::string>& effects,
                     const scene::Scene& scene) {
    std::vector<std::string> names;
    for (const std::string& name : effects)
        if (has_effect(name, scene)) names.push_back(name);
    if (names.empty()) return "";
    return fmt::format("{} leaves out of this scene: {}", who, fmt::join(names, ", "));
}

std::string left_out(const Renderer& renderer, const scene::Scene& scene) {
    return left_out("renderer '" + renderer.name + "'", renderer.leaves_out, scene);
}

multipass::PassList pass_list(const Renderer& renderer, const scene::Scene& scene,
                              const DrawOptions& options) {
    if (options.multipass.pass_list) return *options.multipass.pass_list;
    if (*renderer.pass_owner == multipass::Renderer::Multipass && options.traced)
        return itembuffer::passes_with_tracing(scene, options.multipass.translucency);
    return multipass::passes_for(scene, *renderer.pass_owner, options.multipass.translucency);
}

std::string renderers_help() {
    std::string help;
    for (const Renderer& r : renderers())
        help += (help.empty() ? "" : "; ") + r.name + ": " + r.about;
    return help;
}

std::vector<std::string> machines() { return {"fast", "reference"}; }

}  // namespace gw::render
