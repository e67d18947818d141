// The split of a range of triangles by the surface area heuristic.
#include "raytrace/hierarchy/binned_split.h"
#include "raytrace/hierarchy/wide_tree.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

namespace gw::raytrace {
namespace {

/// `count` boxes of side 0.1 at random places of a box at `low`.
void add_cloud(std::vector<Item>& items, std::size_t count, const vec3& low, std::mt19937& random) {
    const auto number = [&] { return float(random() >> 8) * 0x1p-24f; };
    for (std::size_t i = 0; i < count; ++i) {
        Item item;
        const vec3 p = low + vec3(number(), number(), number());
        item.box.add(p);
        item.box.add(p + vec3(0.1f));
        item.center = p + vec3(0.05f);
        item.triangle = std::uint32_t(items.size());
        items.push_back(item);
    }
}

TEST(BinnedSplit, CostsWhatItsSidesCost) {
    std::mt19937 random(1);
    for (std::size_t count = 9; count < 400; count += 17) {
        std::vector<Item> items;
        add_cloud(items, count, vec3(-1, 2, 3), random);
        const Range range = whole_range(items);
        const Split split = best_split(items, range);
        const std::array<Range, 2> sides = divide(items, range, split);
        EXPECT_EQ(sides[0].count() + sides[1].count(), count);
        EXPECT_EQ(split.cost,
                  cost_of(sides[0].box, sides[0].count()) + cost_of(sides[1].box, sides[1].count()))
            << count;
    }
}

TEST(BinnedSplit, PartsTwoClouds) {
    std::mt19937 random(2);
    std::vector<Item> items;
    add_cloud(items, 10, vec3(0, 0, 50), random);
    add_cloud(items, 30, vec3(0), random);
    const Range range = whole_range(items);
    const std::array<Range, 2> sides = divide(items, range, best_split(items, range));
    EXPECT_EQ(sides[0].count(), 30u);
    EXPECT_EQ(sides[1].count(), 10u);
}

TEST(BinnedSplit, CostsAPacketForEightItems) {
    Box3 box;
    box.add(vec3(0));
    box.add(vec3(1, 2, 3));
    EXPECT_EQ(box.area(), 11);
    EXPECT_EQ(cost_of(box, width_of_tree), 11);
    EXPECT_EQ(cost_of(box, width_of_tree + 1), 22);
}

}  // namespace
}  // namespace gw::raytrace
