// Two-step fog [K3.5] against the machine's fog in one pass.
#include "multipass/frame/driver.h"
#include "tests/multipass/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace gw::multipass {
namespace {

constexpr int size = 24;

/// A slanted square that leads into the fog, lit by one light; perspective, so that fog and colour
/// vary.
scene::Scene road(const scene::Material& material) {
    scene::Scene s;
    add_square(s, "road", material);
    dmat4& m = s.objects[0].world_from_object;
    m[0] = dvec4(3, 0, 0, 0);
    m[1] = dvec4(0, 0.2, -6, 0);
    s.lights.push_back({.name = "key",
                        .direction = {-0.5f, -1, -0.3f},
                        .Ia = vec3(0.5f),
                        .Id = {0.9f, 0.7f, 0.5f}});
    s.camera = scene::Camera{
        .eye = {0, 1.5, 8}, .at = {0, 0, 0}, .fov = 50, .near_plane = 1, .far_plane = 20};
    s.fog = scene::Fog{.mode = FogMode::Linear, .color = {0.6f, 0.7f, 0.8f}, .start = 3, .end = 13};
    return s;
}

std::vector<Rgba> draw(const scene::Scene& s, const Options& options = {},
                       const Profile& profile = vgx()) {
    const auto machine = make_reference(profile, size, size);
    render(*machine, s, scene::make_view(s, size, size), options);
    return machine->planes().color;
}

int largest_difference(const std::vector<Rgba>& a, const std::vector<Rgba>& b) {
    int largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c)
            largest = std::max(largest, std::abs(int(a[i][c]) - int(b[i][c])));
    return largest;
}

const Options in_one_pass{.renderer = Renderer::Hardware};

TEST(Fog, InTwoStepsIsFogInOneForOneComponent) {
    // docs/manual.md: mul(f, C) + mul(1 - f, fog), the two products rounded one by one either way.
    const scene::Scene s = road({.Ka = vec3(0), .Kd = {0.8f, 0.6f, 0.9f}});
    for (const Profile& profile : paper_profiles()) {
        const auto fogged = draw(s, {}, profile);
        EXPECT_EQ(fogged, draw(s, in_one_pass, profile)) << profile.name;
        scene::Scene clear = s;
        clear.fog.reset();
        EXPECT_NE(fogged, draw(clear, {}, profile)) << "else there was no fog";
    }
}

TEST(Fog, InTwoStepsIsFogInOneWithinARoundingPerComponent) {
    // Three components: each is rounded when it is lit, and when it goes through black fog; in one
    // pass the sum is, once.
    scene::Scene s =
        road({.Ka = {0.3f, 0.2f, 0.1f}, .Kd = {0.5f, 0.4f, 0.5f}, .Ks = vec3(0.2f), .Ns = 3});
    for (const Profile& profile : paper_profiles()) {
        const int difference =
            largest_difference(draw(s, {}, profile), draw(s, in_one_pass, profile));
        EXPECT_LE(difference, 4) << profile.name;  // (3 + 1) / 2 twice
    }
}

TEST(Fog, InTwoStepsIsWithinTheRoundingThatTheManualPredicts) {
    // docs/manual/fog.md: k components within (k + 1) / 2 units. Ambient light of whole units, so
    // that lighting itself rounds nothing.
    for (const std::size_t k : {1u, 2u, 3u, 6u}) {
        scene::Scene s = road({.Ka = vec3(1), .Kd = vec3(0)});
        int largest = 0;
        for (const float units : {17.0f, 30.0f, 41.0f}) {
            s.lights.assign(k, {.direction = {0, -1, 0}, .Ia = vec3(units / 255), .Id = vec3(0)});
            largest = std::max(largest, largest_difference(draw(s), draw(s, in_one_pass)));
        }
        EXPECT_LE(2 * largest, int(k) + 1) << k;
        if (k == 6) {
            EXPECT_GT(largest, 0) << "else nothing was rounded";
        }
    }
}

TEST(Fog, CoversShadowsToo) {
    // Where the road is in shadow and Ia = 0, nothing is drawn but fog: the fog of a black road.
    scene::Scene s = road({.Ka = vec3(0), .Kd = vec3(0.8f)});
    s.lights[0].shadow = scene::Shadow::Volume;
    add_square(s, "roof", {.Ka = vec3(0), .Kd = vec3(0)}, {0, 3, 0});
    dmat4& m = s.objects[1].world_from_object;
    m[0] = dvec4(30, 0, 0, 0);
    m[1] = dvec4(0, 0, -30, 0);
    m[2] = dvec4(0, 1, 0, 0);
    scene::Scene black = s;
    black.lights.clear();
    EXPECT_EQ(draw(s), draw(black));
    EXPECT_GT(draw(s)[size / 2 * size + size / 2][2], 40);
}

TEST(Fog, IsAComponentOfItsOwn) {
    const scene::Scene s = road({.Ka = vec3(0.2f), .Kd = vec3(0.5f)});
    const auto machine = make_reference(vgx(), size, size);
    const auto images = render_components(*machine, s, scene::make_view(s, size, size), {});
    EXPECT_EQ(images.back().name, "fog");
    std::vector<Rgba> sum(size * size);
    for (const ComponentImage& image : images)
        for (std::size_t i = 0; i < sum.size(); ++i)
            for (std::size_t c = 0; c < 4; ++c)
                sum[i][c] =
                    static_cast<std::uint16_t>(std::min(255, sum[i][c] + image.color[i][c]));
    EXPECT_EQ(sum, draw(s));
}

}  // namespace
}  // namespace gw::multipass
