// Orthographic views: lines of sight are parallel, so a flat face looks the same all over.
#include "multipass/frame/driver.h"
#include "tests/multipass/scenes.h"

#include <gtest/gtest.h>

namespace gw::multipass {
namespace {

constexpr int size = 16;

scene::Scene square_from(double distance, const scene::Material& material) {
    scene::Scene s;
    add_square(s, "face", material);
    s.lights.push_back(
        {.direction = {-0.1f, 0, -1}, .Ia = vec3(0.1f), .Id = vec3(0.3f), .Is = vec3(0.9f)});
    s.camera = scene::Camera{
        .eye = {0, 0, distance}, .near_plane = 0.5, .far_plane = distance + 5, .ortho_height = 2};
    return s;
}

std::vector<Rgba> draw(const scene::Scene& s, Renderer renderer) {
    const auto machine = make_fast(vgx(), size, size);
    render(*machine, s, scene::make_view(s, size, size), {.renderer = renderer});
    return machine->planes().color;
}

void expect_even(const scene::Material& material) {
    for (const Renderer renderer : {Renderer::Multipass, Renderer::Hardware}) {
        const auto near = draw(square_from(1, material), renderer);
        EXPECT_EQ(near, std::vector<Rgba>(size * size, near[0])) << int(renderer);
        EXPECT_EQ(draw(square_from(40, material), renderer), near) << int(renderer);
        EXPECT_GT(near[0][0], 0);
    }
}

TEST(Orthographic, HighlightIsEvenOnAFlatFace) {
    expect_even({.Ka = vec3(0.1f), .Kd = vec3(0.1f), .Ks = vec3(0.8f), .Ns = 60});
}

/// The map has another colour in each texel, and the face looks up one of them.
TEST(Orthographic, MapsLookUpOneDirectionOnAFlatFace) {
    std::vector<std::uint8_t> texels;
    for (int i = 0; i < 32 * 32; ++i)
        for (const int v : {40 + i % 32 * 6, i / 32 * 8, 7, 255})
            texels.push_back(static_cast<std::uint8_t>(v));
    const scene::Map map{.file = "ramp", .texture = make_texture8("ramp", 32, 32, texels)};
    scene::Material mirror{.Ka = vec3(0), .Kd = vec3(0), .Ks = vec3(1)};
    mirror.refl = {map};
    scene::Material glass{.Ka = vec3(0), .Kd = vec3(0), .Ni = 1.5f};
    glass.refraction = {map};
    for (scene::Material m : {mirror, glass}) {
        scene::Scene tilted = square_from(3, m);
        tilted.lights.clear();
        dmat4& turn = tilted.objects[0].world_from_object;
        turn[0] = {0.8, 0, -0.6, 0};
        turn[2] = {0.6, 0, 0.8, 0};
        const auto color = draw(tilted, Renderer::Multipass);
        const Rgba& seen = color[size / 2 * size + size / 2];
        EXPECT_EQ(seen[2], 7);
        for (int x = 4; x < 12; ++x) EXPECT_EQ(color[size / 2 * size + std::size_t(x)], seen) << x;
    }
}

}  // namespace
}  // namespace gw::multipass
