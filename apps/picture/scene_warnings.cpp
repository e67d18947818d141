#include "apps/picture/scene_warnings.h"

#include "apps/command/terminal.h"

namespace gw::apps {

void print_warnings_of(const scene::Scene& scene, const Size& size, scene::DrawnBy by) {
    const scene::View view = scene::make_view(scene, size.width, size.height);
    print_warnings(scene::warnings_of(scene, view, by));
}

void print_warnings(const std::vector<std::string>& lines) {
    for (const std::string& line : lines)
        if (!line.empty()) print_warning(line);
}

}  // namespace gw::apps
