// Converts pixels of the usual formats and types without transfer: to colours, and from words of R,
// G, B, A.
#pragma once

#include "gl/api/values.h"
#include "gw/base/types.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace gw::gl {

/// Fills `out` with the pixels' colours. False: the format or type is none of these.
bool plain_colors(GLenum format, GLenum type, std::span<const std::byte> bytes, int bits,
                  std::span<Rgba> out);
/// The bytes of words, R in the lowest byte, in a format. `out` of GL_BGRA may be the words' memory.
/// False: the format is none of these.
bool pack_words(std::span<const std::uint32_t> words, GLenum format, std::byte* out);

}  // namespace gw::gl
