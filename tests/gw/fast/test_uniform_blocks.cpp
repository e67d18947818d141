// Blocks of one colour or one depth, which the fast machine stores as one value. Reads of them and
// every other following command find the right pixels. The reference machine stores every pixel.
#include "tests/gw/workbench.h"

#include <functional>

namespace gw::test {
namespace {

constexpr int width = 96, height = 80;  ///< the last tiles extend beyond the window

/// Two triangles over most of the window, and a nearer one across the border of two tiles.
MeshRef triangles() {
    return make_mesh(mesh_data(Primitive::Triangles, {{0, 0, 500},
                                                      {96, 0, 500},
                                                      {96, 80, 900},
                                                      {0, 0, 500},
                                                      {96, 80, 900},
                                                      {0, 70, 700},
                                                      {40, 20, 100},
                                                      {90, 30, 100},
                                                      {60, 75, 100}}));
}
const Draw identifiers{.mesh = triangles(), .id_base = 0x123456};

/// Triangles of one depth each: at the depth of a clear, before it and behind it. The first two
/// cover the window.
MeshRef walls() {
    MeshData data = mesh_data(Primitive::Triangles, {});
    for (const float z : {671.0f, 500.0f, 900.0f}) {
        const std::vector<vec3> quad{{0, 0, z}, {96, 0, z}, {96, 80, z}, {0, 80, z}};
        for (const int i : {0, 1, 2, 0, 2, 3}) data.positions.push_back(quad[std::size_t(i)]);
        for (const vec3& p : {vec3(13, 5, z), vec3(70, 30, z), vec3(20, 70, z)})
            data.positions.push_back(p);
    }
    return make_mesh(std::move(data));
}
const Draw level{.mesh = walls(), .id_base = 0x010203};

State item_buffer(const Workbench& bench) {
    State state = bench.state;
    state.depth.test = true;
    state.color_source = ColorSource::PolygonId;
    return state;
}

/// A clear of the window, one of a part, and the identifiers.
void add_items(CommandList& list, State state) {
    list.add(SetState{state});
    list.add(Clear{.planes = all_planes, .color = vec4(0, 0, 1, 1)});
    state.scissor = {.test = true, .box = {5, 6, 70, 3}};
    list.add(SetState{state});
    list.add(Clear{.planes = mask_of(Plane::Color), .color = vec4(0, 1, 0, 1)});
    state.scissor = {};
    list.add(SetState{state});
    list.add(identifiers);
}

TEST(UniformBlocks, AreReadInAnyFormAndFromAnyPlane) {
    Workbench bench(vgx(), width, height);
    const Rect all{0, 0, width, height}, part{3, 7, 83, 66};
    CommandList list;
    add_items(list, item_buffer(bench));
    list.add(Read{.key = 1, .rect = all, .packed = true});
    list.add(Read{.key = 2, .rect = part, .packed = true});
    list.add(Read{.key = 3, .rect = all});
    list.add(Read{.key = 4, .rect = part});
    list.add(Read{.key = 5, .plane = Plane::Depth, .rect = part});
    list.add(Read{.key = 6, .rect = part, .packed = true});
    bench.run(list);
    const auto& reads = bench.readbacks();
    EXPECT_EQ(reads.at(1).values[width * 10 + 90], 0xFF123456u);
    EXPECT_EQ(reads.at(1).values[width * 79], 0xFFFF0000u);
    EXPECT_EQ(reads.at(3).color[width * 40 + 60], (Rgba{0x58, 0x34, 0x12, 0xFF}));
    EXPECT_EQ(reads.at(5).values[83 * (40 - 7) + 60 - 3], 100u);
    EXPECT_EQ(reads.at(2).values, reads.at(6).values);
}

TEST(UniformBlocks, AClearIsReadBeforeAnythingIsDrawn) {
    Workbench bench(vgx(), width, height);
    bench.clear(all_planes, vec4(1, 0, 1, 0), 0.5);
    bench.run(Read{.key = 1, .rect = {1, 1, 90, 70}, .packed = true});
    bench.run(Read{.key = 2, .plane = Plane::Depth, .rect = {1, 1, 90, 70}});
    EXPECT_EQ(bench.readbacks().at(1).values,
              CacheAlignedVector<std::uint32_t>(90 * 70, 0x00FF00FFu));
    EXPECT_EQ(bench.readbacks().at(2).values,
              CacheAlignedVector<std::uint32_t>(90 * 70, 0x800000u));
}

/// The effect of a draw on the colour.
enum class Ink { Stored, Added, None };

/// Draws twice over a clear, with a read between.
void draw_over_clear(const Draw& draw, const DepthState& depth, Ink ink) {
    Workbench bench(vgx(), width, height);
    CommandList list;
    State state = item_buffer(bench);
    list.add(SetState{state});
    list.add(Clear{.planes = all_planes, .color = vec4(0.1f, 0, 0.999f, 1), .depth = 0.00004});
    state.depth = depth;
    state.blend = {ink == Ink::Added, BlendFactor::One, BlendFactor::One};
    if (ink == Ink::None) state.color_mask = {false, false, false, false};
    list.add(SetState{state});
    list.add(draw);
    list.add(Read{.rect = {0, 0, width, height}, .packed = true});
    list.add(draw);
    bench.run(list);
    bench.planes();
}

TEST(UniformBlocks, AreDrawnOverUnderAnyDepthTest) {
    for (const DepthFunc func :
         {DepthFunc::Never, DepthFunc::Less, DepthFunc::Equal, DepthFunc::LEqual,
          DepthFunc::Greater, DepthFunc::NotEqual, DepthFunc::GEqual, DepthFunc::Always})
        for (const bool mask : {false, true})
            for (const Ink ink : {Ink::Stored, Ink::Added, Ink::None}) {
                SCOPED_TRACE(int(func));
                draw_over_clear(identifiers, {true, func, mask}, ink);
                draw_over_clear(level, {true, func, mask}, ink);
            }
}

/// Triangles on a few blocks of one depth, in neighbouring pairs: the halves of quads, some over a
/// tile's border and over each other, the same triangle twice, and thin ones that reach far.
MeshRef pairs() {
    MeshData data = mesh_data(Primitive::Triangles, {});
    const auto add = [&](std::initializer_list<vec3> corners) {
        data.positions.insert(data.positions.end(), corners);
    };
    for (int i = 0; i < 12; ++i) {
        const float x = 7.25f * float(i), y = 5.5f * float(i), z = float(500 + i % 3),
                    right = x + 3 + float(i), up = y + 9;
        add({{x, y, z}, {right, y, z}, {right, up, z}});
        add({{x, y, z}, {right, up, z}, {x, up, z}});
        add({{right, y, z}, {right + 6, y, z}, {right, up, z}});
        add({{right, y, z}, {right + 6, y, z}, {right, up, z}});
        add({{right, y, z}, {right + 5, up, z + 40}, {right, up, z}});
        add({{90 - x, y, z}, {91 - x, y, z}, {x, 77, z}});
    }
    data.colors.assign(data.positions.size(), vec4(0.25f, 0.125f, 0.0625f, 1));
    return make_mesh(std::move(data));
}

TEST(UniformBlocks, TwoTrianglesAreDrawnAsOneOnlyIfNoPixelIsInBoth) {
    for (const Ink ink : {Ink::Stored, Ink::Added, Ink::None})
        for (const DepthFunc func : {DepthFunc::Less, DepthFunc::LEqual, DepthFunc::Always})
            for (const int side : {96, 41}) {
                Workbench bench(vgx(), width, height);
                CommandList list;
                State state = item_buffer(bench);
                list.add(SetState{state});
                list.add(Clear{.planes = all_planes, .color = vec4(0, 0, 0.25f, 1)});
                state.color_source = ColorSource::Vertex;
                state.depth = {true, func, true};
                state.blend = {ink == Ink::Added, BlendFactor::One, BlendFactor::One};
                if (ink == Ink::None) state.color_mask = {false, false, false, false};
                state.scissor = {.test = true, .box = {3, 2, side, side - 20}};
                list.add(SetState{state});
                list.add(Draw{.mesh = pairs()});
                bench.run(list);
                bench.planes();
            }
}

TEST(UniformBlocks, ALevelTriangleMakesThemAgain) {
    Workbench bench(vgx(), width, height);
    State state = item_buffer(bench);
    CommandList list;
    add_items(list, state);
    state.depth.func = DepthFunc::Always;
    list.add(SetState{state});
    list.add(level);
    list.add(identifiers);
    list.add(Read{.key = 1, .plane = Plane::Depth, .rect = {0, 0, width, height}});
    bench.run(list);
    EXPECT_EQ(bench.readbacks().at(1).values[width * 79], 900u);
}

/// Commands that follow the identifiers.
struct Follower {
    const char* name;
    std::function<void(State&, CommandList&)> add;
};

/// A draw of another mesh or state.
Follower draws(const char* name, std::function<void(State&)> change, float x = 10) {
    return {name, [=](State& state, CommandList& list) {
                change(state);
                list.add(SetState{state});
                MeshData data =
                    mesh_data(Primitive::Triangles, {{x, 3, 50}, {90, 9, 800}, {30, 70, 300}},
                              {{1, 0, 0, 1}, {0, 1, 0, 0.5f}, {1, 1, 0, 0}});
                list.add(Draw{.mesh = make_mesh(std::move(data)), .id_base = 0x777777});
            }};
}
Follower adds(
    const char* name, Command command, std::function<void(State&)> change = [](State&) {}) {
    return {name, [=](State& state, CommandList& list) {
                change(state);
                list.add(SetState{state});
                list.add(command);
            }};
}

std::vector<Follower> drawn_followers() {
    return {
        draws("the same way", [](State&) {}),
        draws("blended",
              [](State& s) {
                  s.blend = {true, BlendFactor::One, BlendFactor::One};
              }),
        draws("masked colour",
              [](State& s) {
                  s.color_mask = {true, false, true, false};
              }),
        draws("smooth", [](State& s) { s.color_source = ColorSource::Vertex; }),
        draws("added to what is uniform and what is not",
              [](State& s) {
                  s.depth.func = DepthFunc::Always;
                  s.blend = {true, BlendFactor::One, BlendFactor::One};
              }),
        {"level",
         [](State& s, CommandList& list) {
             s.depth.func = DepthFunc::GEqual;
             list.add(SetState{s});
             list.add(level);
         }},
        {"level, depth only",
         [](State& s, CommandList& list) {
             s.depth.func = DepthFunc::Greater;
             s.color_mask = {false, false, false, false};
             list.add(SetState{s});
             list.add(level);
         }},
        draws("depth only",
              [](State& s) {
                  s.color_mask = {false, false, false, false};
              }),
        draws("alpha test",
              [](State& s) {
                  s.color_source = ColorSource::Vertex;
                  s.alpha = {true, AlphaFunc::Greater, 0.4f};
              }),
        draws("stencil counts",
              [](State& s) {
                  s.stencil.test = true;
                  s.stencil.zpass = StencilOp::Incr;
              }),
        draws("lines",
              [](State& s) {
                  s.polygon_mode = PolygonMode::Line;
                  s.line_width = 3;
              }),
        draws("colours without depth",
              [](State& s) {
                  s.color_source = ColorSource::Vertex;
                  s.depth = {.test = false, .func = DepthFunc::Always, .mask = false};
              }),
        {"depths first, then colours",
         [](State& s, CommandList& list) {
             s.color_source = ColorSource::Vertex;
             s.color_mask = {false, false, false, false};
             draws("depths", [](State&) {}).add(s, list);
             s.color_mask = {};
             s.depth.func = DepthFunc::Equal;
             draws("colours", [](State&) {}).add(s, list);
         }},
        {"visible fragments, twice",
         [](State& s, CommandList& list) {
             s.depth.func = DepthFunc::Equal;
             s.blend = {true, BlendFactor::One, BlendFactor::One};
             list.add(SetState{s});
             list.add(identifiers);
             list.add(identifiers);
         }},
    };
}
std::vector<Follower> other_followers() {
    const auto both = PlaneMask(mask_of(Plane::Color) | mask_of(Plane::Depth));
    const Rect box{30, 30, 9, 11};
    return {
        adds("clear", Clear{.planes = both, .color = vec4(1, 1, 0, 0), .depth = 0.25}),
        adds("clear of a colour",
             Clear{.planes = mask_of(Plane::Color), .color = vec4(1, 1, 0, 0)}),
        adds("clear of depths", Clear{.planes = mask_of(Plane::Depth), .depth = 0.25}),
        adds("clear of a channel", Clear{.planes = both, .color = vec4(1, 1, 0, 0), .depth = 0.25},
             [](State& s) {
                 s.color_mask = {false, true, false, false};
                 s.depth.mask = false;
             }),
        adds("clear of a part", Clear{.planes = both, .color = vec4(1, 1, 0, 0), .depth = 0.25},
             [](State& s) {
                 s.scissor = {true, {2, 3, 60, 70}};
             }),
        adds("spans", WriteSpans{{{3, 20, 77, 0, true}}, {{9, 8, 7, 6}}, 3}),
        adds("pixels", WritePixels{box, Plane::Color, std::vector<Rgba>(99, {1, 2, 3, 4}), {}, 5}),
        adds("depths", WritePixels{box, Plane::Depth, {}, std::vector<std::uint32_t>(99, 44), 0}),
        adds("copied colours", Copy{Plane::Color, {20, 20, 30, 30}, 1, 2}),
        adds("copied depths", Copy{Plane::Depth, {20, 20, 30, 30}, 1, 2}),
        {"accumulated",
         [](State&, CommandList& list) {
             list.add(Accumulate{AccumOp::Load, 1});
             list.add(Accumulate{AccumOp::Accum, 1});
             list.add(Accumulate{AccumOp::Return, 3});
         }},
    };
}

/// Runs the commands, in the list of the identifiers or in their own. Returns whether they changed
/// a plane.
bool changes(const Follower& follower, bool in_one_list) {
    Workbench bench(vgx(), width, height), before(vgx(), width, height);
    State state = item_buffer(bench);
    CommandList first, second;
    add_items(first, state);
    before.run(first);
    follower.add(state, second);
    if (in_one_list) first.append(second);
    bench.run(first);
    if (!in_one_list) bench.run(second);
    bench.run(Read{.key = 9, .rect = {0, 0, width, height}, .packed = true});
    return !(bench.planes() == before.planes());
}

TEST(UniformBlocks, WhateverFollowsFindsThePixels) {
    for (const auto& followers : {drawn_followers(), other_followers()})
        for (const Follower& follower : followers)
            for (const bool in_one_list : {true, false}) {
                SCOPED_TRACE(follower.name);
                EXPECT_TRUE(changes(follower, in_one_list)) << "nothing to be seen";
            }
}

}  // namespace
}  // namespace gw::test
