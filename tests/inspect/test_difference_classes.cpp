// Claim: each wrong pixel of another renderer has a cause, by what painted it.
#include <gtest/gtest.h>

#include "gw/reference/make.h"
#include "inspect/compare/difference_classes.h"

namespace gw::inspect {
namespace {

MeshRef box(float left, float right) {
    return make_mesh({.primitive = Primitive::Quads,
                      .positions = {{left, -1, 0}, {right, -1, 0}, {right, 1, 0}, {left, 1, 0}}});
}

/// 8 x 2 pixels: two columns each plain, textured, smooth; two untouched.
Recording three_boxes() {
    Recording r;
    r.profile = opengl();
    r.width = 8;
    r.height = 2;
    CommandList list;
    State s;
    s.draw_buffer = DrawBuffer::Back;
    list.add(BeginPass{"boxes"});
    list.add(SetState{s});
    list.add(Draw{.mesh = box(-1, -0.5f)});
    const std::array<std::uint16_t, 4> texel{40000, 50000, 60000, 65535};
    list.add(Draw{.mesh = box(-0.5f, 0), .map = {.texture = make_texture("one", 1, 1, texel)}});
    s.polygon_smooth = true;
    list.add(SetState{s});
    list.add(Draw{.mesh = box(0, 0.5f)});
    list.add(SwapBuffers{});
    s.read_buffer = ReadBuffer::Front;  // programs' frames are read when they are shown
    list.add(SetState{s});
    r.lists = {list};
    return r;
}

struct Played {
    Recording recording = three_boxes();
    Painted painted{recording};
    Planes planes;
    Played() {
        const auto machine = reference::make(recording.profile, 8, 2, &painted);
        Player(recording, *machine).play();
        planes = machine->planes();
    }
};

CauseTally of(const CauseTallies& tallies, Cause cause) { return tallies[std::size_t(cause)]; }

}  // namespace

TEST(DifferenceClasses, KnowWhatPaintedEachPixel) {
    const Played played;
    EXPECT_EQ(played.painted.main_plane(), Plane::Color);
    const std::vector<Paint> row{Paint::Plain,  Paint::Plain,  Paint::Textured, Paint::Textured,
                                 Paint::Smooth, Paint::Smooth, Paint::Plain,    Paint::Plain};
    const std::vector<Paint>& front = played.painted.of(Plane::Color);
    EXPECT_EQ(std::vector(front.begin(), front.begin() + 8), row);
}

TEST(DifferenceClasses, CountUnitsByCause) {
    const Played played;
    Planes theirs = played.planes;
    const auto tally = [&] {
        return tally_causes(played.planes, theirs, Plane::Color, played.painted.of(Plane::Color));
    };
    EXPECT_EQ(tally(), CauseTallies{});
    theirs.color[0][1] -= 3;
    theirs.color[1][2] -= 100;
    theirs.color[2][0] += 2;
    theirs.color[4][3] -= 50;
    theirs.depth[7] = 9;
    theirs.stencil[7] = 1;
    const CauseTallies found = tally();
    EXPECT_EQ(of(found, Cause::Color), (CauseTally{2, 103, 100}));
    EXPECT_EQ(of(found, Cause::Color).mean(), 51.5);
    EXPECT_EQ(of(found, Cause::Texture), (CauseTally{1, 2, 2}));
    EXPECT_EQ(of(found, Cause::Antialiasing), (CauseTally{1, 50, 50}));
    EXPECT_EQ(of(found, Cause::Depth), (CauseTally{1, 9, 9}));
    EXPECT_EQ(of(found, Cause::Stencil), (CauseTally{1, 1, 1}));
    EXPECT_EQ(of(found, Cause::Coverage), CauseTally{});
}

/// The neighbour's colour: a side fell between other pixels.
TEST(DifferenceClasses, AnEdgeIsCoverageWhateverPaintedIt) {
    const Played played;
    Planes theirs = played.planes;
    theirs.color[2] = theirs.color[1];
    theirs.color[6] = theirs.color[5];
    const CauseTallies found =
        tally_causes(played.planes, theirs, Plane::Color, played.painted.of(Plane::Color));
    EXPECT_EQ(of(found, Cause::Coverage).pixels, 2u);
    EXPECT_EQ(of(found, Cause::Texture).pixels, 0u);
}

TEST(DifferenceClasses, PassesAddUp) {
    CauseTallies total{};
    CauseTallies one{};
    one[0] = {2, 10, 7};
    add(total, one);
    one[0] = {1, 3, 3};
    add(total, one);
    EXPECT_EQ(total[0], (CauseTally{3, 13, 7}));
}

}  // namespace gw::inspect
