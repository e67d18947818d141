// Where a range of triangles is halved: the surface area heuristic in bins (Wald 2007).
// Does not know the tree.
#pragma once

#include "raytrace/hierarchy/box3.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace gw::raytrace {

/// A triangle's box, its middle, and the triangle's number.
struct Item {
    Box3 box;
    vec3 center{0};
    std::uint32_t triangle = 0;
};

/// What a range holds: its box, and the box of its items' middles.
struct Range {
    Box3 box, centers;
    std::size_t first = 0, last = 0;  ///< of the items
    std::size_t count() const { return last - first; }
};

/// What a box costs whose items are met eight at a time, as a packet holds them.
float cost_of(const Box3& box, std::size_t count);

/// Bins of equal width over the middles, along an axis.
struct Bins {
    int axis = 0;
    float low = 0, scale = 0;
    int of(const vec3& center) const { return static_cast<int>((center[axis] - low) * scale); }
};

/// The items whose middles fall into bins up to `last` go left.
struct Split {
    /// of both sides; infinity: there is none
    float cost = std::numeric_limits<float>::infinity();
    Bins bins;
    int last = 0;
    Box3 left, right;
};

/// The cheapest of the splits between bins of the three axes; `items` are the range's.
Split best_split(std::span<const Item> items, const Range& range);

/// Orders the range's items left side first and returns the two sides. The order is the same on
/// every machine. Without a split the range is halved by number.
std::array<Range, 2> divide(std::span<Item> items, const Range& range, const Split& split);

/// The range of all items.
Range whole_range(std::span<const Item> items);

}  // namespace gw::raytrace
