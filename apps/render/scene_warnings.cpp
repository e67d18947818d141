#include "apps/render/scene_warnings.h"

#include "apps/command/terminal.h"

namespace gw::apps {

void print_warnings_of(const scene::Scene& scene, const Size& size, scene::DrawnBy by) {
    const scene::View view = scene::make_view(scene, size.width, size.height);
    for (const std::string& line : scene::warnings_of(scene, view, by)) print_warning(line);
}

void print_if_empty(const scene::Scene& scene, const std::vector<Rgba>& color, int color_bits) {
    const std::string line = scene::empty_picture(scene, color, color_bits);
    if (!line.empty()) print_warning(line);
}

}  // namespace gw::apps
