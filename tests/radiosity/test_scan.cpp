// From pixels to texels [F2.2]: nothing lost, nothing missed, the same bits for any number of
// threads.
#include "gw/fast/simd/simd_target.h"
#include "radiosity/hemicube/form_factors.h"
#include "radiosity/hemicube/hemicube.h"
#include "tests/radiosity/plain_scan.h"
#include "tests/radiosity/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace gw::radiosity {
namespace {

constexpr double texels_on_wall = 40.0 * 40;

/// A small lamp before a wall of many texels.
scene::Scene lamp_and_wall() {
    scene::Scene scene;
    add_quad(scene, "lamp", {-0.05f, 0, -0.05f}, {0, 0, 0.1f}, {0.1f, 0, 0}, 0, 1);
    add_quad(scene, "wall", {-2, 0.5f, -2}, {4, 0, 0}, {0, 0, 4}, 0.5f);
    return scene;
}

Row row_with(const PixmapModel& model, int hemicube, int parts, int threads = 0) {
    FormFactors factors(model,
                        {.hemicube = hemicube, .scan = {.most_parts = parts}, .threads = threads});
    return factors.from_patch(0);
}

double texels_lit(const PixmapModel& model, const Row& row) {
    const Pixmap& wall = model.pixmaps[1];
    return static_cast<double>(std::count_if(row.texels.begin(), row.texels.end(),
                                             [&](std::uint32_t t) { return t >= wall.first; }));
}

// [F2.2o] Fig. 3: a coarse buffer misses texels; divided virtually, it reaches all of them. From
// one point, so that no other one makes up for what it misses; with the hemicube turned in any way.
TEST(Oversampling, NoVisibleTexelIsLeftWithoutEnergy) {
    const PixmapModel model = make_model(lamp_and_wall(), {.texels_per_unit = 10});
    for (std::uint64_t seed = 0; seed < 16; ++seed)
        for (const int parts : {1, 64}) {
            FormFactors factors(model,
                                {.hemicube = 32, .scan = {.most_parts = parts}, .seed = seed});
            const double lit =
                texels_lit(model, factors.from_points({{{0, 0, 0}, {0, 1, 0}, 1, 0.1}}, 0));
            if (parts == 1)
                EXPECT_LT(lit, 0.75 * texels_on_wall) << seed;
            else
                EXPECT_EQ(lit, texels_on_wall) << seed;
        }
}

// The same for a wall that is seen at a slant: pixels on it are long and narrow, the farther the
// longer.
TEST(Oversampling, NorIsATexelOfASlantingWall) {
    scene::Scene scene;
    add_quad(scene, "lamp", {-0.05f, 0, -0.05f}, {0, 0, 0.1f}, {0.1f, 0, 0}, 0, 1);
    add_quad(scene, "wall", {0.3f, 0.2f, -1}, {0.2f, 0.1f, 2}, {1, 3, 0.5f}, 0.5f);
    const PixmapModel model = make_model(scene, {.texels_per_unit = 10});
    double elements = 0;
    for (std::size_t t = model.pixmaps[1].first; t < model.texel_count(); ++t)
        elements += model.nearest[t] == t && model.area[t] > 0 ? 1 : 0;
    for (std::uint64_t seed = 0; seed < 16; ++seed) {
        FormFactors factors(model, {.hemicube = 32, .seed = seed});
        EXPECT_EQ(texels_lit(model, factors.from_points({{{0, 0, 0}, {0, 1, 0}, 1, 0.1}}, 0)),
                  elements)
            << seed;
    }
}

// The energy is the same: oversampling only spreads it.
TEST(Oversampling, ChangesNoSum) {
    const PixmapModel model = make_model(lamp_and_wall(), {.texels_per_unit = 10});
    const Row with = row_with(model, 64, 64), without = row_with(model, 64, 1);
    EXPECT_NEAR(std::accumulate(with.factors.begin(), with.factors.end(), 0.0),
                std::accumulate(without.factors.begin(), without.factors.end(), 0.0), 1e-12);
    EXPECT_EQ(with.escaped, without.escaped);
}

/// An octahedron in a closed box.
scene::Scene solid_in_a_box() {
    scene::Scene scene = closed_box({1, 1, 1}, 0.5f, 1);
    MeshData octahedron{
        .positions = {{0.7f, 0.5f, 0.5f},
                      {0.3f, 0.5f, 0.5f},
                      {0.5f, 0.7f, 0.5f},
                      {0.5f, 0.3f, 0.5f},
                      {0.5f, 0.5f, 0.7f},
                      {0.5f, 0.5f, 0.3f}},
        .indices = {2, 4, 0, 2, 0, 5, 2, 5, 1, 2, 1, 4, 3, 0, 4, 3, 5, 0, 3, 1, 5, 3, 4, 1}};
    scene.materials.push_back({.name = "solid", .Kd = vec3(0.5f)});
    scene.objects.push_back(
        {.name = "solid", .mesh = make_mesh(octahedron), .material = scene.materials.size() - 1});
    return scene;
}

// Every pixel is some facet's, none is lost between regions.
TEST(Scan, NoPixelIsLost) {
    const PixmapModel model = make_model(solid_in_a_box(), {.texels_per_unit = 6});
    FormFactors factors(model, {.hemicube = 64});
    for (std::size_t p = 0; p < model.patches.size(); p += 5) {
        const Row row = factors.from_patch(p);
        EXPECT_NEAR(
            std::accumulate(row.factors.begin(), row.factors.end(), 0.0) + row.backs + row.escaped,
            1, 1e-9)
            << p;
        EXPECT_EQ(row.escaped, 0) << p;
        EXPECT_EQ(row.backs, 0) << p;
    }
}

TEST(Scan, AnyNumberOfThreadsGivesTheSameBits) {
    const PixmapModel model = make_model(lamp_and_wall(), {.texels_per_unit = 10});
    const Row one = row_with(model, 64, 64, 1);
    for (int threads : {2, 5}) {
        const Row more = row_with(model, 64, 64, threads);
        EXPECT_EQ(one.texels, more.texels);
        EXPECT_EQ(one.factors, more.factors);
        EXPECT_EQ(one.escaped, more.escaped);
    }
}

// From corners and from the middle; texels larger and smaller than pixels, and cut by figures'
// borders.
TEST(Scan, IsThePlainOneToTheBitOnEveryVectorTarget) {
    for (const double texels : {3.0, 40.0}) {
        const PixmapModel model = make_model(solid_in_a_box(), {.texels_per_unit = texels});
        for (const int parts : {1, 2, 64}) {
            const DeltaFormFactors delta = delta_form_factors(50);
            const Hemicube cube = hemicube_at({0.02, 0.9, 0.3 * parts / 64}, {0.6, -0.8, 0},
                                              17.0 * parts, 1e-3, 3, 50);
            IdBuffers buffers;
            HemicubePainter(50).draw(model, cube, buffers);
            std::vector<double> plain(model.texel_count());
            for (std::uint32_t pixmap = 0; pixmap < model.pixmaps.size(); ++pixmap)
                plain_scan(model, pixmap, cube, buffers, delta, {parts}, plain);
            for (const std::string& target : fast::simd_targets()) {
                ASSERT_TRUE(fast::use_simd_target(target));
                std::vector<double> factors(model.texel_count());
                PixelScratch scratch;
                for (std::uint32_t facet = 0; facet < model.facets.size(); ++facet)
                    scan_pixels(model, facet, cube, buffers, delta, {parts}, factors, scratch);
                EXPECT_EQ(factors, plain)
                    << target << ", " << texels << " texels, " << parts << " parts";
            }
            fast::use_simd_target("");
        }
    }
}

// Identifiers in runs and alone, in rows and buffers of any length; whatever alpha is.
TEST(Seen, HasTheIdentifiersThatAreThere) {
    for (const std::string& target : fast::simd_targets()) {
        ASSERT_TRUE(fast::use_simd_target(target));
        std::minstd_rand random(1);
        for (int round = 0; round < 400; ++round) {
            const std::size_t row = 1 + random() % 40, rows = 1 + random() % 6;
            std::vector<std::uint32_t> pixels;
            std::vector<char> expected(50), present(50);
            while (pixels.size() < row * rows) {
                const std::uint32_t id = random() % 50;
                const std::size_t run = std::min(1 + random() % 30, row * rows - pixels.size());
                pixels.insert(pixels.end(), run, 0xFF000000 | id);
                expected[id] = 1;
            }
            mark_present_ids(pixels, row, present.data());
            ASSERT_EQ(present, expected) << target << ", round " << round;
        }
    }
    fast::use_simd_target("");
}

TEST(Scan, BacksAreSeenAndAreNoSurface) {
    scene::Scene scene;
    // faces up, seen from below
    add_quad(scene, "wall", {-2, 0.5f, -2}, {0, 0, 4}, {4, 0, 0}, 0.5f, 1);
    const PixmapModel model = make_model(scene, {.texels_per_unit = 4});
    FormFactors factors(model, {.hemicube = 32});
    const Row row = factors.from_points({{{0, 0, 0}, {0, 1, 0}, 1, 0.1}}, 0);
    EXPECT_GT(row.backs, 0.5);
    EXPECT_TRUE(row.texels.empty());
}

}  // namespace
}  // namespace gw::radiosity
