#include "inspect/compare/difference_classes.h"

#include "inspect/compare/classify.h"
#include "inspect/replay/plane_values.h"

#include <algorithm>
#include <cstdlib>

namespace gw::inspect {
namespace {

/// The largest difference of a channel.
std::uint64_t units_apart(const Rgba& a, const Rgba& b) {
    int largest = 0;
    for (std::size_t i = 0; i < 4; ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return std::uint64_t(largest);
}

Cause cause_of(Paint paint) {
    switch (paint) {
        case Paint::Plain: return Cause::Color;
        case Paint::Textured: return Cause::Texture;
        case Paint::Smooth: return Cause::Antialiasing;
    }
    return Cause::Color;
}

void add_pixel(CauseTallies& tallies, Cause cause, std::uint64_t units) {
    CauseTally& tally = tallies[std::size_t(cause)];
    ++tally.pixels;
    tally.sum += units;
    tally.largest = std::max(tally.largest, units);
}

}  // namespace

CauseTallies tally_causes(const Planes& ours, const Planes& theirs, Plane colors,
                          const std::vector<Paint>& painted) {
    CauseTallies tallies;
    const auto& a = colors == Plane::Back ? ours.back : ours.color;
    const auto& b = colors == Plane::Back ? theirs.back : theirs.color;
    for (int y = 0; y < ours.height; ++y)
        for (int x = 0; x < ours.width; ++x) {
            const std::size_t i = ours.index(x, y);
            const auto is_edge = [&](Plane plane) {
                return kind_of_difference(ours, theirs, plane, x, y) == Kind::Edge;
            };
            bool covered = false;  // another primitive is seen here
            if (const std::uint64_t units = units_apart(a[i], b[i])) {
                covered = painted[i] != Paint::Smooth && is_edge(colors);
                add_pixel(tallies, covered ? Cause::Coverage : cause_of(painted[i]), units);
            }
            for (const auto& [plane, cause] :
                 {std::pair{Plane::Depth, Cause::Depth}, {Plane::Stencil, Cause::Stencil}}) {
                const std::uint64_t units = distance(ours, theirs, plane, x, y);
                if (units == 0) continue;
                if (!is_edge(plane)) {
                    add_pixel(tallies, cause, units);
                } else if (!covered) {
                    covered = true;
                    add_pixel(tallies, Cause::Coverage, 0);
                }
            }
        }
    return tallies;
}

void add(CauseTallies& to, const CauseTallies& more) {
    for (std::size_t i = 0; i < cause_count; ++i) {
        to[i].pixels += more[i].pixels;
        to[i].sum += more[i].sum;
        to[i].largest = std::max(to[i].largest, more[i].largest);
    }
}

}  // namespace gw::inspect
