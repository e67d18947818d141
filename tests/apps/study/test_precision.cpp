// What docs/precision.md says of adding passes and of the distance between renderers.
#include "apps/study/precision.h"
#include "tests/apps/study/study_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gw::study {
namespace {

constexpr int width = 64, height = 48;
const auto make = [](const Profile& profile) { return make_fast(profile, width, height); };
const auto silent = [](const std::string&) {};

TEST(Difference, CountsInLevelsOfEightBits) {
    const Difference d = difference({0, 0.5, 1}, {0, 0.5, 1 - 3 / 255.0});
    EXPECT_NEAR(d.mean, 1, 1e-12);
    EXPECT_NEAR(d.rms, std::sqrt(3.0), 1e-12);
    EXPECT_NEAR(d.largest, 3, 1e-12);
}

TEST(Adding, RoundsOncePerPass) {
    for (const Adding& row :
         adding(ball(96), {1, 16, 64}, {vgx(), reality()}, make, width, height, silent)) {
        // Two passes for each light (diffuse, specular), each rounded at the vertex and at the
        // pixel: at most 2 units.
        const double unit = row.profile == "vgx" ? 1 : 255.0 / 4095;
        EXPECT_LE(row.frame_buffer.largest, 2 * row.lights * unit)
            << row.profile << " " << row.lights;
        EXPECT_GT(row.frame_buffer.rms, 0) << row.profile << " " << row.lights;
    }
}

TEST(Adding, InTheAccumulationBufferRoundsTheSameUnlessLightsAreDrawnStronger) {
    for (const Adding& row : adding(ball(96), {4, 16, 64}, {vgx()}, make, width, height, silent)) {
        EXPECT_EQ(row.accumulation.rms, row.frame_buffer.rms) << row.lights;
        EXPECT_LT(row.full_strength.rms, row.frame_buffer.rms) << row.lights;
        EXPECT_LE(row.full_strength.largest, 2.5) << row.lights;
    }
}

TEST(Adding, SaturatesInTheFrameBufferWithStrongLights) {
    const auto rows = adding(ball(48), {1, 16}, {vgx()}, make, width, height, silent);
    EXPECT_LT(rows[0].saturated, 0.1);
    EXPECT_GT(rows[1].saturated, 0.5);
}

TEST(Distance, OfMultiPassFallsWithTessellationAndThatOfTheHardwareStays) {
    Rings rings{ball(8)};
    const std::array<std::uint8_t, 4> red{200, 20, 10, 255};
    scene::Map map;
    map.texture = make_texture8("red", 1, 1, red);
    rings.scene.materials[0].map_Kd.push_back(map);
    const auto rows = distances(rings, {8, 64}, {vgx(), ideal()}, make, width, height, silent);
    ASSERT_EQ(rows.size(), 4u);
    for (int profile : {0, 2}) {
        const Distance &coarse = rows[std::size_t(profile)], &fine = rows[std::size_t(profile + 1)];
        EXPECT_LT(fine.multipass, coarse.multipass / 2) << fine.profile;
        EXPECT_GT(fine.hardware, 5 * fine.multipass) << fine.profile;
    }
}

}  // namespace
}  // namespace gw::study
