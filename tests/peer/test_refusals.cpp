// What the player cannot express, or is not given rightly, it names.
#include "gw/error.h"
#include "inspect/peer/player.h"
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

TEST(PlayerRefuses, BothColorPlanesAtOnce) {
    State state;
    state.draw_buffer = DrawBuffer::FrontAndBack;
    CommandList list;
    add(list, state, any_draw());
    try {
        play("llvmpipe", {list}, size, size, opengl());
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).substr(0, 42),
                  "command 1 (Draw): draw_buffer = FrontAndBa");
    }
}

std::string refused_library(const std::string& path) {
    try {
        const peer::Player player(vgx(), 8, 8, path);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(PlayerRefuses, WhatIsNoOpenGL) {
    EXPECT_TRUE(refused_library("/no/such/libOSMesa.so").starts_with("cannot load an OpenGL: "));
    EXPECT_EQ(refused_library("libm.so.6"),
              "libm.so.6 is no OpenGL: it has neither OSMesaMakeCurrent nor glXMakeContextCurrent");
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
