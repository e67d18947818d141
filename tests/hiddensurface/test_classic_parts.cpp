// Claims: what the classical algorithms are built of is exact, and each does what it is known for:
// what it saves, in counts.
#include "hiddensurface/faces/active_faces.h"
#include "hiddensurface/faces/region.h"
#include "hiddensurface/structures/clusters.h"
#include "hiddensurface/structures/octree.h"
#include "scene/shapes/shapes.h"
#include "tests/hiddensurface/small_families.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <map>
#include <numeric>

namespace gw::hiddensurface {
namespace {

/// Pixels of the runs, each counted.
std::vector<int> counted(const std::vector<hiddensurface::Run>& runs, int width, int height) {
    std::vector<int> count(std::size_t(width * height));
    for (const auto& run : runs)
        for (int x = run.x0; x < run.x1; ++x) count[std::size_t(run.y * width + x)] += 1;
    return count;
}

std::vector<GridPoint> random_triangle(Random& random) {
    const auto point = [&] {
        const auto x = std::int64_t(random(0, 32 * 8)), y = std::int64_t(random(0, 32 * 8));
        return GridPoint{x, y, 0};
    };
    for (;;) {
        std::vector<GridPoint> p{point(), point(), point()};
        const std::int64_t turn =
            (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
        if (turn < 0) std::swap(p[1], p[2]);
        if (turn != 0) return p;
    }
}

constexpr Rect window{0, 0, 32, 32};

/// Sixty triangles behind a wall over the whole window.
scene::Scene behind_a_wall() {
    scene::Scene scene = random_triangles(4, 60);
    scene.objects.push_back(random_layers(1, 1).objects[0]);
    scene::Object& wall = scene.objects.back();
    wall.world_from_object[3].z = 4 - wall.mesh->data().positions[0].z;
    return scene;
}

}  // namespace

// A chain of random clips; corners are on the pixels' grid, so many fall on sides of others.
TEST(Region, IsDividedByAClipSoThatEveryPixelIsInOnePart) {
    for (std::uint32_t seed = 1; seed <= 400; ++seed) {
        Random random(seed);
        Lines lines;
        std::vector<GridPoint> whole = random_triangle(random);
        std::vector<Region> parts{{lines.add_contour(whole)}};
        for (int i = 0; i < 6; ++i) {
            std::vector<GridPoint> other = random_triangle(random);
            // Neighbours: a side the other way round, or a corner in common.
            if (i % 3 == 1) other = {whole[1], whole[0], other[2]};
            if (i % 3 == 2) other[0] = whole[2];
            const std::int64_t turn = (other[1].x - other[0].x) * (other[2].y - other[0].y) -
                                      (other[1].y - other[0].y) * (other[2].x - other[0].x);
            if (turn == 0) continue;
            if (turn < 0) std::swap(other[1], other[2]);
            const Contour clip = lines.add_contour(other);
            const auto by = counted(scan_convert(other, 3, window), 32, 32);
            std::vector<Region> next;
            for (const Region& part : parts) {
                const auto [in, out] = lines.clip(part, clip);
                const auto all = counted(lines.runs(part, 3, window), 32, 32);
                const auto inside = counted(lines.runs(in, 3, window), 32, 32);
                const auto outside = counted(lines.runs(out, 3, window), 32, 32);
                for (std::size_t k = 0; k < all.size(); ++k) {
                    ASSERT_EQ(inside[k], all[k] * by[k]) << "seed " << seed << ", pixel " << k;
                    ASSERT_EQ(outside[k], all[k] * (1 - by[k]))
                        << "seed " << seed << ", pixel " << k;
                }
                next.push_back(in);
                next.push_back(out);
            }
            parts = std::move(next);
        }
    }
}

TEST(Region, GetsAHoleWhereTheClipIsInside) {
    Lines lines;
    const Region square{lines.add_contour({{0, 0, 0}, {80, 0, 0}, {80, 80, 0}, {0, 80, 0}})};
    const Contour clip = lines.add_contour({{24, 24, 0}, {56, 24, 0}, {40, 56, 0}});
    const auto [in, out] = lines.clip(square, clip);
    EXPECT_EQ(in.size(), 1u);
    ASSERT_EQ(out.size(), 2u);
    EXPECT_EQ(out[1].size(), 3u);
    EXPECT_FALSE(lines.separates(clip, square));
    const Contour beside = lines.add_contour({{80, 80, 0}, {80, 0, 0}, {120, 40, 0}});
    EXPECT_TRUE(lines.separates(beside, square));
    // Neighbours, moved outwards, share less than a point's width: nothing.
    EXPECT_TRUE(lines.clip(square, beside).first.empty());
}

TEST(Faces, HaveThePixelsAndTheOrderOfTheirTriangles) {
    for (std::uint32_t seed = 1; seed <= 10; ++seed) {
        Trial trial(piercing_rectangles(seed), vgx(), 72, 54);
        const Input& input = trial.input;
        const std::vector<Face> faces = faces_of(input);
        std::map<std::size_t, std::vector<int>> count;
        for (const Face& face : faces) {
            auto& of = count.try_emplace(face.polygon, std::vector<int>(72 * 54)).first->second;
            for (int y = 0; y < 54; ++y)
                for (int x = 0; x < 72; ++x) {
                    const bool inside = covers(face, x, y);
                    of[std::size_t(72 * y + x)] += inside ? 1 : 0;
                    const auto run = run_of(face, y, x, x + 1);
                    EXPECT_EQ(run.x0 < run.x1, inside);
                    EXPECT_EQ(cover_of(face, {x, y, 1, 1}) == Cover::Surrounds, inside);
                }
        }
        for (const auto& [polygon, of] : count) {
            std::vector<hiddensurface::Run> runs;
            for (const WindowTriangle& t : input.polygons[polygon].triangles)
                for (const auto& run : scan_convert(t.corners, 3, input.window()))
                    runs.push_back(run);
            EXPECT_EQ(of, counted(runs, 72, 54)) << "seed " << seed << ", polygon " << polygon;
        }
    }
}

TEST(Octree, HasEveryPolygonOnceAndItsWindowBoxHasAllOfIt) {
    Trial trial(random_triangles(3, 60));
    const std::unique_ptr<Cube> root = build_octree(trial.input.polygons, 2);
    std::vector<int> found(trial.input.polygons.size());
    std::function<void(const Cube&)> visit = [&](const Cube& cube) {
        const WindowBox box = window_box(cube.low, cube.high, trial.view, trial.input.profile);
        for (const std::size_t i : cube.polygons) {
            found[i] += 1;
            for (const WindowTriangle& t : trial.input.polygons[i].triangles)
                for (GridPoint p : t.corners) {
                    EXPECT_GE(p.z, box.nearest);
                    p.x =
                        // what is outside the window is not asked
                        std::clamp<std::int64_t>(p.x, 0, 160 * 8);
                    p.y = std::clamp<std::int64_t>(p.y, 0, 120 * 8);
                    EXPECT_GE(p.x, box.rect.x * 8);
                    EXPECT_LE(p.x, (box.rect.x + box.rect.width) * 8);
                    EXPECT_GE(p.y, box.rect.y * 8);
                    EXPECT_LE(p.y, (box.rect.y + box.rect.height) * 8);
                }
        }
        for (const auto& part : cube.parts)
            if (part) visit(*part);
    };
    visit(*root);
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_EQ(found[i], trial.input.polygons[i].visible() ? 1 : 0) << i;
}

TEST(Octree, IsWalkedFromTheEyesCornerToTheOppositeOne) {
    const Cube cube{{-1, -1, -1}, {1, 1, 1}, {}, {}};
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const dvec3 to_eye(corner & 1 ? 3 : -3, corner & 2 ? 3 : -3, corner & 4 ? 3 : -3);
        for (const double w : {0.0, 1.0}) {
            const auto order = near_to_far(cube, dvec4(to_eye, w));
            EXPECT_EQ(order.front(), corner);
            EXPECT_EQ(order.back(), 7 - corner);
            for (std::size_t i = 1; i < 8; ++i)  // more and more axes on the far side
                EXPECT_GE(std::popcount(order[i] ^ corner), std::popcount(order[i - 1] ^ corner));
        }
    }
}

// True ties: the scene's first is seen, as by the Z-buffer. Newell's five tests leave them open.
TEST(CoincidentFaces, ShowTheScenesFirst) {
    scene::Scene scene = piercing_rectangles(1);
    const scene::Object object = scene.objects[0];
    scene.objects.push_back(object);
    Trial trial(std::move(scene));
    for (const Algorithm& algorithm : algorithms())
        if (algorithm.claim == Claim::Always && algorithm.name != "newell") {
            const std::vector<std::uint32_t> ids = trial.run(algorithm.name).ids;
            EXPECT_LE(*std::max_element(ids.begin(), ids.end()), 10u) << algorithm.name;
        }
}

// The same where the later one is met first on every scan line.
TEST(CoincidentFaces, ShowTheScenesFirstBesideWhatBeginsFartherLeft) {
    MeshData data{.primitive = Primitive::Quads};
    for (const float left : {-1.0f, -2.0f})
        for (const auto& [x, y] :
             {std::pair(0, -1), std::pair(3, -1), std::pair(3, 1), std::pair(0, 1)})
            data.positions.push_back(vec3(left + float(x), float(y), 0));
    Trial trial(polygon_scene(std::move(data)));
    EXPECT_EQ(trial.z_buffer.ids[60 * 160 + 80], 1u);
    for (const Algorithm& algorithm : algorithms())
        if (algorithm.claim == Claim::Always && algorithm.name != "newell") {
            EXPECT_EQ(trial.run(algorithm.name).ids, trial.z_buffer.ids) << algorithm.name;
        }
}

// Bit for bit, also where surfaces lie in each other and polygons come in another order.
TEST(HierarchicalZ, IsTheZBuffer) {
    for (std::uint32_t seed = 1; seed <= 10; ++seed) {
        Trial blocks(touching_blocks(seed)), triangles(coplanar_triangles(seed));
        EXPECT_EQ(blocks.run("hierarchical-z").ids, blocks.z_buffer.ids) << seed;
        EXPECT_EQ(triangles.run("hierarchical-z").ids, triangles.z_buffer.ids) << seed;
    }
}

// The octree has the last polygon, across its middle, before the others, which are in its parts.
TEST(HierarchicalZ, ShowsTheScenesFirstOfWhatLiesInAPlane) {
    MeshData data{.primitive = Primitive::Quads};
    const auto add = [&](float x, float y, float w, float h) {
        for (const auto& [i, k] :
             {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)})
            data.positions.push_back(vec3(x + float(i) * w, y + float(k) * h, 0));
    };
    for (const float x : {-1.9f, -0.9f, 0.1f, 1.1f})
        for (const float y : {-0.9f, 0.1f}) add(x, y, 0.8f, 0.8f);
    add(-2, -1, 4, 2);
    Trial trial(polygon_scene(std::move(data)));
    for (std::uint32_t id = 1; id <= 9; ++id)
        EXPECT_GT(std::count(trial.z_buffer.ids.begin(), trial.z_buffer.ids.end(), id), 100) << id;
    EXPECT_EQ(trial.run("hierarchical-z").ids, trial.z_buffer.ids);
}

