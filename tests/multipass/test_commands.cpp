// What the commands of a pass say: each object's own state, a glaring emitter's material, what a
// clear reaches.
#include "gw/base/arithmetic.h"
#include "gw/error.h"
#include "multipass/frame/driver.h"
#include "multipass/passes/catalogue.h"

#include "tests/multipass/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

// The light around an emitter is summed before it is clamped: with any strength, on any background,
// it is that of a white emitter on black, times Ke and strength.
TEST(Commands, KeepColourAndStrengthOfGlare) {
    constexpr int count = 16;
    scene::Scene s = two_squares();
    s.lights.clear();
    s.objects.pop_back();
    s.materials[0] = {.name = "shine", .Ka = vec3(0), .Kd = vec3(0)};
    s.objects[0].glare = scene::Glare{.radius = 1, .strength = 1, .samples = count};
    const auto drawn = [&](const Profile& profile, const vec3& Ke, float strength,
                           const vec3& background) {
        s.materials[0].Ke = Ke;
        s.objects[0].glare->strength = strength;
        s.background = background;
        return draw(*make_fast(profile, size, size), s);
    };
    const vec3 Ke(1, 0.75f, 0.25f);
    for (const Profile& profile : {vgx(), ideal()}) {
        const std::vector<Rgba> white = drawn(profile, vec3(1), 1, vec3(0)),
                                alone = drawn(profile, vec3(1), 0, vec3(0));
        const double most = max_of_bits(profile.color_bits);
        for (const float strength : {0.75f, 1.0f, 1.5f, 2.0f, 3.0f, 7.0f})
            for (const vec3& background : {vec3(0), vec3(0.25f, 0.5f, 0.125f)}) {
                const std::vector<Rgba> seen = drawn(profile, Ke, strength, background);
                int glow = 0;
                for (std::size_t i = 0; i < seen.size(); ++i) {
                    if (alone[i][0] > 0 || white[i][0] == 0) continue;
                    ++glow;
                    const double covered = std::round(white[i][0] / most * count) / count;
                    for (int c = 0; c < 3; ++c) {
                        const double light =
                            double(background[c]) + double(Ke[c] * strength) * covered;
                        // Of the colours, times the images, and of the mean.
                        const double rounding = std::ceil(strength) * covered / 2 + 2;
                        EXPECT_NEAR(seen[i][std::size_t(c)], std::min(light, 1.0) * most, rounding)
                            << profile.name << " " << strength << " pixel " << i << " channel "
                            << c;
                    }
                }
                EXPECT_GT(glow, 20);
            }
    }
}

TEST(Commands, RefuseGlareThatNoSumHasPlaceFor) {
    scene::Scene s = two_squares();
    s.materials[0].Ke = vec3(2);
    s.objects[0].glare = scene::Glare{.radius = 1, .strength = 63.5f, .samples = 1};
    draw(s);
    s.objects[0].glare->strength = 64;
    try {
        draw(s);
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "glare of object 'left': its strength times Ke takes 128 images; expected at "
                     "most 127, which fit in the accumulation buffer");
    }
}

TEST(Commands, ClearTheDepthInAPassThatDoesNotUpdateIt) {
    scene::Scene s = two_squares();
    s.materials[0].Ke = vec3(1);
    Options options;
    options.pass_list = PassList{{.name = "clear",
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
