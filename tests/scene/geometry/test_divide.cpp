#include "scene/geometry/divide.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

namespace gw::scene {
namespace {

MeshData square() {
    return {.primitive = Primitive::Quads,
            .positions = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}},
            .texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
}

TEST(Divide, AQuadBecomesASquareOfQuads) {
    const MeshData mesh = divide(square(), 2);
    EXPECT_EQ(mesh.indices.size(), 16u);
    EXPECT_EQ(mesh.positions[mesh.indices[2]], vec3(2, 2, 0));
    EXPECT_EQ(mesh.texcoords[mesh.indices[2]], vec2(0.5f, 0.5f));
    EXPECT_EQ(mesh.positions[mesh.indices[12]], vec3(2, 2, 0));
    EXPECT_EQ(mesh.positions[mesh.indices[14]], vec3(4, 4, 0));
    EXPECT_EQ(make_mesh(mesh)->polygon_count(), 4u);
}

TEST(Divide, OnePieceChangesNothing) { EXPECT_EQ(divide(square(), 1), square()); }

TEST(Divide, OtherFacesAreKept) {
    MeshData mesh{.primitive = Primitive::Polygons,
                  .positions = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {2, 8, 0}}};
    mesh.indices = {0, 1, 2, 3, 3, 2, 4};
    mesh.polygon_sizes = {4, 3};
    const MeshData divided = divide(mesh, 3);
    EXPECT_EQ(divided.polygon_sizes, (std::vector<std::uint32_t>{4, 4, 4, 4, 4, 4, 4, 4, 4, 3}));
    EXPECT_EQ(std::vector<std::uint32_t>(divided.indices.end() - 3, divided.indices.end()),
              (std::vector<std::uint32_t>{3, 2, 4}));
    const MeshData triangles{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    EXPECT_EQ(divide(triangles, 5), triangles);
}

TEST(Divide, NeighboursShareThePointsOfTheirSide) {
    // Two quads with one side, walked the other way, begun at another corner; numbers that do not
    // divide well.
    MeshData mesh{.primitive = Primitive::Quads,
                  .positions = {{0.1f, 0.2f, 0.3f},
                                {7.7f, 0.9f, 1.3f},
                                {8.1f, 5.3f, 2.2f},
                                {0.4f, 4.9f, 1.1f},
                                {15.3f, 1.7f, 9.1f},
                                {16.9f, 6.1f, 8.7f}}};
    mesh.indices = {0, 1, 2, 3, 5, 2, 1, 4};
    for (const int n : {3, 7, 13}) {
        const MeshData divided = divide(mesh, n);
        const std::size_t points = std::size_t((n + 1) * (n + 1));
        using Point = std::tuple<float, float, float>;
        std::set<Point> first;
        for (std::size_t i = 6; i < 6 + points; ++i)
            first.insert({divided.positions[i].x, divided.positions[i].y, divided.positions[i].z});
        int shared = 0;
        for (std::size_t i = 6 + points; i < 6 + 2 * points; ++i)
            shared += static_cast<int>(first.count(
                {divided.positions[i].x, divided.positions[i].y, divided.positions[i].z}));
        EXPECT_EQ(shared, n + 1);
    }
}

}  // namespace
}  // namespace gw::scene
