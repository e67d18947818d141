// A pyramid of depths over the window: every cell of a level has the farthest of the four below it.
// Asks whether a rectangle is hidden without looking at its pixels. Does not project.
#pragma once

#include "gw/base/types.h"

#include <cstdint>
#include <vector>

namespace gw::hiddensurface {

class DepthPyramid {
public:
    DepthPyramid(int width, int height, std::int64_t farthest);

    std::int64_t at(int x, int y) const { return levels_[0].at(x, y); }
    /// A nearer depth than was there; the levels above follow as far as they change.
    void set(int x, int y, std::int64_t z);
    /// Every pixel of `rect`, which is in the window and not empty, is nearer than `nearest`. Asked
    /// first of the lowest cell that has all of it, then of the cells below that are not nearer.
    /// Counts cells asked.
    bool hides(const Rect& rect, std::int64_t nearest, std::uint64_t& compared) const;
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