// [Schumacker 1969] One convex solid: front sides have no priorities among them; solids apart need
// no cut.
TEST(Schumacker, CutsNothingOfConvexSolidsThatPlanesSeparate) {
    std::uint64_t cut_by_the_bsp_tree = 0;
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        Trial trial(convex_solids(seed), vgx(), 72, 54);
        const ClusterTree tree = build_clusters(trial.input.polygons, {});
        EXPECT_EQ(tree.splits, 0u) << seed;
        EXPECT_EQ(tree.clusters, tree.separations + 1);
        cut_by_the_bsp_tree += trial.run("bsp").counts.splits;
    }
    EXPECT_GT(cut_by_the_bsp_tree, 10u);
    Random random(1);
    MeshData data;
    add_solid(data, vec3(0), random);
    Trial one(polygon_scene(std::move(data)));
    const ClusterTree tree = build_clusters(one.input.polygons, {});
    EXPECT_EQ(tree.clusters, 1u);
    for (const RankedSide& side : tree.nodes[0].sides)
        EXPECT_EQ(side.priority, side.front ? 1u : 2u);
}

// Above 512 faces no face is compared with another, so the memory grows with the faces.
TEST(Schumacker, RanksALargeConvexSolidWithoutComparingItsFaces) {
    Trial trial(polygon_scene(scene::make_icosphere(1, 3)));
    const std::size_t faces = trial.input.polygons.size();
    ASSERT_EQ(faces, 1280u);
    const ClusterTree tree = build_clusters(trial.input.polygons, {});
    EXPECT_EQ(tree.clusters, 1u);
    EXPECT_EQ(tree.comparison_bytes, 0u);
    for (const RankedSide& side : tree.nodes[0].sides)
        EXPECT_EQ(side.priority, side.front ? 1u : 2u);
    EXPECT_EQ(trial.run("schumacker").counts.wrong, 0u);
}

