// Textures in the layout of the fast machine's kernels: all levels in one array. For the bilinear
// filter, the four texels that a pixel mixes are adjacent. Does not filter.
#pragma once

#include "gw/stages/texels.h"

#include <array>
#include <cstdint>
#include <vector>

namespace gw::fast {

/// Texels (i, j) and (i, j + 1) of one level, wrapped. A bilinear filter mixes two pairs side by
/// side. A row of pairs ends with its first pair again, or with its last if coordinates are
/// clamped.
struct TexelPair {
    std::uint32_t lower, upper;
};

/// A texture's pairs, level after level.
struct TexelPairs {
    /// of each level; a row is one longer than the level is wide
    std::array<std::int32_t, 16> first{};
    std::vector<TexelPair> pairs;
};

struct FastTexels {
    Texels texels;
    std::array<std::int32_t, 16> first{};  ///< of each level, in texels
    std::vector<std::uint32_t> packed;     ///< if bits == 8: 8 bits a channel, R lowest
    std::vector<Rgba> wide;                ///< else
    std::array<TexelPairs, 4> pairs;       ///< by both wraps; made when asked for
};

FastTexels make_fast_texels(Texels texels);

/// The texture's pairs for these wraps; null if it has more than 8 bits.
const TexelPairs* texel_pairs(FastTexels& texels, Wrap wrap_s, Wrap wrap_t);

}  // namespace gw::fast
