// docs/manual/rasterization.md, "Antialiasing": the worked examples. White of alpha 1 is drawn over
// 0 without blending, so that the alpha plane shows the coverage.
#include "tests/gw/workbench.h"

#include <cmath>

namespace gw {
namespace {

using test::Workbench;

struct SmoothBench : Workbench {
    explicit SmoothBench(const Profile& profile = opengl(), int width = 8, int height = 8)
        : Workbench(profile, width, height) {
        state.point_smooth = state.line_smooth = state.polygon_smooth = true;
    }
    int coverage(int x, int y) { return color(x, y)[3]; }
};

// [R9.23] [R9.24]
TEST(ManualAntialiasing, AreasByHand) {
    SmoothBench bench;
    bench.draw(Primitive::Quads, {{1.5f, 1, 0}, {3.25f, 1, 0}, {3.25f, 2, 0}, {1.5f, 2, 0}});
    EXPECT_EQ(bench.coverage(0, 1), 0);
    EXPECT_EQ(bench.coverage(1, 1), 128);
    EXPECT_EQ(bench.coverage(2, 1), 255);
    EXPECT_EQ(bench.coverage(3, 1), 64);
    EXPECT_EQ(bench.take_counters().fragments, 3u);

    bench.clear();
    bench.draw(Primitive::Triangles, {{0, 0, 0}, {0, 2, 0}, {3, 0, 0}});  // clockwise
    EXPECT_EQ(bench.coverage(0, 0), 255);
    EXPECT_EQ(bench.coverage(1, 0), 234);
    EXPECT_EQ(bench.coverage(2, 0), 85);
    EXPECT_EQ(bench.coverage(0, 1), 170);
    EXPECT_EQ(bench.coverage(1, 1), 21);
}

// [R9.23]
TEST(ManualAntialiasing, APixelOfCoverageZeroHasNoFragment) {
    SmoothBench bench;
    bench.state.depth = {.test = true, .func = DepthFunc::Always};
    bench.clear();
    // 1/600 pixel of the column 1: 0.4 units of coverage. Of the column 0: all.
    bench.draw(Primitive::Quads,
               {{0, 0, 7}, {1.00390625f, 0, 7}, {1.00390625f, 0.375f, 7}, {0, 0.375f, 7}});
    EXPECT_EQ(bench.coverage(0, 0), 96);
    EXPECT_EQ(bench.depth(0, 0), 7u);
    EXPECT_EQ(bench.depth(1, 0), 0xFFFFFFu);
    EXPECT_EQ(bench.take_counters().fragments, 1u);
}

// [R9.25]
TEST(ManualAntialiasing, AllPiecesOfAPolygonAreOneFragment) {
    const std::vector<vec3> square{{1, 1, 0}, {5, 1, 0}, {5, 5, 0}, {1, 5, 0}};
    SmoothBench bench;
    bench.state.blend = {
        .enable = true, .src = BlendFactor::SrcAlpha, .dst = BlendFactor::OneMinusSrcAlpha};
    bench.draw(Primitive::Quads, square);
    EXPECT_EQ(bench.take_counters().fragments, 16u);
    for (int i = 1; i < 5; ++i) EXPECT_EQ(bench.color(i, i)[0], 255) << i;

    // As two triangles of their own: half of half is left.
    bench.clear();
    bench.draw(Primitive::Triangles,
               {square[0], square[1], square[2], square[0], square[2], square[3]});
    EXPECT_EQ(bench.take_counters().fragments, 20u);
    for (int i = 1; i < 5; ++i) EXPECT_EQ(bench.color(i, i)[0], 192) << i;  // 128 + 128 127/255
}

// [R9.25]
TEST(ManualAntialiasing, OutlinesOfAPolygonComeBeforeItsFilledPieces) {
    // A bow tie becomes (3, 0, 1), a filled front face, and (3, 1, 2), a back face as an outline,
    // whose line from (6, 1) to (1, 6) crosses the first one.
    SmoothBench bench;
    bench.state.two_side_polygon_mode = true;
    bench.state.back_polygon_mode = PolygonMode::Line;
    bench.draw(Primitive::Quads, {{1, 1, 0}, {6, 6, 0}, {6, 1, 0}, {1, 6, 0}});
    EXPECT_EQ(bench.take_counters().drawn, 2u);
    EXPECT_EQ(bench.coverage(2, 4), 255);  // the fill's, not the line's
    EXPECT_NE(bench.coverage(4, 2), 0);    // the line's alone
    EXPECT_LT(bench.coverage(4, 2), 255);
}

// [R9.26]
TEST(ManualAntialiasing, ALineIsARectangle) {
    SmoothBench bench;
    bench.draw(Primitive::Lines, {{1, 1.5f, 0}, {4.5f, 1.5f, 0}});
    for (int x = 1; x < 4; ++x) EXPECT_EQ(bench.coverage(x, 1), 255) << x;
    EXPECT_EQ(bench.coverage(4, 1), 128);
    EXPECT_EQ(bench.take_counters().fragments, 4u);

    bench.clear();
    bench.state.line_width = 1.5f;
    bench.draw(Primitive::Lines, {{4.5f, 1.5f, 0}, {1, 1.5f, 0}});
    for (int y : {0, 2}) {
        EXPECT_EQ(bench.coverage(2, y), 64) << y;  // 1/4
        EXPECT_EQ(bench.coverage(4, y), 32) << y;  // 1/8: 31.9
    }
    EXPECT_EQ(bench.coverage(2, 1), 255);

    // A diagonal of width sqrt 2: the rectangle (1, 0) (5, 4) (4, 5) (0, 1).
    bench.clear();
    bench.state.line_width = std::sqrt(2.0f);
    bench.draw(Primitive::Lines, {{0.5f, 0.5f, 0}, {4.5f, 4.5f, 0}});
    for (int i = 1; i < 4; ++i) {
        EXPECT_EQ(bench.coverage(i, i), 255) << i;
        EXPECT_EQ(bench.coverage(i, i - 1), 128) << i;
        EXPECT_EQ(bench.coverage(i - 1, i), 128) << i;
    }
    EXPECT_EQ(bench.coverage(0, 0), 128);
}

// [R9.26]
TEST(ManualAntialiasing, AStippleLeavesOutStepsOfOnePixelLength) {
    SmoothBench bench(opengl(), 16, 8);
    bench.state.line_stipple = {.enable = true, .factor = 2, .pattern = 0x5555};
    bench.draw(Primitive::LineStrip, {{0.5f, 1.5f, 0}, {5.75f, 1.5f, 0}, {5.75f, 7.5f, 0}});
    // Steps of 1 pixel from 0.5 on: two are drawn, two left out. The sixth ends at 5.75.
    const int row[] = {128, 255, 128, 0, 128};
    for (int x = 0; x < 5; ++x) EXPECT_EQ(bench.coverage(x, 1), row[x]) << x;
    // The first line has 6 steps, so the second one begins with two steps that are left out.
    EXPECT_EQ(bench.coverage(5, 2), 0);
    EXPECT_EQ(bench.coverage(5, 3), 96);   // 3/4 wide, the upper half of the pixel: 95.6
    EXPECT_EQ(bench.coverage(5, 4), 191);  // 3/4: 191.25
}

// [R9.27]
TEST(ManualAntialiasing, APointIsADisc) {
    SmoothBench bench;
    bench.state.point_size = 2;
    bench.draw(Primitive::Points, {{2, 2, 0}});
    for (const auto& [x, y] : {std::pair(1, 1), {2, 1}, {1, 2}, {2, 2}})
        EXPECT_EQ(bench.coverage(x, y), 200);  // pi / 4: 200.28
    EXPECT_EQ(bench.take_counters().fragments, 4u);

    bench.clear();
    bench.state.point_size = 1;
    bench.draw(Primitive::Points, {{4.5f, 4.5f, 0}});
    EXPECT_EQ(bench.coverage(4, 4), 200);
    bench.clear();
    bench.state.point_size = 6;
    bench.draw(Primitive::Points, {{4, 4, 0}});
    EXPECT_EQ(bench.coverage(4, 4), 255);
    EXPECT_EQ(bench.coverage(0, 0), 0);
}

// [R9.28]
TEST(ManualAntialiasing, ValuesOutsideAreLimitedToTheCorners) {
    Profile profile = opengl();
    profile.perspective_color = false;
    SmoothBench bench(profile);
    bench.state.depth = {.test = true, .func = DepthFunc::Always};
    bench.clear();
    // Depth 1000 x and red 51 x, from x = 1.75 to 4.25. The centre of column 1 lies 1/4 outside: it
    // has the values of x = 1.75 and not of 1.5. So has column 4 those of 4.25.
    const auto z = [](float x) { return 1000 * x; };
    const auto red = [](float x) { return vec4(x / 5, 0, 0, 1); };
    bench.draw(
        Primitive::Quads,
        {{1.75f, 1, z(1.75f)}, {4.25f, 1, z(4.25f)}, {4.25f, 3, z(4.25f)}, {1.75f, 3, z(1.75f)}},
        {red(1.75f), red(4.25f), red(4.25f), red(1.75f)});
    EXPECT_EQ(bench.depth(1, 1), 1750u);
    EXPECT_EQ(bench.depth(2, 1), 2500u);
    EXPECT_EQ(bench.depth(4, 1), 4250u);
    EXPECT_EQ(bench.color(1, 1), (Rgba{89, 0, 0, 64}));    // 51 1.75 = 89.25
    EXPECT_EQ(bench.color(2, 1), (Rgba{127, 0, 0, 255}));  // 89 + 0.3 128 = 127.4
    EXPECT_EQ(bench.color(4, 1), (Rgba{217, 0, 0, 64}));   // 216.75

    // A line's ends alike.
    bench.clear();
    bench.state.line_width = 1;
    bench.draw(Primitive::Lines, {{1.75f, 5.5f, 1750}, {4.25f, 5.5f, 4250}},
               {red(1.75f), red(4.25f)});
    EXPECT_EQ(bench.depth(1, 5), 1750u);
    EXPECT_EQ(bench.depth(3, 5), 3500u);
    EXPECT_EQ(bench.depth(4, 5), 4250u);
}

// [R9.29]
TEST(ManualAntialiasing, CoverageMultipliesAlphaBeforeTheAlphaTest) {
    SmoothBench bench;
    const vec4 half{1, 1, 1, 0.5f};  // alpha 128
    const std::vector<vec3> square{{1.5f, 1, 0}, {3, 1, 0}, {3, 2, 0}, {1.5f, 2, 0}};
    bench.draw(Primitive::Quads, square, {half, half, half, half});
    EXPECT_EQ(bench.color(1, 1), (Rgba{255, 255, 255, 64}));  // 128 128 / 255 = 64.25
    EXPECT_EQ(bench.color(2, 1), (Rgba{255, 255, 255, 128}));
    bench.take_counters();
    bench.state.alpha = {.test = true, .func = AlphaFunc::Greater, .ref = 0.3f};
    bench.draw(Primitive::Quads, square, {half, half, half, half});
    const Counters c = bench.take_counters();
    EXPECT_EQ(c.alpha_killed, 1u);
    EXPECT_EQ(c.written, 1u);
}

// [R9.29]
TEST(ManualAntialiasing, CoverageHasTheProfilesBits) {
    Profile profile = opengl();
    const auto quarter = [&](int bits) {
        profile.coverage_bits = bits;
        SmoothBench bench(profile);
        bench.draw(Primitive::Quads, {{1.25f, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1.25f, 2, 0}});
        return bench.coverage(1, 1);
    };
    EXPECT_EQ(quarter(1), 255);   // 3/4 of 1 rounds to 1
    EXPECT_EQ(quarter(2), 170);   // 2.25: 2 of 3
    EXPECT_EQ(quarter(4), 187);   // 11.25: 11 of 15
    EXPECT_EQ(quarter(8), 191);   // 191.25
    EXPECT_EQ(quarter(16), 191);  // 49151 of 65535
}

// [R9.30]
TEST(ManualAntialiasing, AStippleLeavesOutWholePixels) {
    SmoothBench bench;
    std::array<std::uint32_t, 32> rows;
    rows.fill(0xAAAAAAAA);
    bench.state.polygon_stipple = {std::make_shared<const std::array<std::uint32_t, 32>>(rows)};
    bench.draw(Primitive::Quads, {{0.5f, 0.5f, 0}, {4, 0.5f, 0}, {4, 4, 0}, {0.5f, 4, 0}});
    EXPECT_EQ(bench.coverage(0, 1), 128);
    EXPECT_EQ(bench.coverage(1, 1), 0);
    EXPECT_EQ(bench.coverage(2, 1), 255);
}

// [R9.4] [R9.5]
TEST(ManualAntialiasing, OtherSizesAreRounded) {
    SmoothBench bench;
    bench.state.line_smooth = bench.state.point_smooth = false;
    const auto rows = [&](float width) {
        bench.state.line_width = bench.state.point_size = width;
        bench.draw(Primitive::Lines, {{1, 4.5f, 0}, {2, 4.5f, 0}});
        const auto line = bench.take_counters().fragments;
        bench.draw(Primitive::Points, {{4, 4, 0}});
        EXPECT_EQ(bench.take_counters().fragments, line * line);
        return int(line);
    };
    EXPECT_EQ(rows(1.25f), 1);
    EXPECT_EQ(rows(1.5f), 2);
    EXPECT_EQ(rows(2.5f), 3);
    EXPECT_EQ(rows(3.49f), 3);
}

// [R1.4]
TEST(ManualAntialiasing, IsRefusedByNameWithoutCoverageBits) {
    for (const Profile& profile : paper_profiles())
        for (bool State::*smooth :
             {&State::point_smooth, &State::line_smooth, &State::polygon_smooth}) {
            Workbench bench(profile, 8, 8);
            bench.state.*smooth = true;
            EXPECT_EQ(
                test::error_of([&] { bench.clear(); }),
                "command 0 (SetState): extension antialiasing is not in profile " + profile.name);
        }
}

}  // namespace
}  // namespace gw
