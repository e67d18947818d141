// Textures in the layout of the fast machine's kernels. For the bilinear filter, the four texels that
// a pixel mixes are adjacent. Does not filter.
#pragma once

#include "gw/stages/texels.h"

#include <array>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

namespace gw::fast {

class Frame;

/// Texels (i, j) and (i, j + 1) of one level, as filter_texel() gives them. A bilinear filter mixes
/// two pairs side by side.
struct TexelPair {
    std::uint32_t lower, upper;
};

/// A texture's pairs, level after level. Rows and columns begin at 0, under BorderClamp at -1. A row
/// ends with i = width of the level.
struct TexelPairs {
    Addressing how;
    std::array<std::int32_t, 16> first{};  ///< of each level
    std::vector<TexelPair> pairs;
};

struct FastTexels {
    Texels texels;
    std::array<std::int32_t, 16> first{};  ///< of each level, in texels
    std::deque<TexelPairs> pairs;          ///< made when asked for
    const Frame* frame = nullptr;          ///< it has the depths, which `texels` lacks; null: no
};

FastTexels make_fast_texels(Texels texels);
/// The depths of a surface's frame, which stay there: for comparison only.
FastTexels depths_in_place(const Frame& frame, const Profile& profile);

/// Takes parts over from a texture with the same levels, into the pairs too.
void update(FastTexels& texels, const Texture& texture, std::span<const TexturePart> parts,
            const TexelBits& bits);

/// The texture's pairs; null if it has more than 8 bits, or already pairs with many border colours.
const TexelPairs* texel_pairs(FastTexels& texels, Addressing how);

}  // namespace gw::fast
