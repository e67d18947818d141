// Wavefront MTL, read strictly. docs/scenes.md lists the statements. Does not read textures.
#pragma once

#include "scene/scene_builder.h"
#include "scene/text/warnings.h"

#include <filesystem>

namespace gw::scene {

/// The materials of a file in order. If a name comes twice, the first counts, with a warning. A
/// fault in a statement of a material, "file:line: what; expected what", is the material's, with a
/// warning for the case that nothing uses it. Throws Error for others.
MaterialLibrary read_mtl(const std::filesystem::path& path, Warnings& warnings);

}  // namespace gw::scene