// Of faces in one plane the scene's first is seen, from both sides and whichever way it faces.
TEST(Schumacker, ShowsTheFirstOfManyFacesInOnePlane) {
    MeshData data{.primitive = Primitive::Quads};
    Random random(3);
    for (int i = 0; i < 700; ++i) {
        const auto x = float(random(-1.5, 1)), y = float(random(-1, 0.5));
        std::vector<vec3> corners{
            {x, y, 0}, {x + 0.5f, y, 0}, {x + 0.5f, y + 0.5f, 0}, {x, y + 0.5f, 0}};
        if (i % 2 == 1) std::reverse(corners.begin(), corners.end());
        data.positions.insert(data.positions.end(), corners.begin(), corners.end());
    }
    for (const double z : {6, -6}) {
        scene::Scene scene = polygon_scene(data);
        scene.camera->eye = {0, 0, z};
        Trial trial(std::move(scene));
        EXPECT_EQ(trial.run("schumacker").ids, trial.z_buffer.ids) << z;
    }
}

TEST(Schumacker, DividesWhatHasNoPriorities) {
    Trial cycle(case_scene("cycle")), pierce(case_scene("pierce"));
    EXPECT_GE(cycle.run("schumacker").counts.splits, 1u);
    EXPECT_GE(pierce.run("schumacker").counts.splits, 1u);
}

