// Claims: without a Z plane means without one; the picture comes from the machine; counts and logs
// are true.
#include "gw/error.h"
#include "hiddensurface/run/read_step.h"
#include "tests/hiddensurface/cases.h"

#include <gtest/gtest.h>

namespace gw::hiddensurface {
namespace {

/// Depths that nobody would draw.
void fill_depth(Machine& machine) {
    const Planes& planes = machine.planes();
    WritePixels pixels{.rect = {0, 0, planes.width, planes.height}, .plane = Plane::Depth};
    for (std::size_t i = 0; i < planes.depth.size(); ++i)
        pixels.values.push_back(static_cast<std::uint32_t>(i * 7919 % 16777216));
    CommandList list;
    list.add(SetState{State{}});
    list.add(pixels);
    machine.execute(list);
}

}  // namespace

TEST(DepthPlaneOfTheMachine, IsNeitherReadNorWrittenWhereNotUsed) {
    Trial trial(random_triangles(5, 20));
    for (const Algorithm& algorithm : algorithms()) {
        StepLog none;
        const Output output = algorithm.run(trial.input, none);
        for (const auto& make : {+[] { return make_reference(vgx(), 160, 120); },
                                 +[] { return make_fast(vgx(), 160, 120, {.threads = 1}); }}) {
            const auto machine = make();
            fill_depth(*machine);
            const std::vector<std::uint32_t> before = machine->planes().depth;
            machine->reset_passes();
            machine->execute(output.list);
            EXPECT_EQ(machine->planes().depth == before, !algorithm.uses_depth_plane)
                << algorithm.name;
            if (algorithm.uses_depth_plane) continue;
            const Counters& counted = machine->passes().back().counters;
            // Clear writes 4 bytes of colour a pixel, a fragment 4; nothing is left for Z's 3.
            EXPECT_EQ(counted.bytes, 4 * (counted.pixels + counted.written)) << algorithm.name;
            EXPECT_EQ(counted.depth_killed, 0u);
        }
    }
}

TEST(Counts, AddUp) {
    Trial trial(random_triangles(6, 25));
    std::uint64_t complexity = 0;
    for (const std::uint8_t n : depth_complexity(trial.input)) complexity += n;
    for (const Algorithm& algorithm : algorithms()) {
        const Result result = trial.run(algorithm.name);
        const Counts& c = result.counts;
        EXPECT_EQ(c.polygons, trial.z_buffer.counts.polygons);
        EXPECT_EQ(c.overdraw, c.passed - c.pixels);
        std::uint64_t writes = 0;
        for (const std::uint8_t n : result.writes) writes += n;
        EXPECT_EQ(writes, c.passed) << algorithm.name;
    }
    // Pieces have every pixel of their polygon once.
    for (const char* name :
         {"painter-farthest", "painter-nearest", "painter-centroid", "newell", "bsp", "schumacker"})
        EXPECT_EQ(trial.run(name).counts.passed, complexity) << name;
    for (const char* name : {"scan-line", "ray-casting", "warnock", "bouknight", "watkins",
                             "a-buffer", "quake", "weiler-atherton"})
        EXPECT_EQ(trial.run(name).counts.overdraw, 0u) << name;
    EXPECT_EQ(trial.z_buffer.counts.fragments, complexity);
    EXPECT_EQ(trial.z_buffer.counts.depths, complexity);
}

/// Identifiers, bottom row first.
std::vector<std::uint32_t> painted_by(const std::vector<Step>& steps, int width, int height) {
    std::vector<std::uint32_t> ids(std::size_t(width) * std::size_t(height));
    for (const Step& step : steps)
        for (const auto& [run, id] : step.painted)
            for (int x = run.x0; x < run.x1; ++x) ids.at(pixel_index(x, run.y, width)) = id;
    return ids;
}

TEST(StepLog, HasAllChangesOfThePicture) {
    Trial trial(random_triangles(8, 8), vgx(), 160, 120);
    const PictureGrid grid = grid_of(trial.input);
    for (const Level level : {Level::Polygon, Level::Pixel})
        for (const Algorithm& algorithm : algorithms()) {
            StepLog log(level);
            const Result result = trial.run(algorithm.name, log);
            std::vector<Step> steps;
            for (const Step& step : log.steps()) {
                const std::string line = to_json(step, steps.size() + 1, grid);
                steps.push_back(step_of_line(line, grid));
                EXPECT_EQ(to_json(steps.back(), steps.size(), grid), line);
            }
            EXPECT_EQ(painted_by(steps, 160, 120), result.ids) << algorithm.name;
        }
}

TEST(StepLog, RefusesLinesThatItDidNotWrite) {
    const PictureGrid grid{8, 8};
    EXPECT_THROW(step_of_line("{", grid), Error);
    EXPECT_THROW(step_of_line("{}", grid), Error);
    EXPECT_THROW(step_of_line(R"({"level":"polygon","kind":"juggle"})", grid), Error);
}

TEST(Algorithms, AreFoundByName) {
    EXPECT_EQ(algorithms().front().name, "back-face");
    EXPECT_EQ(algorithm_named("bsp").name, "bsp");
    EXPECT_THROW(algorithm_named("no such"), Error);
}

}  // namespace gw::hiddensurface
