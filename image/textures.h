// Reads the texture files of a scene. Texels are those of the files: no colour management, no
// orientation tags, alpha not multiplied in. Does not depend on a map's use.
#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gw::image {

/// Fills in every map's `texture` that is null, reading each file once. It stays null if Map::may_lack
/// and the file is missing. Throws Error naming the file and line of a map whose file is missing, no
/// regular file, unreadable, cut short or has a side outside 1 .. max_texture_size. Returns warnings: files with values above 1.
std::vector<std::string> load_textures(scene::Scene& scene);

/// One file. Values of 8 and 16 bits are unchanged; floating point and 32-bit values are clamped to
/// 0 .. 1 (not a number: 0) and become the nearest of 16 bits. Grey is R = G = B; without alpha,
/// alpha is 1. Channels after R, G, B, A and pictures after the first are not read. Throws Error
/// "what; expected what" without the file's name.
TextureRef read_texture(const std::filesystem::path& file);

}  // namespace gw::image
