// The fast machine's planes: tiles of 4x4-pixel blocks, so that a vector fits a block and a tile
// stays in cache. Does not draw. Conversion to and from the host's Planes is here too.
#pragma once

#include "gw/fast/frame/blocks.h"
#include "gw/fast/frame/uniform.h"
#include "gw/planes.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace gw::fast {

inline constexpr int block_side = 4, block_pixels = 16;
inline constexpr int group_side = group_blocks * block_side;
inline constexpr std::size_t max_tile_blocks = 256;  ///< of a tile of 64 x 64 pixels, the largest

/// Pixels of one block: the colours by channel, everything else by pixel.
/// Lane = 4 (y mod 4) + x mod 4.
struct alignas(64) ColorBlock {
    std::uint16_t channel[4][block_pixels];
};
struct alignas(64) DepthBlock {
    std::uint32_t value[block_pixels];
};
struct alignas(16) StencilBlock {
    std::uint8_t value[block_pixels];
};
struct alignas(64) AccumBlock {
    std::int32_t channel[4][block_pixels];
};

/// A window divided into square tiles with sides of 2^log2_tile pixels, in rows from the bottom.
struct TileGrid {
    int width = 0, height = 0, log2_tile = 6;

    int side() const { return 1 << log2_tile; }
    int columns() const { return (width + side() - 1) >> log2_tile; }
    int rows() const { return (height + side() - 1) >> log2_tile; }
    std::size_t count() const { return std::size_t(columns()) * std::size_t(rows()); }
    int blocks_per_row() const { return side() / block_side; }
    std::size_t blocks_per_tile() const {
        return std::size_t(blocks_per_row()) * std::size_t(blocks_per_row());
    }
};

/// One tile's blocks and its position in the window. `accum` is null until accumulation is used.
struct Tile {
    int x = 0, y = 0, side = 64;
    ColorBlock* color = nullptr;
    ColorBlock* other_color = nullptr;  ///< of the plane that is not in use; null: there is none
    DepthBlock* depth = nullptr;
    StencilBlock* stencil = nullptr;
    AccumBlock* accum = nullptr;
    UniformGroup* uniform = nullptr;
    UniformPlanes* has_uniform = nullptr;
    DepthPlanes* depth_planes = nullptr;

    std::size_t blocks() const { return block(0, side / block_side); }
    std::size_t block(int bx, int by) const {
        return std::size_t(by) * (std::size_t(side) / block_side) + std::size_t(bx);
    }
    /// The group of block (bx, by), and the block's index in the group.
    UniformGroup& group(int bx, int by) const {
        const std::size_t per_row = std::size_t(side) / (block_side * group_blocks);
        return uniform[std::size_t(by) / group_blocks * per_row + std::size_t(bx) / group_blocks];
    }
    static std::uint32_t in_group(int bx, int by) {
        return std::uint32_t(by) % group_blocks * group_blocks + std::uint32_t(bx) % group_blocks;
    }
};

/// The uniform colours of a group of the colour plane that is not in use.
struct UniformColors {
    std::uint64_t color[16] = {};
    std::uint16_t one_color = 0;
};

/// Tiles have one colour plane in use. The other one is made when it is first used.
class Frame {
public:
    Frame(int width, int height, int log2_tile);
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;

    const TileGrid& grid() const { return grid_; }
    Tile tile(std::size_t index);
    /// Makes the accumulation plane (zero) if it does not exist yet.
    void need_accum();
    /// Makes Color or Back the plane in use.
    void use_color(Plane plane);
    /// Makes the other colour plane (zero) if it does not exist yet, and writes its uniform blocks
    /// back.
    void need_other_color();
    /// The front plane becomes the back plane and the reverse.
    void swap_colors() { in_use_ = in_use_ == Plane::Color ? Plane::Back : Plane::Color; }

    /// Copies a rectangle of the planes out: begin_read, then each tile, in any order. All uniform
    /// blocks of the tile must have been written back, also for write(). `planes` has the
    /// rectangle's size, and those planes that are wanted.
    void begin_read(Planes& planes);
    void read(std::size_t tile, const Rect& rect, Planes& planes) const;
    void write(const Rect& rect, const Planes& planes);
    Rect whole() const { return {0, 0, grid_.width, grid_.height}; }
    std::vector<std::size_t> tiles_of(const Rect& rect) const;
    /// The tile of a pixel.
    std::size_t tile_at(int x, int y) const {
        return std::size_t((y >> grid_.log2_tile) * grid_.columns() + (x >> grid_.log2_tile));
    }

    /// Where the depth of a pixel is stored.
    struct DepthPlace {
        const UniformGroup* group;
        const DepthBlock* block;
        std::uint32_t in_group, lane;
        std::uint32_t tile;
        int i, j;  ///< the pixel in the tile
    };
    DepthPlace depth_place(int x, int y) const;
    const DepthPlanes& depth_planes(const DepthPlace& place) const {
        return depth_planes_[place.tile];
    }
    std::uint32_t depth_at(const DepthPlace& place) const;

private:
    void exchange_colors();
    void write_back_other(std::size_t tile);

    TileGrid grid_;
    Plane in_use_ = Plane::Color;
    Blocks<ColorBlock> color_, other_color_;
    Blocks<DepthBlock> depth_;
    Blocks<StencilBlock> stencil_;
    Blocks<AccumBlock> accum_;
    std::vector<UniformGroup> uniform_;
    std::vector<UniformPlanes> has_uniform_;  ///< by tile
    std::vector<DepthPlanes> depth_planes_;   ///< by tile
    std::vector<UniformColors> other_uniform_;
    std::vector<std::uint8_t> other_has_uniform_;  ///< by tile
};

}  // namespace gw::fast
