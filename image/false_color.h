// False colours for planes that hold no colours. For the eye; the exact values go to EXR files.
#pragma once

#include "image/picture.h"

#include <array>

namespace gw::image {

/// Nearest red, then yellow, green, cyan, farthest blue, over the range that occurs; the largest
/// value of `bits` bits (the background) is black.
Picture depth_colors(const std::vector<std::uint32_t>& depth, int width, int height, int bits);

/// 0 is black; 1, 2, 3, ... are red, green, blue, yellow, cyan, magenta, white, then the same
/// darker.
Picture stencil_colors(const std::vector<std::uint8_t>& stencil, int width, int height);

/// A colour for every identifier, distinct up to 24 bits; `none` is black.
Picture id_colors(const std::vector<std::uint32_t>& ids, int width, int height, std::uint32_t none);

/// R, G, B as fractions of the largest magnitude that occurs; sums below 0 are black.
Picture accum_colors(const std::vector<std::array<std::int32_t, 4>>& accum, int width, int height);

}  // namespace gw::image
