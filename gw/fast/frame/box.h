// A rectangle of the window as lanes of one tile's blocks. Does not know the drawing.
#pragma once

#include "gw/fast/frame/frame.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace gw::fast {

struct BlockBox {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;             ///< pixels of the tile, [x0, x1) x [y0, y1)
    std::array<std::uint16_t, 16> column{}, row{};  ///< lanes inside, by block column and row

    bool empty() const { return x0 >= x1 || y0 >= y1; }
    bool whole(const Tile& tile) const {
        return x0 == 0 && y0 == 0 && x1 == tile.side && y1 == tile.side;
    }
    std::uint32_t mask(int bx, int by) const {
        return std::uint32_t(column[std::size_t(bx)] & row[std::size_t(by)]);
    }
};

inline BlockBox block_box(const Rect& rect, const Tile& tile) {
    BlockBox b;
    b.x0 = std::clamp(rect.x - tile.x, 0, tile.side);
    b.x1 = std::clamp(rect.x + rect.width - tile.x, 0, tile.side);
    b.y0 = std::clamp(rect.y - tile.y, 0, tile.side);
    b.y1 = std::clamp(rect.y + rect.height - tile.y, 0, tile.side);
    if (b.x1 - b.x0 == tile.side && b.y1 - b.y0 == tile.side) {
        b.column.fill(0xFFFF);
        b.row.fill(0xFFFF);
        return b;
    }
    const auto lanes = [&](int block, int low, int high, std::uint32_t line, int step) {
        std::uint32_t mask = 0;
        for (int k = 0; k < block_side; ++k) {
            const int i = block * block_side + k;
            if (i >= low && i < high) mask |= line << (step * k);
        }
        return std::uint16_t(mask);
    };
    for (int block = 0; block < tile.side / block_side; ++block) {
        b.column[std::size_t(block)] = lanes(block, b.x0, b.x1, 0x1111u, 1);
        b.row[std::size_t(block)] = lanes(block, b.y0, b.y1, 0xFu, block_side);
    }
    return b;
}

}  // namespace gw::fast
