// Textures in blocks of 4x4 texels. GL_EXT_texture_compression_s3tc
#pragma once

#include "gw/base/types.h"

#include <GL/gl.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gw::gl {

/// A compressed format.
struct BlockFormat {
    enum class Alpha : std::uint8_t {
        One,           ///< 1
        OneBit,        ///< 0 or 1: the fourth code of blocks whose first colour is not greater
        Explicit,      ///< 4 bits a texel
        Interpolated,  ///< between two values of 8 bits
    };
    GLenum format;
    Alpha alpha;
    std::size_t bytes;  ///< of a block
};
/// Null: no such format.
const BlockFormat* block_format(GLenum format);

/// The bytes of an image; blocks that stick out count whole.
std::size_t blocks_size(const BlockFormat& format, GLsizei width, GLsizei height);

/// The texels of an image, 16 bits a channel, row after row.
std::vector<Rgba> decoded(const BlockFormat& format, GLsizei width, GLsizei height,
                          std::span<const std::byte> blocks);

/// The blocks of an image of such texels. A block's two colours are those of its texels that differ
/// most, and each texel gets the nearest code. Alphas below 1/2 are the holes of formats that have one
/// bit of it.
std::vector<std::byte> encoded(const BlockFormat& format, GLsizei width, GLsizei height,
                               std::span<const Rgba> texels);

}  // namespace gw::gl
