// What the commands of a pass say: each object's own state, a glaring emitter's material, what a
// clear reaches.
#include "multipass/frame/driver.h"
#include "multipass/passes/catalogue.h"

#include "tests/multipass/scenes.h"

#include <gtest/gtest.h>

namespace gw::multipass {
namespace {

constexpr int size = 16;
constexpr std::size_t left = size / 2 * size + 2, right = size / 2 * size + 13;

std::vector<Rgba> draw(Machine& machine, const scene::Scene& s, const Options& options = {}) {
    render(machine, s, scene::make_view(s, size, size), options);
    return machine.planes().color;
}

std::vector<Rgba> draw(const scene::Scene& s) {
    return draw(*make_reference(vgx(), size, size), s);
}

TEST(Commands, SetTheStateOfEachObject) {
    scene::Scene s = two_squares();
    const Rgba plain = draw(s)[right];
    s.materials[0].map_Kd.push_back(plain_map(255, 0, 0));
    const std::vector<Rgba> picture = draw(s);
    EXPECT_EQ(picture[right], plain);
    EXPECT_GT(picture[left][0], picture[left][1]);
    std::swap(s.objects[0], s.objects[1]);
    EXPECT_EQ(draw(s), picture);
}

TEST(Commands, GiveGlareItsStrength) {
    scene::Scene s = two_squares();
    s.lights.clear();
    s.materials[0].Ke = vec3(1);
    s.objects.pop_back();
    s.objects[0].glare = scene::Glare{.radius = 1, .strength = 1, .samples = 4};
    const std::vector<Rgba> whole = draw(s);
    s.objects[0].glare->strength = 0.5f;
    const std::vector<Rgba> half = draw(s);
    int glow = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        if (whole[i][0] == 255) continue;  // the emitter itself
        glow += whole[i][0];
        EXPECT_NEAR(half[i][0], whole[i][0] / 2.0, 1) << i;
    }
    EXPECT_GT(glow, 1000);
}

TEST(Commands, ClearTheDepthInAPassThatDoesNotUpdateIt) {
    scene::Scene s = two_squares();
    s.materials[0].Ke = vec3(1);
    Options options;
    options.passes = PassList{{.name = "clear",
                               .clear = picture,
                               .depth = {.test = true, .func = DepthFunc::Less, .mask = false}},
                              {.name = "shine",
                               .material = {.Ke = object},
                               .depth = {.test = true, .func = DepthFunc::Less, .mask = true}}};
    const auto machine = make_reference(vgx(), size, size);
    const std::vector<Rgba> first = draw(*machine, s, options);
    EXPECT_EQ(first[left][0], 255);
    EXPECT_EQ(draw(*machine, s, options), first);
}

TEST(Commands, OfManyPartsComeInSeveralLists) {
    scene::Scene s = two_squares();
    s.lights.resize(1);
    const scene::Object square = s.objects[0];
    for (int i = 0; i < 1 << 16; ++i) {
        scene::Object more = square;
        more.world_from_object = dmat4(1.0 / 64);
        more.world_from_object[3] = {i % 256 / 64.0 - 2, i / 256 / 64.0 - 2, -1 - i % 7, 1};
        s.objects.push_back(std::move(more));
    }
    const scene::View view = scene::make_view(s, size, size);
    const PassList passes = passes_for(s, Renderer::Multipass);
    const auto at_once = make_fast(vgx(), size, size), in_parts = make_fast(vgx(), size, size);
    at_once->execute(frame_list(s, view, passes, s.background));
    render(*in_parts, s, view, {.one_winner = OneWinner::Never});
    EXPECT_TRUE(in_parts->planes() == at_once->planes());
    EXPECT_TRUE(in_parts->passes() == at_once->passes());
}

}  // namespace
}  // namespace gw::multipass
