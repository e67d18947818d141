// docs/manual/samples.md: surfaces with samples, and their mean. On both machines.
#include "tests/gw/random.h"
#include "tests/gw/workbench.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace gw {
namespace {

constexpr PlaneMask color_plane = mask_of(Plane::Color), depth_plane = mask_of(Plane::Depth);

/// A machine with surface 1 in use, all 0 in all samples. Clip coordinates are object coordinates.
class SampleBench : public test::Workbench {
public:
    SampleBench(int samples, int width = 1, int height = 1, const Profile& profile = opengl())
        : Workbench(profile, width, height) {
        state.projection = dmat4(1);
        run(MakeSurface{1, {width, height, surface_planes, 0, samples}});
        run(UseSurface{1});
        take_counters();
    }
    /// The surface's values in the window, after a Blit.
    void resolve(PlaneMask planes = surface_planes) {
        const Rect all{0, 0, machine().planes().width, machine().planes().height};
        run(UseSurface{0});
        run(Blit{.from_surface = 1, .planes = planes, .source = all, .target = all});
        run(UseSurface{1});
        take_counters();
    }
    int mean_red() {
        resolve();
        return color(0, 0)[0];
    }
    /// Samples written by a draw.
    std::uint64_t written(MeshData data) {
        take_counters();
        draw(std::move(data));
        return take_counters().written;
    }
};

/// A square of pixel coordinates in a surface of one pixel.
MeshData square(double x0, double y0, double x1, double y1, vec4 color = vec4(1), float z = 0) {
    const auto at = [](double v) { return float(2 * v - 1); };
    return test::mesh_data(
        Primitive::Quads,
        {{at(x0), at(y0), z}, {at(x1), at(y0), z}, {at(x1), at(y1), z}, {at(x0), at(y1), z}},
        std::vector<vec4>(4, color));
}
/// A triangle over what lies to the left of x, in the same coordinates.
MeshData left_of(double x, vec4 color = vec4(1), float z = 0) {
    const auto at = [](double v) { return float(2 * v - 1); };
    return test::mesh_data(Primitive::Triangles,
                           {{at(x), at(-2), z}, {at(x), at(3), z}, {at(x - 2.5), at(0.5), z}},
                           std::vector<vec4>(3, color));
}
/// One triangle over the whole pixel.
MeshData whole(vec4 color = vec4(1), float z = 0) { return left_of(1.5, color, z); }

// [R17.1] [R17.2] [R17.6] [R17.7]
TEST(ManualSamples, TheMeanOfFour) {
    SampleBench bench(4);
    bench.draw(left_of(0.5));
    const Counters drawn = bench.take_counters();
    EXPECT_EQ(drawn.fragments, 1u);
    EXPECT_EQ(drawn.written, 2u);
    EXPECT_EQ(bench.mean_red(), 128);
    bench.clear(color_plane);
    bench.state.multisample.enable = false;
    EXPECT_EQ(bench.written(left_of(0.5)), 0u);
    EXPECT_EQ(bench.mean_red(), 0);
    EXPECT_EQ(bench.written(left_of(0.75)), 4u);
    EXPECT_EQ(bench.mean_red(), 255);
}

/// With 12 bits a channel.
// [R1.3]
TEST(ManualSamples, OfTheRealityEngine) {
    Profile profile = reality();
    profile.extensions.surfaces = profile.extensions.multisample = true;
    SampleBench bench(4, 1, 1, profile);
    EXPECT_EQ(bench.written(left_of(0.5)), 2u);
    EXPECT_EQ(bench.mean_red(), 2048);
}

using Places = std::vector<std::array<int, 2>>;
const std::map<int, Places> places{
    {2, {{6, 6}, {2, 2}}},
    {4, {{3, 1}, {7, 3}, {1, 5}, {5, 7}}},
    {8, {{4, 2}, {3, 5}, {6, 4}, {2, 1}, {1, 6}, {0, 3}, {5, 7}, {7, 0}}}};

/// Squares of an eighth of a pixel around each place of the grid.
// [R17.2]
TEST(ManualSamples, HaveTheirPlaces) {
    for (const auto& [samples, of] : places) {
        SampleBench bench(samples);
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x) {
                const MeshData around =
                    square((x - 0.5) / 8, (y - 0.5) / 8, (x + 0.5) / 8, (y + 0.5) / 8);
                const bool is_place = std::count(of.begin(), of.end(), std::array{x, y}) != 0;
                EXPECT_EQ(bench.written(around), is_place ? 1u : 0u) << x << " " << y;
            }
    }
}

