#include "hiddensurface/model/scan_conversion.h"

#include "hiddensurface/model/floor_div.h"

#include <algorithm>

namespace gw::hiddensurface {
namespace {

/// The highest row whose centre is not above y.
int top_row(std::int64_t y, int s) {
    return static_cast<int>((y - (std::int64_t{1} << (s - 1))) >> s);
}

/// Edges from the highest down, since each is added when its first row is reached. [L7]
std::vector<EdgeWalk> sorted_edges(std::span<const GridPoint> p, int s, int highest) {
    std::vector<EdgeWalk> edges;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const GridPoint &a = p[i], &b = p[(i + 1) % p.size()];
        if (a.y == b.y) continue;
        const EdgeWalk edge(a, b, s, highest);
        if (!edge.done()) edges.push_back(edge);
    }
    std::stable_sort(edges.begin(), edges.end(),
                     [](const EdgeWalk& a, const EdgeWalk& b) { return a.row() > b.row(); });
    return edges;
}

}  // namespace

EdgeWalk::EdgeWalk(const GridPoint& a, const GridPoint& b, int s, int highest) {
    const GridPoint &top = a.y > b.y ? a : b, &bottom = a.y > b.y ? b : a;
    const std::int64_t dy = top.y - bottom.y, half = std::int64_t{1} << (s - 1);
    row_ = std::min(top_row(top.y, s), highest);
    last_ = top_row(bottom.y, s) + 1;
    height_ = dy << s;
    // x at the row's centre, less half a pixel, times D.
    const std::int64_t n = (top.x - half) * dy + (bottom.x - top.x) * (top.y - center(row_, s));
    x_ = -floor_div(-n, height_);
    remainder_ = x_ * height_ - n;
    const std::int64_t step = (bottom.x - top.x) * (std::int64_t{1} << s);
    step_ = floor_div(step, height_);
    step_remainder_ = step - step_ * height_;
}

void EdgeWalk::down() {
    row_ -= 1;
    x_ += step_;
    remainder_ -= step_remainder_;
    if (remainder_ < 0) {
        remainder_ += height_;
        x_ += 1;
    }
}

std::vector<Run> scan_convert(std::span<const GridPoint> corners, int s, const Rect& window) {
    std::vector<EdgeWalk> waiting = sorted_edges(corners, s, window.y + window.height - 1), active;
    std::vector<Run> runs;
    std::size_t next = 0;
    for (int y = waiting.empty() ? window.y - 1 : waiting.front().row(); y >= window.y; --y) {
        while (next < waiting.size() && waiting[next].row() == y) active.push_back(waiting[next++]);
        std::erase_if(active, [](const EdgeWalk& edge) { return edge.done(); });
        if (active.empty() && next == waiting.size()) break;
        std::vector<int> crossings;
        for (EdgeWalk& edge : active) {
            crossings.push_back(edge.x());
            edge.down();
        }
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
            const int x0 = std::max(crossings[i], window.x);
            const int x1 = std::min(crossings[i + 1], window.x + window.width);
            if (x0 < x1) runs.push_back({y, x0, x1});
        }
    }
    return runs;
}

}  // namespace gw::hiddensurface
