// Halves a range of triangles by the surface area heuristic in bins (Wald 2007). Does not know the
// tree.
#pragma once

#include "gw/base/types.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace gw::raytrace {

/// An axis-aligned box of float32, empty until something is added. Corners have four numbers, so
/// that the compiler uses vectors; the fourth has no meaning.
struct alignas(16) Box3 {
    float low[4], high[4];

    Box3() {
        for (int k = 0; k < 4; ++k) {
            low[k] = std::numeric_limits<float>::infinity();
            high[k] = -std::numeric_limits<float>::infinity();
        }
    }
    void add(const vec3& p) {
        for (int k = 0; k < 3; ++k) {
            low[k] = p[k] < low[k] ? p[k] : low[k];
            high[k] = p[k] > high[k] ? p[k] : high[k];
        }
    }
    void add(const Box3& b) {
        for (int k = 0; k < 4; ++k) {
            low[k] = b.low[k] < low[k] ? b.low[k] : low[k];
            high[k] = b.high[k] > high[k] ? b.high[k] : high[k];
        }
    }
    /// Half the surface; 0 of an empty one.
    float area() const {
        const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
        return x < 0 ? 0 : (x * y + y * z) + z * x;
    }
};

/// A triangle's box, its middle, and the triangle's number.
struct Item {
    Box3 box;
    vec3 center{0};
    std::uint32_t triangle = 0;
};

/// Items in a row, their box, and the box of their middles.
struct Range {
    Box3 box, centers;
    std::size_t first = 0, last = 0;  ///< of the items
    std::size_t count() const { return last - first; }
};

/// The cost of a box whose items are tested eight at a time, as a packet holds them.
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
