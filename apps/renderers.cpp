#include "apps/renderers.h"

#include "gw/error.h"
#include "hiddensurface/scan_line_renderer.h"
#include "multipass/driver.h"

#include <algorithm>

namespace gw::apps {

namespace {

Renderer in_passes(std::string name, std::string about, multipass::Renderer which) {
    return {std::move(name), std::move(about),
            [which](Machine& machine, const scene::Scene& scene, const scene::View& view,
                    multipass::Options options) {
                options.renderer = which;
                multipass::render(machine, scene, view, options);
            },
            which};
}

void draw_scan_lines(Machine& machine, const scene::Scene& scene, const scene::View& view,
                     const multipass::Options& options) {
    if (options.samples > 1)
        throw Error("the scan-line renderer takes one sample a pixel; expected --samples 1");
    machine.execute(hiddensurface::scan_line_picture(scene, view, machine.profile()));
}

}  // namespace

const std::vector<Renderer>& renderers() {
    static const std::vector<Renderer> all{
        in_passes("hardware", "equation 1, everything in one pass", multipass::Renderer::Hardware),
        in_passes("multipass", "equations 2 and 4, a pass for each component (default)",
                  multipass::Renderer::Multipass),
        {"scanline", "equation 3 at every pixel of a scan line's spans; no shadows", draw_scan_lines, {}},
    };
    return all;
}

const Renderer& renderer_named(const std::string& name) {
    return *std::find_if(renderers().begin(), renderers().end(),
                         [&](const Renderer& r) { return r.name == name; });
}

std::vector<std::string> renderer_names() {
    std::vector<std::string> names;
    for (const Renderer& renderer : renderers()) names.push_back(renderer.name);
    return names;
}

std::string renderers_help() {
    std::string help;
    for (const Renderer& r : renderers()) help += (help.empty() ? "" : "; ") + r.name + ": " + r.about;
    return help;
}

}  // namespace gw::apps
