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
    /// True if every pixel of `rect`, which is in the window and not empty, is nearer than `nearest`.
    /// Reads the lowest cell around it first, then the cells below those that are not nearer. Counts
    /// the cells read.
    bool hides(const Rect& rect, std::int64_t nearest, std::uint64_t& compared) const;
    /// The lowest cell around `rect`: its level, pixels 0, and its depth.
    std::pair<std::size_t, std::int64_t> around(const Rect& rect) const;
    std::uint64_t bytes() const;

private:
    struct Level {
        int width = 0, height = 0;
        std::vector<std::int64_t> z;
        std::int64_t& at(int x, int y) { return z[pixel_index(x, y, width)]; }
        std::int64_t at(int x, int y) const { return z[pixel_index(x, y, width)]; }
    };
    std::int64_t farthest_below(std::size_t level, int x, int y) const;
    bool hides(std::size_t level, int x, int y, const Rect& rect, std::int64_t nearest,
               std::uint64_t& compared) const;

    std::vector<Level> levels_;  ///< pixels first
};

}  // namespace gw::hiddensurface
