// docs/manual/differences.md: the worked examples.
#include "tests/gw/workbench.h"

namespace gw {
namespace {

using test::Workbench;

TEST(ManualDifferences, SumsBeyondOneAreKept) {
    Workbench bench(vgx(), 4, 4);
    bench.write({0, 0, 4, 4}, {200, 200, 200, 200});
    for (int i = 0; i < 16; ++i) bench.run(Accumulate{AccumOp::Accum, 1});
    EXPECT_EQ(bench.accum(1, 1)[0], 3200);
    bench.run(Accumulate{AccumOp::Return, 1.0f / 16});
    EXPECT_EQ(bench.color(1, 1)[0], 200);
}

/// Red in column 8 of a line from x = 0.5, w = 1, to x = 16.5, w = 3, in a window of 32 pixels.
int half_way(const Profile& profile) {
    Workbench bench(profile, 32, 32);
    bench.state.projection = dmat4{1};
    bench.state.projection[2] = {0, 0, 0, 1};  // clip = (x, y, 0, z)
    bench.state.projection[3] = {0, 0, 0, 0};
    const float left = 0.5f / 16 - 1, right = 16.5f / 16 - 1, y = 4.5f / 16 - 1;
    bench.draw(Primitive::Lines, {{left, y, 1}, {3 * right, 3 * y, 3}},
               {{0, 0, 0, 1}, {1, 0, 0, 1}});
    return bench.color(8, 4)[0];
}

TEST(ManualDifferences, HalfWayOnTheScreen) {
    Profile in_perspective = vgx();
    in_perspective.perspective_color = true;
    EXPECT_EQ(half_way(vgx()), 128);
    EXPECT_EQ(half_way(in_perspective), 64);
}

}  // namespace
}  // namespace gw
