// Closed rooms whose surfaces all emit E and reflect rho: B = E / (1 - rho) at every texel [F2.2],
// whatever the room's shape, the corners included, within half a percent.
#include "radiosity/solver/solver.h"
#include "tests/radiosity/scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gw::radiosity {
namespace {

/// A wall whose corners are given in order, its front where they run counterclockwise.
void add_wall(scene::Scene& scene, std::vector<vec3> corners, float rho, float emission) {
    const std::string name = "wall " + std::to_string(scene.objects.size());
    scene.materials.push_back({.name = name, .Kd = vec3(rho), .Ke = vec3(emission)});
    scene.objects.push_back(
        {.name = name,
         .mesh = make_mesh({.primitive = Primitive::Polygons, .positions = std::move(corners)}),
         .material = scene.materials.size() - 1});
}

/// Over a floor plan (x, z), seen from above counterclockwise with z downwards; floor and ceiling
/// as pieces.
scene::Scene prism(const std::vector<vec2>& plan,
                   const std::vector<std::vector<std::size_t>>& pieces, float height, float rho) {
    scene::Scene scene;
    const auto at = [&](std::size_t i, float y) { return vec3(plan[i].x, y, plan[i].y); };
    for (std::size_t i = 0; i < plan.size(); ++i) {
        const std::size_t j = (i + 1) % plan.size();
        add_wall(scene, {at(i, 0), at(i, height), at(j, height), at(j, 0)}, rho, 1);
    }
    for (const auto& piece : pieces) {
        std::vector<vec3> floor, ceiling;
        for (std::size_t i : piece) floor.push_back(at(i, 0));
        for (auto i = piece.rbegin(); i != piece.rend(); ++i) ceiling.push_back(at(*i, height));
        add_wall(scene, floor, rho, 1);
        add_wall(scene, ceiling, rho, 1);
    }
    return scene;
}

/// The least and the largest radiosity of a covered texel over E / (1 - rho), when next to nothing
/// is unshot.
std::pair<double, double> solved(const scene::Scene& scene, double texels, int hemicube,
                                 float rho) {
    Solver solver(make_model(scene, {.texels_per_unit = texels}),
                  {.form_factors = {.hemicube = hemicube}});
    while (books(solver.model(), solver.solution()).unshot_share() > 1e-5) solver.shoot();
    std::pair<double, double> range{1e9, 0};
    for (std::size_t t = 0; t < solver.model().texel_count(); ++t) {
        if (solver.model().area[t] == 0) continue;
        const double b = radiosity_at(solver.model(), solver.solution(), t).x * (1 - double(rho));
        range = {std::min(range.first, b), std::max(range.second, b)};
    }
    return range;
}

void expect_furnace(const scene::Scene& scene, double texels, int hemicube, float rho,
                    double allowed = 0.005) {
    const auto [low, high] = solved(scene, texels, hemicube, rho);
    EXPECT_GT(low, 1 - allowed);
    EXPECT_LT(high, 1 + allowed);
}

TEST(Furnace, AFlatBox) { expect_furnace(closed_box({1.2f, 0.4f, 1}, 0.3f, 1), 5, 64, 0.3f); }

TEST(Furnace, ALongBoxOfBrightWalls) {
    expect_furnace(closed_box({0.7f, 0.7f, 3}, 0.8f, 1), 4, 64, 0.8f);
}

TEST(Furnace, ARoomRoundACorner) {
    const std::vector<vec2> plan{{0, 0}, {0, 2}, {1, 2}, {1, 1}, {2, 1}, {2, 0}, {1, 0}};
    expect_furnace(prism(plan, {{0, 1, 2, 6}, {6, 3, 4, 5}}, 1, 0.5f), 4, 64, 0.5f);
}

// Triangular walls: texels on the slanting border are covered in part. Within half a percent with a
// hemicube of 256; within a percent and a half with one of 64, that there is time for here.
TEST(Furnace, ATetrahedron) {
    const vec3 a(0, 0, 0), b(1.5f, 0, 0.2f), c(0.4f, 0, 1.6f), d(0.5f, 1.3f, 0.6f);
    scene::Scene scene;
    for (const auto& wall : {std::vector{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}}) {
        add_wall(scene, wall, 0.5f, 1);
    }
    expect_furnace(scene, 6, 64, 0.5f, 0.015);
}

// A room with a block in it: all that is seen is equally bright.
TEST(Furnace, ABlockInABox) {
    scene::Scene scene = closed_box({1.5f, 1, 1.5f}, 0.5f, 1);
    const scene::Scene block = closed_box({0.5f, 0.4f, 0.5f}, 0.5f, 1);
    for (const scene::Object& side : block.objects) {
        std::vector<vec3> corners;
        for (const vec3& p : side.mesh->data().positions)
            corners.push_back(p + vec3(0.3f, 0.25f, 0.6f));
        add_wall(scene, {corners.rbegin(), corners.rend()}, 0.5f, 1);
    }
    expect_furnace(scene, 6, 64, 0.5f);
}

}  // namespace
}  // namespace gw::radiosity
