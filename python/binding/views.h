// A scene in view, as every renderer needs it: defaults added, the camera chosen.
#pragma once

#include "gw/machine.h"
#include "scene/draw/fit.h"
#include "scene/draw/view.h"
#include "scene/scene.h"

#include <optional>

namespace gw::python {

struct SceneInView {
    /// Throws Error if the window is outside 1 .. max_window_size, or the camera sees nothing.
    SceneInView(const scene::Scene& given, const std::optional<scene::Camera>& camera, int width,
                int height)
        : scene(given) {
        check_window(width, height);
        if (camera) scene.camera = camera;
        scene::add_defaults(scene, width, height);
        view = scene::make_view(scene, width, height);
    }
    scene::Scene scene;
    scene::View view;
};

}  // namespace gw::python
