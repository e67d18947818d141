// docs/manual/machine.md: the worked examples.
#include "tests/gw/workbench.h"

namespace gw {
namespace {

using test::error_of;
using test::Workbench;

// [R1.3] [R1.5]
TEST(ManualMachine, AnOddProfile) {
    const Profile odd{.name = "odd",
                      .color_bits = 10,
                      .depth_bits = 20,
                      .stencil_bits = 2,
                      .subpixel_bits = 1,
                      .lit_bits = 5};
    validate(odd);
    Workbench bench(odd, 16, 16);
    bench.clear(all_planes, {1, 0.5f, 0, 1}, 0.5, 7);
    EXPECT_EQ(bench.color(3, 3), (Rgba{1023, 512, 0, 1023}));
    EXPECT_EQ(bench.depth(3, 3), 524288u);
    EXPECT_EQ(bench.stencil(3, 3), 3);
    // 1/31 of 5 lit bits is 33 of 1023.
    bench.state.color_source = ColorSource::Lighting;
    MeshData square =
        test::mesh_data(Primitive::Quads, {{2.5f, 2.5f, 0}, {6, 2.5f, 0}, {6, 6, 0}, {2.5f, 6, 0}});
    bench.draw(Draw{.mesh = make_mesh(square),
                    .material = {.Ka = vec3(0), .Kd = vec3(0), .Ke = vec3(0.04f)}});
    EXPECT_EQ(bench.color(4, 4), (Rgba{33, 33, 33, 1023}));
    EXPECT_EQ(bench.take_counters().fragments,
              4u * 3);  // columns 2 to 5, rows 3 to 5: the lower side on centres
}

// [R1.3]
TEST(ManualMachine, ProfilesAreThoseOfTheTable) {
    const auto row = [](const Profile& p) {
        return std::vector<int>{p.color_bits, p.depth_bits,    p.stencil_bits,
                                p.accum_bits, p.subpixel_bits, p.lit_bits,
                                p.max_lights, p.fragment_fog,  p.perspective_color};
    };
    EXPECT_EQ(row(vgx()), (std::vector<int>{8, 24, 8, 16, 3, 8, 8, 0, 0}));
    EXPECT_EQ(row(reality()), (std::vector<int>{12, 32, 8, 24, 3, 12, 8, 1, 0}));
    EXPECT_EQ(row(ideal()), (std::vector<int>{16, 32, 8, 32, 8, 16, 64, 1, 1}));
    for (const Profile& p : paper_profiles()) EXPECT_EQ(p.color_planes, 1);
    EXPECT_EQ(opengl().color_planes, 2);
    EXPECT_EQ(vgx().extensions, Extensions{});
    EXPECT_EQ(reality().extensions, (Extensions{.polygon_offset = true, .shadow_texture = true}));
    EXPECT_EQ(ideal().extensions, (Extensions{true, true, true, true}));
}

TEST(ManualMachine, ProfilesOutOfRangeAreNamed) {
    const auto refused = [](auto change) {
        Profile p = vgx();
        change(p);
        return error_of([&] { make_reference(p, 4, 4); });
    };
    EXPECT_EQ(refused([](Profile& p) { p.color_bits = 7; }),
              "profile 'vgx': color_bits = 7; expected 8 to 16");
    EXPECT_EQ(refused([](Profile& p) { p.depth_bits = 33; }),
              "profile 'vgx': depth_bits = 33; expected 16 to 32");
    EXPECT_EQ(refused([](Profile& p) { p.stencil_bits = 0; }),
              "profile 'vgx': stencil_bits = 0; expected 1 to 8");
    EXPECT_EQ(refused([](Profile& p) { p.accum_bits = 8; }),
              "profile 'vgx': accum_bits = 8; expected 16 to 32");
    EXPECT_EQ(refused([](Profile& p) { p.subpixel_bits = 9; }),
              "profile 'vgx': subpixel_bits = 9; expected 1 to 8");
    EXPECT_EQ(refused([](Profile& p) { p.lit_bits = 9; }),
              "profile 'vgx': lit_bits = 9; expected 4 to 8");
    EXPECT_EQ(refused([](Profile& p) { p.max_lights = 0; }),
              "profile 'vgx': max_lights = 0; expected 1 to 1024");
}

// [R1.4]
TEST(ManualMachine, ExtensionsAreRefusedByName) {
    const auto refused = [](const Profile& profile, auto change) {
        Workbench bench(profile, 4, 4);
        change(bench.state);
        return error_of([&] { bench.clear(); });
    };
    const auto offset = [](State& s) { s.polygon_offset.enable = true; };
    const auto shadow = [](State& s) { s.texture.shadow_compare = true; };
    const auto wrap = [](State& s) {
        s.stencil.test = true;
        s.stencil.zpass = StencilOp::IncrWrap;
    };
    const auto two_sided = [](State& s) {
        s.stencil.test = true;
        s.stencil.two_side = true;
    };
    EXPECT_EQ(refused(vgx(), offset),
              "command 0 (SetState): extension polygon_offset is not in profile vgx");
    EXPECT_EQ(refused(vgx(), shadow),
              "command 0 (SetState): extension shadow_texture is not in profile vgx");
    EXPECT_EQ(refused(reality(), wrap),
              "command 0 (SetState): extension stencil_wrap is not in profile reality");
    EXPECT_EQ(refused(reality(), two_sided),
              "command 0 (SetState): extension two_sided_stencil is not in profile reality");
    EXPECT_EQ(refused(reality(), offset), "");
    EXPECT_EQ(refused(reality(), shadow), "");
    EXPECT_EQ(refused(ideal(), wrap), "");
    EXPECT_EQ(refused(ideal(), two_sided), "");
}

// [R1.7]
TEST(ManualMachine, ARefusedListChangesNothing) {
    Workbench bench(vgx(), 4, 4);
    CommandList list;
    list.add(Clear{all_planes, vec4(1), 1, 3});
    list.add(Draw{});
    EXPECT_EQ(error_of([&] { bench.machine().execute(list); }),
              "command 1 (Draw): mesh = null; expected a mesh");
    EXPECT_EQ(bench.planes(), Planes(4, 4));
}

// [R1.6]
TEST(ManualMachine, PixelsCountFromTheBottomLeft) {
    Workbench bench(vgx(), 5, 3);
    bench.write({4, 2, 1, 1}, {9, 9, 9, 9});
    ASSERT_EQ(bench.planes().color.size(), 15u);
    EXPECT_EQ(bench.planes().color[14], (Rgba{9, 9, 9, 9}));
}

// [R4.5] [R4.6]
TEST(ManualMachine, TheDepthMaskGuardsClearsTheTestGuardsFragments) {
    const std::vector<vec3> square{{0, 0, 5}, {4, 0, 5}, {4, 4, 5}, {0, 4, 5}};
    Workbench bench(vgx(), 4, 4);
    bench.state.depth = {.test = false, .mask = true};
    bench.draw(Primitive::Quads, square);
    EXPECT_EQ(bench.depth(1, 1), 0u);
    bench.clear(mask_of(Plane::Depth));
    EXPECT_EQ(bench.depth(1, 1), 16777215u);
    bench.state.depth = {.test = true, .mask = false};
    bench.draw(Primitive::Quads, square);
    bench.clear(mask_of(Plane::Depth), vec4(0), 0);
    EXPECT_EQ(bench.depth(1, 1), 16777215u);
}

// [R1.9] [R1.10]
TEST(ManualMachine, ShadingStateDoesNotMoveFragments) {
    Workbench bench(reality(), 64, 64);
    MeshData square = test::mesh_data(Primitive::Quads,
                                      {{8, 8, 100}, {24, 8, 9000}, {24, 24, 77777}, {8, 24, 3}});
    square.texcoords = {{0, 0}, {9, 0}, {9, 9}, {0, 9}};
    Draw draw{.mesh = make_mesh(square)};
    bench.clear();
    bench.state.depth = {.test = true};
    bench.draw(draw);
    bench.take_counters();
    bench.state.depth = {.test = true, .func = DepthFunc::Equal, .mask = false};
    bench.state.color_source = ColorSource::Lighting;
    bench.state.fog = {.enable = true};
    bench.state.blend = {true, BlendFactor::One, BlendFactor::One};
    draw.map.texture = make_texture8("white", 1, 1, std::vector<std::uint8_t>(4, 255));
    draw.lights = std::make_shared<const std::vector<Light>>(2);
    bench.draw(draw);
    const Counters c = bench.take_counters();
    EXPECT_EQ(c.fragments, 256u);
    EXPECT_EQ(c.written, 256u);
}

// [R1.11]
TEST(ManualMachine, LimitsAreNamed) {
    EXPECT_EQ(error_of([] { make_reference(vgx(), 4097, 1); }),
              "window of 4097 x 1 pixels; expected 1 to 4096 each");
    EXPECT_EQ(error_of([] { make_fast(vgx(), 0, 1); }),
              "window of 0 x 1 pixels; expected 1 to 4096 each");
    const auto refused = [](auto change) {
        Workbench bench(vgx(), 4, 4);
        change(bench.state);
        return error_of([&] { bench.clear(); });
    };
    EXPECT_EQ(refused([](State& s) { s.point_size = 129; }),
              "command 0 (SetState): point_size = 129; expected 1 to 128");
    EXPECT_EQ(refused([](State& s) { s.line_width = 0; }),
              "command 0 (SetState): line_width = 0; expected 1 to 128");
    EXPECT_EQ(refused([](State& s) {
                  s.viewport = {-4097, 0, 8, 8};
              }),
              "command 0 (SetState): viewport.x = -4097; expected -4096 to 4096");
    EXPECT_EQ(refused([](State& s) {
                  s.viewport = {0, 0, 8, 5000};
              }),
              "command 0 (SetState): viewport.height = 5000; expected 1 to 4096");
    EXPECT_EQ(refused([](State& s) { s.jitter.x = 8; }),
              "command 0 (SetState): jitter.x = 8; expected less than a pixel");
    EXPECT_EQ(refused([](State& s) { s.jitter.y = -8; }),
              "command 0 (SetState): jitter.y = -8; expected less than a pixel");
}

}  // namespace
}  // namespace gw
