// DrawPixels on the window: the pixel of the rectangle that each pixel of the window shows, and the
// colour of its fragment. docs/manual/pixels.md, "Drawn pixels". Does not test fragments or write
// planes.
#pragma once

#include "gw/command_list.h"
#include "gw/stages/resolve.h"
#include "gw/stages/tables.h"
#include "gw/stages/texels.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace gw {

/// A rectangle in its place, zoomed. The command, the state and the texels outlive it.
class PlacedPixels {
public:
    PlacedPixels(const DrawPixels& pixels, const Resolved& state, const BoundTexels& texels);

    /// The window's pixels that it covers, inside the pixel box.
    const Rect& box() const { return box_; }
    /// The place in the rectangle of the pixel that x, y of the box shows; none if it is not drawn.
    std::optional<std::size_t> source_of(int x, int y) const {
        const int column = columns_[std::size_t(x - box_.x)], row = rows_[std::size_t(y - box_.y)];
        if (!pixels_->bits.empty() && !has_bit(column, row)) return {};
        return pixel_index(column, row, pixels_->width);
    }
    /// Of the fragment of a pixel, after texture and fog.
    Rgba color(std::size_t pixel) const {
        if (pixels_->colors.empty()) return raster_color_;
        return is_plain_ ? pixels_->colors[pixel] : shaded(pixels_->colors[pixel]);
    }
    /// Whether all pixels are drawn, in the colours that colors_of_row() has and at one depth.
    bool has_plain_colors() const {
        return is_plain_ && pixels_->bits.empty() && pixels_->depths.empty() &&
               !pixels_->colors.empty();
    }
    /// The row of the rectangle that row y of the box shows, and the columns from column x on.
    const Rgba* colors_of_row(int y) const {
        return &pixels_->colors[pixel_index(0, rows_[std::size_t(y - box_.y)], pixels_->width)];
    }
    const int* columns_from(int x) const { return &columns_[std::size_t(x - box_.x)]; }
    std::uint32_t depth(std::size_t pixel) const {
        return pixels_->depths.empty() ? pixels_->raster.depth : pixels_->depths[pixel];
    }
    /// Whether it writes stencil values in place of fragments.
    bool is_stencil() const { return !pixels_->stencils.empty(); }
    std::uint32_t stencil(std::size_t pixel) const { return pixels_->stencils[pixel]; }
    /// The texels that are looked up for a fragment.
    int look_ups() const { return look_ups_; }

private:
    bool has_bit(int column, int row) const {
        const std::size_t byte = std::size_t(row) * pixels_->bit_row() + std::size_t(column) / 8;
        return (pixels_->bits[byte] >> (7 - column % 8) & 1) != 0;
    }
    Rgba shaded(const Rgba& color) const;

    const DrawPixels* pixels_;
    const Resolved* state_;
    Rect box_;
    std::vector<int> columns_, rows_;  ///< of the rectangle, for those of the box
    UnitTexels texels_;
    int look_ups_ = 0;
    std::uint32_t fog_factor_ = 0;
    bool is_plain_ = false;  ///< neither texture, colour sum nor fog
    Rgba raster_color_{};    ///< after texture and fog
};

/// The part of the window that a command with a source reads.
Rect source_box(const DrawPixels& command, int width, int height);

/// The command with its source's values in place of the source; colours are those of `buffer`. Source
/// pixels outside the window are not drawn.
DrawPixels with_values(const DrawPixels& command, ReadBuffer buffer, const Planes& planes);

}  // namespace gw
