#include "python/binding/checked.h"

#include "gw/error.h"
#include "scene/validate/check.h"

#include <fmt/format.h>

namespace gw::python {

void check_range(const std::string& name, double value, double low, double high) {
    if (!(value >= low && value <= high))
        throw Error(fmt::format("{}: {:.9g}; expected {:.9g} .. {:.9g}", name, value, low, high));
}

SceneInView::SceneInView(const scene::Scene& given, const std::optional<scene::Camera>& camera,
                         int width, int height)
    : scene(given) {
    check_window(width, height);
    if (camera) scene.camera = camera;
    scene::check_scene(scene);
    scene::add_defaults(scene, width, height);
    view = scene::make_view(scene, width, height);
}

}  // namespace gw::python
