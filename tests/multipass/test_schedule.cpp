// Pass lists and schedules: which passes run, how often, and who takes part.
#include "multipass/steps/schedule.h"

#include "gw/error.h"
#include "multipass/frame/driver.h"
#include "multipass/passes/catalogue.h"
#include "tests/multipass/scenes.h"

#include <gtest/gtest.h>

namespace gw::multipass {
namespace {

std::vector<std::string> names(const scene::Scene& s, Renderer renderer = Renderer::Multipass) {
    const PassModel model = make_pass_model(s);
    std::vector<std::string> result;
    for (const Step& step : schedule(passes_for(s, renderer), model))
        result.push_back(name_of(step, model));
    return result;
}

std::vector<std::string> drawn_passes(const CommandList& list) {
    std::vector<std::string> result;
    for (const Command& c : list.commands)
        if (const auto* begin = std::get_if<BeginPass>(&c)) result.push_back(begin->name);
    return result;
}

TEST(Schedule, RepeatsLightPassesLightByLight) {
    EXPECT_EQ(names(two_squares()),
              (std::vector<std::string>{"depth", "ambient key", "diffuse key", "specular key",
                                        "ambient fill", "diffuse fill", "specular fill",
                                        "reflection", "refraction", "emission"}));
}

TEST(Schedule, PutsTheShadowBeforeItsLightsPasses) {
    scene::Scene s = two_squares();
    s.lights[1].shadow = scene::Shadow::Volume;
    EXPECT_EQ(names(s),
              (std::vector<std::string>{"depth", "ambient key", "diffuse key", "specular key",
                                        "shadow fill", "ambient fill", "diffuse fill",
                                        "specular fill", "reflection", "refraction", "emission"}));
    const PassModel model = make_pass_model(s);
    for (const Step& step : schedule(passes_for(s, Renderer::Multipass), model))
        EXPECT_EQ(step.pass.stencil.test, step.light == 1 && (step.pass.name == Name("diffuse") ||
                                                              step.pass.name == Name("specular")));
}

TEST(Schedule, HasNoLimitOfLights) {
    scene::Scene s = two_squares();
    s.lights.assign(1000, s.lights[0]);
    EXPECT_EQ(names(s).size(), 1 + 3 * 1000 + 3);
}

TEST(Schedule, RepeatsAComponentForEachOfItsMaps) {
    scene::Scene s = two_squares();
    s.lights.resize(1);
    s.materials[0].map_Ka = {plain_map(1, 1, 1), plain_map(2, 2, 2), plain_map(3, 3, 3)};
    const auto all = names(s);
    EXPECT_EQ(std::vector(all.begin() + 1, all.begin() + 5),
              (std::vector<std::string>{"ambient key", "ambient key map 2", "ambient key map 3",
                                        "diffuse key"}));
}

TEST(Concerns, OnlyThoseThatCanAddSomething) {
    scene::Scene s = two_squares();
    s.materials[0].map_Ka = {plain_map(1, 1, 1), plain_map(2, 2, 2)};
    s.lights[1].only = {"right"};
    const PassModel model = make_pass_model(s);
    const Part &left = model.parts[0], &right = model.parts[1];
    EXPECT_TRUE(concerns({ambient_pass, 0, 0}, left, model));
    EXPECT_TRUE(concerns({ambient_pass, 0, 1}, left, model));
    EXPECT_FALSE(concerns({ambient_pass, 0, 1}, right, model)) << "it has no second map";
    EXPECT_FALSE(concerns({specular_pass, 0, 0}, left, model)) << "its Ks is 0";
    EXPECT_FALSE(concerns({diffuse_pass, 1, 0}, left, model)) << "the light is for the other";
    EXPECT_FALSE(concerns({reflection_pass, {}, 0}, right, model)) << "it has no reflection map";
    EXPECT_TRUE(concerns({depth_pass, {}, 0}, left, model)) << "Z is of all shapes";
}

TEST(FrameList, LeavesOutPassesThatAddNothing) {
    const scene::Scene s = two_squares();
    const CommandList list =
        frame_list(s, scene::make_view(s, 8, 8), passes_for(s, Renderer::Multipass), vec3(0));
    EXPECT_EQ(drawn_passes(list),
              (std::vector<std::string>{"depth", "ambient key", "diffuse key", "specular key",
                                        "ambient fill", "diffuse fill", "specular fill"}));
}

TEST(FrameList, AfterTheDepthPassNothingUpdatesZAndNoStencilOperationRuns) {
    const scene::Scene s = two_squares();
    const CommandList list =
        frame_list(s, scene::make_view(s, 8, 8), passes_for(s, Renderer::Multipass), vec3(0));
    bool after_depth = false;
    for (const Command& c : list.commands) {
        if (const auto* begin = std::get_if<BeginPass>(&c)) after_depth = begin->name != "depth";
        const auto* set = std::get_if<SetState>(&c);
        if (!set || !after_depth) continue;
        EXPECT_EQ(set->state->depth, seen);
        EXPECT_EQ(set->state->blend, add);
        EXPECT_EQ(set->state->stencil, StencilState{});
    }
    EXPECT_TRUE(after_depth);
}

TEST(FrameList, AllPassesOfAViewShareItsGeometry) {
    const scene::Scene s = two_squares();
    const CommandList list =
        frame_list(s, scene::make_view(s, 8, 8), passes_for(s, Renderer::Multipass), vec3(0));
    std::optional<State> first;
    for (const Command& c : list.commands) {
        if (const auto* draw = std::get_if<Draw>(&c)) {
            const bool left = draw->eye_from_object[3].x < 0;
            EXPECT_EQ(draw->mesh, s.objects[left ? 0 : 1].mesh);
        }
        const auto* set = std::get_if<SetState>(&c);
        if (!set) continue;
        if (!first) first = set->state;
        EXPECT_EQ(set->state->projection, first->projection);
        EXPECT_EQ(set->state->viewport, first->viewport);
        EXPECT_EQ(set->state->cull, first->cull);
        EXPECT_EQ(set->state->jitter, first->jitter);
    }
    EXPECT_TRUE(first.has_value());
}

TEST(ComponentLists, AreOnePerAdditivePassOverTheSameZ) {
    const scene::Scene s = two_squares();
    const auto lists = component_lists(s, passes_for(s, Renderer::Multipass));
    std::vector<std::string> result;
    for (const ComponentList& list : lists) {
        result.push_back(list.name);
        EXPECT_EQ(list.passes.front(), depth_pass);
    }
    EXPECT_EQ(result, (std::vector<std::string>{"ambient", "diffuse", "specular", "reflection",
                                                "refraction", "emission"}));
}

TEST(CheckLights, NamesTheLimitAndTheRendererThatHasNone) {
    scene::Scene s = two_squares();
    s.lights.assign(9, s.lights[0]);
    try {
        check_lights(s, {hardware_pass}, vgx());
        FAIL() << "nine lights in one pass of the VGX";
    } catch (const Error& e) {
        EXPECT_STREQ(
            e.what(),
            "9 lights on object 'left'; profile vgx knows 8 in one pass. --renderer multipass has no limit");
    }
    EXPECT_NO_THROW(check_lights(s, {hardware_pass}, ideal()));
    s.lights[0].only = {"right"};
    s.lights[1].only = {"left"};
    EXPECT_NO_THROW(check_lights(s, {hardware_pass}, vgx())) << "eight on each object";
}

}  // namespace
}  // namespace gw::multipass