/// Sample k is the k-th of its list: the coverage test keeps those before a number.
// [R17.2] [R17.4]
TEST(ManualSamples, AreNumberedInTheOrderOfTheirPlaces) {
    for (const auto& [samples, of] : places) {
        SampleBench bench(samples);
        bench.state.multisample.coverage_test = true;
        for (int kept = 0; kept <= samples; ++kept)
            for (int k = 0; k < samples; ++k) {
                const auto& [x, y] = of[std::size_t(k)];
                bench.state.multisample.coverage = float(kept) / float(samples);
                const MeshData around =
                    square((x - 0.5) / 8, (y - 0.5) / 8, (x + 0.5) / 8, (y + 0.5) / 8);
                EXPECT_EQ(bench.written(around), k < kept ? 1u : 0u) << samples << " " << k;
            }
    }
}

/// Coverage and depth of a sample are those of a surface without samples under a jitter. The steps of
/// a strip are counted without either.
// [R17.2] [R17.5] [R9.20]
TEST(ManualSamples, AreSurfacesUnderAJitter) {
    constexpr int side = 16;
    test::Random random(7);
    const auto unit = [&] { return 2.4f * random.fraction() - 1.2f; };
    for (const Primitive primitive :
         {Primitive::Triangles, Primitive::Lines, Primitive::LineStrip, Primitive::Points})
        for (int round = 0; round < 6; ++round) {
            MeshData data{.primitive = primitive};
            for (int i = 0; i < 12; ++i) data.positions.emplace_back(unit(), unit(), unit());
            const int samples = 2 << (round % 3);
            SampleBench bench(samples, side, side);
            State& state = bench.state;
            state.jitter = {3, -5};
            state.point_size = state.line_width = 3;
            state.depth = {.test = true, .func = DepthFunc::Greater};
            state.line_stipple = {true, 2, 0x3B5D};
            state.polygon_offset = {.enable = true, .factor = 1.5f, .units = 20};
            const std::uint64_t written = bench.written(data);
            bench.resolve();
            const Planes first = bench.planes();
            bench.run(MakeSurface{2, {side, side, surface_planes}});
            bench.run(UseSurface{2});
            std::uint64_t sum = 0;
            for (int k = samples - 1; k >= 0; --k) {
                const auto& [x, y] = places.at(samples)[std::size_t(k)];
                bench.clear(depth_plane, vec4(0), 0);
                state.jitter = {3 + (4 - x) * 32, -5 + (4 - y) * 32};
                sum += bench.written(data);
            }
            EXPECT_EQ(written, sum);
            bench.run(Read{1, Plane::Depth, {0, 0, side, side}});
            const auto& depths = bench.readbacks().at(1).values;
            EXPECT_TRUE(std::equal(depths.begin(), depths.end(), first.depth.begin()));
        }
}

// [R17.3] [R17.8]
TEST(ManualSamples, TheFirstSampleOfAnUncoveredCentre) {
    SampleBench bench(4);
    MeshData quarter = square(0, 0, 0.25, 1, {0, 0, 0, 1});
    quarter.colors[1].r = quarter.colors[2].r = 100 / 255.0f;
    EXPECT_EQ(bench.written(quarter), 1u);
    EXPECT_EQ(bench.mean_red(), (50 + 2) / 4);
}

/// A fragment that covers the centre has its colour in all samples.
// [R17.3]
TEST(ManualSamples, ColoursAreThoseOfTheCentre) {
    SampleBench bench(8);
    MeshData slope = whole({0, 0, 0, 1});
    slope.colors[0].r = slope.colors[1].r = 250 / 255.0f;
    EXPECT_EQ(bench.written(slope), 8u);
    EXPECT_EQ(bench.mean_red(), 150);
}

// [R17.4] [R17.7]
TEST(ManualSamples, KeepWhatAlphaSays) {
    SampleBench bench(4);
    const auto written = [&](int alpha) {
        return bench.written(whole({1, 1, 1, float(alpha) / 255}));
    };
    MultisampleState& m = bench.state.multisample;
    m.alpha_to_coverage = true;
    for (const auto& [alpha, samples] : std::map<int, std::uint64_t>{{0, 0},
                                                                     {31, 0},
                                                                     {32, 1},
                                                                     {95, 1},
                                                                     {96, 2},
                                                                     {159, 2},
                                                                     {160, 3},
                                                                     {223, 3},
                                                                     {224, 4},
                                                                     {255, 4}})
        EXPECT_EQ(written(alpha), samples) << alpha;
    bench.state.alpha = {true, AlphaFunc::Greater, 96 / 255.0f};
    bench.take_counters();
    bench.draw(whole({1, 1, 1, 96 / 255.0f}));
    const Counters killed = bench.take_counters();
    EXPECT_EQ(killed.fragments, 1u);
    EXPECT_EQ(killed.alpha_killed, 2u);
    EXPECT_EQ(written(97), 2u);
    m.alpha_to_one = true;
    EXPECT_EQ(written(95), 1u);  // the test is of alpha one
    m.enable = false;
    EXPECT_EQ(written(97), 4u);
    EXPECT_EQ(written(96), 0u);
}

