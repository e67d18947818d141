// docs/manual/fragments.md: the worked examples. tests/gw/exhaustive has every case of the tables.
#include "tests/gw/workbench.h"

namespace gw {
namespace {

using test::Workbench;
const Rect pixel{0, 0, 1, 1};

// [R12.13]
TEST(ManualFragments, TheColourMask) {
    Workbench bench(vgx(), 1, 1);
    bench.write(pixel, {1, 2, 3, 4});
    bench.state.color_mask = {true, false, true, false};
    bench.write(pixel, {10, 0, 0, 0});
    EXPECT_EQ(bench.color(0, 0), (Rgba{10, 2, 0, 4}));
}

// [R12.5] [R12.6] [R12.7]
TEST(ManualFragments, StencilByHand) {
    Workbench bench(vgx(), 1, 1);
    const auto after = [&](const StencilState& state) {
        bench.state.stencil = {};
        bench.clear(mask_of(Plane::Stencil), vec4(0), 1, 5);
        bench.state.stencil = state;
        bench.write(pixel, {});
        return bench.stencil(0, 0);
    };
    EXPECT_EQ(after({.test = true,
                     .func = StencilFunc::Equal,
                     .ref = 3,
                     .mask = 1,
                     .zpass = StencilOp::Invert,
                     .write_mask = 0x0F}),
              10);
    EXPECT_EQ(after({.test = true,
                     .func = StencilFunc::Less,
                     .ref = 3,
                     .fail = StencilOp::Zero,
                     .zpass = StencilOp::Incr}),
              6);
    EXPECT_EQ(after({.test = true,
                     .func = StencilFunc::Greater,
                     .ref = 3,
                     .fail = StencilOp::Zero,
                     .zpass = StencilOp::Incr}),
              0);
    EXPECT_EQ(after({.test = false, .func = StencilFunc::Never, .fail = StencilOp::Zero}), 5);
}

// [R12.1]
TEST(ManualFragments, TestsInTheirOrder) {
    // A fragment that fails the alpha test changes no stencil value; one that fails the stencil
    // test changes no depth.
    Workbench bench(vgx(), 1, 1);
    bench.clear(all_planes, vec4(0), 1, 5);
    bench.take_counters();
    bench.state.alpha = {true, AlphaFunc::Greater, 0.5f};
    bench.state.stencil = {.test = true,
                           .func = StencilFunc::Never,
                           .fail = StencilOp::Incr,
                           .zpass = StencilOp::Zero};
    bench.state.depth.test = true;
    bench.write(pixel, {1, 1, 1, 128}, 7);  // 128 > 128 fails
    EXPECT_EQ(bench.stencil(0, 0), 5);
    bench.write(pixel, {1, 1, 1, 129}, 7);
    EXPECT_EQ(bench.stencil(0, 0), 6);
    EXPECT_EQ(bench.depth(0, 0), 16777215u);
    const Counters c = bench.take_counters();
    EXPECT_EQ(c.fragments, 2u);
    EXPECT_EQ(c.alpha_killed, 1u);
    EXPECT_EQ(c.stencil_killed, 1u);
}

// [R12.14] [R12.15]
TEST(ManualFragments, JoinedColoursByHand) {
    Workbench bench(opengl(), 1, 1);
    const auto joined = [&](const BlendState& blend, const LogicOpState& logic) {
        bench.state.blend = {};
        bench.state.logic_op = {};
        bench.write(pixel, {100, 100, 100, 100});
        bench.state.blend = blend;
        bench.state.logic_op = logic;
        bench.write(pixel, {200, 200, 200, 200});
        return bench.color(0, 0)[0];
    };
    const auto blended = [&](BlendEquation equation) {
        return joined({true, BlendFactor::One, BlendFactor::One, equation}, {});
    };
    EXPECT_EQ(blended(BlendEquation::Subtract), 100);
    EXPECT_EQ(blended(BlendEquation::ReverseSubtract), 0);
    EXPECT_EQ(blended(BlendEquation::Min), 100);
    EXPECT_EQ(blended(BlendEquation::Max), 200);
    const auto logic = [&](LogicOp op) { return joined({true}, {true, op}); };
    EXPECT_EQ(logic(LogicOp::And), 64);
    EXPECT_EQ(logic(LogicOp::AndReverse), 136);
    EXPECT_EQ(logic(LogicOp::Xor), 172);
    EXPECT_EQ(logic(LogicOp::Nor), 19);
    EXPECT_EQ(logic(LogicOp::Invert), 155);
    EXPECT_EQ(logic(LogicOp::Copy), 200);
    EXPECT_EQ(logic(LogicOp::Noop), 100);
    EXPECT_EQ(logic(LogicOp::Set), 255);
}

// [R12.12]
TEST(ManualFragments, AConstantColour) {
    Workbench bench(opengl(), 1, 1);
    bench.write(pixel, {100, 100, 100, 255});
    bench.state.blend = {.enable = true,
                         .src = BlendFactor::ConstantColor,
                         .dst = BlendFactor::OneMinusConstantAlpha,
                         .color = {1, 0.5f, 0, 0.25f}};
    bench.write(pixel, {200, 200, 200, 255});
    // k = (255, 128, 0, 64): mul(100, 191) = 75 (74.90) more than mul(200, k)
    EXPECT_EQ(bench.color(0, 0), (Rgba{255, 175, 75, 255}));
}

// [R12.10] [R12.11] [R12.12]
TEST(ManualFragments, BlendByHand) {
    Workbench bench(vgx(), 1, 1);
    const auto over = [&](BlendFactor src, BlendFactor dst) {
        bench.state.blend = {};
        bench.write(pixel, {100, 100, 100, 255});
        bench.state.blend = {true, src, dst};
        bench.write(pixel, {200, 100, 50, 128});
        return bench.color(0, 0);
    };
    EXPECT_EQ(over(BlendFactor::SrcAlpha, BlendFactor::OneMinusSrcAlpha),
              (Rgba{150, 100, 75, 191}));
    EXPECT_EQ(over(BlendFactor::One, BlendFactor::One), (Rgba{255, 200, 150, 255}));
    EXPECT_EQ(over(BlendFactor::DstColor, BlendFactor::Zero),
              (Rgba{78, 39, 20, 128}));  // 78.43, 39.22, 19.61
    EXPECT_EQ(over(BlendFactor::Zero, BlendFactor::SrcColor), (Rgba{78, 39, 20, 128}));
    EXPECT_EQ(over(BlendFactor::SrcAlphaSaturate, BlendFactor::One),
              (Rgba{100, 100, 100, 255}));  // min(128, 0)
}

TEST(ManualFragments, TheAlphaTestDecidesAlsoWhereNoColorIsWritten) {
    Workbench bench;
    bench.clear();
    bench.state.alpha = {.test = true, .func = AlphaFunc::Greater, .ref = 0.5f};
    bench.state.color_mask = {false, false, false, false};
    bench.state.depth = {.test = true, .func = DepthFunc::Less};
    bench.draw(
        Primitive::Quads,
        {{0, 0, 9}, {8, 0, 9}, {8, 8, 9}, {0, 8, 9}, {8, 0, 9}, {16, 0, 9}, {16, 8, 9}, {8, 8, 9}},
        {vec4(1), vec4(1), vec4(1), vec4(1), vec4(0), vec4(0), vec4(0), vec4(0)});
    EXPECT_EQ(bench.depth(7, 7), 9u);
    EXPECT_EQ(bench.depth(8, 7), 0xFFFFFFu);
    EXPECT_EQ(bench.color(7, 7), (Rgba{}));
    const Counters c = bench.take_counters();
    EXPECT_EQ(c.alpha_killed, 64u);
    EXPECT_EQ(c.written, 64u);
}

}  // namespace
}  // namespace gw
