// What a project of yours would hold its renderer to.
#include "my_renderer.h"

#include <gw/machine.h>
#include <inspect/testing/expect_passes.h>
#include <inspect/testing/matchers.h>

#include <gtest/gtest.h>

namespace {

using namespace gw::testing;
using ::testing::Gt;

gw::inspect::Recording recording(int turn) {
    return recording_of(my_renderer::pyramid(turn), gw::vgx(), 64, 64);
}

}  // namespace

// The whole picture, pass by pass. After a wanted change: GW_UPDATE_GOLDENS=1 ctest --test-dir
// build
TEST(MyRenderer, DrawsThePyramidAsTheGoldenSays) {
    EXPECT_PASSES_EQ(recording(0), "goldens/pyramid.json");
}

// Another claim, without a golden: a square pyramid under a lamp at the eye is the same from all
// four sides.
TEST(MyRenderer, DrawsTheSamePictureFromEverySide) {
    const auto front = gw::make_fast(gw::vgx(), 64, 64), side = gw::make_fast(gw::vgx(), 64, 64);
    front->execute(my_renderer::pyramid(0));
    side->execute(my_renderer::pyramid(90));
    EXPECT_THAT(side->planes(), PlanesEq(front->planes(), gw::vgx()));
}

TEST(MyRenderer, CoversTheMiddleAndNotTheCorners) {
    const auto machine = gw::make_fast(gw::vgx(), 64, 64);
    machine->execute(my_renderer::pyramid());
    EXPECT_THAT(machine->planes(), HasColor(0, 0, {0, 0, 0, 0}));
    gw::Planes background(64, 64);
    EXPECT_THAT(machine->planes(), CoveredPixels(gw::Plane::Color, background, Gt(500u)));
}
