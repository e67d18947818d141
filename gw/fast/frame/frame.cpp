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

/// Calls visit(host index, block, lane, count) for each row of a tile's blocks that is in the
/// rectangle: so many pixels, one after the other.
template <typename Visit>
void for_each_row(const TileGrid& grid, std::size_t index, const Rect& rect, const Visit& visit) {
    const int tile_x = int(index % std::size_t(grid.columns())) << grid.log2_tile,
              tile_y = int(index / std::size_t(grid.columns())) << grid.log2_tile;
    const int left = std::max(tile_x, rect.x), low = std::max(tile_y, rect.y);
    const int right = std::min(tile_x + grid.side(), rect.x + rect.width),
              high = std::min(tile_y + grid.side(), rect.y + rect.height);
    for (int y = low; y < high; ++y) {
        const std::size_t row = index * grid.blocks_per_tile() +
                                std::size_t((y - tile_y) / block_side * grid.blocks_per_row());
        for (int x = left, next = 0; x < right; x = next) {
            next = std::min(x - x % block_side + block_side, right);
            visit(rect.index(x, y), row + std::size_t((x - tile_x) / block_side),
                  std::size_t(y % block_side * block_side + x % block_side), std::size_t(next - x));
        }
    }
}

}  // namespace

void Frame::begin_read(Planes& planes) {
    if (!other_color_.empty()) return need_other_color();
    std::vector<Rgba>& unused = in_use_ == Plane::Color ? planes.back : planes.color;
    std::fill(unused.begin(), unused.end(), Rgba{});
}

void Frame::read(std::size_t index, const Rect& rect, Planes& planes) const {
    const bool front = in_use_ == Plane::Color;
    std::vector<Rgba>&used = front ? planes.color : planes.back,
    &unused = front ? planes.back : planes.color;
    const bool other = !other_color_.empty() && !unused.empty();
    const auto colors = [](const ColorBlock& block, std::size_t lane, std::size_t count, Rgba* to) {
        for (std::size_t k = 0; k < count; ++k)
            for (std::size_t c = 0; c < 4; ++c) to[k][c] = block.channel[c][lane + k];
    };
    const bool has_depth = !planes.depth.empty(), has_stencil = !planes.stencil.empty();
    for_each_row(grid_, index, rect,
                 [&](std::size_t i, std::size_t b, std::size_t lane, std::size_t n) {
                     if (!used.empty()) colors(color_[b], lane, n, &used[i]);
                     if (other) colors(other_color_[b], lane, n, &unused[i]);
                     if (has_depth) std::copy_n(depth_[b].value + lane, n, &planes.depth[i]);
                     if (has_stencil) std::copy_n(stencil_[b].value + lane, n, &planes.stencil[i]);
                     if (accum_.empty() || planes.accum.empty()) return;
                     for (std::size_t k = 0; k < n; ++k)
                         for (std::size_t c = 0; c < 4; ++c)
                             planes.accum[i + k][c] = accum_[b].channel[c][lane + k];
                 });
}

void Frame::write(const Rect& rect, const Planes& planes) {
    const bool front = in_use_ == Plane::Color;
    const std::vector<Rgba>&used = front ? planes.color : planes.back,
          &unused = front ? planes.back : planes.color;
    const auto is_zero = [](const Rgba& color) { return color == Rgba{}; };
    if (other_color_.empty() && !std::all_of(unused.begin(), unused.end(), is_zero))
        need_other_color();
    const bool other = !other_color_.empty() && !unused.empty();
    const auto colors = [](const Rgba* from, std::size_t lane, std::size_t count,
                           ColorBlock& block) {
        for (std::size_t k = 0; k < count; ++k)
            for (std::size_t c = 0; c < 4; ++c) block.channel[c][lane + k] = from[k][c];
    };
    const bool has_depth = !planes.depth.empty(), has_stencil = !planes.stencil.empty();
    const auto row = [&](std::size_t i, std::size_t b, std::size_t lane, std::size_t n) {
        if (!used.empty()) colors(&used[i], lane, n, color_[b]);
        if (other) colors(&unused[i], lane, n, other_color_[b]);
        if (has_depth) std::copy_n(&planes.depth[i], n, depth_[b].value + lane);
        if (has_stencil) std::copy_n(&planes.stencil[i], n, stencil_[b].value + lane);
        if (accum_.empty() || planes.accum.empty()) return;
        for (std::size_t k = 0; k < n; ++k)
            for (std::size_t c = 0; c < 4; ++c)
                accum_[b].channel[c][lane + k] = planes.accum[i + k][c];
    };
    for (const std::size_t tile : tiles_of(rect)) for_each_row(grid_, tile, rect, row);
}

std::vector<std::size_t> Frame::tiles_of(const Rect& rect) const {
    std::vector<std::size_t> tiles;
    if (rect.width <= 0 || rect.height <= 0) return tiles;
    const int right = (rect.x + rect.width - 1) >> grid_.log2_tile,
              high = (rect.y + rect.height - 1) >> grid_.log2_tile;
    for (int row = rect.y >> grid_.log2_tile; row <= high; ++row)
        for (int column = rect.x >> grid_.log2_tile; column <= right; ++column)
            tiles.push_back(std::size_t(row * grid_.columns() + column));
    return tiles;
}

Frame::DepthPlace Frame::depth_place(int x, int y) const {
    const int mask = grid_.side() - 1, i = x & mask, j = y & mask;
    const int bx = i / block_side, by = j / block_side;
    const std::size_t tile = tile_at(x, y);
    const std::size_t first = tile * grid_.blocks_per_tile();
    const int groups_per_row = grid_.side() / group_side;
    return {&uniform_[first / (group_blocks * group_blocks) +
                      std::size_t(by / group_blocks * groups_per_row + bx / group_blocks)],
            &depth_[first + std::size_t(by * grid_.blocks_per_row() + bx)],
            Tile::in_group(bx, by),
            std::uint32_t(j % block_side * block_side + i % block_side),
            std::uint32_t(tile),
            i,
            j};
}

std::uint32_t Frame::depth_at(const DepthPlace& place) const {
    const UniformGroup& group = *place.group;
    if (group.one_depth >> place.in_group & 1) return group.depth[place.in_group];
    if (group.one_plane >> place.in_group & 1)
        return std::uint32_t(
            value_of(depth_planes_[place.tile][group.depth[place.in_group]], place.i, place.j));
    return place.block->value[place.lane];
}

}  // namespace gw::fast
