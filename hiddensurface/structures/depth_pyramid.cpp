#include "hiddensurface/structures/depth_pyramid.h"

#include <algorithm>

namespace gw::hiddensurface {

DepthPyramid::DepthPyramid(int width, int height, std::int64_t farthest) {
    for (;; width = (width + 1) / 2, height = (height + 1) / 2) {
        levels_.push_back({width, height, {}});
        levels_.back().z.assign(std::size_t(width) * std::size_t(height), farthest);
        if (width <= 1 && height <= 1) return;
    }
}

std::int64_t DepthPyramid::farthest_below(std::size_t level, int x, int y) const {
    const Level& below = levels_[level - 1];
    std::int64_t farthest = 0;
    for (int j = 2 * y; j < std::min(2 * y + 2, below.height); ++j)
        for (int i = 2 * x; i < std::min(2 * x + 2, below.width); ++i)
            farthest = std::max(farthest, below.at(i, j));
    return farthest;
}

void DepthPyramid::set(int x, int y, std::int64_t z) {
    levels_[0].at(x, y) = z;
    for (std::size_t level = 1; level < levels_.size(); ++level) {
        x /= 2;
        y /= 2;
        const std::int64_t farthest = farthest_below(level, x, y);
        if (levels_[level].at(x, y) == farthest) return;
        levels_[level].at(x, y) = farthest;
    }
}

DepthPyramid::Answer DepthPyramid::ask(const Rect& rect, std::int64_t nearest) const {
    const int x1 = rect.x + rect.width - 1, y1 = rect.y + rect.height - 1;
    std::size_t level = 0;
    while (rect.x >> level != x1 >> level || rect.y >> level != y1 >> level) ++level;
    Answer answer{.hidden = true, .level = level};
    ask(level, rect.x >> level, rect.y >> level, rect, nearest, answer);
    return answer;
}

void DepthPyramid::ask(std::size_t level, int x, int y, const Rect& rect, std::int64_t nearest,
                       Answer& answer) const {
    const std::int64_t z = levels_[level].at(x, y);
    answer.read += 1;
    if (z < nearest) {
        answer.cells += 1;
        answer.level = std::min(answer.level, level);
        answer.farthest = std::max(answer.farthest, z);
        answer.x = x;
        answer.y = y;
        return;
    }
    if (level == 0) {
        answer.hidden = false;
        answer.level = 0;
        answer.farthest = z;
        answer.x = x;
        answer.y = y;
        return;
    }
    const std::size_t below = level - 1;
    const int x0 = std::max(2 * x, rect.x >> below),
              x1 = std::min(2 * x + 1, (rect.x + rect.width - 1) >> below);
    const int y0 = std::max(2 * y, rect.y >> below),
              y1 = std::min(2 * y + 1, (rect.y + rect.height - 1) >> below);
    for (int j = y0; j <= y1 && answer.hidden; ++j)
        for (int i = x0; i <= x1 && answer.hidden; ++i) ask(below, i, j, rect, nearest, answer);
}

std::uint64_t DepthPyramid::bytes() const {
    std::uint64_t cells = 0;
    for (const Level& level : levels_) cells += level.z.size();
    return cells * sizeof(std::int64_t);
}

}  // namespace gw::hiddensurface
