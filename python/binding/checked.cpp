#include "python/binding/checked.h"

#include "gw/error.h"
#include "scene/text/number.h"
#include "scene/validate/check.h"
#include "scene/validate/limits.h"

#include <cmath>
#include <cstdint>

namespace gw::python {
namespace {

/// 1000000, not 1e+06.
std::string text_of(double value) {
    const bool is_whole = std::abs(value) < 1e15 && value == std::floor(value);
    return is_whole ? std::to_string(std::int64_t(value)) : scene::number_text(value);
}

[[noreturn]] void refuse(const std::string& name, double value, const char* what,
                         scene::Range range) {
    throw Error(name + ": " + text_of(value) + "; expected " + scene::range_text(what, range));
}

}  // namespace

void check_range(const std::string& name, double value, double low, double high) {
    const scene::Range range{low, high};
    if (!range.contains(value)) refuse(name, value, "a number", range);
}

void check_whole(const std::string& name, double value, double low, double high) {
    const scene::Range range{low, high};
    if (!range.contains(value) || value != std::floor(value))
        refuse(name, value, "a whole number", range);
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
