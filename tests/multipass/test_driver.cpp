// Pictures by passes: sums of components, many lights, selective light, eq. 1 against eq. 2.
#include "multipass/frame/driver.h"

#include "tests/multipass/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gw::multipass {
namespace {

constexpr int size = 16;

std::vector<Rgba> draw(const scene::Scene& s, const Options& options = {},
                       const Profile& profile = vgx()) {
    const auto machine = make_reference(profile, size, size);
    render(*machine, s, scene::make_view(s, size, size), options);
    return machine->planes().color;
}

/// The colour in the middle of the left and the right square of two_squares, and beside them.
constexpr int left = size / 2 * size + 2, right = size / 2 * size + 13, outside = 0;

/// Sum of component images, saturated.
std::vector<Rgba> sum_of_components(const scene::Scene& s, const Profile& profile,
                                    const Options& options = {}) {
    const auto machine = make_reference(profile, size, size);
    std::vector<Rgba> sum(size * size);
    const std::uint32_t max = (1u << profile.color_bits) - 1;
    for (const ComponentImage& image :
         render_components(*machine, s, scene::make_view(s, size, size), options))
        for (std::size_t i = 0; i < sum.size(); ++i)
            for (std::size_t c = 0; c < 4; ++c)
                sum[i][c] = static_cast<std::uint16_t>(
                    std::min<std::uint32_t>(max, sum[i][c] + image.color[i][c]));
    return sum;
}

TEST(Components, AddUpToThePictureOnEveryProfile) {
    scene::Scene s = two_squares();
    s.materials[0].Ke = vec3(0.0625f, 0, 0);
    s.materials[1].map_Kd = {plain_map(255, 128, 3)};
    s.materials[1].refl = {plain_map(20, 40, 60)};
    for (const Profile& profile : paper_profiles()) {
        const auto whole = draw(s, {}, profile);
        EXPECT_EQ(sum_of_components(s, profile), whole) << profile.name;
        EXPECT_LT(std::max(whole[left][0], whole[right][0]), (1 << profile.color_bits) - 1)
            << "not saturated";
    }
}

TEST(Components, AddUpWhereTheSumSaturatesAndOnABackground) {
    scene::Scene s = two_squares();
    s.background = {0.25f, 0.5f, 0};
    for (scene::Light& light : s.lights) light.Id = vec3(2);
    const auto whole = draw(s);
    EXPECT_EQ(whole[left], (Rgba{255, 255, 255, 255}));
    EXPECT_EQ(whole[outside], (Rgba{64, 128, 0, 255}));
    EXPECT_EQ(sum_of_components(s, vgx()), whole);
}

TEST(Multipass, AddsOneLightAfterTheOther) {
    scene::Scene s = two_squares();
    s.materials[0] = {.Ka = vec3(0), .Kd = vec3(1)};
    s.lights.resize(1);
    s.lights[0].Ia = vec3(0);
    s.lights[0].Id = vec3(2 / 255.0f, 1 / 255.0f, 0);
    for (const unsigned count : {1u, 2u, 9u, 100u}) {
        s.lights.assign(count, s.lights[0]);
        const auto n = static_cast<std::uint16_t>(count);
        EXPECT_EQ(draw(s)[left], (Rgba{std::uint16_t(2 * n), n, 0, 255}));
    }
}

TEST(Multipass, ASelectiveLightLightsItsPartsOnly) {
    scene::Scene s = two_squares();
    s.lights.resize(1);
    s.lights[0].only = {"right"};
    const auto picture = draw(s);
    EXPECT_EQ(picture[left], (Rgba{0, 0, 0, 255}));
    EXPECT_GT(picture[right][0], 0);
}

TEST(Multipass, ASelectiveLightDoesNotLeakThroughWhatHidesItsParts) {
    scene::Scene s = two_squares();
    add_square(s, "screen", {.Ka = vec3(0), .Kd = vec3(1)}, {0, 0, 1});
    s.objects.back().world_from_object[0].x = 4;
    s.lights.resize(1);
    s.lights[0].only = {"left", "right"};
    for (const Rgba& color : draw(s)) EXPECT_EQ(color, (Rgba{0, 0, 0, 255}));
    std::rotate(s.objects.begin(), s.objects.begin() + 2, s.objects.end());
    for (const Rgba& color : draw(s))
        EXPECT_EQ(color, (Rgba{0, 0, 0, 255})) << "in whatever order they come";
}

TEST(Multipass, SeveralMapsOfAComponentAddUp) {
    scene::Scene s = two_squares();
    s.materials[0] = {.Ka = vec3(1), .Kd = vec3(0)};
    s.lights.resize(1);
    s.lights[0].Ia = vec3(1);
    s.materials[0].map_Ka = {plain_map(10, 0, 1), plain_map(0, 20, 2), plain_map(0, 0, 4)};
    EXPECT_EQ(draw(s)[left], (Rgba{10, 20, 7, 255}));
    EXPECT_EQ(draw(s, {.renderer = Renderer::Hardware})[left], (Rgba{10, 0, 1, 255}))
        << "eq. 1 has one map";
}

TEST(Multipass, TextureAndReflectionMapOnOneObject) {
    scene::Scene s = two_squares();
    s.materials[0] = {.Ka = vec3(0), .Kd = vec3(1), .Ks = vec3(1)};
    s.materials[0].map_Kd = {plain_map(100, 0, 0)};
    s.materials[0].refl = {plain_map(0, 50, 0)};
    s.lights.resize(1);
    s.lights[0].Id = vec3(1);
    s.lights[0].Is = vec3(0);
    EXPECT_EQ(draw(s)[left], (Rgba{100, 50, 0, 255}));
}

/// The gloss of a red ring [K Fig. 1]: highlight and body in one colour, since Ns = 0 makes the
/// gloss the same everywhere.
struct Gloss {
    scene::Scene s = two_squares();
    Gloss() {
        s.materials[0] = {.Ka = vec3(0), .Kd = vec3(0.5f), .Ks = vec3(0.25f), .Ns = 0};
        s.lights.resize(1);
        s.lights[0] = {.direction = {0, 0, -1}, .Id = vec3(1)};
    }
};

TEST(Figure1, WithoutAMapTheGlossIsWhite) {
    EXPECT_EQ(draw(Gloss().s, {.renderer = Renderer::Hardware})[left], (Rgba{191, 191, 191, 255}));
}

TEST(Figure1, HardwareWithARedMapReddensTheGloss) {
    Gloss gloss;
    gloss.s.materials[0].map_Kd = {plain_map(255, 0, 0)};
    EXPECT_EQ(draw(gloss.s, {.renderer = Renderer::Hardware})[left], (Rgba{191, 0, 0, 255}));
}

TEST(Figure1, MultipassKeepsTheGlossWhiteOnARedMap) {
    Gloss gloss;
    gloss.s.materials[0].map_Kd = {plain_map(255, 0, 0)};
    EXPECT_EQ(draw(gloss.s)[left], (Rgba{128 + 64, 64, 64, 255}));
}

TEST(Hardware, LightsEachObjectByItsOwnLights) {
    scene::Scene s = two_squares();
    s.lights[0].only = {"right"};
    s.lights[1].only = {"right"};
    const auto picture = draw(s, {.renderer = Renderer::Hardware});
    EXPECT_EQ(picture[left], (Rgba{0, 0, 0, 255}));
    EXPECT_GT(picture[right][0], 0);
}

TEST(PassReports, CountWhatEachPassDraws) {
    const scene::Scene s = two_squares();
    const auto machine = make_reference(vgx(), size, size);
    render(*machine, s, scene::make_view(s, size, size), {});
    const auto& passes = machine->passes();
    const auto find = [&](const char* name) {
        return std::find_if(passes.begin(), passes.end(),
                            [&](const PassReport& p) { return p.name == name; });
    };
    EXPECT_EQ(find("depth")->counters.primitives, 4u);
    EXPECT_EQ(find("ambient key")->counters.primitives, 4u);
    EXPECT_EQ(find("specular key")->counters.primitives, 2u);
    EXPECT_EQ(find("ambient key")->counters.written, find("depth")->counters.written);
}

}  // namespace
}  // namespace gw::multipass