// [Watkins 1970] What is hidden ends none of his spans, and every one of Bouknight's.
TEST(Watkins, LooksAtALineOnceWhereAWallHidesAll) {
    Trial trial(behind_a_wall());
    const Counts bouknight = trial.run("bouknight").counts, watkins = trial.run("watkins").counts;
    EXPECT_EQ(watkins.spans, 120u);
    EXPECT_GT(bouknight.spans, 1000u);
    EXPECT_LT(watkins.depths * 2, bouknight.depths);
}

// [Greene 1993] Behind a layer that fills the window everything is rejected: nothing but the layer
// is drawn.
TEST(HierarchicalZ, RejectsWhatIsBehindAWall) {
    Trial trial(behind_a_wall());
    const Result result = trial.run("hierarchical-z");
    EXPECT_EQ(result.ids, trial.z_buffer.ids);
    EXPECT_GT(result.counts.rejected, 0u);
    EXPECT_LT(result.counts.passed, trial.z_buffer.counts.passed);
    EXPECT_LT(result.counts.depths, trial.z_buffer.counts.depths);
}

// [Carpenter 1984] A square that covers 3/8 of a pixel across and 1/2 down has 3 x 2 of its points.
TEST(ABuffer, GivesEveryPolygonItsPartOfThePixel) {
    MeshData data{.primitive = Primitive::Quads};
    for (const auto& [x, y] : {std::pair(0.0, 0.0), {0.375, 0.0}, {0.375, 0.5}, {0.0, 0.5}})
        data.positions.push_back(vec3(float(x), float(y), 0));
    for (const auto& [x, y] : {std::pair(-5.0, -5.0), {5.0, -5.0}, {5.0, 5.0}, {-5.0, 5.0}})
        data.positions.push_back(vec3(float(x), float(y), -1));
    scene::Scene scene = polygon_scene(std::move(data));
    scene.camera->ortho_height = 8;
    Trial trial(std::move(scene), vgx(), 8, 8);
    const Result result = trial.run("a-buffer");
    std::map<std::pair<int, int>, double> sums;
    for (const Share& share : result.shares) {
        sums[{share.x, share.y}] += share.part;
        if (share.id == 1) {
            EXPECT_EQ(share.part, 6.0 / 32);
            EXPECT_EQ(std::pair(share.x, share.y), std::pair(4, 4));
        }
    }
    EXPECT_EQ(sums.size(), 64u);
    for (const auto& [pixel, sum] : sums) EXPECT_EQ(sum, 1.0);
    EXPECT_EQ(result.ids, trial.z_buffer.ids);
}

// [Weiler, Atherton 1977] Three in a cycle: each a polygon with what hides it taken out; together
// every pixel once.
TEST(WeilerAtherton, EndsACycleWithPolygonsThatDoNotOverlap) {
    Trial trial(case_scene("cycle"));
    const Result result = trial.run("weiler-atherton");
    EXPECT_EQ(result.ids, trial.z_buffer.ids);
    EXPECT_EQ(result.counts.overdraw, 0u);
    EXPECT_EQ(result.counts.nodes, 5u);
    EXPECT_EQ(result.pieces.size(), 5u);
}

// [Warnock 1969] One face: one window. The lower half of the picture hidden by a wall costs one
// look a quarter.
TEST(Warnock, LooksOnceWhereThePictureIsSimple) {
    Trial one(random_layers(1, 1));
    EXPECT_EQ(one.run("warnock").counts.nodes, 1u);
    Trial many(random_layers(1, 16));
    EXPECT_EQ(many.run("warnock").counts.nodes, 1u);
}

// [Abrash 1997] No depths, no overdraw; the keys do it.
TEST(Quake, ComparesKeysOnly) {
    Trial trial(case_scene("solids"));
    const Counts counts = trial.run("quake").counts;
    EXPECT_EQ(counts.depths, 0u);
    EXPECT_EQ(counts.overdraw, 0u);
    EXPECT_GT(counts.keys, 0u);
}

}  // namespace gw::hiddensurface
