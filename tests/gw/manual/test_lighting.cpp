// docs/manual/lighting.md: the worked examples.
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
    return lit_color(draw, {.local_viewer = local_viewer}, profile, p, {0, 0, 1})[0];
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
    const auto color = lit_color(draw, {}, vgx(), dvec3(0), {0, 0, 1});
    EXPECT_EQ(color[0], 128);  // -1 + 3 * 0.5: not clamped in between
    EXPECT_EQ(color[3], 128);
}

}  // namespace
}  // namespace gw
