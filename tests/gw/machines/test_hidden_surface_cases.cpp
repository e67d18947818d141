// Hidden-surface cases with known answers on the machine: T-junctions, layers, piercing, the cycle.
#include "tests/gw/random.h"
#include "tests/gw/workbench.h"

#include <algorithm>
#include <numeric>

namespace gw {
namespace {

using namespace test;

Profile with_subpixel_bits(int bits) {
    Profile profile = ideal();
    profile.subpixel_bits = bits;
    return profile;
}

/// The case's screen has y down; its rectangle has 30 x 10 pixels.
vec3 screen(float x, float y) { return {x, 10 - y, 0}; }

/// The number of pixels of the rectangle by the number of times they are covered.
std::array<int, 3> coverage(int bits, const std::vector<vec3>& triangles) {
    Workbench bench(with_subpixel_bits(bits), 32, 16);
    bench.state.blend = {true, BlendFactor::One, BlendFactor::One};
    bench.draw(Primitive::Triangles, triangles,
               std::vector<vec4>(triangles.size(), vec4(1 / 65535.0f)));
    std::array<int, 3> count{};
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 30; ++x) ++count[std::min<std::size_t>(2, bench.color(x, y)[0])];
    return count;
}

TEST(HiddenSurfaceCases, ATJunctionLosesPixelsByItsSubPixelBits) {
    const vec3 a = screen(0, 0), b = screen(30, 10), c = screen(0, 10), apex = screen(30, 0);
    const vec3 third = screen(10, 10 / 3.0f);
    const std::vector<vec3> with_junction{a, c, b, a, third, apex, third, b, apex};
    const std::vector<vec3> mended{a, c, third, third, c, b, a, third, apex, third, b, apex};
    for (int bits = 1; bits <= 8; ++bits) {
        const std::array<int, 3> count = coverage(bits, with_junction);
        EXPECT_EQ(count[0], bits % 2 == 0 ? 10 : 0) << bits << " bits";
        EXPECT_EQ(coverage(bits, mended), (std::array<int, 3>{0, 300, 0})) << bits << " bits";
    }
}

TEST(HiddenSurfaceCases, LayersInRandomOrderAreWrittenHarmonicallyOften) {
    constexpr int layers = 16, orders = 400;
    std::uint64_t written = 0;
    for (int seed = 0; seed < orders; ++seed) {
        Random random(std::uint64_t(seed) + 1);
        std::vector<int> order(layers);
        std::iota(order.begin(), order.end(), 0);
        for (std::size_t i = layers - 1; i > 0; --i)
            std::swap(order[i], order[std::size_t(random.between(0, std::int64_t(i)))]);
        Workbench bench(vgx(), 4, 4);
        bench.clear();
        bench.state.depth.test = true;
        int nearest = layers;
        std::uint64_t expected = 0;
        for (const int z : order) {
            const auto depth = float(100 * z + 5);
            bench.draw(Primitive::Quads,
                       {{0, 0, depth}, {4, 0, depth}, {4, 4, depth}, {0, 4, depth}});
            expected += z < nearest ? 16 : 0;
            nearest = std::min(nearest, z);
        }
        const Counters c = bench.take_counters();
        EXPECT_EQ(c.written, expected);
        EXPECT_EQ(c.written + c.depth_killed, std::uint64_t{layers} * 16);
        written += c.written;
    }
    double harmonic = 0;
    for (int i = 1; i <= layers; ++i) harmonic += 1.0 / i;
    EXPECT_NEAR(double(written) / (16.0 * orders), harmonic, 0.15);  // H_16 = 3.381
}

/// A colour index drawn as red.
std::vector<vec4> red(int value, std::size_t n) {
    return std::vector<vec4>(n, vec4(float(value) / 255, 0, 0, 1));
}

TEST(HiddenSurfaceCases, PiercingRectanglesShareTheScreenWhereTheyCross) {
    // In the case a larger z is nearer; the depth here is 6 - z. P: z = x over 0..6 x 1..5. Q: z =
    // 6 - x over 0..6 x 2..4.
    Workbench bench(vgx(), 64, 64);
    bench.state.projection[2][2] = 2.0 / 6;
    bench.state.projection[0][0] = bench.state.projection[1][1] = 2.0 / 6;
    bench.state.projection[3] = {-1, -1, -1, 1};
    bench.clear();
    bench.state.depth.test = true;
    bench.draw(Primitive::Quads, {{0, 1, 6}, {6, 1, 0}, {6, 5, 0}, {0, 5, 6}}, red(1, 4));
    bench.draw(Primitive::Quads, {{0, 2, 0}, {6, 2, 6}, {6, 4, 6}, {0, 4, 0}}, red(2, 4));
    for (int y = 22; y < 42; ++y)
        for (int x = 0; x < 64; ++x)
            EXPECT_EQ(bench.color(x, y)[0], x < 32 ? 2 : 1) << x << " " << y;
    EXPECT_EQ(bench.color(5, 15)[0], 1);
}

TEST(HiddenSurfaceCases, AnyOrderOfTheCycleGivesTheSamePicture) {
    const std::array<std::vector<vec3>, 3> triangles{{{{-1, 1, -3}, {-2, 0, -3}, {2, -1, -2}},
                                                      {{2, 1, -3}, {2, 2, -3}, {-1, -1, -2}},
                                                      {{1, -2, -3}, {2, -2, -3}, {1, 2, -2}}}};
    std::array<int, 3> order{0, 1, 2};
    std::vector<Rgba> first;
    do {
        Workbench bench(vgx(), 128, 128);
        // Perspective from the origin: near 1, far 8, as wide as deep.
        bench.state.projection = dmat4(0);
        bench.state.projection[0][0] = bench.state.projection[1][1] = 1;
        bench.state.projection[2] = {0, 0, -9.0 / 7, -1};
        bench.state.projection[3][2] = -16.0 / 7;
        bench.clear();
        bench.state.depth.test = true;
        for (const int i : order)
            bench.draw(Primitive::Triangles, triangles[std::size_t(i)], red(i + 1, 3));
        if (first.empty()) first = bench.planes().color;
        EXPECT_EQ(bench.planes().color, first);
    } while (std::next_permutation(order.begin(), order.end()));
    for (const int i : {1, 2, 3})
        EXPECT_GT(std::count(first.begin(), first.end(), Rgba{std::uint16_t(i), 0, 0, 255}), 100);
}

}  // namespace
}  // namespace gw
