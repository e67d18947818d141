// A pyramid of depths over the window: every cell of a level has the farthest depth of the four
// below it. Tells whether a rectangle is hidden without reading its pixels. Does not project.
#pragma once

#include "gw/base/types.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace gw::hiddensurface {

class DepthPyramid {
public:
    DepthPyramid(int width, int height, std::int64_t farthest);

    std::int64_t at(int x, int y) const { return levels_[0].at(x, y); }
    /// Stores a nearer depth and updates the levels above.
    void set(int x, int y, std::int64_t z);
    /// The cells that answered: all are nearer, or the last is a pixel that is not.
    struct Answer {
        bool hidden = false;
        std::uint64_t read = 0;     ///< cells
        std::uint64_t cells = 0;    ///< that are nearer: together they cover the rectangle
        std::size_t level = 0;      ///< pixels 0; of several cells the lowest
        std::int64_t farthest = 0;  ///< depth of the farthest of the cells, or of the pixel
        int x = 0, y = 0;           ///< the cell, or the pixel
    };
    /// Whether every pixel of `rect`, which is in the window and not empty, is nearer than `nearest`.
    /// Reads the lowest cell around it first, then the cells below those that are not nearer.
    Answer ask(const Rect& rect, std::int64_t nearest) const;
    std::uint64_t bytes() const;

private:
    struct Level {
        int width = 0, height = 0;
        std::vector<std::int64_t> z;
        std::int64_t& at(int x, int y) { return z[pixel_index(x, y, width)]; }
        std::int64_t at(int x, int y) const { return z[pixel_index(x, y, width)]; }
    };
    std::int64_t farthest_below(std::size_t level, int x, int y) const;
    void ask(std::size_t level, int x, int y, const Rect& rect, std::int64_t nearest,
             Answer& answer) const;

    std::vector<Level> levels_;  ///< pixels first
};

}  // namespace gw::hiddensurface