// [R17.4]
TEST(ManualSamples, KeepAPartByTheCoverageTest) {
    for (const int samples : {2, 4, 8})
        for (const float coverage :
             {-1.0f, 0.0f, 0.0624f, 0.0625f, 0.125f, 0.25f, 0.6f, 0.75f, 1.0f, 3e38f})
            for (const bool invert : {false, true}) {
                SampleBench bench(samples);
                bench.state.multisample = {
                    .coverage_test = true, .coverage = coverage, .invert = invert};
                const double part = std::min(std::max(double(coverage), 0.0), 1.0);
                const auto first = std::uint64_t(std::floor(part * samples + 0.5));
                const std::uint64_t expected = invert ? std::uint64_t(samples) - first : first;
                EXPECT_EQ(bench.written(whole()), expected);
                // Sample 0 is among the first.
                bench.resolve(depth_plane | color_plane);
                EXPECT_EQ(bench.color(0, 0)[0], int(255 * int(expected) + samples / 2) / samples);
                bench.state.multisample.enable = false;
                EXPECT_EQ(bench.written(whole()), std::uint64_t(samples));
            }
}

/// Alpha to one changes the alpha that is written and blended, after alpha has chosen the samples.
// [R17.4]
TEST(ManualSamples, AlphaIsOneAfterItHasChosen) {
    SampleBench bench(2);
    bench.state.multisample = {.alpha_to_coverage = true, .alpha_to_one = true};
    EXPECT_EQ(bench.written(whole({1, 1, 1, 100 / 255.0f})), 1u);
    bench.resolve();
    EXPECT_EQ(bench.color(0, 0)[3], (255 + 1) / 2);
}

/// Each sample has its own stencil value, depth and colour below a blend.
// [R17.5]
TEST(ManualSamples, StagesAfterTheAlphaTestAreOfSamples) {
    SampleBench bench(4);
    bench.clear(surface_planes);
    bench.state.depth = {.test = true, .func = DepthFunc::Less};
    bench.state.stencil = {.test = true, .zfail = StencilOp::Incr, .zpass = StencilOp::Invert};
    EXPECT_EQ(bench.written(left_of(0.5, {100 / 255.0f, 0, 0, 1}, -0.5f)), 2u);
    bench.take_counters();
    bench.state.blend = {true, BlendFactor::One, BlendFactor::One};
    bench.draw(whole({50 / 255.0f, 0, 0, 1}, 0));
    const Counters second = bench.take_counters();
    EXPECT_EQ(second.fragments, 1u);
    EXPECT_EQ(second.written, 2u);
    EXPECT_EQ(second.depth_killed, 2u);
    // Stencil twice for 4 samples, depths read, then written and colours read and written.
    EXPECT_EQ(second.bytes, 4u * 2 + 4 * 3 + 2 * (3 + 8));
    EXPECT_EQ(bench.mean_red(), (100 + 100 + 50 + 50 + 2) / 4);
    EXPECT_EQ(bench.stencil(0, 0), 255);  // of sample 0: inverted, then at its greatest value
}

// [R17.1] [R17.7]
TEST(ManualSamples, ClearsAndRectanglesAreOfAllSamples) {
    SampleBench bench(8);
    bench.clear(surface_planes, vec4(0.2f), 0.5, 9);
    const Counters cleared = bench.take_counters();
    EXPECT_EQ(cleared.pixels, 3u);
    EXPECT_EQ(cleared.bytes, 8u * (4 + 3 + 1));
    EXPECT_EQ(bench.mean_red(), 51);
    EXPECT_EQ(bench.stencil(0, 0), 9);
    bench.state.stencil.write_mask = 0xF0;
    bench.run(WritePixels{{0, 0, 1, 1}, Plane::Stencil, {}, {0x77}, 0});
    EXPECT_EQ(bench.take_counters().bytes, 8u);
    bench.write({0, 0, 1, 1}, {9, 9, 9, 9});
    const Counters written = bench.take_counters();
    EXPECT_EQ(written.fragments, 1u);
    EXPECT_EQ(written.written, 8u);
    EXPECT_EQ(bench.mean_red(), 9);
    EXPECT_EQ(bench.stencil(0, 0), 0x79);
}

