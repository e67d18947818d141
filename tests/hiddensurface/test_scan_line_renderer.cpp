// Claims: eq. 3 at every pixel is eq. 1 where nothing varies over a polygon, and better where it
// does. [K3s]
#include "hiddensurface/run/scan_line_renderer.h"
#include "scene/draw/shading.h"
#include "tests/hiddensurface/cases.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gw::hiddensurface {
namespace {

std::vector<Rgba> scan_line_colors(const scene::Scene& scene, int size) {
    const auto machine = make_reference(vgx(), size, size);
    machine->execute(scan_line_picture(scene, scene::make_view(scene, size, size), vgx()));
    return machine->planes().color;
}

scene::Scene square(const scene::Material& material, const scene::Light& light) {
    scene::Scene scene =
        polygon_scene({.primitive = Primitive::Quads,
                       .positions = {{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}},
                       .texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
    scene.materials[0] = material;
    scene.lights.push_back(light);
    return scene;
}

scene::Map half_map() {
    const std::array<std::uint8_t, 8> texels{255, 0, 0, 255, 0, 255, 0, 255};
    return {.file = "half", .texture = make_texture8("half", 2, 1, texels)};
}

}  // namespace

TEST(ScanLineRenderer, IsLambertsLawUnderADirectionalLight) {
    const auto colors =
        scan_line_colors(square({.Ka = vec3(0.5f), .Kd = vec3(1), .Ks = vec3(0)},
                                {.direction = {0, 0, -1}, .Ia = vec3(0.2f), .Id = vec3(0.5f)}),
                         8);
    // 0.1 + 0.5 of 255
    for (const Rgba& color : colors) EXPECT_EQ(color, (Rgba{153, 153, 153, 255}));
}

// A highlight in the middle of one large polygon: lighting at the corners cannot see it.
TEST(ScanLineRenderer, ShowsAHighlightInsideAPolygon) {
    const auto colors =
        scan_line_colors(square({.Ka = vec3(0), .Kd = vec3(0), .Ks = vec3(1), .Ns = 200},
                                {.direction = {0, 0, -1}, .Id = vec3(1)}),
                         33);
    EXPECT_GT(colors[16 * 33 + 16][0], 250);
    EXPECT_LT(colors[0][0], 20);
}

TEST(ScanLineRenderer, ClearsToTheBackgroundAndLeavesZAlone) {
    scene::Scene scene;
    scene.background = vec3(1, 0, 0.2f);
    scene.camera = scene::Camera{};
    const auto machine = make_reference(vgx(), 4, 4);
    const auto before = machine->planes().depth;
    machine->execute(scan_line_picture(scene, scene::make_view(scene, 4, 4), vgx()));
    EXPECT_EQ(machine->planes().color, std::vector<Rgba>(16, Rgba{255, 0, 51, 255}));
    EXPECT_EQ(machine->planes().depth, before);
}

// The same pixels as the machine's own jittered picture; and the light of the point that lies there
// then.
TEST(ScanLineRenderer, MovesWithTheJitterAsTheMachineDoes) {
    scene::Scene scene = random_triangles(3, 12);
    scene.materials[0] = {.Ka = vec3(0), .Kd = vec3(0), .Ks = vec3(0), .Ke = vec3(1)};
    const scene::View view = scene::make_view(scene, 40, 30);
    std::vector<std::vector<Rgba>> pictures;
    for (const JitterState& jitter : {JitterState{}, JitterState{3, -2}, JitterState{-4, 4}}) {
        const auto machine = make_reference(vgx(), 40, 30);
        machine->execute(scan_line_picture(scene, view, vgx(), jitter));
        pictures.push_back(machine->planes().color);
        machine->execute(scene::id_pass(scene, view, {.jitter = jitter}));
        for (std::size_t i = 0; i < pictures.back().size(); ++i)
            EXPECT_EQ(pictures.back()[i][0] != 0, scene::id_of(machine->planes().color[i]) != 0)
                << i;
    }
    EXPECT_NE(pictures[1], pictures[0]);
    EXPECT_NE(pictures[2], pictures[0]);
}

// A texture of a step at every pixel's middle: half a pixel of jitter moves the picture onto the
// other texel.
TEST(ScanLineRenderer, ShadesThePointThatTheJitterMovesUnderThePixel) {
    scene::Scene scene = square({.Ka = vec3(0), .Kd = vec3(0), .Ks = vec3(0), .Ke = vec3(1)}, {});
    scene.camera->ortho_height = 18;           // the square fills the window of 18 x 18
    scene.materials[0].map_Ke = {half_map()};  // red left of the middle, green right of it
    const scene::View view = scene::make_view(scene, 18, 18);
    const auto green_at = [&](int jitter, int x) {
        const auto machine = make_reference(vgx(), 18, 18);
        machine->execute(scan_line_picture(scene, view, vgx(), {jitter, 0}));
        return machine->planes().color[std::size_t(9 * 18 + x)][1];
    };
    // Green grows from left to right here; the picture moved right has at x what was left of it.
    EXPECT_LT(green_at(4, 9), green_at(0, 9));
    EXPECT_GT(green_at(-4, 9), green_at(0, 9));
}

TEST(Shade, MultipliesEachComponentByItsOwnMap) {
    scene::Material material{
        .Ka = vec3(1), .Kd = vec3(1), .Ks = vec3(1), .Ke = vec3(0.125f), .Ns = 1};
    material.map_Kd = {half_map()};
    const gw::Light light{
        .position = {0, 0, 1, 0}, .Ia = vec3(0.25f), .Id = vec3(0.5f), .Is = vec3(0.25f)};
    const scene::SurfacePoint left{.st = {0.25, 0.5}}, right{.st = {0.75, 0.5}};
    const auto shaded = [&](const scene::SurfacePoint& p) {
        return scene::shade(material, {&light, 1}, p);
    };
    // The gloss and the emission are not reddened; the ambient map is the diffuse map.
    EXPECT_EQ(shaded(left), dvec3(0.25 + 0.5 + 0.25 + 0.125, 0.375, 0.375));
    EXPECT_EQ(shaded(right), dvec3(0.375, 0.25 + 0.5 + 0.25 + 0.125, 0.375));
    // In shadow only the light's diffuse and specular parts go. [K3.2]
    EXPECT_EQ(scene::light_color(material, light, left, 0), dvec3(0.25, 0, 0));
}

TEST(Sample, FiltersBetweenTexelsAndBetweenLevels) {
    const scene::Map map = half_map();
    EXPECT_EQ(scene::sample(map, {0.25, 0.5}), dvec3(1, 0, 0));
    EXPECT_EQ(scene::sample(map, {0.5, 0.5}), dvec3(0.5, 0.5, 0));
    EXPECT_EQ(scene::sample(map, {1.25, 7.5}), dvec3(1, 0, 0));  // repeats
    const dvec3 whole = scene::sample(map, {0.25, 0.5}, {1, 0}, {0, 0});
    EXPECT_NEAR(whole.x, 0.5, 1.0 / 255);  // one texel: their mean
    EXPECT_NEAR(whole.y, 0.5, 1.0 / 255);
    EXPECT_EQ(scene::sample(scene::Map{}, {0, 0}), dvec3(1));
}

}  // namespace gw::hiddensurface
