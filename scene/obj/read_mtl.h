// Wavefront MTL, read strictly. docs/scenes.md lists the statements. Does not read textures.
#pragma once

#include "scene/scene.h"
#include "scene/text/warnings.h"

#include <filesystem>
#include <vector>

namespace gw::scene {

/// The materials of a file in order. If a name comes twice, the first counts, with a warning.
/// Throws Error "file:line: what; expected what".
std::vector<Material> read_mtl(const std::filesystem::path& path, Warnings& warnings);

}  // namespace gw::scene
