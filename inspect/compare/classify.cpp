#include "inspect/compare/classify.h"

#include "inspect/replay/plane_values.h"

#include <algorithm>

namespace gw::inspect {
namespace {

constexpr int close_color = 4, close_depth = 256;

const std::vector<Rgba>& colors_of(const Planes& planes, Plane plane) {
    return plane == Plane::Back ? planes.back : planes.color;
}

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
        const Rgba &a = colors_of(ours, plane)[our_pixel],
                   &b = colors_of(theirs, plane)[their_pixel];
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

Kind kind_of_difference(const Planes& ours, const Planes& theirs, Plane plane, int x, int y) {
    const std::size_t i = ours.index(x, y);
    const Compared compared{ours, theirs, plane};
    if (compared.are_close(i, i)) return Kind::Rounding;
    return compared.is_edge(x, y) ? Kind::Edge : Kind::Other;
}

Differences classify(const Planes& ours, const Planes& theirs, Plane plane) {
    Differences result;
    for (int y = 0; y < ours.height; ++y)
        for (int x = 0; x < ours.width; ++x) {
            const std::uint64_t d = distance(ours, theirs, plane, x, y);
            if (d == 0) continue;
            switch (kind_of_difference(ours, theirs, plane, x, y)) {
                case Kind::Rounding: ++result.rounding; break;
                case Kind::Edge: ++result.edge; break;
                case Kind::Other: ++result.other; break;
            }
            result.worst = std::max(result.worst, d);
        }
    return result;
}

}  // namespace gw::inspect
