// A TOML scene. docs/scenes.md has every section and key.
#pragma once

#include "scene/read_scene.h"

namespace gw::scene {

/// Throws Error "file:line: what; expected what"; an unknown key names the nearest known one.
SceneFile read_toml(const std::filesystem::path& path);

}  // namespace gw::scene
