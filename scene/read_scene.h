// read_scene: a scene file, whatever its kind, as a Scene. docs/scenes.md has the formats.
// Does not read texture files (image::load_textures does) and does not fit a camera.
#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gw::scene {

/// A scene and what was read but is not honoured: "file:line: text", one line per kind of statement and file.
struct SceneFile {
    Scene scene;
    std::vector<std::string> warnings;
};

/// Reads a TOML scene (.toml) or a bare Wavefront OBJ (.obj; no lights, no camera), by the file's extension.
/// Throws Error "file:line: what; expected what".
SceneFile read_scene(const std::filesystem::path& path);

}  // namespace gw::scene
