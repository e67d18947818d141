// A user's choices for a viewed scene: its picture's options, camera, lights and fog. Plain values.
// Does not draw.
#pragma once

#include "apps/picture/picture_options.h"
#include "scene/scene.h"
#include "scene/toml/toml_view.h"

#include <set>
#include <string>
#include <vector>

namespace gw::apps {

struct Settings {
    PictureOptions picture;  ///< its `camera` and `up` are not used
    scene::Camera camera;
    std::set<std::size_t> lights_off{};  ///< places in the scene's lights
    bool fog = true;
};

/// The scene with the settings' camera, shadows, lights and fog.
scene::Scene scene_of(scene::Scene scene, const Settings& settings);

/// The view as a file, whose picture gw render draws with the same bits. `base` is as the file names
/// it.
scene::SavedView saved(const Settings& settings, const std::filesystem::path& base);

/// Two settings with equal keys differ at most in their cameras.
std::string key_of(const Settings& settings);

/// Settings of less work, for a scene that moves: first fewer samples, then no rays, then one pass.
/// Each step contains those before it; the first is the settings themselves.
struct LessWork {
    Settings settings;
    std::string left_out;  ///< "1 sample, no rays"; empty: nothing
};
std::vector<LessWork> less_work(const Settings& settings);

}  // namespace gw::apps
