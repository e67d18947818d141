#include "gw/fast/frame/frame.h"

#include <algorithm>
#include <bit>
#include <utility>

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

void Frame::need_other_color() {
    if (!other_color_.empty()) {
        for (std::size_t i = 0; i < grid_.count(); ++i)
            if (std::exchange(other_has_uniform_[i], 0)) write_back_other(i);
        return;
    }
    other_color_.resize(color_.size());
    other_uniform_.resize(uniform_.size());
    other_has_uniform_.resize(grid_.count());
}

void Frame::write_back_other(std::size_t index) {
    const Tile t = tile(index);
    for (int by = 0; by < grid_.blocks_per_row(); ++by)
        for (int bx = 0; bx < grid_.blocks_per_row(); ++bx) {
            UniformColors& group = other_uniform_[std::size_t(&t.group(bx, by) - uniform_.data())];
            const std::uint32_t bit = 1u << Tile::in_group(bx, by);
            if ((group.one_color & bit) == 0) continue;
            group.one_color = std::uint16_t(group.one_color & ~bit);
            const Rgba color = std::bit_cast<Rgba>(group.color[Tile::in_group(bx, by)]);
            for (std::size_t c = 0; c < 4; ++c)
                std::fill_n(t.other_color[t.block(bx, by)].channel[c], block_pixels, color[c]);
        }
}

void Frame::use_color(Plane plane) {
    if (plane == in_use_) return;
    in_use_ = plane;
    exchange_colors();
}

void Frame::exchange_colors() {
    if (other_color_.empty()) need_other_color();
    std::swap(color_, other_color_);
    for (std::size_t i = 0; i < uniform_.size(); ++i) {
        std::swap(uniform_[i].color, other_uniform_[i].color);
        std::swap(uniform_[i].one_color, other_uniform_[i].one_color);
    }
    for (std::size_t i = 0; i < grid_.count(); ++i)
        has_uniform_[i].color =
            std::exchange(other_has_uniform_[i], std::uint8_t(has_uniform_[i].color)) != 0;
}

Tile Frame::tile(std::size_t index) {
    const std::size_t first = index * grid_.blocks_per_tile(),
                      columns = std::size_t(grid_.columns());
    return {int(index % columns) << grid_.log2_tile,
            int(index / columns) << grid_.log2_tile,
            grid_.side(),
            &color_[first],
            other_color_.empty() ? nullptr : &other_color_[first],
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

void Frame::read(Planes& planes) {
    const bool front = in_use_ == Plane::Color, other = !other_color_.empty();
    std::vector<Rgba>&used = front ? planes.color : planes.back,
    &unused = front ? planes.back : planes.color;
    if (other)
        need_other_color();
    else
        std::fill(unused.begin(), unused.end(), Rgba{});
    for_each_pixel(grid_, planes, [&](std::size_t i, std::size_t b, std::size_t lane) {
        for (std::size_t c = 0; c < 4; ++c) used[i][c] = color_[b].channel[c][lane];
        if (other)
            for (std::size_t c = 0; c < 4; ++c) unused[i][c] = other_color_[b].channel[c][lane];
        planes.depth[i] = depth_[b].value[lane];
        planes.stencil[i] = stencil_[b].value[lane];
        if (!accum_.empty())
            for (std::size_t c = 0; c < 4; ++c) planes.accum[i][c] = accum_[b].channel[c][lane];
    });
}

void Frame::write(const Planes& planes) {
    const bool front = in_use_ == Plane::Color;
    const std::vector<Rgba>&used = front ? planes.color : planes.back,
          &unused = front ? planes.back : planes.color;
    const auto is_zero = [](const Rgba& color) { return color == Rgba{}; };
    if (other_color_.empty() && !std::all_of(unused.begin(), unused.end(), is_zero))
        need_other_color();
    const bool other = !other_color_.empty();
    for_each_pixel(grid_, planes, [&](std::size_t i, std::size_t b, std::size_t lane) {
        for (std::size_t c = 0; c < 4; ++c) color_[b].channel[c][lane] = used[i][c];
        if (other)
            for (std::size_t c = 0; c < 4; ++c) other_color_[b].channel[c][lane] = unused[i][c];
        depth_[b].value[lane] = planes.depth[i];
        stencil_[b].value[lane] = planes.stencil[i];
        if (!accum_.empty())
            for (std::size_t c = 0; c < 4; ++c) accum_[b].channel[c][lane] = planes.accum[i][c];
    });
}

}  // namespace gw::fast
