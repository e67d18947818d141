// Claims: the first difference of two recordings is named: profile, command, state's field, mesh's
// element, map, light; and of their planes the pass, the worst pixel, and the fragment that made
// it.
#include <gtest/gtest.h>

#include "inspect/compare/difference.h"
#include "inspect/replay/player.h"
#include "tests/inspect/same.h"
#include "tests/inspect/three_passes.h"

namespace gw::inspect {
namespace {

std::string first(const Recording& a, const Recording& b) {
    const auto finding = first_command_difference(a, b);
    return finding ? text(*finding, a.height) : "none";
}

Recording with_draw(const Draw& draw) {
    Recording recording = recording_of(BeginPass{.name = "p"});
    recording.lists[0].add(draw);
    return recording;
}

}  // namespace

TEST(Diff, OfARecordingAndItselfIsNothing) {
    for (const fuzz::Suite& suite : fuzz::suites()) {
        const Recording a = recording_of(fuzz::make_case(suite, 0));
        EXPECT_EQ(first(a, decode(encode(a))), "none");
        EXPECT_FALSE(first_result_difference(a, a, maker_of("fast", 1)));
    }
}

TEST(Diff, HowCommandsAreCutIntoListsDoesNotCount) {
    const Recording a = three_passes();
    Recording b = a;
    b.lists[0].append(b.lists[1]);
    b.lists.pop_back();
    EXPECT_EQ(first(a, b), "none");
}

TEST(Diff, NamesWhatDiffers) {
    const MeshData data{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    const Draw draw{.mesh = make_mesh(data)};
    const Recording a = with_draw(draw);
    Draw other = draw;
    MeshData moved = data;
    moved.positions[1].y = 2;
    other.mesh = make_mesh(moved);
    EXPECT_EQ(first(a, with_draw(other)),
              "pass 0 'p', command 1 (Draw), positions 1: expected 1 0 0, got 1 2 0\n");
    other = draw;
    other.material.Kd.y = 0.5f;
    EXPECT_EQ(first(a, with_draw(other)),
              "pass 0 'p', command 1 (Draw), Kd: expected 0.8 0.8 0.8, got 0.8 0.5 0.8\n");
    other = draw;
    other.lights = std::make_shared<const std::vector<Light>>(1);
    EXPECT_EQ(first(a, with_draw(other)),
              "pass 0 'p', command 1 (Draw), number of lights: expected 0, got 1\n");
    other = draw;
    other.map.texture = make_texture8("wood", 1, 1, std::vector<std::uint8_t>{1, 2, 3, 4});
    EXPECT_EQ(first(a, with_draw(other)),
              "pass 0 'p', command 1 (Draw), map: expected none, got wood\n");
    other = draw;
    other.eye_from_object[3].x = 1;
    EXPECT_NE(first(a, with_draw(other)).find("eye_from_object"), std::string::npos);
}

TEST(Diff, NamesTheMemberOfADrawnRectangle) {
    const auto with = [](const DrawPixels& d) { return recording_of(d); };
    DrawPixels draw{.width = 2, .height = 1, .raster = {.x = 1.5}, .colors = {{1, 2, 3, 4}, {}}};
    const Recording a = with(draw);
    DrawPixels other = draw;
    other.raster.x = 2;
    EXPECT_NE(first(a, with(other)).find("(DrawPixels), raster: expected x 1.5 y 0 depth 0"),
              std::string::npos);
    other = draw;
    other.colors[1][3] = 9;
    EXPECT_NE(first(a, with(other)).find("colors 1: expected 0 0 0 0, got 0 0 0 9"),
              std::string::npos);
    other = draw;
    other.source = PixelSource{Plane::Depth, 3, 4};
    EXPECT_NE(first(a, with(other)).find("source: expected none, got Depth 3 4"),
              std::string::npos);
    other = draw;
    other.map.slot = 3;
    EXPECT_NE(first(a, with(other)).find("texture slot: expected none, got 3"), std::string::npos);
    other = draw;
    other.map.surface = SurfacePlane{2, Plane::Depth};
    EXPECT_NE(
        first(a, with(other)).find("texture's surface: expected none, got Depth of surface 2"),
        std::string::npos);
}

TEST(Diff, NamesTheStatesField) {
    Recording a = recording_of(SetState{}),
              b = recording_of(SetState{State{.blend = {.dst = BlendFactor::One}}});
    EXPECT_EQ(first(a, b), "command 0 (SetState), blend.dst: expected 'Zero', got 'One'\n");
    b = a;
    b.profile = ideal();
    EXPECT_NE(first(a, b).find("profile"), std::string::npos);
    b = a;
    b.lists[0].add(Clear{});
    EXPECT_EQ(first(a, b), "number of commands: expected 1, got 2\n");
    EXPECT_EQ(first(a, recording_of(Clear{})),
              "command 0 (SetState), kind: expected SetState, got Clear\n");
}

TEST(Diff, FindsTheWorstPixelAndItsFragment) {
    const Recording a = three_passes();
    Recording b = a;
    auto& colors = std::get<WritePixels>(b.lists[0].commands[3]).colors;
    colors[0][0] += 1;
    colors[3][2] += 50;
    const auto d = first_result_difference(a, b, maker_of("fast", 1));
    ASSERT_TRUE(d);
    EXPECT_EQ(
        text(d->finding, a.height),
        "pass 1 'first', plane color, 2 pixels, the worst one, pixel 3 3: expected 100 100 100 255, got 100 "
        "100 150 255\n");
    EXPECT_EQ(wrong_pixel_lines(*d, 5),
              "3 3: 100 100 100 255, 100 100 150 255\n2 4: 100 100 100 255, 101 100 100 255\n");
    EXPECT_EQ(wrong_pixel_lines(*d, 1), "3 3: 100 100 100 255, 100 100 150 255\n... and 1 more\n");
    const std::string events = first_event_difference(a, b, 3, 2);
    EXPECT_NE(
        events.find(
            "A: pass first, command 3, primitive 3, outcome written, fragment's colour 100 100 100 255"),
        std::string::npos)
        << events;
    EXPECT_NE(
        events.find(
            "B: pass first, command 3, primitive 3, outcome written, fragment's colour 100 100 150 255"),
        std::string::npos);
}

}  // namespace gw::inspect
