// Wavefront MTL, read strictly. docs/scenes.md says what is understood. Does not read textures.
#pragma once

#include "scene/scene.h"
#include "scene/text/warnings.h"

#include <filesystem>
#include <vector>

namespace gw::scene {

/// The materials of a file in order. A name that comes twice counts the first time (warned about).
/// Throws Error "file:line: what; expected what".
std::vector<Material> read_mtl(const std::filesystem::path& path, Warnings& warnings);

}  // namespace gw::scene
