// Stencil, masks, culling, alpha test, blending, pixel rectangles, copies and accumulation through
// Mesa and us.
#include "tests/peer/compare.h"

namespace gw {
namespace {

using namespace test;

class Fragments : public Driver {};
INSTANTIATE_TEST_SUITE_P(AgainstMesa, Fragments, testing::Values("llvmpipe", "softpipe"),
                         [](const auto& driver) { return std::string(driver.param); });

template <typename Enum>
Enum pick(Random& random, Enum last) {
    return Enum(random.between(0, std::int64_t(last)));
}

State random_tests(Random& random) {
    State s = window_state();
    s.shade_model = ShadeModel::Flat;
    s.stencil = {.test = !random.one_in(8),
                 .func = pick(random, StencilFunc::Always),
                 .ref = int(random.between(0, 255)),
                 .mask = std::uint32_t(random.between(0, 255)),
                 .fail = pick(random, StencilOp::Invert),
                 .zfail = pick(random, StencilOp::Invert),
                 .zpass = pick(random, StencilOp::Invert),
                 .write_mask = random.one_in(2) ? 255 : std::uint32_t(random.between(0, 255))};
    s.depth = {.test = !random.one_in(4),
               .func = pick(random, DepthFunc::Always),
               .mask = !random.one_in(4)};
    s.alpha = {
        .test = random.one_in(3), .func = pick(random, AlphaFunc::Always), .ref = 128.0f / 255};
    s.cull = {.enable = random.one_in(3),
              .face = pick(random, Face::FrontAndBack),
              .front = pick(random, Winding::CCW)};
    s.scissor = {.test = random.one_in(2), .box = {int(random.between(0, 20)), 5, 37, 50}};
    s.color_mask = {!random.one_in(4), !random.one_in(4), true, !random.one_in(4)};
    return s;
}

struct Scene {
    std::vector<GridTriangle> triangles;
    CommandList list;
};

/// Triangles of constant depth, multiples of 2^16, each with tests of its own.
Scene tested_scene(Random& random) {
    Scene s;
    s.list.add(Clear{all_planes, random_color(random), 0.5, int(random.between(0, 255))});
    for (int i = 0; i < 12; ++i) {
        s.triangles.push_back(random_triangle(random));
        const std::int64_t z = random.between(0, 255) << 16;
        const vec4 color = random_color(random);
        add(s.list, random_tests(random),
            Draw{.mesh = make_mesh(mesh_of(s.triangles.back(), {z, z, z}, {color, color, color}))});
    }
    return s;
}

TEST_P(Fragments, StencilDepthAlphaCullScissorAndMasksAgree) {
    std::vector<Scene> scenes;
    std::vector<CommandList> lists;
    Random random(3);
    for (int i = 0; i < 150; ++i) lists.push_back(scenes.emplace_back(tested_scene(random)).list);
    const std::vector<Planes> ours = execute(lists, size, size), theirs = play(lists).planes;
    Tally stencil, color, depth;
    for (std::size_t i = 0; i < scenes.size(); ++i)
        for_pixels([&](int x, int y, std::size_t p) {
            if (near_side(scenes[i].triangles, x, y)) return;
            stencil.add(std::abs(ours[i].stencil[p] - theirs[i].stencil[p]));
            color.add(difference(ours[i].color[p], theirs[i].color[p]));
            depth.add(std::abs(double(ours[i].depth[p]) - double(theirs[i].depth[p])));
        });
    report(GetParam(), "stencil after 12 triangles with random tests", stencil);
    report(GetParam(), "... their flat colours", color);
    report(GetParam(), "... their constant depths", depth);
    EXPECT_GT(stencil.compared, 400000);
    EXPECT_EQ(stencil.different, 0);
    EXPECT_EQ(color.different, 0);
    EXPECT_LE(depth.worst, 1);
}

WritePixels random_pixels(Random& random) {
    WritePixels w{.rect = {0, 0, size, size}};
    for (int i = 0; i < size * size; ++i) {
        const std::uint64_t bits = random.next();
        w.colors.push_back({std::uint16_t(bits & 255), std::uint16_t(bits >> 8 & 255),
                            std::uint16_t(bits >> 16 & 255), std::uint16_t(bits >> 24 & 255)});
    }
    return w;
}

bool is_source_factor(BlendFactor f) {
    return f != BlendFactor::SrcColor && f != BlendFactor::OneMinusSrcColor;
}
bool is_destination_factor(BlendFactor f) {
    return f != BlendFactor::DstColor && f != BlendFactor::OneMinusDstColor &&
           f != BlendFactor::SrcAlphaSaturate;
}

TEST_P(Fragments, EachPairOfBlendFactorsIsWithinOneUnit) {
    std::vector<CommandList> lists;
    Random random(4);
    for (int s = 0; s <= int(BlendFactor::SrcAlphaSaturate); ++s)
        for (int d = 0; d <= int(BlendFactor::SrcAlphaSaturate); ++d) {
            if (!is_source_factor(BlendFactor(s)) || !is_destination_factor(BlendFactor(d)))
                continue;
            CommandList& list = lists.emplace_back();
            State state = window_state();
            add(list, state, random_pixels(random));
            state.blend = {.enable = true, .src = BlendFactor(s), .dst = BlendFactor(d)};
            add(list, state, random_pixels(random));
        }
    const Tally tally = compare_colors(execute(lists, size, size), play(lists).planes);
    report(GetParam(), "one blend, every pair of factors", tally);
    EXPECT_EQ(tally.compared, 72L * size * size);
    EXPECT_LE(tally.worst, 1);
}

/// 64 layers of "over" with alpha about a half, then 40 of One, One.
CommandList layers() {
    Random random(5);
    CommandList list;
    State state = window_state();
    add(list, state, random_pixels(random));
    state.blend = {
        .enable = true, .src = BlendFactor::SrcAlpha, .dst = BlendFactor::OneMinusSrcAlpha};
    for (int i = 0; i < 64; ++i) add(list, state, random_pixels(random));
    state.blend.src = state.blend.dst = BlendFactor::One;
    const std::vector<Rgba> dim(size * size, Rgba{1, 2, 3, 1});
    for (int i = 0; i < 40; ++i)
        add(list, state, WritePixels{.rect = {0, 0, size, size}, .colors = dim});
    return list;
}

/// softpipe keeps a tile in floats between blends, so its sums are no reference: only told.
TEST_P(Fragments, ManyLayers) {
    const Tally tally = compare_colors(execute({layers()}, size, size), play({layers()}).planes);
    report(GetParam(), "64 layers over one another, 40 sums", tally);
    EXPECT_LE(tally.worst, 2);
}

CommandList pixel_commands(Random& random) {
    CommandList list;
    State state = window_state();
    state.depth.mask = true;
    state.stencil.write_mask = 0x3F;
    state.color_mask.g = false;
    list.add(Clear{all_planes, {1, 0.5f, 0.25f, 1}, 0.75, 5});
    add(list, state, random_pixels(random));
    WritePixels depth{.rect = {3, 4, 40, 30}, .plane = Plane::Depth},
        stencil{.rect = {9, 2, 20, 60}, .plane = Plane::Stencil};
    for (int i = 0; i < 1200; ++i) {
        depth.values.push_back(std::uint32_t(random.between(0, 16777215)));
        stencil.values.push_back(std::uint32_t(random.between(0, 255)));
    }
    list.add(depth);
    list.add(stencil);
    for (const Plane plane : {Plane::Color, Plane::Depth, Plane::Stencil})
        list.add(Copy{plane, {5, 5, 30, 25}, 20, 21});
    list.add(WriteSpans{{{4, 60, 20, 0, true}, {-3, 61, 10, 1, false}},
                        {{9, 8, 7, 6},
                         {1, 1, 1, 1},
                         {2, 2, 2, 2},
                         {3, 3, 3, 3},
                         {4, 4, 4, 4},
                         {5, 5, 5, 5},
                         {6, 6, 6, 6},
                         {7, 7, 7, 7},
                         {8, 8, 8, 8},
                         {9, 9, 9, 9},
                         {10, 10, 10, 10}}});
    return list;
}

TEST_P(Fragments, RectanglesSpansAndCopiesAgree) {
    Random random(6);
    const std::vector<CommandList> lists{pixel_commands(random), pixel_commands(random)};
    const std::vector<Planes> ours = execute(lists, size, size), theirs = play(lists).planes;
    Tally color, stencil, depth;
    for (std::size_t i = 0; i < lists.size(); ++i)
        for_pixels([&](int, int, std::size_t p) {
            color.add(difference(ours[i].color[p], theirs[i].color[p]));
            stencil.add(std::abs(ours[i].stencil[p] - theirs[i].stencil[p]));
            depth.add(std::abs(double(ours[i].depth[p]) - double(theirs[i].depth[p])));
        });
    report(GetParam(), "rectangles, spans, copies: colour", color);
    report(GetParam(), "rectangles, spans, copies: stencil", stencil);
    report(GetParam(), "rectangles, copies: depth", depth);
    EXPECT_EQ(color.different, 0);
    EXPECT_EQ(stencil.different, 0);
    EXPECT_LE(depth.worst, 4);
}

TEST_P(Fragments, AccumulationIsWithinTwoUnits) {
    Random random(7);
    CommandList list;
    list.add(Clear{all_planes});
    for (int i = 0; i < 16; ++i) {
        add(list, window_state(), random_pixels(random));
        list.add(Accumulate{AccumOp::Accum, 1});
    }
    list.add(Accumulate{AccumOp::Return, 1.0f / 16});
    const Tally tally = compare_colors(execute({list}, size, size), play({list}).planes);
    report(GetParam(), "mean of 16 pictures by accumulation", tally);
    EXPECT_LE(tally.worst, 2);
}

}  // namespace
}  // namespace gw
