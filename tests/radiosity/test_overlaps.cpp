// Automatic ST of surfaces that would cover a texel twice.
#include "radiosity/model/figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace gw::radiosity {
namespace {

scene::Scene one(MeshData mesh) {
    scene::Scene scene;
    scene.materials.push_back({.name = "matter", .Kd = vec3(0.5f), .Ke = vec3(1)});
    scene.objects.push_back({.name = "thing", .mesh = make_mesh(std::move(mesh))});
    return scene;
}

double area(const PixmapModel& model) {
    return std::accumulate(model.area.begin(), model.area.end(), 0.0);
}

/// Half the length of the sides' cross product, by components.
double area_of(const MeshData& mesh) {
    double sum = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const dvec3 a(mesh.positions[mesh.indices[i]]), b(mesh.positions[mesh.indices[i + 1]]),
            c(mesh.positions[mesh.indices[i + 2]]);
        const double x = (b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y),
                     y = (b.z - a.z) * (c.x - a.x) - (b.x - a.x) * (c.z - a.z),
                     z = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        sum += std::sqrt(x * x + y * y + z * z) / 2;
    }
    return sum;
}

void expect_no_texel_twice(const PixmapModel& model) {
    for (const double share : model.share) EXPECT_LE(share, 1.001);
}

/// A ramp around the y axis from radius 1 to 2, seen from above.
MeshData spiral(double turns) {
    MeshData mesh;
    const int steps = int(turns * 36);
    for (int i = 0; i <= steps; ++i) {
        const double angle = i * std::numbers::pi / 18;
        for (const double r : {1.0, 2.0})
            mesh.positions.push_back(
                {float(r * std::cos(angle)), float(0.3 * i / 36), float(-r * std::sin(angle))});
        if (i == steps) break;
        const auto v = std::uint32_t(2 * i);
        for (const std::uint32_t k : {v, v + 1, v + 2, v + 1, v + 3, v + 2})
            mesh.indices.push_back(k);
    }
    return mesh;
}

TEST(Overlaps, OneTurnOfARampIsOneChart) {
    const PixmapModel model = make_model(one(spiral(0.9)), {.texels_per_unit = 20});
    EXPECT_EQ(model.pixmaps.size(), 1u);
    EXPECT_EQ(model.pixmaps[0].name, "thing");
}

TEST(Overlaps, ARampOfSeveralTurnsHasAPixmapForEach) {
    const MeshData ramp = spiral(2.5);
    const PixmapModel model = make_model(one(ramp), {.texels_per_unit = 20});
    EXPECT_GE(model.pixmaps.size(), 3u);
    EXPECT_LE(model.pixmaps.size(), 6u);
    EXPECT_EQ(model.pixmaps[0].name, "thing 1");
    EXPECT_EQ(model.pixmaps.back().name, "thing " + std::to_string(model.pixmaps.size()));
    EXPECT_NEAR(area(model), area_of(ramp), 1e-6 * area_of(ramp));
    expect_no_texel_twice(model);
}

TEST(Overlaps, DoubledFacesHaveTwoPixmaps) {
    const MeshData twice{.positions = {{0, 0, 0}, {0, 0, 2}, {2, 0, 2}, {2, 0, 0}},
                         .indices = {0, 1, 2, 0, 2, 3, 0, 1, 2, 0, 2, 3}};
    const PixmapModel model = make_model(one(twice), {.texels_per_unit = 4});
    ASSERT_EQ(model.pixmaps.size(), 2u);
    for (const Pixmap& pixmap : model.pixmaps) {
        EXPECT_EQ(pixmap.width, 8);
        EXPECT_EQ(pixmap.height, 8);
    }
    EXPECT_NEAR(area(model), 8, 1e-9);
    expect_no_texel_twice(model);
}

}  // namespace
}  // namespace gw::radiosity
