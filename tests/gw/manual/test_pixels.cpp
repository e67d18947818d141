// docs/manual/pixels.md: the worked examples.
#include "tests/gw/workbench.h"

#include <algorithm>

namespace gw {
namespace {

using test::Workbench;

// [R13.5]
TEST(ManualPixels, OverlappingCopies) {
    Workbench bench(vgx(), 16, 4);
    bench.run(WritePixels{{4, 0, 4, 1}, Plane::Depth, {}, {1, 2, 3, 4}, 0});
    bench.run(Copy{Plane::Depth, {4, 0, 4, 1}, 5, 0});
    for (const auto& [x, depth] : {std::pair(4, 1u), {5, 1u}, {6, 2u}, {7, 3u}, {8, 4u}, {9, 0u}})
        EXPECT_EQ(bench.depth(x, 0), depth) << x;
    // Upwards and to the left, beyond the window. Pixels without a source stay.
    bench.run(Copy{Plane::Depth, {-2, -1, 12, 3}, -1, 0});
    for (const auto& [x, depth] : {std::pair(4, 0u), {5, 1u}, {6, 1u}, {7, 2u}, {8, 3u}, {9, 4u}})
        EXPECT_EQ(bench.depth(x, 1), depth) << x;
    EXPECT_EQ(bench.depth(4, 0), 1u);
}

// [R4.4] [R13.1] [R13.2] [R13.4]
TEST(ManualPixels, MasksAndScissorGuardEveryPlane) {
    Workbench bench(vgx(), 8, 8);
    bench.state.scissor = {true, {2, 2, 3, 3}};
    bench.state.color_mask = {false, true, true, true};
    bench.state.stencil.write_mask = 0x0F;
    bench.clear(all_planes, vec4(1), 1, 255);
    EXPECT_EQ(bench.take_counters().pixels, 4u * 9);
    EXPECT_EQ(bench.color(2, 2), (Rgba{0, 255, 255, 255}));
    EXPECT_EQ(bench.color(1, 2), (Rgba{}));
    EXPECT_EQ(bench.stencil(4, 4), 15);
    EXPECT_EQ(bench.stencil(5, 4), 0);
    EXPECT_EQ(bench.depth(3, 3), 16777215u);
}

// [R13.8] [R13.9]
TEST(ManualPixels, AccumulationByHand) {
    Workbench bench(vgx(), 1, 1);
    const auto acc = [&] { return bench.accum(0, 0)[0]; };
    bench.write({0, 0, 1, 1}, {100, 0, 0, 0});
    bench.run(Accumulate{AccumOp::Load, 1});
    bench.write({0, 0, 1, 1}, {255, 0, 0, 0});
    bench.run(Accumulate{AccumOp::Accum, 0.5f});
    EXPECT_EQ(acc(), 228);
    bench.run(Accumulate{AccumOp::Mult, -1});
    EXPECT_EQ(acc(), -228);
    bench.run(Accumulate{AccumOp::Return, 1});
    EXPECT_EQ(bench.color(0, 0)[0], 0);
    bench.write({0, 0, 1, 1}, {253, 0, 0, 0});
    bench.run(Accumulate{AccumOp::Load, 0.5f});
    EXPECT_EQ(acc(), 126);
    bench.run(Accumulate{AccumOp::Add, 1});
    EXPECT_EQ(acc(), 381);
    EXPECT_EQ(bench.take_counters().accum_overflows, 0u);
}

// [R13.8] [R13.16] [R13.19]
TEST(ManualPixels, AccumulationOfFractions) {
    Workbench bench(opengl(), 1, 1);
    bench.run(Clear{.planes = mask_of(Plane::Accum), .accum = {0.5f, -1, 0, 1}});
    EXPECT_EQ(bench.accum(0, 0), (std::array{127 * 65536 + 32768, -255 * 65536, 0, 255 * 65536}));
    bench.clear(mask_of(Plane::Color), vec4(102 / 255.0f));
    bench.run(Accumulate{AccumOp::Load, 1 / 64.0f});
    EXPECT_EQ(bench.accum(0, 0)[0], 104448);
    for (int i = 1; i < 64; ++i) bench.run(Accumulate{AccumOp::Accum, 1 / 64.0f});
    EXPECT_EQ(bench.accum(0, 0)[0], 6684672);
    bench.clear(mask_of(Plane::Color), vec4(0));
    bench.run(Accumulate{AccumOp::Return, 1});
    EXPECT_EQ(bench.color(0, 0)[0], 102);
}

// [R13.16]
TEST(ManualPixels, AccumulationIsClearedToAValue) {
    Workbench bench(vgx(), 8, 8);
    bench.state.scissor = {true, {1, 2, 5, 3}};
    bench.run(Clear{.planes = mask_of(Plane::Accum), .accum = {0.5f, -0.25f, 2, -1}});
    EXPECT_EQ(bench.accum(5, 4), (std::array{128, -64, 255, -255}));
    EXPECT_EQ(bench.accum(6, 4), (std::array{0, 0, 0, 0}));
    EXPECT_EQ(bench.take_counters().pixels, 15u);
    bench.run(Clear{.planes = mask_of(Plane::Color), .accum = vec4(1)});
    EXPECT_EQ(bench.accum(5, 4)[0], 128);  // another plane
}

// [R13.9] [R13.16]
TEST(ManualPixels, AClearedValueOfTooManyBitsIsWrapped) {
    Profile deep = vgx();
    deep.color_bits = 16;
    Workbench bench(deep, 1, 1);
    bench.run(Clear{.planes = mask_of(Plane::Accum), .accum = {1, -1, 0.5f, 0}});
    EXPECT_EQ(bench.accum(0, 0), (std::array{-1, 1, -32768, 0}));
    EXPECT_EQ(bench.take_counters().accum_overflows, 0u);
}

// [R12.2] [R12.3] [R13.3]
TEST(ManualPixels, SpansAndRectanglesAreFragments) {
    Workbench bench(vgx(), 8, 8);
    bench.clear();
    bench.state.depth.test = true;
    bench.write({0, 0, 8, 8}, {1, 1, 1, 1}, 100);
    bench.run(WriteSpans{
        {{-2, 3, 6, 0, false}},
        {{2, 0, 0, 0}, {3, 0, 0, 0}, {4, 0, 0, 0}, {5, 0, 0, 0}, {6, 0, 0, 0}, {7, 0, 0, 0}},
        99});
    EXPECT_EQ(bench.color(0, 3)[0], 4);  // the first two lie outside
    EXPECT_EQ(bench.color(3, 3)[0], 7);
    EXPECT_EQ(bench.depth(3, 3), 99u);
    bench.write({0, 0, 8, 8}, {9, 9, 9, 9}, 100);  // Less: nowhere
    EXPECT_EQ(bench.color(5, 5)[0], 1);
}

/// Across whole blocks and tiles of the fast machine and across parts of them.
// [R13.7]
TEST(ManualPixels, PackedColorsAreWordsRLowest) {
    Workbench bench(vgx(), 80, 80);
    bench.clear(all_planes, vec4(1, 0, 0, 0));
    bench.write({3, 2, 70, 71}, {0x11, 0x22, 0x33, 0x44});
    bench.run(Read{.key = 1, .rect = {2, 1, 75, 74}, .packed = true});
    const Readback& read = bench.readbacks().at(1);
    EXPECT_TRUE(read.color.empty());
    ASSERT_EQ(read.values.size(), 75u * 74u);
    for (std::size_t i = 0; i < read.values.size(); ++i) {
        const std::size_t x = i % 75, y = i / 75;
        const bool written = x >= 1 && x < 71 && y >= 1 && y < 72;
        ASSERT_EQ(read.values[i], written ? 0x44332211u : 0x000000FFu) << x << ", " << y;
    }
}

TEST(ManualPixels, OnlyColorsOfEightBitsArePacked) {
    Workbench bench(vgx(), 8, 8), deep(ideal(), 8, 8);
    const auto read = [](Workbench& b, Plane plane) {
        return test::error_of([&] {
            b.run(Read{.plane = plane, .rect = {0, 0, 8, 8}, .packed = true});
        });
    };
    EXPECT_EQ(read(bench, Plane::Depth),
              "command 1 (Read): plane of packed pixels = 1; expected Color");
    EXPECT_EQ(read(deep, Plane::Color),
              "command 1 (Read): color_bits of packed pixels = 16; expected at most 8");
}

/// One row of `count` colours 1, 2, ... in R, drawn from a corner.
DrawPixels row_of(int count, double x, double zoom_x) {
    DrawPixels d{.width = count, .height = 1, .raster = {.x = x}, .zoom_x = zoom_x};
    for (int i = 1; i <= count; ++i) d.colors.push_back({std::uint16_t(i), 0, 0, 0});
    return d;
}

/// The red of the lowest row.
std::vector<int> reds(Workbench& bench) {
    std::vector<int> out;
    for (int x = 0; x < bench.planes().width; ++x) out.push_back(bench.color(x, 0)[0]);
    return out;
}

// [R13.10]
TEST(ManualPixels, ZoomedColumns) {
    Workbench bench(opengl(), 8, 2);
    bench.run(row_of(3, 2.25, 1.5));
    EXPECT_EQ(reds(bench), (std::vector<int>{0, 0, 1, 1, 2, 3, 3, 0}));
    EXPECT_EQ(bench.color(2, 1)[0], 0);
    bench.clear();
    bench.run(row_of(3, 2.25, -1.5));
    EXPECT_EQ(reds(bench), (std::vector<int>{2, 1, 0, 0, 0, 0, 0, 0}));
    bench.clear();
    bench.run(row_of(3, 8, -1));  // mirrored, and its right edge is the window's
    EXPECT_EQ(reds(bench), (std::vector<int>{0, 0, 0, 0, 0, 3, 2, 1}));
    bench.clear();
    bench.run(row_of(8, 2, 0.25));  // the third and the seventh begin at a centre
    EXPECT_EQ(reds(bench), (std::vector<int>{0, 0, 3, 7, 0, 0, 0, 0}));
    bench.clear();
    bench.run(row_of(3, 2, 0));
    bench.run(row_of(3, -1e300, 1e300));
    EXPECT_EQ(reds(bench), (std::vector<int>{2, 2, 2, 2, 2, 2, 2, 2}));
}

/// The window's edge cuts a block: its columns 1, 4 and, repeated, 4, 4 are not adjacent.
TEST(ManualPixels, ZoomedColumnsAtAnEdge) {
    Workbench bench(opengl(), 6, 4);
    bench.run(row_of(9, 4, 1.0 / 3));
    EXPECT_EQ(reds(bench), (std::vector<int>{0, 0, 0, 0, 2, 5}));
}

/// Every zoom covers each pixel once: drawn twice under Incr the stencil counts 1.
TEST(ManualPixels, NeighboursInARectangleShareNoPixel) {
    Workbench bench(opengl(), 64, 64);
    bench.state.stencil = {.test = true, .zpass = StencilOp::Incr};
    for (const double zoom : {0.3, 0.7, 1.0, 1.1, 2.5, -0.3, -1.7}) {
        bench.clear();
        DrawPixels d{.width = 20, .height = 20, .raster = {.x = 30.2, .y = 31.7}};
        d.zoom_x = zoom;
        d.zoom_y = -zoom;
        bench.run(d);
        const auto most =
            *std::max_element(bench.planes().stencil.begin(), bench.planes().stencil.end());
        EXPECT_EQ(most, 1) << zoom;
        bench.take_counters();
    }
}

// [R13.11] An L of 9 x 2 in the raster colour, as glBitmap draws it.
TEST(ManualPixels, BitsChooseThePixels) {
    Workbench bench(opengl(), 16, 4);
    DrawPixels d{.width = 9, .height = 2, .raster = {.x = 1, .y = 1}};
    d.raster.color = {9, 8, 7, 6};
    d.raster.depth = 5;
    d.bits = {0b10000001, 0b10000000, 0b10000000, 0b01111111};
    bench.state.depth = {.test = true, .func = DepthFunc::Always};
    bench.run(d);
    for (int x = 0; x < 16; ++x) {
        EXPECT_EQ(bench.color(x, 1)[0], x == 1 || x == 8 || x == 9 ? 9 : 0) << x;
        EXPECT_EQ(bench.color(x, 2)[0], x == 1 ? 9 : 0) << x;
    }
    EXPECT_EQ(bench.depth(1, 1), 5u);
    EXPECT_EQ(bench.take_counters().written, 4u);
}

// [R13.12] Depths with and without colours, one colour and depth for all others.
TEST(ManualPixels, DepthsAreFragmentsInTheRasterColor) {
    Workbench bench(opengl(), 4, 4);
    bench.clear(all_planes, vec4(0), 0);
    bench.state.depth = {.test = true, .func = DepthFunc::Greater};
    DrawPixels d{.width = 2, .height = 1, .depths = {0, 7}};
    d.raster.color = {1, 2, 3, 4};
    bench.run(d);
    EXPECT_EQ(bench.color(0, 0), (Rgba{}));
    EXPECT_EQ(bench.color(1, 0), (Rgba{1, 2, 3, 4}));
    EXPECT_EQ(bench.depth(1, 0), 7u);
    d.colors = {{5, 0, 0, 0}, {6, 0, 0, 0}};
    d.depths = {8, 8};
    bench.run(d);
    EXPECT_EQ(bench.color(0, 0)[0], 5);
    EXPECT_EQ(bench.color(1, 0)[0], 6);
    EXPECT_EQ(bench.take_counters().depth_killed, 1u);
}

// [R13.12] Fog of 11's example; [R13.13] texel 1 of a row of two, doubled by q = 1/2.
TEST(ManualPixels, TheRasterPositionIsTexturedAndFogged) {
    Workbench bench(opengl(), 4, 4);
    DrawPixels d = row_of(1, 0, 1);
    d.colors = {{255, 255, 255, 255}};
    d.raster.distance = 1;
    bench.state.fog = {
        .enable = true, .mode = FogMode::Linear, .start = 0, .end = 4, .color = {0, 0, 1, 1}};
    bench.run(d);
    EXPECT_EQ(bench.color(0, 0), (Rgba{191, 191, 255, 255}));
    bench.state.fog = {};
    bench.state.texture.mag_filter = MagFilter::Nearest;
    bench.state.color_source = ColorSource::PolygonId;  // of draws only
    const std::vector<std::uint8_t> texels{10, 20, 30, 40, 50, 60, 70, 80};
    d.map.texture = make_texture8("two", 2, 1, texels);
    d.raster.texcoord = {0.125f, 0, 0, 0.5f};
    bench.run(d);
    EXPECT_EQ(bench.color(0, 0), (Rgba{10, 20, 30, 40}));
    d.raster.texcoord.x = 0.25f;
    bench.run(d);
    EXPECT_EQ(bench.color(0, 0), (Rgba{50, 60, 70, 80}));
    bench.state.texture.mag_filter = MagFilter::Linear;
    bench.run(d);  // at the edge of both: half of each
    EXPECT_EQ(bench.color(0, 0), (Rgba{30, 40, 50, 60}));
    d.raster.texcoord.w = 0;
    bench.run(d);
    EXPECT_EQ(bench.color(0, 0), (Rgba{255, 255, 255, 255}));
    EXPECT_EQ(bench.take_counters().texels, 4u * 4);  // of the initial min_filter
}

// [R13.12] [R8.13]
TEST(ManualPixels, TheSumDependsOnTheColourSource) {
    Workbench bench(opengl(), 1, 1);
    State& s = bench.state;
    DrawPixels d{.width = 1, .height = 1, .colors = {{100, 50, 0, 255}}};
    d.raster.secondary_color = {60, 0, 0, 0};
    d.raster.distance = 0.5;
    s.fog = {.enable = true, .mode = FogMode::Linear, .start = 0, .end = 1, .color = {0, 0, 1, 0}};
    s.color_sum = true;
    const auto drawn = [&](ColorSource source, bool separate_specular = false) {
        s.color_source = source;
        s.lighting.separate_specular = separate_specular;
        bench.run(d);
        return bench.color(0, 0);
    };
    EXPECT_EQ(drawn(ColorSource::Vertex), (Rgba{80, 25, 127, 255}));
    EXPECT_EQ(drawn(ColorSource::PolygonId), (Rgba{50, 25, 127, 255}));
    EXPECT_EQ(drawn(ColorSource::Lighting), (Rgba{50, 25, 127, 255}));
    EXPECT_EQ(drawn(ColorSource::Lighting, true), (Rgba{80, 25, 127, 255}));
}

// [R13.13]
TEST(ManualPixels, TheRasterPositionIsComparedWithADepthSlot) {
    Profile profile = opengl();
    profile.extensions.shadow_texture = true;
    Workbench bench(profile, 2, 1);
    bench.run(WritePixels{{0, 0, 2, 1}, Plane::Depth, {}, {1u << 22, 1u << 23}, 0});
    bench.run(CopyTexture{0, Plane::Depth, {0, 0, 2, 1}});
    bench.state.texture.shadow_compare = true;
    DrawPixels d{.width = 1, .height = 1};
    d.raster.color = {255, 255, 255, 255};
    d.map.slot = 0;
    for (const auto& [s, lit] : {std::pair(0.25f, false), {0.75f, true}}) {
        d.raster.texcoord = {s, 0, 0.5f, 1};  // r is 2^23
        bench.run(d);
        EXPECT_EQ(bench.color(0, 0)[0], lit ? 255 : 0);
    }
}

// [R13.14]
TEST(ManualPixels, StencilRectanglesMakeNoFragments) {
    Workbench bench(opengl(), 4, 4);
    bench.state.stencil.write_mask = 6;
    bench.state.alpha = {true, CompareFunc::Never};
    DrawPixels d{.width = 2, .height = 1, .raster = {.x = 1}, .zoom_y = 2, .stencils = {255, 9}};
    d.bits = {0b01000000};
    bench.run(d);
    EXPECT_EQ(bench.stencil(1, 0), 0);
    EXPECT_EQ(bench.stencil(2, 0), 0);  // 9 & 6
    d.bits = {};
    bench.run(d);
    EXPECT_EQ(bench.stencil(1, 1), 6);
    const Counters c = bench.take_counters();
    EXPECT_EQ(c.fragments, 0u);
    EXPECT_EQ(c.pixels, 2u + 4);
    EXPECT_EQ(c.bytes, 2u + 4);
}

// [R13.15] A copy over itself, twice as large; pixels from outside the window are not drawn.
TEST(ManualPixels, CopiesAreFragmentsOfThePresentValues) {
    Workbench bench(opengl(), 8, 1);
    bench.run(row_of(8, 0, 1));
    DrawPixels d{.width = 4, .height = 1, .raster = {.x = 0}, .zoom_x = 2};
    d.source = PixelSource{Plane::Color, -1, 0};
    bench.take_counters();
    bench.run(d);
    EXPECT_EQ(reds(bench), (std::vector<int>{1, 2, 1, 1, 2, 2, 3, 3}));
    const Counters c = bench.take_counters();
    EXPECT_EQ(c.fragments, 6u);
    EXPECT_EQ(c.pixels, 3u);
    EXPECT_EQ(c.bytes, 3u * 4 + 6 * 4);
    bench.run(WritePixels{{0, 0, 2, 1}, Plane::Stencil, {}, {3, 4}, 0});
    d.source = PixelSource{Plane::Stencil, 0, 0};
    bench.run(d);
    EXPECT_EQ(bench.stencil(1, 0), 3);
    EXPECT_EQ(bench.stencil(3, 0), 4);
    bench.run(WritePixels{{0, 0, 2, 1}, Plane::Depth, {}, {3, 4}, 0});
    bench.state.depth = {.test = true, .func = DepthFunc::Always};
    d.source = PixelSource{Plane::Depth, 0, 0};
    d.raster.color = {9, 9, 9, 9};
    bench.run(d);
    EXPECT_EQ(bench.depth(3, 0), 4u);
    EXPECT_EQ(bench.color(3, 0)[0], 9);
}

}  // namespace
}  // namespace gw
