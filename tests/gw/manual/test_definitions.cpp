// docs/manual/numbers.md, state.md, commands.md: definitions, and initial values.
#include "gw/base/arithmetic.h"
#include "gw/names.h"
#include "gw/stages/lighting.h"
#include "gw/stages/perspective.h"
#include "gw/stages/texels.h"
#include "gw/stages/vertex.h"
#include "test_paths.h"
#include "tests/gw/workbench.h"

#include <cmath>
#include <fstream>
#include <sstream>

namespace gw {
namespace {

using test::Workbench;

std::string page(const char* name) {
    std::ifstream in(std::string(GW_SOURCE_DIR "/docs/manual/") + name);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
}

// [R2.7]
TEST(ManualNumbers, UnitVectorsAtTheEndsOfTheirRange) {
    EXPECT_EQ(normalized({0, 3, 4}), dvec3(0, 0.6, 0.8));
    EXPECT_EQ(normalized({0, 0, 0}), dvec3(0));
    EXPECT_EQ(normalized({0, 1e-170, 0}), dvec3(0));  // the square underflows
    EXPECT_EQ(normalized({1e200, 1, 0}), dvec3(0));   // the length is infinite
    EXPECT_EQ(normalized({NAN, 1, 0}), dvec3(0));
    const dvec3 mixed = normalized({INFINITY, 1, 0});
    EXPECT_TRUE(std::isnan(mixed.x));
    EXPECT_EQ(mixed.y, 0);
}

// [R2.5] [R8.5] [R8.7]
TEST(ManualNumbers, ComparisonsWithNanAreFalse) {
    EXPECT_EQ(clamp01(NAN), 0);
    EXPECT_EQ(bounded(NAN, 5), -5);
    EXPECT_EQ(to_integer(NAN, 2, 7), 2);
    // A normal of NaN: no diffuse light, and no highlight.
    const LightTerms dark = light_terms(Light{}, {0, 0, 0}, {NAN, 0, 0}, {0, 0, 1}, 1, true);
    EXPECT_EQ(dark.diffuse, 0);
    EXPECT_EQ(dark.specular, 0);
    // A spot whose angle is NaN is not cut off.
    Light spot{.position = {3e38f, 0, 0, 1e-30f}, .spot_direction = {0, 1, 0}};
    spot.spot_cos_cutoff = 0.5f;
    const dvec3 p(-INFINITY, 0, 0);
    // The attenuation is NaN too: as if it were the least one.
    EXPECT_EQ(light_terms(spot, p, {0, 0, 1}, {0, 0, 1}, 1, true).ambient, 1 / 1e-30);
}

// [R4.3]
TEST(ManualState, AViewportOfNoSizeIsTheWindow) {
    Workbench bench(vgx(), 8, 8);
    bench.state.viewport = {3, 5, 0, 0};
    bench.draw(Primitive::Quads, {{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}});
    EXPECT_EQ(bench.take_counters().fragments, 64u);
}

// [R5.1]
TEST(ManualCommands, EveryCommandIsInTheTable) {
    const std::string text = page("commands.md");
    const std::vector<Command> all{BeginPass{},   Clear{},       SetState{},   Draw{},
                                   WriteSpans{},  WritePixels{}, Accumulate{}, Copy{},
                                   CopyTexture{}, Read{},        DrawPixels{}, SwapBuffers{},
                                   Query{},       MakeSurface{}, UseSurface{}, Blit{}};
    ASSERT_EQ(all.size(), std::variant_size_v<Command>);
    for (const Command& command : all) {
        const std::string name = name_of(command);
        EXPECT_NE(text.find("| " + name + " | "), text.npos) << name;
        const bool has_members = !std::holds_alternative<SwapBuffers>(command);
        EXPECT_EQ(text.find("| " + name + " `") != text.npos, has_members) << name;
    }
}

// [R5.5] [R5.6]
TEST(ManualCommands, MaterialsAndLightsStartSo) {
    const Material m;
    EXPECT_EQ(m.Ka, vec3(0.2f));
    EXPECT_EQ(m.Kd, vec3(0.8f));
    EXPECT_EQ(m.Ks, vec3(0));
    EXPECT_EQ(m.Ke, vec3(0));
    EXPECT_EQ(m.Ns, 0);
    EXPECT_EQ(m.alpha, 1);
    const Light l;
    EXPECT_EQ(l.position, vec4(0, 0, 1, 0));
    EXPECT_EQ(l.Ia, vec3(0));
    EXPECT_EQ(l.Id, vec3(1));
    EXPECT_EQ(l.Is, vec3(1));
    EXPECT_EQ(l.spot_direction, vec3(0, 0, -1));
    EXPECT_EQ(l.spot_exponent, 0);
    EXPECT_EQ(l.spot_cos_cutoff, -1);
    EXPECT_EQ(l.constant_attenuation, 1);
    EXPECT_EQ(l.linear_attenuation, 0);
    EXPECT_EQ(l.quadratic_attenuation, 0);
}

// [R8.8]
TEST(ManualLighting, BackFacesAreLitByTheOtherNormal) {
    const auto red = [](bool two_side, const vec3& light) {
        Workbench bench;
        bench.state.color_source = ColorSource::Lighting;
        bench.state.lighting.two_side = two_side;
        Draw draw{.mesh = make_mesh(test::mesh_data(Primitive::Quads,
                                                    {{0, 4, 0}, {4, 4, 0}, {4, 0, 0}, {0, 0, 0}}))};
        draw.material = {.Ka = vec3(0), .Kd = vec3(1)};
        draw.lights =
            std::make_shared<const std::vector<Light>>(1, Light{.position = vec4(light, 0)});
        bench.draw(draw);
        return int(bench.color(1, 1)[0]);
    };
    EXPECT_EQ(red(false, {0, 0, 1}), 255);
    EXPECT_EQ(red(true, {0, 0, 1}), 0);
    EXPECT_EQ(red(true, {0, 0, -1}), 255);
}

// [R9.17]
TEST(ManualRasterization, ProjectiveCoordinatesOfAnySign) {
    const std::array<dvec4, 2> strq{dvec4(1, -6, 0.5, 2), dvec4(3, 0, 0, -1)};
    const std::array<double, 2> w{1, 2};  // q / w = 2, -1/2: H = 2
    const Projective p = projective(strq, w);
    EXPECT_EQ(p.denominator[0], 1 << 30);
    EXPECT_EQ(p.denominator[1], -(1 << 28));
    EXPECT_EQ(p.numerator[0].exponent, 0);  // s / w = 1, 3/2; over H 1/2, 3/4
    EXPECT_EQ(p.numerator[0].at[0], 1 << 29);
    EXPECT_EQ(p.numerator[0].at[1], 3 << 28);
    EXPECT_EQ(p.numerator[1].exponent, 2);  // |t / w| over H 3, 0
    EXPECT_EQ(p.numerator[1].at[0], -(3 << 28));
    EXPECT_EQ(p.numerator[1].at[1], 0);
    EXPECT_EQ(p.numerator[2].exponent, -2);  // r / w over H 1/4, 0
    EXPECT_EQ(p.numerator[2].at[0], 1 << 30);
    const std::array<dvec4, 1> none{dvec4(1, 1, 1, 0)};
    const std::array<double, 1> one{1};
    EXPECT_EQ(projective(none, one).denominator[0], 0);
}

// [R9.18]
TEST(ManualRasterization, SlopesByHand) {
    // U = 100 + 3 x + 5 y, Q = 7 + 2 x + y in units with 16 fraction bits, at pixel 0 0.
    const PlaneSlope u{3 * 65536.0, 5 * 65536.0, 100}, q{2 * 65536.0, 1 * 65536.0, 7};
    const CoordinateSlope s = coordinate_slope(u, q);
    EXPECT_EQ(s.a, 65536.0 * (3 * 7 - 100 * 2));
    EXPECT_EQ(s.b, 65536.0 * (5 * 7 - 100 * 1));
    EXPECT_EQ(s.k, 65536.0f * (3 * 1 - 5 * 2));
    JoinedSlopes larger;
    larger.add(s, 0, 0, 1);
    EXPECT_EQ(larger.value(), 65536.0 * 179);
    larger.add(s, 40, 0, 1);
    EXPECT_EQ(larger.value(), 65536.0 * (-65 + 7 * 40));  // the column's
    // Only slivers have gradients beyond 2^62, which are kept there.
    EXPECT_EQ(coordinate_slope({0x1p70, 0, 0}, {0, 0, 1}).a, 0x1p62);
}

// [R9.19] [R9.14]
TEST(ManualRasterization, ALongerSpanThanTheExponentIsLimited) {
    const std::array<double, 2> w{1, 1}, s{0, 5000};
    const Numerators n = numerators(s, w, 0);
    EXPECT_EQ(n.exponent, 10);
    EXPECT_EQ(n.at[1], 1 << 30);
    EXPECT_EQ(numerators(s, w, 0, 40).exponent, 13);
}

// [R6.14] [R10.5]
TEST(ManualTexture, CoordinatesAreKeptWithin2To200) {
    const Profile profile = vgx();
    State state;
    state.texture.gen = TexGen::EyeLinear;
    state.texture.eye_linear = dmat4(0);
    state.texture.eye_linear[3] = {1e300, -1e300, 1e308, 1};
    Draw draw{.mesh = make_mesh({.primitive = Primitive::Points, .positions = {{0, 0, 0}}})};
    EXPECT_EQ(run_vertex(vertex_program(state, draw, profile), 0).texcoord, dvec4(0, 0, 0, 1));
    draw.map.slot = 0;
    EXPECT_EQ(run_vertex(vertex_program(state, draw, profile), 0).texcoord,
              dvec4(0x1p200, -0x1p200, 0x1p200, 1));
}

// [R10.15]
TEST(ManualTexture, TheWeightOfALevelIsTheNearestInteger) {
    for (int m = 0; m < 256; ++m) {
        const double exact = 256 * std::log2(1 + m / 256.0);
        const double distance = std::abs(exact - std::floor(exact) - 0.5);
        EXPECT_GT(distance, 1e-4) << m << ": so no rounding of log2 decides";
        EXPECT_EQ(mantissa_levels()[std::size_t(m)], std::min(255.0, std::nearbyint(exact))) << m;
    }
}

// [R14.3]
TEST(ManualCounters, AnOutlineIsOnePrimitive) {
    Workbench bench;
    bench.state.polygon_mode = PolygonMode::Line;
    bench.draw(Primitive::Triangles, {{8.5f, 8.5f, 0}, {16.5f, 8.5f, 0}, {8.5f, 16.5f, 0}});
    const Counters c = bench.take_counters();
    EXPECT_EQ(c.primitives, 1u);
    EXPECT_EQ(c.drawn, 1u);
    EXPECT_EQ(c.rejected + c.clipped + c.degenerate, 0u);
    EXPECT_EQ(c.fragments, 24u);
}

// [R14.7]
TEST(ManualCounters, PixelsByHand) {
    Workbench bench(vgx(), 8, 4);
    bench.state.color_mask = {false, false, false, false};
    bench.state.scissor = {true, {0, 0, 4, 4}};
    bench.clear(mask_of(Plane::Color) | mask_of(Plane::Depth));
    EXPECT_EQ(bench.take_counters().pixels, 32u);
    bench.run(WritePixels{{3, 0, 2, 2}, Plane::Depth, {}, {1, 2, 3, 4}, 0});
    EXPECT_EQ(bench.take_counters().pixels, 2u);
    bench.run(Accumulate{AccumOp::Accum, 1});
    EXPECT_EQ(bench.take_counters().pixels, 16u);
    bench.run(Copy{Plane::Color, {-1, 0, 2, 1}, 2, 0});
    EXPECT_EQ(bench.take_counters().pixels, 1u);
    bench.run(Read{0, Plane::Color, {4, 0, 4, 4}});
    EXPECT_EQ(bench.take_counters().pixels, 16u);
    bench.run(CopyTexture{0, Plane::Color, {4, 0, 4, 4}});
    EXPECT_EQ(bench.take_counters().pixels, 16u);
}

// [R14.9]
TEST(ManualCounters, ADigestIsOfTheEndOfItsPass) {
    const auto machine = make_reference(vgx(), 4, 4);
    CommandList first, second;
    first.add(BeginPass{"a", mask_of(Plane::Stencil)});
    first.add(Clear{mask_of(Plane::Stencil), {}, 1, 1});
    machine->execute(first);
    const Digest one = machine->passes()[0].digests[std::size_t(Plane::Stencil)];
    EXPECT_EQ(one, digest(machine->planes(), Plane::Stencil));
    second.add(Clear{mask_of(Plane::Stencil), {}, 1, 2});
    second.add(BeginPass{"b", 0});
    second.add(Clear{mask_of(Plane::Stencil), {}, 1, 3});
    machine->execute(second);
    const PassReport& a = machine->passes()[0];
    EXPECT_NE(a.digests[std::size_t(Plane::Stencil)], one);
    EXPECT_NE(a.digests[std::size_t(Plane::Stencil)], digest(machine->planes(), Plane::Stencil));
}

}  // namespace
}  // namespace gw
