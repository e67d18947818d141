// Numbers and scenes from Python, checked before work begins (scene/validate/check.h).
#pragma once

#include "gw/machine.h"
#include "scene/draw/fit.h"
#include "scene/draw/view.h"
#include "scene/scene.h"

#include <optional>
#include <string>

namespace gw::python {

/// Throws Error "patch: 0; expected a whole number from 1 to 4096", in the words of scene files. Not
/// a number is outside every range.
void check_range(const std::string& name, double value, double low, double high);
void check_whole(const std::string& name, double value, double low, double high);
/// 0: all.
inline void check_threads(int threads) { check_whole("threads", threads, 0, 1024); }

/// A scene in view, as every renderer needs it: defaults added, the camera chosen.
struct SceneInView {
    /// Throws Error for a window outside 1 .. max_window_size, for values that no file can have,
    /// and if the camera sees nothing.
    SceneInView(const scene::Scene& given, const std::optional<scene::Camera>& camera, int width,
                int height);
    scene::Scene scene;
    scene::View view;
};

}  // namespace gw::python
