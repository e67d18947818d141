// Reads a scene file of any kind. docs/scenes.md has the formats. Does not read texture files
// (image::load_textures does) and does not fit a camera.
#pragma once

#include "scene/film.h"
#include "scene/scene.h"
#include "scene/toml/toml_value.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gw::scene {

struct SceneFile {
    Scene scene;
    /// Statements that are not honoured: "file:line: text", one line per kind of statement and
    /// file.
    std::vector<std::string> warnings;
    /// The tables of [[pass]], unread; multipass/passes/pass_toml.h reads them. The objects that
    /// they name exist.
    std::vector<TomlValue> passes;
    /// Every file that was read: the scene, its OBJ and MTL files, its buffers. Textures are read later.
    std::vector<std::filesystem::path> files;
    /// The scene's coordinates are the files' minus this: 0 unless these lie far from 0, as map
    /// coordinates do (scene/geometry/far.h).
    dvec3 origin{0};
    /// How the scene changes with time: one of TOML, one for each animation of glTF.
    std::vector<Film> films{};
};

/// Reads a TOML scene (.toml), a bare Wavefront OBJ (.obj; no lights, no camera) or glTF 2.0 (.gltf,
/// .glb), by the file's extension. Throws Error "file:line: what; expected what".
SceneFile read_scene(const std::filesystem::path& path);

}  // namespace gw::scene
