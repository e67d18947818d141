// glTF 2.0 (.gltf, .glb) as a scene. docs/scenes.md, "glTF", says what becomes of its parts. Does not
// read textures.
#pragma once

#include "scene/film.h"
#include "scene/scene.h"
#include "scene/text/warnings.h"

#include <filesystem>
#include <vector>

namespace gw::scene {

struct GltfFile {
    Scene scene;
    dvec3 origin{0};  ///< the scene's coordinates are the file's minus this (geometry/far.h)
    std::vector<Film> films;
};

/// Throws Error "FILE: PLACE is WHAT; expected WHAT", where PLACE is a path in its JSON.
GltfFile read_gltf(const std::filesystem::path& path, Warnings& warnings);

/// Objects that one file may place: instances take few bytes each.
inline constexpr std::size_t most_gltf_objects = 1'000'000;
/// Vertices and corners that one file may have: its accessors may overlap.
inline constexpr std::size_t most_gltf_numbers = std::size_t{1} << 27;

}  // namespace gw::scene