// [R17.6] [R17.7]
TEST(ManualSamples, BlitsCopySamplesAndSampleZeroOfDepths) {
    SampleBench bench(4);
    bench.state.depth = {.test = true, .func = DepthFunc::Always};
    bench.draw(left_of(0.5));  // samples 0 and 2: depth of z = 0
    bench.run(UseSurface{0});
    bench.run(MakeSurface{2, {1, 1, surface_planes, 0, 4}});
    bench.run(UseSurface{2});
    Blit blit{.from_surface = 1, .planes = 7, .source = {0, 0, 1, 1}, .target = {0, 0, 1, 1}};
    bench.take_counters();
    bench.run(blit);
    const Counters copied = bench.take_counters();
    EXPECT_EQ(copied.pixels, 3u);
    EXPECT_EQ(copied.bytes, 4u * 2 * (4 + 3 + 1));
    bench.run(UseSurface{0});
    blit.from_surface = 2;
    bench.take_counters();
    bench.run(blit);
    const Counters resolved = bench.take_counters();
    EXPECT_EQ(resolved.pixels, 3u);
    EXPECT_EQ(resolved.bytes, (4u * 4 + 4) + 2 * 3 + 2 * 1);
    EXPECT_EQ(bench.color(0, 0)[0], 128);
    EXPECT_EQ(bench.depth(0, 0), 8388608u);
    // All samples get the values of a surface without.
    bench.run(UseSurface{1});
    blit.from_surface = 0;
    bench.take_counters();
    bench.run(blit);
    EXPECT_EQ(bench.take_counters().bytes, (4u + 3 + 1) * (1 + 4));
    EXPECT_EQ(bench.mean_red(), 128);
}

// [R17.6]
TEST(ManualSamples, BlitsOfSamplesAreFlippedAndCut) {
    SampleBench bench(2, 3, 1);
    bench.write({0, 0, 1, 1}, {10, 0, 0, 0});
    bench.write({1, 0, 1, 1}, {20, 0, 0, 0});
    bench.run(UseSurface{0});
    bench.state.scissor = {true, {1, 0, 2, 1}};
    bench.run(Blit{.from_surface = 1,
                   .planes = color_plane,
                   .source = {0, 0, 3, 1},
                   .target = {0, 0, 3, 1},
                   .flip_x = true,
                   .filter = MagFilter::Linear});
    EXPECT_EQ(bench.color(0, 0)[0], 0);
    EXPECT_EQ(bench.color(1, 0)[0], 20);
    EXPECT_EQ(bench.color(2, 0)[0], 10);
}

// [R17.7] [R14.11]
TEST(ManualSamples, QueriesCountSamples) {
    SampleBench bench(8);
    bench.run(Query{5, true});
    bench.draw(whole());
    bench.run(Query{5, false});
    bench.compare();
    EXPECT_EQ(query_result(bench.machine().passes(), 5), 8u);
}

/// Without the smooth shapes of chapter 9, which samples replace.
// [R17.2]
TEST(ManualSamples, NothingIsSmoothBesides) {
    for (const Primitive primitive : {Primitive::Points, Primitive::Lines, Primitive::Quads}) {
        std::array<Planes, 2> planes;
        for (const bool smooth : {false, true}) {
            SampleBench bench(4, 16, 16);
            State& s = bench.state;
            s.point_smooth = s.line_smooth = s.polygon_smooth = s.diamond_lines = smooth;
            s.point_size = s.line_width = 5;
            MeshData data = square(0.1, 0.2, 0.7, 0.8);
            data.primitive = primitive;
            bench.draw(data);
            bench.resolve();
            planes[smooth] = bench.planes();
        }
        EXPECT_TRUE(planes[0] == planes[1]);
    }
}

// [R17.1]
TEST(ManualSamples, AWindowIgnoresTheSamplesOfItsState) {
    test::Workbench bench(opengl(), 1, 1);
    bench.state.projection = dmat4(1);
    bench.state.multisample = {
        .alpha_to_coverage = true, .alpha_to_one = true, .coverage_test = true, .coverage = 0};
    bench.draw(whole({1, 1, 1, 0.2f}));
    EXPECT_EQ(bench.take_counters().written, 1u);
    EXPECT_EQ(bench.color(0, 0)[3], 51);
}

}  // namespace
}  // namespace gw
