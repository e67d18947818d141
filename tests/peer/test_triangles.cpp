// Random triangles through Mesa and through us: coverage, flat colours, depth, Gouraud shading.
#include "tests/peer/compare.h"

#include <gtest/gtest.h>

namespace gw {
namespace {

using namespace test;

class Triangles : public Driver {};
INSTANTIATE_TEST_SUITE_P(AgainstMesa, Triangles, testing::Values("llvmpipe", "softpipe"),
                         [](const auto& driver) { return std::string(driver.param); });

struct Scene {
    GridTriangle triangle;
    std::array<std::int64_t, 3> depth{};
    CommandList list;
};

/// One flat triangle with sloping depth over a cleared window.
Scene flat_scene(Random& random) {
    Scene s{random_triangle(random), {}, {}};
    for (std::int64_t& z : s.depth) z = random.between(0, 16777215);
    const vec4 color{float(random.between(0, 255)) / 255, float(random.between(0, 255)) / 255, 0.2f,
                     1};
    State state = window_state();
    state.depth = {.test = true, .func = DepthFunc::Always};
    state.shade_model = ShadeModel::Flat;
    s.list.add(Clear{all_planes});
    add(s.list, state,
        Draw{.mesh = make_mesh(mesh_of(s.triangle, s.depth, {color, color, color}))});
    return s;
}

std::vector<CommandList> lists_of(const std::vector<Scene>& scenes) {
    std::vector<CommandList> lists;
    for (const Scene& s : scenes) lists.push_back(s.list);
    return lists;
}

std::vector<Scene> flat_scenes(int count) {
    std::vector<Scene> scenes;
    Random random(1);
    for (int i = 0; i < count; ++i) scenes.push_back(flat_scene(random));
    return scenes;
}

TEST_P(Triangles, CoverageAndFlatColoursAgreeAwayFromSides) {
    const std::vector<Scene> scenes = flat_scenes(200);
    const std::vector<Planes> ours = execute(lists_of(scenes), size, size);
    const Answers theirs = play(lists_of(scenes));
    Tally away, near;
    for (std::size_t i = 0; i < scenes.size(); ++i)
        for_pixels([&](int x, int y, std::size_t p) {
            const int d = difference(ours[i].color[p], theirs.planes[i].color[p]);
            (near_side(scenes[i].triangle, x, y) ? near : away).add(d);
        });
    report(GetParam(), "flat colour, coverage; no side within a unit", away);
    report(GetParam(), "flat colour, coverage; a side within a unit", near);
    EXPECT_GT(away.compared, 200 * 3000);
    EXPECT_EQ(away.different, 0);
}

/// Jitter moves the triangle by units of the grid, and a viewport by pixels.
TEST_P(Triangles, JitterAndViewportMoveTheSameFragments) {
    Random random(11);
    std::vector<Scene> scenes;
    for (int i = 0; i < 60; ++i) {
        Scene s{random_triangle(random), {}, {}};
        State state = window_state();
        state.jitter = {int(random.between(-7, 7)), int(random.between(-7, 7))};
        state.viewport = {int(random.between(-9, 9)), 3, size, size};
        s.list.add(Clear{all_planes});
        add(s.list, state, Draw{.mesh = make_mesh(mesh_of(s.triangle, {}, {}))});
        for (GridPoint& p : s.triangle)
            p = {p.x + state.jitter.x + state.viewport.x * grid, p.y + state.jitter.y + 3 * grid};
        scenes.push_back(std::move(s));
    }
    const std::vector<Planes> ours = execute(lists_of(scenes), size, size);
    const Answers theirs = play(lists_of(scenes));
    Tally away;
    for (std::size_t i = 0; i < scenes.size(); ++i)
        for_pixels([&](int x, int y, std::size_t p) {
            if (!near_side(scenes[i].triangle, x, y))
                away.add(difference(ours[i].color[p], theirs.planes[i].color[p]));
        });
    report(GetParam(), "coverage under jitter and a moved viewport", away);
    EXPECT_EQ(away.different, 0);
}

/// Units of 24 bits a pixel: the larger of the two slopes.
double slope(const Scene& s) {
    const auto gradient = [&](auto difference_of) {
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i)
            sum += double(s.depth[i]) *
                   double(difference_of(s.triangle[(i + 1) % 3], s.triangle[(i + 2) % 3]));
        return std::abs(sum * grid / double(cross(s.triangle[0], s.triangle[1], s.triangle[2])));
    };
    return std::max(gradient([](const GridPoint& a, const GridPoint& b) { return a.y - b.y; }),
                    gradient([](const GridPoint& a, const GridPoint& b) { return b.x - a.x; }));
}

TEST_P(Triangles, DepthIsWithinABoundScaledBySlope) {
    const std::vector<Scene> scenes = flat_scenes(200);
    const std::vector<Planes> ours = execute(lists_of(scenes), size, size);
    const Answers theirs = play(lists_of(scenes));
    Tally units, scaled;
    for (std::size_t i = 0; i < scenes.size(); ++i)
        for_pixels([&](int x, int y, std::size_t p) {
            if (near_side(scenes[i].triangle, x, y) || ours[i].color[p][3] == 0) return;
            const double d = std::abs(double(ours[i].depth[p]) - double(theirs.planes[i].depth[p]));
            units.add(d);
            scaled.add(d / (1 + slope(scenes[i]) * 0x1p-17));
        });
    report(GetParam(), "depth, units of 24 bits", units);
    report(GetParam(), "depth, units / (1 + slope 2^-17)", scaled);
    EXPECT_GT(units.compared, 80000);
    EXPECT_LE(scaled.worst, GetParam() == std::string("llvmpipe") ? 4 : 64);
}

/// glFrustum(-1, 1, -1, 1, 1, 33) with the eye at the origin.
State perspective_state() {
    State s;
    s.projection[2] = {0, 0, -34.0 / 32, -1};
    s.projection[3] = {0, 0, -66.0 / 32, 0};
    return s;
}

/// A triangle whose corners lie at different distances, in front of the near plane and behind the
/// far one.
CommandList smooth_list(Random& random) {
    MeshData data;
    for (int i = 0; i < 3; ++i) {
        const float w = float(random.between(2 * 64, 24 * 64)) / 64;
        data.positions.push_back(
            {(random.fraction() * 2 - 1) * w, (random.fraction() * 2 - 1) * w, -w});
        data.colors.push_back(random_color(random));
        data.colors.back().a = 1;
    }
    CommandList list;
    list.add(Clear{all_planes});
    add(list, perspective_state(), Draw{.mesh = make_mesh(std::move(data))});
    return list;
}

/// Where both drew.
Tally compare_covered(const std::vector<Planes>& a, const std::vector<Planes>& b) {
    Tally tally;
    for (std::size_t i = 0; i < a.size(); ++i)
        for_pixels([&](int, int, std::size_t p) {
            if (a[i].color[p][3] != 0 && b[i].color[p][3] != 0)
                tally.add(difference(a[i].color[p], b[i].color[p]));
        });
    return tally;
}

TEST_P(Triangles, GouraudIsTheirsInPerspectiveAndOursOnTheScreen) {
    std::vector<CommandList> lists;
    Random random(2);
    for (int i = 0; i < 100; ++i) lists.push_back(smooth_list(random));
    Profile fine = vgx();
    fine.subpixel_bits = 8;
    const std::vector<Planes> theirs = play(lists).planes;
    const Tally screen = compare_covered(execute(lists, size, size, fine), theirs);
    fine.perspective_color = true;
    const Tally perspective = compare_covered(execute(lists, size, size, fine), theirs);
    report(GetParam(), "Gouraud, ours linear on the screen", screen);
    report(GetParam(), "Gouraud, ours with perspective_color", perspective);
    EXPECT_GT(screen.compared, 20000);
    EXPECT_GT(screen.worst, 40);
    EXPECT_LE(perspective.worst, 2);
}

}  // namespace
}  // namespace gw
