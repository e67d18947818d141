// [K3.4, K4]: rays blend translucent objects as the passes do.
#include "itembuffer/superposed_ray_tracer.h"
#include "tests/raytrace/walls.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace gw::itembuffer {
namespace {

constexpr int size = 17;
constexpr std::size_t middle = size * size / 2;

std::vector<Rgba> by_passes(const scene::Scene& s) {
    const auto machine = make_fast(vgx(), size, size);
    render(*machine, s, scene::make_view(s, size, size), {});
    return machine->planes().color;
}

std::vector<Rgba> by_rays(const scene::Scene& s) {
    const auto machine = make_fast(vgx(), size, size);
    superpose_ray_traced(*machine, s, scene::make_view(s, size, size), 1, {});
    return machine->planes().color;
}

/// A red pane, d = 0.4, before a blue wall, both behind the eye, and a mirror before it.
scene::Scene pane_in_mirror() {
    raytrace::Walls walls;
    walls.add_shining({0, 0, 10}, {-9, 0, 0}, {0, 9, 0}, {0, 0, 1});
    walls.add_shining({0, 0, 8}, {-9, 0, 0}, {0, 9, 0}, {1, 0, 0}).d = 0.4f;
    scene::Material& mirror = walls.add({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
    mirror.Ks = vec3(1);
    mirror.illum = 3;
    return walls.scene;
}

TEST(TranslucentRays, BlendInAMirror) {
    EXPECT_EQ(by_passes(pane_in_mirror())[middle], (Rgba{102, 0, 153, 255}));
    EXPECT_EQ(by_rays(pane_in_mirror())[middle], (Rgba{102, 0, 153, 255}));
}

TEST(TranslucentRays, EndAtTheBackground) {
    scene::Scene s = pane_in_mirror();
    s.objects.erase(s.objects.begin());
    s.background = {0, 1, 0};
    EXPECT_EQ(by_passes(s)[middle], (Rgba{102, 153, 0, 255}));
    EXPECT_EQ(by_rays(s)[middle], (Rgba{102, 153, 0, 255}));
}

/// Three panes before a lit wall, in fog, as the eye sees them: each pass rounds once, and each pane
/// has at most five passes over it.
TEST(TranslucentRays, FromTheEyeBlendAsPassesDo) {
    for (const bool fog : {false, true}) {
        raytrace::Walls walls;
        walls.add({0, 0, -3}, {4, 0, 0}, {0, 4, 0}) = {.Ka = vec3(0.3f), .Kd = vec3(0.6f)};
        for (const float z : {-1.0f, 0.0f, 1.0f})
            walls.add({0.3f * z, 0, z}, {2, 0, 0}, {0, 2, 0}) = {
                .Ka = vec3(0.2f), .Kd = vec3(0.3f + 0.2f * z, 0.4f, 0.1f), .d = 0.35f};
        walls.scene.lights = {{.direction = {0.2f, 0, -1},
                               .Ia = vec3(0.5f),
                               .Id = vec3(0.8f),
                               .shadow = scene::Shadow::Volume}};
        if (fog) walls.scene.fog = scene::Fog{.mode = FogMode::Exp, .density = 0.05f};
        const auto passes = by_passes(walls.scene), rays = by_rays(walls.scene);
        for (std::size_t i = 0; i < passes.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                ASSERT_LE(std::abs(int(passes[i][c]) - int(rays[i][c])), 6) << i << ", fog " << fog;
    }
}

/// [K3.2] The mirror's map is kept out of the lamp's shadow, which covers its left half.
TEST(OrdinaryRayTracer, KeepsReflectionMapsOutOfTheShadow) {
    raytrace::Walls walls;
    const std::array<std::uint8_t, 4> white{255, 255, 255, 255};
    scene::Material& shiny = walls.add({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
    shiny.Ks = vec3(0.5f);
    shiny.refl.push_back({.file = "white", .texture = make_texture8("white", 1, 1, white)});
    walls.add({-20, 0, 20}, {-20, 0, 0}, {0, 20, 0});
    walls.scene.lights = {
        {.direction = {0, 0, -1}, .Ia = vec3(0), .Id = vec3(0), .shadow = scene::Shadow::Volume}};
    for (const bool in_shadow : {true, false}) {
        walls.scene.reflection_in_shadow = in_shadow;
        const auto passes = by_passes(walls.scene), rays = by_rays(walls.scene);
        const std::size_t left = middle - 3, right = middle + 3;
        EXPECT_EQ(rays[right], passes[right]);
        EXPECT_EQ(rays[left], passes[left]);
        EXPECT_EQ(rays[left][0] > 0, in_shadow);
        EXPECT_GT(rays[right][0], 0);
    }
}

}  // namespace
}  // namespace gw::itembuffer
