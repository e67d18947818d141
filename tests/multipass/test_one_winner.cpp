// Coincident faces are added once.
#include "multipass/effects/one_winner.h"

#include "multipass/frame/driver.h"
#include "tests/multipass/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace gw::multipass {
namespace {

constexpr int size = 16;

std::vector<Rgba> draw(const scene::Scene& s, OneWinner one_winner = OneWinner::Auto,
                       const Profile& profile = vgx()) {
    const auto machine = make_reference(profile, size, size);
    render(*machine, s, scene::make_view(s, size, size), {.one_winner = one_winner});
    return machine->planes().color;
}

TEST(OneWinner, AddsADoubledObjectOnce) {
    scene::Scene s = two_squares();
    const auto once = draw(s);
    s.objects.push_back(s.objects[0]);
    s.objects.push_back(s.objects[1]);
    EXPECT_EQ(draw(s), once);
    EXPECT_NE(draw(s, OneWinner::Never), once) << "else the scheme was not needed";
}

TEST(OneWinner, IsTheFirstObjectInEveryPass) {
    scene::Scene s = two_squares();
    const auto alone = draw(s);
    // A second material on the left square, with components and lights that the first has not:
    // nothing of it may show.
    scene::Material loud{.Ka = vec3(1), .Kd = vec3(1), .Ks = vec3(1), .Ke = vec3(1)};
    loud.refl = {plain_map(255, 255, 255)};
    loud.map_Ka = {plain_map(9, 9, 9), plain_map(9, 9, 9)};
    add_square(s, "loud", loud, {-1.25, 0, 0});
    s.lights.push_back({.direction = {0, 0, -1}, .Ia = vec3(1), .only = {"loud"}});
    EXPECT_EQ(draw(s), alone);
}

TEST(OneWinner, OnEveryProfileWithEveryEffect) {
    // A model whose faces are all there twice, as found models have them: the second set turned
    // over, and in a mesh of its own. Shadows both ways, fog, maps, emission, a selective light,
    // glare, superposition.
    scene::Scene s = two_squares();
    s.materials[0].map_Kd = {plain_map(200, 100, 50), plain_map(20, 30, 40)};
    s.materials[0].Ke = vec3(0.0625f);
    s.materials[1].refl = {plain_map(10, 60, 30)};
    s.fog = scene::Fog{.mode = FogMode::Linear, .color = {0.1f, 0.2f, 0.4f}, .start = 2, .end = 12};
    add_square(s, "roof", {.Kd = vec3(0.5f)}, {-1, 0.5, 1});
    s.objects.back().world_from_object[0].x = 0.5;
    s.lights[0].direction = {0.3f, -0.3f, -1};
    s.lights[0].shadow = scene::Shadow::Volume;
    s.lights[1].shadow = scene::Shadow::Map;
    s.lights.push_back({.direction = {0, 0, -1}, .Id = {0.2f, 0, 0}, .only = {"right"}});
    scene::Scene doubled = s;
    for (const scene::Object& object : s.objects) {
        MeshData data = object.mesh->data();
        std::reverse(data.indices.begin(), data.indices.end());
        doubled.objects.push_back(object);
        doubled.objects.back().mesh = make_mesh(std::move(data));
    }
    for (const Profile& profile : paper_profiles()) {
        EXPECT_EQ(draw(doubled, OneWinner::Auto, profile), draw(s, OneWinner::Auto, profile))
            << profile.name;
        EXPECT_NE(draw(doubled, OneWinner::Never, profile), draw(s, OneWinner::Auto, profile))
            << profile.name;
    }
}

TEST(OneWinner, ChangesNothingWhereNothingCoincides) {
    const scene::Scene s = two_squares();
    EXPECT_EQ(draw(s, OneWinner::Always), draw(s, OneWinner::Never));
    EXPECT_EQ(draw(s, OneWinner::Auto), draw(s, OneWinner::Never));
}

/// The left square again, turned over, and half of the right one: ties on some pixels, in two
/// parts.
scene::Scene partly_doubled() {
    scene::Scene s = two_squares();
    s.objects.push_back(s.objects[0]);
    MeshData half = s.objects[1].mesh->data();
    half.indices.resize(3);
    s.objects.push_back(s.objects[1]);
    s.objects.back().mesh = make_mesh(half);
    return s;
}

TEST(OneWinner, IsTheSameWithAndWithoutCareForOtherPixels) {
    const scene::Scene s = partly_doubled();
    const auto everywhere = draw(s, OneWinner::Always);
    EXPECT_EQ(draw(s), everywhere);
    EXPECT_EQ(draw(s), draw(two_squares()));
    EXPECT_NE(draw(s, OneWinner::Never), everywhere);
}

TEST(OneWinner, TiedPixelsAreFoundWithTheTrianglesNearThem) {
    const scene::Scene s = partly_doubled();
    const scene::View view = scene::make_view(s, size, size);
    const PassModel model = make_pass_model(s);
    const PlacedModel placed = place_model(model, view);
    std::vector<std::uint32_t> winners(std::size_t(size) * size, 1);
    EXPECT_TRUE(tied_pixels(placed, winners).spans.empty());
    EXPECT_TRUE(tied_pixels(placed, winners).portions.empty());
    winners[size + 3] = 2;
    const TiedPixels tied = tied_pixels(placed, winners);
    ASSERT_EQ(tied.spans.size(), 1u);
    EXPECT_EQ(tied.spans[0], (Span{.x = 3, .y = 1, .length = 1}));
    for (const Portion& portion : tied.portions)
        EXPECT_LE(portion.of(model.parts[portion.part].mesh)->triangles().size(),
                  model.parts[portion.part].mesh->triangles().size());
}

TEST(OneWinner, NeedsOneStencilBit) {
    Profile profile = vgx();
    profile.stencil_bits = 1;
    scene::Scene s = two_squares();
    const auto once = draw(s, OneWinner::Auto, profile);
    s.objects.push_back(s.objects[0]);
    EXPECT_EQ(draw(s, OneWinner::Auto, profile), once);
}

TEST(OneWinner, CountsTheSurplusFragments) {
    scene::Scene s = two_squares();
    const auto machine = make_reference(vgx(), size, size);
    const auto surplus = [&](const scene::Scene& counted) {
        machine->reset_passes();
        render(*machine, counted, scene::make_view(counted, size, size), {});
        const auto& passes = machine->passes();
        const auto at = std::find_if(passes.begin(), passes.end(),
                                     [](const PassReport& p) { return p.name == "count winners"; });
        return surplus_winners(std::span(passes).subspan(std::size_t(at - passes.begin()), 2));
    };
    EXPECT_EQ(surplus(s), 0u);
    s.objects.push_back(s.objects[0]);
    EXPECT_EQ(surplus(s), 7u * 8u) << "a square of 8x8 pixels, a column of it outside the window";
}

}  // namespace
}  // namespace gw::multipass
