// Invalid lists and meshes are refused by both machines, with a message that names the fault.
// docs/manual/commands.md, "Refusals".
#include "tests/gw/workbench.h"

#include <limits>

namespace gw {
namespace {

using namespace test;

constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                infinity = std::numeric_limits<float>::infinity();

TEST(Refusals, MeshesRefuseWhatIsNotFinite) {
    for (const float v : {nan, infinity, -infinity}) {
        EXPECT_EQ(error_of([&] {
                      make_mesh(mesh_data(Primitive::Points, {{0, v, 0}}));
                  }),
                  "mesh: position 0 has a component that is not a finite number");
        MeshData data = mesh_data(Primitive::Points, {{0, 0, 0}});
        data.texcoords = {{0, v}};
        EXPECT_EQ(error_of([&] { make_mesh(data); }),
                  "mesh: texcoord 0 has a component that is not a finite number");
    }
}

TEST(Refusals, StatesAndDrawsRefuseWhatIsNotFinite) {
    const auto state = [](auto change) {
        Workbench bench(vgx(), 16, 16);
        change(bench.state);
        return error_of([&] { bench.clear(); });
    };
    EXPECT_EQ(state([](State& s) { s.projection[1][2] = nan; }),
              "command 0 (SetState): projection = nan; expected a finite number");
    EXPECT_EQ(state([](State& s) { s.depth_range.far_value = infinity; }),
              "command 0 (SetState): depth_range.far_value = inf; expected a finite number");
    EXPECT_EQ(state([](State& s) { s.alpha.ref = nan; }),
              "command 0 (SetState): alpha.ref = nan; expected a finite number");
    EXPECT_EQ(state([](State& s) { s.fog = {.enable = true, .density = 0}; }),
              "command 0 (SetState): fog.density = 0; expected a positive number");
    EXPECT_EQ(state([](State& s) {
                  s.fog = {.enable = true, .mode = FogMode::Linear, .start = 3, .end = 3};
              }),
              "command 0 (SetState): fog.end = 3; expected another value than fog.start");
    EXPECT_EQ(state([](State& s) { s.clip_planes[3].plane.y = -infinity; }),
              "command 0 (SetState): clip_planes = -inf; expected a finite number");

    const auto draw = [](auto change) {
        Workbench bench(vgx(), 16, 16);
        Draw d{.mesh = make_mesh(mesh_data(Primitive::Points, {{2, 2, 0}}))};
        Light light;
        change(d, light);
        d.lights = std::make_shared<const std::vector<Light>>(1, light);
        return error_of([&] { bench.draw(d); });
    };
    EXPECT_EQ(draw([](Draw& d, Light&) { d.material.Ns = nan; }),
              "command 1 (Draw): material.Ns = nan; expected 0 to 10000");
    EXPECT_EQ(draw([](Draw& d, Light&) { d.material.Kd.y = infinity; }),
              "command 1 (Draw): material = inf; expected a finite number");
    EXPECT_EQ(draw([](Draw&, Light& l) { l.quadratic_attenuation = -1; }),
              "command 1 (Draw): light attenuation = -1; expected 0 or more");
    EXPECT_EQ(draw([](Draw&, Light& l) { l.position.w = nan; }),
              "command 1 (Draw): light.position = nan; expected a finite number");
    Workbench bench(vgx(), 16, 16);
    EXPECT_EQ(error_of([&] {
                  bench.run(Accumulate{AccumOp::Accum, nan});
              }),
              "command 1 (Accumulate): value = nan; expected a finite number");
    EXPECT_EQ(error_of([&] {
                  bench.run(Clear{1, vec4(0, infinity, 0, 0)});
              }),
              "command 1 (Clear): color = inf; expected a finite number");
}

TEST(Refusals, MasksAndEnumerationsThatNameNothingAreRefused) {
    const auto refusal = [](Command command) {
        Workbench bench(vgx(), 16, 16);
        CommandList list;
        list.add(std::move(command));
        return error_of([&] { bench.run(list); });
    };
    EXPECT_EQ(refusal(Clear{.planes = 255}),
              "command 0 (Clear): planes = 255; expected bits of four planes, 0 to 15");
    EXPECT_EQ(refusal(BeginPass{"", 16}),
              "command 0 (BeginPass): digests = 16; expected bits of four planes, 0 to 15");
    EXPECT_EQ(refusal(Read{.plane = static_cast<Plane>(4), .rect = {0, 0, 1, 1}}),
              "command 0 (Read): plane = 4; expected 0 to 3");
    EXPECT_EQ(refusal(Copy{.plane = static_cast<Plane>(9)}),
              "command 0 (Copy): plane = 9; expected 0 to 3");
    EXPECT_EQ(refusal(WritePixels{.plane = static_cast<Plane>(7)}),
              "command 0 (WritePixels): plane = 7; expected 0 to 3");
    EXPECT_EQ(refusal(Accumulate{static_cast<AccumOp>(5), 1}),
              "command 0 (Accumulate): op = 5; expected 0 to 4");
    State state;
    state.stencil.back.zfail = static_cast<StencilOp>(8);
    EXPECT_EQ(refusal(SetState{state}),
              "command 0 (SetState): stencil.back.zfail = 8; expected 0 to 7");
    state = {};
    state.texture.min_filter = static_cast<MinFilter>(6);
    EXPECT_EQ(refusal(SetState{state}),
              "command 0 (SetState): texture.min_filter = 6; expected 0 to 5");
    EXPECT_EQ(error_of([] { make_mesh({.primitive = static_cast<Primitive>(8)}); }),
              "mesh: primitive 8; expected 0 to 7");
}

TEST(Refusals, ARefusalNamesThePassAlsoOfAnEarlierList) {
    Workbench bench(vgx(), 16, 16);
    CommandList list;
    list.add(BeginPass{"depth"});
    list.add(Clear{});
    bench.run(list);
    list.commands = {Clear{}, Accumulate{.value = nan}, BeginPass{"color"}};
    EXPECT_EQ(error_of([&] { bench.run(list); }),
              "command 1 (Accumulate) of pass 'depth': value = nan; expected a finite number");
    list.commands = {BeginPass{"color"}, Clear{}, Clear{.planes = 16}};
    EXPECT_EQ(
        error_of([&] { bench.run(list); }),
        "command 2 (Clear) of pass 'color': planes = 16; expected bits of four planes, 0 to 15");
}

}  // namespace
}  // namespace gw
