// A scene's texture files become textures. Texels are what the files hold: no colour management, no
// orientation tags, alpha not multiplied in. Does not look at what a map is used for.
#pragma once

#include "scene/scene.h"

namespace gw::image {

/// Fills in every map's `texture` that is null, each file read once. Throws Error naming the file
/// and line that ask for a map which is missing, no regular file, unreadable, cut short or has a
/// side outside 1 ..
/// max_texture_size.
void load_textures(scene::Scene& scene);

/// One file. 8-bit files stay as they are, 16-bit files too; floating point and 32-bit files are
/// clamped to 0 .. 1 (not a number: 0) and become the nearest of 16 bits. Grey is R = G = B;
/// without alpha, alpha is 1; channels after R, G, B, A and pictures after the first are not read.
/// Throws Error "what; expected what" without the file's name.
TextureRef read_texture(const std::filesystem::path& file);

}  // namespace gw::image
