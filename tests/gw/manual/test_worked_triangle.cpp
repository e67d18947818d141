// The worked triangle of docs/manual/rasterization.md, "Planes": its numbers by hand and through
// the machine.
#include "gw/reference/plane_equation.h"
#include "tests/gw/workbench.h"

namespace gw {
namespace {

using namespace reference;

const std::array<WindowVertex, 3> vertices{
    {{82, 28, 1000000}, {561, 160, 5000000}, {120, 486, 9000000}}};

// [R9.6]
TEST(WorkedTriangle, HasTheManualsGradients) {
    const SnappedTriangle t = snapped_triangle(vertices, {}, 3);
    EXPECT_EQ(t.area2, 214366);
    const PlaneEquation z = plane_through(t, {1000000, 5000000, 9000000});
    EXPECT_EQ(std::int64_t(z.gx), 1897910527);
    EXPECT_EQ(std::int64_t(z.gy), 9000400437);
    const PlaneEquation red = plane_through(t, {0, 255, 128});
    EXPECT_EQ(std::int64_t(red.gx), 244317);
    EXPECT_EQ(std::int64_t(red.gy), 126255);
    EXPECT_EQ(z.at(20, 20), 3631537);
    EXPECT_EQ(red.at(20, 20), 71);
    EXPECT_EQ(z.at(64, 20), 4905769);
}

// [R9.8] [R9.9]
TEST(WorkedTriangle, IsDrawnSo) {
    test::Workbench bench(vgx(), 128, 64);
    bench.state.depth = {.test = true, .func = DepthFunc::Always};
    bench.draw(Primitive::Triangles,
               {{10.25f, 3.5f, 1000000}, {70.125f, 20, 5000000}, {15, 60.75f, 9000000}},
               {{0, 0, 0, 1}, {1, 0, 0, 1}, {128 / 255.0f, 0, 0, 1}});
    EXPECT_EQ(bench.depth(20, 20), 3631537u);
    EXPECT_EQ(bench.color(20, 20), (Rgba{71, 0, 0, 255}));
    EXPECT_EQ(bench.depth(64, 20), 4905769u);
    EXPECT_EQ(bench.take_counters().drawn, 1u);
}

TEST(WorkedTriangle, IsTheSameInEveryOrderOfItsVertices) {
    std::array<std::size_t, 3> order{0, 1, 2};
    const PlaneEquation expected =
        plane_through(snapped_triangle(vertices, {}, 3), {1000000, 5000000, 9000000});
    do {
        const SnappedTriangle t =
            snapped_triangle({vertices[order[0]], vertices[order[1]], vertices[order[2]]}, {}, 3);
        const auto z = [&](std::size_t i) { return std::int64_t{vertices[order[t.source[i]]].z}; };
        const PlaneEquation p = plane_through(t, {z(0), z(1), z(2)});
        EXPECT_TRUE(p.gx == expected.gx && p.gy == expected.gy && p.x0 == expected.x0);
        EXPECT_EQ(p.at(33, 17), expected.at(33, 17));
    } while (std::next_permutation(order.begin(), order.end()));
}

}  // namespace
}  // namespace gw
