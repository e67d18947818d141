#include "gw/fast/frame/frame.h"

#include "gw/planes.h"

namespace gw::fast {

Frame::Frame(int width, int height, int log2_tile) : grid_{width, height, log2_tile} {
    const std::size_t blocks = grid_.count() * grid_.blocks_per_tile();
    color_.resize(blocks);
    depth_.resize(blocks);
    stencil_.resize(blocks);
    uniform_.resize(blocks / (group_blocks * group_blocks));
    has_uniform_.resize(grid_.count());
    depth_planes_.resize(grid_.count());
}

void Frame::need_accum() {
    if (accum_.empty()) accum_.resize(color_.size());
}

Tile Frame::tile(std::size_t index) {
    const std::size_t first = index * grid_.blocks_per_tile(),
                      columns = std::size_t(grid_.columns());
    return {int(index % columns) << grid_.log2_tile,
            int(index / columns) << grid_.log2_tile,
            grid_.side(),
            &color_[first],
            &depth_[first],
            &stencil_[first],
            accum_.empty() ? nullptr : &accum_[first],
            &uniform_[first / (group_blocks * group_blocks)],
            &has_uniform_[index],
            &depth_planes_[index]};
}

namespace {

/// Calls visit(host index, block, lane) for every pixel of the window.
template <typename Visit>
void for_each_pixel(const TileGrid& grid, const Planes& planes, const Visit& visit) {
    const int mask = grid.side() - 1;
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x) {
            const std::size_t tile =
                std::size_t(y >> grid.log2_tile) * std::size_t(grid.columns()) +
                std::size_t(x >> grid.log2_tile);
            const std::size_t inside =
                std::size_t((y & mask) / block_side) * std::size_t(grid.blocks_per_row()) +
                std::size_t((x & mask) / block_side);
            visit(planes.index(x, y), tile * grid.blocks_per_tile() + inside,
                  std::size_t(y % block_side * block_side + x % block_side));
        }
}

}  // namespace

void Frame::read(Planes& planes) const {
    for_each_pixel(grid_, planes, [&](std::size_t i, std::size_t b, std::size_t lane) {
        for (std::size_t c = 0; c < 4; ++c) planes.color[i][c] = color_[b].channel[c][lane];
        planes.depth[i] = depth_[b].value[lane];
        planes.stencil[i] = stencil_[b].value[lane];
        if (!accum_.empty())
            for (std::size_t c = 0; c < 4; ++c) planes.accum[i][c] = accum_[b].channel[c][lane];
    });
}

void Frame::write(const Planes& planes) {
    for_each_pixel(grid_, planes, [&](std::size_t i, std::size_t b, std::size_t lane) {
        for (std::size_t c = 0; c < 4; ++c) color_[b].channel[c][lane] = planes.color[i][c];
        depth_[b].value[lane] = planes.depth[i];
        stencil_[b].value[lane] = planes.stencil[i];
        if (!accum_.empty())
            for (std::size_t c = 0; c < 4; ++c) accum_[b].channel[c][lane] = planes.accum[i][c];
    });
}

}  // namespace gw::fast
