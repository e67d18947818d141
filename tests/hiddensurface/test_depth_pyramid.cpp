// Claims: the pyramid hides a rectangle if and only if every pixel of it is nearer, and the cells or
// the pixel that it names decide that.
#include "hiddensurface/structures/depth_pyramid.h"
#include "tests/hiddensurface/cases.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gw::hiddensurface {

TEST(DepthPyramid, HidesWhatEveryPixelOfTheRectangleHides) {
    Random random(5);
    DepthPyramid pyramid(37, 21, 1000);
    std::vector<std::int64_t> z(37 * 21, 1000);
    int hidden = 0;
    for (int i = 0; i < 3000; ++i) {
        const int x = int(random(0, 37)), y = int(random(0, 21));
        z[std::size_t(37 * y + x)] =
            std::min(z[std::size_t(37 * y + x)], std::int64_t(random(0, 600)));
        pyramid.set(x, y, z[std::size_t(37 * y + x)]);
        const Rect rect{x, y, 1 + int(random(0, std::min(8, 37 - x))),
                        1 + int(random(0, std::min(8, 21 - y)))};
        const auto nearest = std::int64_t(random(0, 1001));
        bool expected = true;
        for (int j = rect.y; j < rect.y + rect.height; ++j)
            for (int k = rect.x; k < rect.x + rect.width; ++k)
                expected = expected && z[std::size_t(37 * j + k)] < nearest;
        const DepthPyramid::Answer answer = pyramid.ask(rect, nearest);
        EXPECT_EQ(answer.hidden, expected);
        if (!expected) {
            EXPECT_EQ(answer.farthest, z[std::size_t(37 * answer.y + answer.x)]);
            EXPECT_GE(answer.farthest, nearest);
        }
        hidden += expected ? 1 : 0;
    }
    EXPECT_GT(hidden, 100);
}

// The reason that a step gives: what hides a box is nearer than the box.
TEST(DepthPyramid, NamesCellsThatHideTheRectangle) {
    Random random(6);
    DepthPyramid pyramid(40, 24, 1000);
    std::vector<std::int64_t> z(40 * 24, 1000);
    int by_cells = 0;
    for (int i = 0; i < 4000; ++i) {
        const int x = int(random(0, 40)), y = int(random(0, 24));
        std::int64_t& stored = z[std::size_t(40 * y + x)];
        stored = std::min(stored, std::int64_t(random(0, 600)));
        pyramid.set(x, y, stored);
        const Rect rect{x, y, 1 + int(random(0, std::min(6, 40 - x))),
                        1 + int(random(0, std::min(6, 24 - y)))};
        const auto nearest = std::int64_t(random(500, 1001));
        const DepthPyramid::Answer answer = pyramid.ask(rect, nearest);
        EXPECT_GE(answer.read, answer.cells);
        if (!answer.hidden) continue;
        std::int64_t farthest = 0;
        for (int j = rect.y; j < rect.y + rect.height; ++j)
            for (int k = rect.x; k < rect.x + rect.width; ++k)
                farthest = std::max(farthest, z[std::size_t(40 * j + k)]);
        EXPECT_LT(answer.farthest, nearest);
        EXPECT_GE(answer.farthest, farthest);
        EXPECT_GE(answer.cells, 1u);
        by_cells += answer.cells > 1 ? 1 : 0;
    }
    EXPECT_GT(by_cells, 20);
}

}  // namespace gw::hiddensurface
