// docs/manual/lighting.md: the worked examples.
#include "gw/stages/clip.h"
#include "gw/stages/lighting.h"
#include "tests/gw/workbench.h"

#include <cmath>

namespace gw {
namespace {

/// Red of the lit colour at p with normal (0, 0, 1).
double red(const Material& material, const Light& light, const dvec3& p = dvec3(0),
           Profile profile = vgx(), bool local_viewer = false) {
    Draw draw{.material = material};
    draw.lights = std::make_shared<const std::vector<Light>>(1, light);
    return lit_colors(draw.material, draw.lights, {.local_viewer = local_viewer}, profile, p,
                      {0, 0, 1})
        .color[0];
}

const Material shiny{
    .Ka = vec3(0.5f), .Kd = vec3(0.5f), .Ks = vec3(0.25f), .Ke = vec3(0.0625f), .Ns = 2};
const Light slanting{.position = {0, 3, 4, 0}, .Ia = vec3(0.25f)};

// [R8.1] [R8.2] [R8.7]
TEST(ManualLighting, TermByTerm) {
    EXPECT_EQ(red(shiny, slanting), 207);
    Profile narrow = vgx();
    narrow.lit_bits = 5;
    EXPECT_EQ(red(shiny, slanting, dvec3(0), narrow), 206);

    const auto only = [](auto change) {
        Material m{.Ka = vec3(0), .Kd = vec3(0)};
        change(m);
        return red(m, slanting);
    };
    EXPECT_EQ(only([](Material& m) { m.Ke = shiny.Ke; }), 16);            // 15.94
    EXPECT_EQ(only([](Material& m) { m.Ka = shiny.Ka; }), 32);            // 31.875
    EXPECT_EQ(only([](Material& m) { m.Kd = shiny.Kd; }), 102);           // 0.4
    EXPECT_EQ(only([](Material& m) { m.Ks = shiny.Ks, m.Ns = 2; }), 57);  // 0.225: 57.375
    EXPECT_EQ(only([](Material& m) { m.Ks = shiny.Ks, m.Ns = 0; }), 64);  // 0.25, everywhere
}

// [R8.7]
TEST(ManualLighting, BehindTheSurfaceOnlyAmbientLight) {
    Light behind = slanting;
    behind.position = {0, 3, -4, 0};
    EXPECT_EQ(red(shiny, behind), 48);  // 0.0625 + 0.125 = 0.1875: 47.81
}

// [R8.3] [R8.4] [R8.5]
TEST(ManualLighting, AttenuationAndSpot) {
    const Material diffuse{.Ka = vec3(0), .Kd = vec3(1)};
    Light point{
        .position = {0, 0, 2, 1}, .linear_attenuation = 0.5f, .quadratic_attenuation = 0.25f};
    EXPECT_EQ(red(diffuse, point), 85);

    const Material ambient{.Ka = vec3(0.5f), .Kd = vec3(0)};
    const Light spot{
        .position = {0, 0, 2, 1}, .Ia = vec3(1), .spot_exponent = 2, .spot_cos_cutoff = 0.5f};
    EXPECT_EQ(red(ambient, spot), 128);            // straight below: 127.5
    EXPECT_EQ(red(ambient, spot, {2, 0, 0}), 64);  // half of it: 63.75
    EXPECT_EQ(red(ambient, spot, {4, 0, 0}), 0);
    Light bare = point;
    bare.constant_attenuation = bare.linear_attenuation = bare.quadratic_attenuation = 0;
    EXPECT_EQ(red(diffuse, bare), 255);  // an attenuation of 0 is clamped to 1e-30
}

// [R8.6]
TEST(ManualLighting, ALocalViewerSeesTheHighlightFromTheEye) {
    // The surface at (3, 0, -4): e = (-0.6, 0, 0.8); light towards (0.6, 0, 0.8): h = (0, 0, 1).
    const Material gloss{.Ka = vec3(0), .Kd = vec3(0), .Ks = vec3(1), .Ns = 50};
    const Light light{.position = {0.6f, 0, 0.8f, 0}};
    EXPECT_EQ(red(gloss, light, {3, 0, -4}, vgx(), true), 255);
    // From infinity h = (0.6, 0, 1.8) / sqrt 3.6, cos = sqrt 0.9: 0.9^25 = 0.0718.
    EXPECT_EQ(red(gloss, light, {3, 0, -4}), 18);
}

// [R8.1] [R8.2]
TEST(ManualLighting, LightsAddAndTheSumIsClampedOnce) {
    Draw draw{.material = {.Ka = vec3(0), .Kd = vec3(1), .Ke = vec3(-1), .alpha = 0.5f}};
    draw.lights = std::make_shared<const std::vector<Light>>(3, Light{.Id = vec3(0.5f)});
    const auto color = lit_colors(draw.material, draw.lights, {}, vgx(), dvec3(0), {0, 0, 1}).color;
    EXPECT_EQ(color[0], 128);  // -1 + 3 * 0.5: not clamped in between
    EXPECT_EQ(color[3], 128);
}

// [R8.11]
TEST(ManualLighting, HighlightsApart) {
    const LightsRef lights = std::make_shared<const std::vector<Light>>(1, slanting);
    const auto [color, secondary] =
        lit_colors(shiny, lights, {.separate_specular = true}, vgx(), dvec3(0), {0, 0, 1});
    EXPECT_EQ(color[0], 150);     // 149.81
    EXPECT_EQ(secondary[0], 57);  // 57.375
    const auto joined = lit_colors(shiny, lights, {}, vgx(), dvec3(0), {0, 0, 1});
    EXPECT_EQ(joined.secondary, (std::array<double, 4>{}));
}

/// The line of the worked example.
struct SecondaryLine {
    test::Workbench bench{opengl(), 4, 4};
    MeshData mesh = test::mesh_data(Primitive::Lines, {{0, 0.5f, 0}, {4, 0.5f, 0}},
                                    {{0.5f, 0.5f, 0.5f, 0.25f}, {0.5f, 0.5f, 0.5f, 0.25f}});
    SecondaryLine() {
        mesh.secondary_colors = {{0, 1, 0}, {0, 0, 0}};
        bench.state.color_sum = true;
    }
    Rgba at(int x) {
        bench.draw(mesh);
        return bench.color(x, 0);
    }
};

// [R8.12] [R8.13]
TEST(ManualLighting, SecondaryColoursAreAdded) {
    SecondaryLine line;
    EXPECT_EQ(line.at(1), (Rgba{128, 255, 128, 64}));
    EXPECT_EQ(line.at(3), (Rgba{128, 160, 128, 64}));
    line.bench.state.shade_model = ShadeModel::Flat;
    EXPECT_EQ(line.at(1), (Rgba{128, 128, 128, 64}));
    line.bench.state.shade_model = ShadeModel::Smooth;
    line.bench.state.color_sum = false;
    EXPECT_EQ(line.at(1), (Rgba{128, 128, 128, 64}));
    line.bench.state.color_sum = true;
    line.bench.state.color_source = ColorSource::PolygonId;
    EXPECT_EQ(line.at(1), (Rgba{0, 0, 0, 255}));
}

// [R8.13]
TEST(ManualLighting, TheSumComesAfterTextureAndBeforeFog) {
    SecondaryLine line;
    line.mesh.texcoords = {{0, 0}, {0, 0}};
    const std::vector<std::uint16_t> black{0, 0, 0, 65535};
    Draw draw{.mesh = make_mesh(line.mesh), .map = {make_texture("black", 1, 1, black), {}}};
    line.bench.draw(draw);
    EXPECT_EQ(line.bench.color(1, 0), (Rgba{0, 159, 0, 64}));
    line.bench.state.fog = {
        .enable = true, .mode = FogMode::Linear, .start = -1, .end = 1, .color = {1, 0, 0, 0}};
    line.bench.state.projection[2] = {0, 0, 0, 0};
    line.bench.state.projection[3].z = 0;
    line.bench.draw(draw);
    EXPECT_EQ(line.bench.color(1, 0), (Rgba{127, 80, 0, 64}));  // f = 128
}

// [R8.11] [R8.13] [R8.8]
TEST(ManualLighting, SeparateHighlightsNeedNoColourSum) {
    test::Workbench bench(opengl(), 4, 4);
    bench.state.color_source = ColorSource::Lighting;
    bench.state.lighting.two_side = true;
    bench.state.lighting.separate_specular = true;
    const std::vector<vec3> square{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
    Draw draw{.mesh = make_mesh(test::mesh_data(Primitive::Quads, square))};
    draw.material = {.Ka = vec3(0), .Kd = vec3(0), .Ks = {0.5f, 0, 0}, .Ke = {0, 0, 1}};
    draw.lights = std::make_shared<const std::vector<Light>>(1, Light{});
    const std::vector<std::uint16_t> black{0, 0, 0, 65535};
    draw.map = {make_texture("black", 1, 1, black), {}};
    bench.draw(draw);
    EXPECT_EQ(bench.color(1, 1), (Rgba{128, 0, 0, 255}));
    bench.state.cull.front = Winding::CW;  // the light is behind the back
    bench.draw(draw);
    EXPECT_EQ(bench.color(1, 1), (Rgba{0, 0, 0, 255}));
    bench.state.lighting.separate_specular = false;
    bench.state.color_sum = true;
    bench.state.cull.front = Winding::CCW;
    bench.draw(draw);
    EXPECT_EQ(bench.color(1, 1), (Rgba{0, 0, 0, 255}));
}

// [R8.12] [R8.13]
TEST(ManualLighting, DrawnPixelsAddTheRasterPositionsColour) {
    test::Workbench bench(opengl(), 4, 4);
    bench.state.color_sum = true;
    DrawPixels pixels{.width = 1, .height = 1, .colors = {{10, 20, 250, 40}}};
    pixels.raster.secondary_color = {1, 2, 30, 99};
    bench.run(pixels);
    EXPECT_EQ(bench.color(0, 0), (Rgba{11, 22, 255, 40}));
    bench.state.color_sum = false;
    bench.run(pixels);
    EXPECT_EQ(bench.color(0, 0), (Rgba{10, 20, 250, 40}));
}

// [R1.4]
TEST(ManualLighting, ASecondaryColourIsAnExtension) {
    for (const bool sum : {false, true}) {
        test::Workbench bench(ideal(), 4, 4);
        (sum ? bench.state.color_sum : bench.state.lighting.separate_specular) = true;
        EXPECT_EQ(test::error_of([&] { bench.clear(); }),
                  "command 0 (SetState): extension secondary_color is not in profile ideal");
    }
}

// [R8.12] A cut rounds the secondary colour as the colour.
TEST(ManualLighting, ClippingCutsSecondaryColours) {
    Vertex in, out;
    in.color = in.secondary = in.back_secondary = {255, 10, 0, 0};
    out.color = out.secondary = {0, 255, 0, 0};
    const Vertex cut = interpolate(in, out, 0.5);
    EXPECT_EQ(cut.secondary, cut.color);
    EXPECT_EQ(cut.secondary[0], 128);  // 127.5
    EXPECT_EQ(cut.back_secondary[1], 5);
}

/// Three points, of which the mesh gives materials or colours.
struct ThreePoints {
    test::Workbench bench{opengl(), 8, 8};
    MeshData mesh =
        test::mesh_data(Primitive::Points, {{0.5f, 0.5f, 0}, {1.5f, 0.5f, 0}, {2.5f, 0.5f, 0}});
    Draw draw{.material = {.Ka = vec3(0), .Kd = vec3(0), .Ke = {1, 0, 0}}};

    ThreePoints() { bench.state.color_source = ColorSource::Lighting; }
    std::array<Rgba, 3> colors() {
        draw.mesh = make_mesh(mesh);
        bench.draw(draw);
        return {bench.color(0, 0), bench.color(1, 0), bench.color(2, 0)};
    }
};

// [R8.9]
TEST(ManualLighting, MaterialsByVertex) {
    ThreePoints points;
    const auto glowing = [](vec3 Ke) { return Material{.Ka = vec3(0), .Kd = vec3(0), .Ke = Ke}; };
    points.mesh.materials = {{glowing({0, 1, 0}), glowing({0, 0, 1})},
                             {glowing({1, 1, 0}), glowing({0, 0, 1})}};
    points.mesh.material_indices = {1, 0, 0};
    const auto colors = points.colors();
    EXPECT_EQ(colors[0], (Rgba{255, 255, 0, 255}));
    EXPECT_EQ(colors[1], (Rgba{0, 255, 0, 255}));
    EXPECT_EQ(colors[2], (Rgba{0, 255, 0, 255}));
}

// [R8.9] [R8.8]
TEST(ManualLighting, ABackMaterial) {
    test::Workbench bench(opengl(), 4, 4);
    bench.state.color_source = ColorSource::Lighting;
    bench.state.lighting.two_side = true;
    const std::vector<vec3> square{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
    Draw draw{.mesh = make_mesh(test::mesh_data(Primitive::Quads, square))};
    draw.material = {.Ka = vec3(0), .Kd = vec3(0), .Ke = {1, 0, 0}};
    draw.back_material =
        std::make_shared<const Material>(Material{.Ka = vec3(0), .Kd = vec3(0), .Ke = {0, 1, 0}});
    bench.draw(draw);
    EXPECT_EQ(bench.color(1, 1), (Rgba{255, 0, 0, 255}));
    bench.state.cull.front = Winding::CW;
    bench.draw(draw);
    EXPECT_EQ(bench.color(1, 1), (Rgba{0, 255, 0, 255}));
    bench.state.lighting.two_side = false;
    bench.draw(draw);
    EXPECT_EQ(bench.color(1, 1), (Rgba{255, 0, 0, 255}));
}

// [R8.10]
TEST(ManualLighting, TheMaterialFollowsTheColour) {
    const auto follows = [](ColorMaterial mode, Face face) {
        ThreePoints points;
        points.mesh.colors = {{0, 1, 0, 0.5f}, {0, 0, 1, 1}, {1, 1, 1, 1}};
        points.draw.lights = std::make_shared<const std::vector<Light>>(1, Light{});
        points.bench.state.lighting.color_material = {true, face, mode};
        return points.colors();
    };
    EXPECT_EQ(follows(ColorMaterial::Emission, Face::Front)[0], (Rgba{0, 255, 0, 255}));
    EXPECT_EQ(follows(ColorMaterial::Diffuse, Face::FrontAndBack)[0], (Rgba{255, 255, 0, 128}));
    EXPECT_EQ(follows(ColorMaterial::AmbientAndDiffuse, Face::Front)[1], (Rgba{255, 0, 255, 255}));
    EXPECT_EQ(follows(ColorMaterial::Ambient, Face::Front)[1], (Rgba{255, 0, 0, 255}));
    EXPECT_EQ(follows(ColorMaterial::Specular, Face::Front)[2], (Rgba{255, 255, 255, 255}));
    EXPECT_EQ(follows(ColorMaterial::Diffuse, Face::Back)[0], (Rgba{255, 0, 0, 255}));
}

}  // namespace
}  // namespace gw
