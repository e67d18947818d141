#include "inspect/compare/classify.h"

#include "inspect/compare/plane_values.h"

#include <algorithm>

namespace gw::inspect {
namespace {

constexpr int close_color = 4, close_depth = 256;

bool close(int a, int b, int bound) { return std::abs(a - b) <= bound; }

/// Values at different pixels of two planes.
struct Compared {
    const Planes& ours;
    const Planes& theirs;
    Plane plane;

    bool are_close(std::size_t our_pixel, std::size_t their_pixel) const {
        if (plane == Plane::Stencil) return ours.stencil[our_pixel] == theirs.stencil[their_pixel];
        if (plane == Plane::Depth) {
            const std::int64_t d = std::int64_t{ours.depth[our_pixel]} - theirs.depth[their_pixel];
            return d >= -close_depth && d <= close_depth;
        }
        const Rgba &a = ours.color[our_pixel], &b = theirs.color[their_pixel];
        return std::equal(a.begin(), a.end(), b.begin(),
                          [](int p, int q) { return close(p, q, close_color); });
    }

    bool is_edge(int x, int y) const {
        const std::size_t here = ours.index(x, y);
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, ours.height - 1); ++v)
            for (int u = std::max(x - 1, 0); u <= std::min(x + 1, ours.width - 1); ++u) {
                const std::size_t there = ours.index(u, v);
                if (there != here && are_close(there, here)) return true;
            }
        return false;
    }
};

}  // namespace

Differences classify(const Planes& ours, const Planes& theirs, Plane plane) {
    const Compared compared{ours, theirs, plane};
    Differences result;
    for (int y = 0; y < ours.height; ++y)
        for (int x = 0; x < ours.width; ++x) {
            const std::uint64_t d = distance(ours, theirs, plane, x, y);
            if (d == 0) continue;
            const std::size_t i = ours.index(x, y);
            auto& count = compared.are_close(i, i) ? result.rounding
                          : compared.is_edge(x, y) ? result.edge
                                                   : result.other;
            count += 1;
            result.worst = std::max(result.worst, d);
        }
    return result;
}

}  // namespace gw::inspect
