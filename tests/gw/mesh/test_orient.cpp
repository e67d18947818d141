#include "gw/mesh/orient.h"

#include <gtest/gtest.h>

#include <random>

namespace gw {
namespace {

// Sign of a determinant of integers, exactly.
int orient_int(std::array<long, 2> a, std::array<long, 2> b, std::array<long, 2> c) {
    const __int128 d =
        __int128(b[0] - a[0]) * (c[1] - a[1]) - __int128(b[1] - a[1]) * (c[0] - a[0]);
    return (d > 0) - (d < 0);
}

TEST(Orient, AgreesWithIntegersOnNearlyCollinearPoints) {
    std::mt19937 random(1);
    int zeros = 0;
    for (int i = 0; i < 200000; ++i) {
        const auto any = [&] { return static_cast<long>(random() % 4097) - 2048; };
        const std::array<long, 2> a{any(), any()}, d{any(), any()};
        const long k = static_cast<long>(random() % 4000);
        const std::array<long, 2> b{a[0] + d[0], a[1] + d[1]};
        const std::array<long, 2> c{a[0] + k * d[0] + static_cast<long>(random() % 3) - 1,
                                    a[1] + k * d[1]};
        const auto to = [](std::array<long, 2> p) {
            return vec2(static_cast<float>(p[0]), static_cast<float>(p[1]));
        };
        const int expected = orient_int(a, b, c);
        zeros += expected == 0;
        ASSERT_EQ(orient(to(a), to(b), to(c)), expected) << i;
    }
    EXPECT_GT(zeros, 50000);
}

// [R7.2]
TEST(Orient, IsExactWhereDoublesRound) {
    // c is off the line through a and b by one unit in the last place of a tiny number.
    const vec2 a{0x1p60f, 0x1p60f}, b{-0x1p60f, -0x1p60f};
    EXPECT_EQ(orient(a, b, vec2(0x1p-100f, 0x1p-100f)), 0);
    EXPECT_EQ(orient(b, a, vec2(0x1p-100f, 0x1.000002p-100f)), 1);
    EXPECT_EQ(orient(b, a, vec2(0x1.000002p-100f, 0x1p-100f)), -1);
}

TEST(Orient, SwappingTwoPointsTurnsTheSign) {
    const vec2 a{0.1f, 0.2f}, b{0.7f, -0.3f}, c{1.1f, 5.0f};
    EXPECT_EQ(orient(a, b, c), -orient(b, a, c));
    EXPECT_EQ(orient(a, b, c), orient(b, c, a));
}

}  // namespace
}  // namespace gw
