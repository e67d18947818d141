#include "apps/render/view_drawer.h"

#include "itembuffer/render.h"
#include "multipass/frame/driver.h"
#include "multipass/frame/scene_maps.h"

namespace gw::apps {

std::function<void(const scene::View&)> view_drawer(const Drawing& drawing, Machine& machine) {
    const auto alone = [&](const scene::View& view) { draw(drawing, view, machine); };
    if (!drawing.renderer.passes) return alone;
    DrawOptions options = draw_options(drawing.options);
    options.passes.renderer = *drawing.renderer.passes;
    options.passes.passes = passes_of(drawing);
    if (multipass::has_scene_maps(drawing.scene, options.passes)) return alone;
    const bool traced = options.traced && options.passes.renderer == multipass::Renderer::Multipass;
    const std::shared_ptr<multipass::Driver> driver =
        traced ? itembuffer::make_driver(machine, drawing.scene, options.passes, options.rays)
               : std::make_unique<multipass::Driver>(machine, drawing.scene, options.passes);
    return [driver](const scene::View& view) { driver->draw(view); };
}

}  // namespace gw::apps
