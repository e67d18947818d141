// Usual formats of a byte a component, without transfer: to colours, and from words of R, G, B, A.
#pragma once

#include "gl/api/values.h"
#include "gw/base/types.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gw::gl {

/// The bytes of as many pixels as `out` has, each times `factor`. False: the format is none of
/// these.
bool scale_bytes(GLenum format, std::span<const std::byte> bytes, std::uint16_t factor,
                 std::vector<Rgba>& out);
/// The bytes of words, R in the lowest byte, in a format. `out` of GL_BGRA may be the words' memory.
/// False: the format is none of these.
bool pack_words(std::span<const std::uint32_t> words, GLenum format, std::byte* out);

}  // namespace gw::gl
