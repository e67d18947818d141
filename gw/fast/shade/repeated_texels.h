// Keeps the texels of triangles that are drawn repeatedly in one tile with the same texture.
// Full-screen passes and passes over the same walls do so. Does not look them up.
#pragma once

#include "gw/fast/plan/texels.h"
#include "gw/fast/raster/primitive.h"

#include <array>
#include <bitset>
#include <vector>

namespace gw::fast {

/// The inputs of a triangle's filtered texels in a tile, if they are of one level.
struct TexelKey {
    const TexelPairs* pairs = nullptr;
    TilePlane q, s, t;
    int s_exponent = 0, t_exponent = 0;
    std::int32_t s_k = 0, t_k = 0;
    bool operator==(const TexelKey&) const = default;
};
inline TexelKey texel_key(const TexelPairs& pairs, const TexturePlanes& p) {
    return {&pairs, p.q, p.s.plane, p.t.plane, p.s.exponent, p.t.exponent, p.s.k, p.t.k};
}

/// One key's texels, two channels in the halves of each word. Blocks are numbered from the tile's
/// corner, 16 in a row.
struct KeptTexels {
    struct alignas(64) Block {
        std::uint32_t rb[block_pixels], ga[block_pixels];
    };
    TexelKey key;
    std::bitset<max_tile_blocks> known;
    std::vector<Block> blocks;
};

/// The kept texels of the tile that is being drawn. Most triangles are drawn once, so texels are
/// kept from the second time on.
class RepeatedTexels {
public:
    void clear() {
        for (KeptTexels& kept : kept_) kept.key.pairs = nullptr;
    }
    /// A triangle's kept texels; null for the first triangle with its key.
    KeptTexels* find(const TexelKey& key) {
        for (KeptTexels& kept : kept_)
            if (kept.key == key) {
                kept.blocks.resize(max_tile_blocks);
                return &kept;
            }
        next_ = (next_ + 1) % kept_.size();
        kept_[next_].key = key;
        kept_[next_].known.reset();
        return nullptr;
    }

private:
    std::array<KeptTexels, 4> kept_;  ///< a window's quads have two triangles each
    std::size_t next_ = 0;
};

}  // namespace gw::fast
