// Claims: the lecture's building blocks are exact: normal, view test, edges, depth. [L3, L4, L7,
// L8]
#include "hiddensurface/faces/flat_colors.h"
#include "hiddensurface/model/normal.h"
#include "hiddensurface/model/piece.h"
#include "hiddensurface/model/scan_conversion.h"
#include "hiddensurface/run/svg.h"
#include "hiddensurface/structures/merge_sort.h"
#include "scene/scene_builder.h"
#include "tests/hiddensurface/cases.h"

#include <gtest/gtest.h>

#include <set>

namespace gw::hiddensurface {
namespace {

GridPoint random_point(Random& random, int s) {
    const double size = 24 << s;
    return {std::int64_t(random(-size, 3 * size)), std::int64_t(random(-size, 3 * size)),
            std::int64_t(random(0, 16777215))};
}

/// Pixels of a triangle, each counted.
std::vector<int> coverage(const std::vector<std::array<GridPoint, 3>>& triangles, int s, int width,
                          int height) {
    std::vector<int> count(std::size_t(width * height));
    for (const auto& t : triangles)
        for (const auto& run : scan_convert(t, s, {0, 0, width, height}))
            for (int x = run.x0; x < run.x1; ++x) count[std::size_t(run.y * width + x)] += 1;
    return count;
}

}  // namespace

TEST(FlatColors, DifferWithoutAMaterialAndAreTheMaterialsOtherwise) {
    scene::Scene scene = case_scene("cycle");
    std::set<std::string> own;
    for (scene::Material& material : scene.materials) material = scene::default_material();
    const Trial without(scene);
    for (const auto& [id, color] : hex_colors(without.input)) own.insert(color);
    EXPECT_EQ(own.size(), 4u);  // three polygons and the background
    const auto is_grey = [](const FlatColor& c) { return c[0] == c[1] && c[1] == c[2]; };
    for (const auto& [id, color] : flat_colors(without.input))
        EXPECT_TRUE(id == 0 || !is_grey(color)) << id;
    for (scene::Material& material : scene.materials) material.name = "plaster";
    const Trial with(scene);
    for (const auto& [id, color] : flat_colors(with.input))
        EXPECT_TRUE(id == 0 || is_grey(color)) << id;
}

TEST(Normal, PointsToTheSideThatRunsCounterClockwise) {
    EXPECT_EQ(face_normal({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), dvec3(0, 0, 1));
    const Loop square{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    EXPECT_EQ(polygon_normal(square), dvec3(0, 0, 8));  // twice the area
    const Loop u{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {3, 4, 0},
                 {3, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0}};
    EXPECT_EQ(polygon_normal(u), dvec3(0, 0, 20));  // reflex corners do not turn it over
}

// Case BACK FACE of the shared data: the normal's z alone says front.
TEST(Facing, IsDecidedByTheLineOfSightNotByTheNormalAlone) {
    const dvec3 n(4.0 / 5, 0, 3.0 / 5);
    EXPECT_GT(n.z, 0);
    EXPECT_NEAR(facing(dvec3(0, 0, 0), dvec3(10, 0, -10), n), -2, 1e-12);
    EXPECT_EQ(facing(dvec3(0, 0, 5), dvec3(3, 0, 5), dvec3(0, 1, 0)), 0);  // edge-on
    // all lines of sight parallel
    EXPECT_GT(facing(dvec4(0, 0, 1, 0), dvec3(10, 0, -10), n), 0);
}

TEST(Overlap, IsDecidedByTheSidesOfBoth) {
    const Piece square{.parts = {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}}};
    const auto triangle = [](double d) {
        return Piece{.parts = {{{d, 0, 0}, {6, 6, 0}, {0, d, 0}}}};
    };
    // Only the triangle's side x + y = d can separate them: their extents overlap.
    for (const auto& [d, overlap] : {std::pair(4.5, false), {4.0, false}, {3.5, true}}) {
        EXPECT_EQ(projections_overlap(square, triangle(d)), overlap) << d;
        EXPECT_EQ(projections_overlap(triangle(d), square), overlap) << d;
    }
}

TEST(EdgeWalk, StandsWhereTheClosedFormDoesAfterEveryStep) {
    Random random(1);
    for (const int s : {1, 3, 8})
        for (int i = 0; i < 500; ++i) {
            const GridPoint a = random_point(random, s), b = random_point(random, s);
            if (a.y == b.y) continue;
            for (EdgeWalk walk(a, b, s, 1000); !walk.done(); walk.down()) {
                // A walk that begins here is worked out by the closed form alone.
                EXPECT_EQ(walk.x(), EdgeWalk(a, b, s, walk.row()).x());
                EXPECT_EQ(walk.x(), EdgeWalk(b, a, s, walk.row()).x());
            }
        }
}

TEST(EdgeWalk, IsTheFirstPixelNotLeftOfTheEdge) {
    Random random(2);
    const int s = 3;
    for (int i = 0; i < 500; ++i) {
        const GridPoint a = random_point(random, s), b = random_point(random, s);
        if (a.y == b.y) continue;
        const GridPoint &top = a.y > b.y ? a : b, &low = a.y > b.y ? b : a;
        for (EdgeWalk walk(a, b, s, 1000); !walk.done(); walk.down()) {
            const auto right_of = [&](int x) {  // >= 0: the centre is on the edge or right of it
                return (center(x, s) - low.x) * (top.y - low.y) -
                       (top.x - low.x) * (center(walk.row(), s) - low.y);
            };
            EXPECT_GE(right_of(walk.x()), 0);
            EXPECT_LT(right_of(walk.x() - 1), 0);
        }
    }
}

TEST(ScanConvert, CoversNeighboursExactlyOnce) {
    Random random(3);
    const int s = 3;
    for (int i = 0; i < 100; ++i) {
        // A point inside a square, joined to its corners: a partition.
        const GridPoint c{std::int64_t(random(1, 255)), std::int64_t(random(1, 255)), 0};
        const std::array<GridPoint, 4> q{{{0, 0, 0}, {256, 0, 0}, {256, 256, 0}, {0, 256, 0}}};
        EXPECT_EQ(coverage({{q[0], q[1], c}, {q[1], q[2], c}, {q[2], q[3], c}, {q[3], q[0], c}}, s,
                           32, 32),
                  std::vector<int>(1024, 1));
    }
}

TEST(ScanConvert, FillsConcavePolygonsBetweenPairsOfCrossings) {
    std::vector<GridPoint> u;
    for (const auto& [x, y] :
         {std::pair(0, 0), {4, 0}, {4, 4}, {3, 4}, {3, 1}, {1, 1}, {1, 4}, {0, 4}})
        u.push_back({x * 8, y * 8, 0});
    const std::vector<hiddensurface::Run> expected{{3, 0, 1}, {3, 3, 4}, {2, 0, 1}, {2, 3, 4},
                                                   {1, 0, 1}, {1, 3, 4}, {0, 0, 4}};
    EXPECT_EQ(scan_convert(u, 3, {0, 0, 10, 10}), expected);
}

// Case T-JUNCTION of the shared data.
TEST(ScanConvert, LeavesHolesAtATJunctionOnlyWhereTheVertexIsOffTheGrid) {
    for (int s = 1; s <= 8; ++s) {
        const auto at = [s](double x, double y) {  // y down in the case
            const double unit = 1 << s;
            return GridPoint{std::int64_t(std::floor(x * unit + 0.5)),
                             std::int64_t(std::floor((10 - y) * unit + 0.5)), 0};
        };
        const GridPoint a = at(0, 0), b = at(30, 10), t = at(10, 10.0 / 3), apex = at(30, 0);
        const auto count = coverage({{a, b, at(0, 10)}, {a, apex, t}, {t, apex, b}}, s, 30, 10);
        const auto holes = std::count(count.begin(), count.end(), 0);
        EXPECT_EQ(holes, s % 2 == 0 ? 10 : 0) << "sub-pixel bits " << s;
        EXPECT_EQ(coverage({{a, b, at(0, 10)}, {a, apex, b}}, s, 30, 10), std::vector<int>(300, 1));
    }
}

TEST(DepthPlane, IncrementsAndClosedFormAgree) {
    Random random(4);
    for (int i = 0; i < 300; ++i) {
        const std::array<GridPoint, 3> t{random_point(random, 3), random_point(random, 3),
                                         random_point(random, 3)};
        if ((t[1].x - t[0].x) * (t[2].y - t[0].y) == (t[2].x - t[0].x) * (t[1].y - t[0].y))
            continue;
        const DepthPlane plane = depth_plane(t, 3, 24);
        DepthWalk walk(plane, -20, i % 50);
        for (int x = -20; x < 60; ++x, walk.right()) EXPECT_EQ(walk.z(), plane.at(x, i % 50));
    }
}

// The algorithms' pixels and depths are the machine's.
TEST(Project, HasTheMachinesPixelsAndDepths) {
    for (const Profile& profile : profiles()) {
        Trial trial(random_triangles(7, 40), profile);
        Planes mine(160, 120);
        const auto far_value = std::uint32_t((std::uint64_t{1} << profile.depth_bits) - 1);
        for (auto& z : mine.depth) z = far_value;
        for (const Polygon& polygon : trial.input.polygons)
            for (const WindowTriangle& t : polygon.triangles)
                for (const auto& run :
                     scan_convert(t.corners, profile.subpixel_bits, trial.input.window()))
                    for (int x = run.x0; x < run.x1; ++x) {
                        std::uint32_t& z = mine.depth[mine.index(x, run.y)];
                        z = std::min(z, std::uint32_t(t.depth.at(x, run.y)));
                    }
        trial.machine->execute(scene::id_pass(trial.scene, trial.view));
        EXPECT_EQ(mine.depth, trial.machine->planes().depth) << profile.name;
    }
}

// The sort whose questions the counters and step logs show.
TEST(MergeSort, IsStableAndAsksTheSameEverywhere) {
    using Question = std::pair<int, int>;
    std::vector<Question> asked;
    std::vector<int> list{31, 10, 20, 11, 30};  // by tens: 31 before 30, 10 before 11
    merge_sort(list.begin(), list.end(), [&](int a, int b) {
        asked.emplace_back(a, b);
        return a / 10 < b / 10;
    });
    EXPECT_EQ(list, (std::vector<int>{10, 11, 20, 31, 30}));
    // 31 | 10; then 11 | 30 and 20 | 11 30; then 10 31 | 11 20 30.
    EXPECT_EQ(asked, (std::vector<Question>{{10, 31},
                                            {10, 31},
                                            {30, 11},
                                            {11, 20},
                                            {11, 20},
                                            {30, 20},
                                            {11, 31},
                                            {11, 10},
                                            {11, 31},
                                            {20, 31},
                                            {30, 31}}));

    for (std::uint32_t seed = 1; seed <= 50; ++seed) {
        Random random(seed);
        std::vector<std::pair<int, int>> pairs;
        for (int i = 0; i < int(seed); ++i) pairs.emplace_back(int(random(0, 9)), i);
        auto expected = pairs;
        const auto lower = [](const auto& a, const auto& b) { return a.first < b.first; };
        std::stable_sort(expected.begin(), expected.end(), lower);
        merge_sort(pairs.begin(), pairs.end(), lower);
        EXPECT_EQ(pairs, expected) << seed;
        std::size_t questions = 0;
        merge_sort(pairs.begin(), pairs.end(), [&](const auto& a, const auto& b) {
            ++questions;
            return lower(a, b);
        });
        EXPECT_EQ(questions, pairs.size() - 1);  // in order already
    }
}

// A square as two triangles, whose common side is no cut.
TEST(PiecesSvg, DrawsNoSideBetweenPartsOfAPiece) {
    Trial trial(case_scene("cycle"));
    const dvec3 a(80, 80, 0), b(240, 80, 0), c(240, 240, 0), d(80, 240, 0);
    const std::vector<Piece> pieces{{.name = "1", .parts = {{a, b, c}, {a, c, d}}},
                                    {.name = "2", .parts = {{a, b, c}, {a, c, d}}}};
    const std::string svg = pieces_svg(trial.input, pieces, std::vector<std::string>(3, "#ffffff"));
    const auto count = [&](const std::string& part) {
        std::size_t found = 0;
        for (auto at = svg.find(part); at != svg.npos; at = svg.find(part, at + 1)) ++found;
        return found;
    };
    EXPECT_EQ(count("M10.000,110.000 L30.000,90.000"), 2u);  // the areas
    EXPECT_EQ(count("M10.000,110.000 L30.000,90.000 L10.000,90.000Z"), 2u);
    EXPECT_EQ(count("M10.000,110.000 L30.000,110.000 L30.000,90.000"), 2u);  // the areas
    EXPECT_EQ(count("M30.000,90.000 L10.000,90.000"), 2u);
    // Their numbers do not cover each other.
    EXPECT_EQ(count("x=\"23.33\" y=\"103.33\""), 1u);
    EXPECT_EQ(count("x=\"23.33\" y=\"111.33\""), 1u);
}

}  // namespace gw::hiddensurface
