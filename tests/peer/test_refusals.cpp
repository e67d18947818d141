// What the player cannot express, or is not given rightly, it names.
#include "gw/error.h"
#include "tests/peer/compare.h"

namespace gw {
namespace {

using namespace test;

std::string refusal(const State& state, const Command& command) {
    CommandList list;
    add(list, state, command);
    try {
        play("llvmpipe", {list}, size, size);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

Draw any_draw() {
    Random random(1);
    return Draw{.mesh = make_mesh(mesh_of(random_triangle(random), {0, 0, 0}, {}))};
}

TEST(PlayerRefuses, TwoSidedLighting) {
    State state;
    state.color_source = ColorSource::Lighting;
    state.lighting.two_side = true;
    EXPECT_NE(refusal(state, any_draw()).find("command 1 (Draw): lighting.two_side"),
              std::string::npos);
}

TEST(PlayerRefuses, ExtensionsThatTheProfileLacks) {
    State state;
    state.polygon_offset.enable = true;
    EXPECT_EQ(refusal(state, any_draw()),
              "command 0 (SetState): extension polygon_offset is not in profile vgx");
}

TEST(PlayerRefuses, EmptySlots) {
    Draw draw = any_draw();
    draw.map.slot = 3;
    EXPECT_EQ(refusal(State{}, draw),
              "command 1 (Draw): texture slot 3 is empty; expected a CopyTexture before");
}

}  // namespace
}  // namespace gw
