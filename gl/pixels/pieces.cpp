#include "gl/pixels/pieces.h"

#include "gw/machine.h"

#include <algorithm>
#include <utility>

namespace gw::gl {

namespace {

constexpr int piece_side = max_window_size;
static_assert(piece_side % 8 == 0);  // pieces of bits begin with a byte

/// A part of rows of `row` values.
template <class T>
std::vector<T> part_of(const std::vector<T>& values, std::size_t row, std::size_t first,
                       std::size_t count, int y, int height) {
    std::vector<T> out;
    if (values.empty()) return out;
    for (int j = y; j < y + height; ++j) {
        const T* const begin = values.data() + std::size_t(j) * row + first;
        out.insert(out.end(), begin, begin + count);
    }
    return out;
}

gw::DrawPixels piece_of(const gw::DrawPixels& whole, int x, int y) {
    gw::DrawPixels out;
    out.width = std::min(piece_side, whole.width - x);
    out.height = std::min(piece_side, whole.height - y);
    out.raster = whole.raster;
    out.zoom_x = whole.zoom_x;
    out.zoom_y = whole.zoom_y;
    out.map = whole.map;
    const auto part = [&](const auto& values) {
        return part_of(values, std::size_t(whole.width), std::size_t(x), std::size_t(out.width), y,
                       out.height);
    };
    out.colors = part(whole.colors);
    out.depths = part(whole.depths);
    out.stencils = part(whole.stencils);
    out.bits =
        part_of(whole.bits, whole.bit_row(), std::size_t(x) / 8, out.bit_row(), y, out.height);
    return out;
}

}  // namespace

// A piece's last edge is computed as the first edge of the next: corner + zoom * piece_side.
void for_each_piece(gw::DrawPixels whole, const std::function<void(gw::DrawPixels)>& take) {
    if (whole.width <= piece_side && whole.height <= piece_side) return take(std::move(whole));
    double corner_y = whole.raster.y;
    for (std::int64_t y = 0; y < whole.height;
         y += piece_side, corner_y += whole.zoom_y * piece_side) {
        double corner_x = whole.raster.x;
        for (std::int64_t x = 0; x < whole.width;
             x += piece_side, corner_x += whole.zoom_x * piece_side) {
            gw::DrawPixels piece = piece_of(whole, int(x), int(y));
            piece.raster.x = corner_x;
            piece.raster.y = corner_y;
            take(std::move(piece));
        }
    }
}

}  // namespace gw::gl
