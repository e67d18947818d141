#include "raytrace/hierarchy/binned_split.h"

#include "raytrace/hierarchy/wide_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gw::raytrace {
namespace {

/// The scale is a little smaller than bins / extent, so that the last middle falls into the last
/// bin.
Bins bins_of(const Box3& centers, int axis, int bins) {
    const float extent = centers.high[axis] - centers.low[axis];
    const float scale = float(bins) * (1 - 0x1p-20f) / extent;
    return {axis, centers.low[axis], extent > 0 && std::isfinite(scale) ? scale : 0};
}

struct Bin {
    Box3 box;
    std::uint32_t count = 0;
    void add(const Bin& b) {
        box.add(b.box);
        count += b.count;
    }
};

template <int bins>
using Histogram = std::array<Bin, std::size_t(bins)>;

template <int bins>
void look_for_split(const Histogram<bins>& h, const Bins& where, Split& best) {
    std::array<float, std::size_t(bins)> right{};
    Bin sum;
    for (int b = bins - 1; b > 0; --b) {
        sum.add(h[std::size_t(b)]);
        right[std::size_t(b)] =
            sum.count ? cost_of(sum.box, sum.count) : std::numeric_limits<float>::infinity();
    }
    sum = {};
    for (int b = 0; b + 1 < bins; ++b) {
        if (h[std::size_t(b)].count == 0) continue;  // the same split as before
        sum.add(h[std::size_t(b)]);
        const float cost = cost_of(sum.box, sum.count) + right[std::size_t(b) + 1];
        if (cost < best.cost) {
            best.cost = cost;
            best.bins = where;
            best.last = b;
        }
    }
}

template <int bins>
Split best_of(std::span<const Item> items, const Box3& centers) {
    std::array<Bins, 3> where;
    std::array<Histogram<bins>, 3> histogram;
    for (int axis = 0; axis < 3; ++axis) where[std::size_t(axis)] = bins_of(centers, axis, bins);
    for (const Item& item : items)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Bin& bin = histogram[axis][std::size_t(where[axis].of(item.center))];
            bin.box.add(item.box);
            bin.count += 1;
        }
    Split best;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (where[axis].scale > 0) look_for_split<bins>(histogram[axis], where[axis], best);
    if (!std::isfinite(best.cost)) return best;
    const Histogram<bins>& h = histogram[std::size_t(best.bins.axis)];
    for (int b = 0; b < bins; ++b)
        (b <= best.last ? best.left : best.right).add(h[std::size_t(b)].box);
    return best;
}

Range range_of(std::span<const Item> items, std::size_t first, std::size_t last) {
    Range range{.first = first, .last = last};
    for (std::size_t i = first; i < last; ++i) {
        range.box.add(items[i].box);
        range.centers.add(items[i].center);
    }
    return range;
}

}  // namespace

float cost_of(const Box3& box, std::size_t count) {
    const std::size_t groups = (count + width_of_tree - 1) / width_of_tree;
    return box.area() * float(groups);
}

// Few items need few bins, and most ranges are small.
Split best_split(std::span<const Item> items, const Range& range) {
    const std::span<const Item> own = items.subspan(range.first, range.count());
    if (own.size() <= 8) return best_of<4>(own, range.centers);
    if (own.size() <= 32) return best_of<8>(own, range.centers);
    return best_of<16>(own, range.centers);
}

std::array<Range, 2> divide(std::span<Item> items, const Range& range, const Split& split) {
    if (!std::isfinite(split.cost)) {
        const std::size_t middle = range.first + range.count() / 2;
        return {range_of(items, range.first, middle), range_of(items, middle, range.last)};
    }
    Box3 left, right;
    std::size_t i = range.first, j = range.last;
    for (;;) {
        for (; i < j && split.bins.of(items[i].center) <= split.last; ++i)
            left.add(items[i].center);
        for (; i < j && split.bins.of(items[j - 1].center) > split.last; --j)
            right.add(items[j - 1].center);
        if (i == j) break;
        std::swap(items[i], items[j - 1]);
    }
    return {Range{split.left, left, range.first, i}, Range{split.right, right, i, range.last}};
}

Range whole_range(std::span<const Item> items) { return range_of(items, 0, items.size()); }

}  // namespace gw::raytrace
