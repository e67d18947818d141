// RGBM: what comes back lies within the bound that rgbm.h states.
#include "image/rgbm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace gw::image {

using Bytes = std::array<std::uint8_t, 4>;

TEST(Rgbm, ComesBackWithinItsBound) {
    for (const double range : {1.0, 5.0, 8.0, 34.49})
        for (int r = 0; r <= 60; ++r)
            for (int g = 0; g <= 60; ++g)
                for (int b = 0; b <= 60; ++b) {
                    // Small and large values: cubes of even steps.
                    const auto value = [&](int i) { return std::pow(i / 60.0, 3) * range; };
                    const dvec3 color(value(r), value(g), value(b));
                    const double most = std::max(std::max(color.x, color.y), color.z),
                                 bound = (most + range / 255) / 510 * (1 + 1e-12);
                    const dvec3 back = color_of_rgbm(rgbm_of(color, range), range);
                    for (int c = 0; c < 3; ++c) ASSERT_LE(std::abs(back[c] - color[c]), bound);
                }
}

TEST(Rgbm, HasTheSmallestFactorThatHoldsTheColour) {
    EXPECT_EQ(rgbm_of({0, 0, 0}, 8), (Bytes{0, 0, 0, 0}));
    EXPECT_EQ(rgbm_of({8, 4, 0}, 8), (Bytes{255, 128, 0, 255}));
    EXPECT_EQ(rgbm_of({0, 8.0 * 51 / 255, 0}, 8), (Bytes{0, 255, 0, 51}));
    EXPECT_EQ(rgbm_of({0, 8.0 * 50.6 / 255, 0}, 8), (Bytes{0, 253, 0, 51}));
    EXPECT_EQ(rgbm_of({1e-9, 0, 0}, 8)[3], 1);
}

TEST(Rgbm, BeyondItsRangeIsClamped) {
    EXPECT_EQ(rgbm_of({100, 4, -1}, 8), (Bytes{255, 128, 0, 255}));
    EXPECT_EQ(rgbm_of({NAN, 0, 0}, 8), (Bytes{0, 0, 0, 0}));
}

}  // namespace gw::image
