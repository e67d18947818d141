// Claims: what would take long says so beforehand, the same on every machine, and about right.
#include "hiddensurface/run/estimate.h"
#include "tests/hiddensurface/deep_scenes.h"

#include <gtest/gtest.h>

namespace gw::hiddensurface {
namespace {

struct Ready {
    explicit Ready(scene::Scene given, int width = 64, int height = 48)
        : scene(std::move(given)),
          view(scene::make_view(scene, width, height)),
          input(make_input(scene, view, vgx())) {}
    Ready(const Ready&) = delete;
    scene::Scene scene;
    scene::View view;
    Input input;
};

Estimate estimate_of(const std::string& name, const Ready& ready) {
    return estimate(algorithm_named(name), ready.input);
}

TEST(Estimate, IsNoneOfSmallScenesAndOfWhatGrowsWithTheScene) {
    const Ready small(prism(1000)), large(prism(4096));
    for (const Algorithm& algorithm : algorithms()) {
        if (algorithm.growth.law != GrowthLaw::Rays) {
            EXPECT_EQ(estimate(algorithm, small.input).seconds, 0) << algorithm.name;
        }
        EXPECT_EQ(estimate(algorithm, large.input).seconds > 0,
                  algorithm.growth.law != GrowthLaw::Linear)
            << algorithm.name;
    }
}

// A convex body is one chain of the tree: every face is compared with the planes of all before it.
TEST(Estimate, GrowsWithTheSquareOfAConvexBodysFaces) {
    const Ready once(prism(4096)), twice(prism(8192));
    for (const char* name : {"bsp", "quake"}) {
        const double ratio = estimate_of(name, twice).seconds / estimate_of(name, once).seconds;
        EXPECT_NEAR(ratio, 4, 0.4) << name;
    }
    EXPECT_EQ(estimate_of("bsp", once).polygons, 4096u);
}

/// Small triangles in all directions, each over a few others.
scene::Scene sparse_triangles(int count) {
    Random random(1);
    MeshData data;
    for (int i = 0; i < count; ++i) {
        const vec3 c = random_vector(random, 1.5, 1.2, 1.5);
        for (int k = 0; k < 3; ++k)
            data.positions.push_back(c + random_vector(random, 0.05, 0.05, 0.05));
    }
    return polygon_scene(std::move(data));
}

// The questions that are asked in the end are those foretold, within a factor of three.
TEST(Estimate, ForetellsTheQuestions) {
    const Ready ready(sparse_triangles(2500));
    for (const char* name : {"newell", "bsp", "weiler-atherton"}) {
        const Algorithm& algorithm = algorithm_named(name);
        const Estimate foretold = estimate(algorithm, ready.input);
        StepLog none;
        const Counts c = algorithm.run(ready.input, none).counts;
        const double asked = double(c.facings + c.keys + c.extents + c.planes + c.overlaps +
                                    c.crossings + c.depths) *
                             1e-9 * algorithm.growth.nanoseconds;
        EXPECT_LT(foretold.seconds, 3 * asked) << name;
        EXPECT_GT(foretold.seconds, asked / 3) << name;
    }
}

// Gaps between the faces of a sample would make contours that the body has not.
TEST(Estimate, ForetellsWhatDependsOnCommonSides) {
    const Ready ready(prism(4096));
    const LineAlgorithm& appel = *line_algorithm_named("appel");
    StepLog none;
    const LineCounts lines = appel.run(ready.input, none).counts;
    const double asked = double(lines.facings + lines.extents + lines.planes + lines.crossings) *
                         1e-9 * appel.growth.nanoseconds;
    EXPECT_NEAR(estimate(appel, ready.input).seconds / asked, 1, 0.5);
}

TEST(Estimate, IsBeyondAnyLimitButNone) {
    const Estimate long_run{"newell", 20480, 2400, 20e6}, large_run{"schumacker", 99, 1, 5e9};
    EXPECT_TRUE(is_beyond(long_run, 300));
    EXPECT_FALSE(is_beyond(long_run, 3000));
    EXPECT_TRUE(is_beyond(large_run, 300));
    EXPECT_FALSE(is_beyond(long_run, 0));
    EXPECT_FALSE(is_beyond(large_run, 0));
}

TEST(Estimate, IsSaidInWords) {
    EXPECT_EQ(text_of({"newell", 20480, 2400, 20e6}),
              "newell: 20,480 polygons would take about 40 minutes and 20 MB");
    EXPECT_EQ(text_of({"ray-casting", 1234567, 90, 0}),
              "ray-casting: 1,234,567 polygons would take about 90 seconds");
    EXPECT_EQ(text_of({"bsp", 999, 100 * 3600, 3.5e9}),
              "bsp: 999 polygons would take about 5 days and 4 GB");
}

TEST(Estimate, KnowsTheLineAlgorithms) {
    const Ready ready(prism(4096));
    for (const LineAlgorithm& algorithm : line_algorithms()) {
        if (algorithm.name != "floating-horizon") {
            EXPECT_GT(estimate(algorithm, ready.input).seconds, 0) << algorithm.name;
        }
    }
}

}  // namespace
}  // namespace gw::hiddensurface
