// Images as blocks: those that are given as texels become blocks here, and their texels those of the
// blocks. [GL13] 3.8.1, GL_EXT_texture_compression_s3tc
#pragma once

#include "gl/texture/image_places.h"

namespace gw::gl {

/// The format of an image. A compressed one that has no blocks, or not for this image, becomes the
/// format of its base.
GLint stored_format(const ImageRequest& r, const ImagePlace& place);

/// Makes blocks of an image's texels if its format is of blocks.
void compress(TextureImage& image);

/// Replaces a part by texels; of an image of blocks, whole blocks.
void replace_texels(Context& context, const ReplacedPart& part, std::span<const Rgba> colors);

}  // namespace gw::gl
