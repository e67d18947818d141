#include "gw/error.h"
#include "gw/mesh.h"

#include <gtest/gtest.h>

#include <limits>

namespace gw {
namespace {

using Vertices = std::array<std::uint32_t, 3>;

MeshData points(std::size_t n, Primitive primitive) {
    MeshData data{.primitive = primitive};
    for (std::size_t i = 0; i < n; ++i) data.positions.push_back({i, i * i, 0});
    return data;
}

std::string error_of(MeshData data) {
    try {
        make_mesh(std::move(data));
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

// [R6.2]
TEST(Mesh, TrianglesAreTakenAsTheyStand) {
    const MeshRef mesh = make_mesh(points(6, Primitive::Triangles));
    EXPECT_EQ(mesh->kind(), MeshKind::Triangles);
    ASSERT_EQ(mesh->triangles().size(), 2u);
    EXPECT_EQ(mesh->triangles()[1], (Triangle{Vertices{3, 4, 5}, 5, 1, 7}));
    EXPECT_EQ(mesh->polygon_count(), 2u);
}

// [R6.2]
TEST(Mesh, AStripTurnsEverySecondTriangle) {
    const MeshRef mesh = make_mesh(points(5, Primitive::TriangleStrip));
    ASSERT_EQ(mesh->triangles().size(), 3u);
    EXPECT_EQ(mesh->triangles()[0], (Triangle{Vertices{0, 1, 2}, 2, 0, 7}));
    EXPECT_EQ(mesh->triangles()[1], (Triangle{Vertices{2, 1, 3}, 3, 1, 7}));
    EXPECT_EQ(mesh->triangles()[2], (Triangle{Vertices{2, 3, 4}, 4, 2, 7}));
}

TEST(Mesh, AFanSharesItsFirstVertex) {
    const MeshRef mesh = make_mesh(points(4, Primitive::TriangleFan));
    ASSERT_EQ(mesh->triangles().size(), 2u);
    EXPECT_EQ(mesh->triangles()[1], (Triangle{Vertices{0, 2, 3}, 3, 1, 7}));
}

// [R6.2] [R6.4]
TEST(Mesh, AQuadIsTwoTrianglesOfOnePolygonAndHasTheColourOfItsLastVertex) {
    MeshData data{.primitive = Primitive::Quads,
                  .positions = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
    data.indices = {1, 2, 3, 4};
    const MeshRef mesh = make_mesh(data);
    ASSERT_EQ(mesh->triangles().size(), 2u);
    EXPECT_EQ(mesh->triangles()[0], (Triangle{Vertices{1, 2, 3}, 4, 0, 0b011}));
    EXPECT_EQ(mesh->triangles()[1], (Triangle{Vertices{1, 3, 4}, 4, 0, 0b110}));
    EXPECT_EQ(mesh->polygon_count(), 1u);
}

TEST(Mesh, AConcaveQuadIsSplitAtItsReflexCorner) {
    const MeshRef mesh = make_mesh(
        {.primitive = Primitive::Quads, .positions = {{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}});
    for (const Triangle& t : mesh->triangles())
        EXPECT_TRUE(t.vertex[0] == 2 || t.vertex[1] == 2 || t.vertex[2] == 2);
    const MeshRef other = make_mesh(
        {.primitive = Primitive::Quads, .positions = {{0, 4, 0}, {0, 0, 0}, {4, 0, 0}, {1, 1, 0}}});
    for (const Triangle& t : other->triangles())
        EXPECT_TRUE(t.vertex[0] == 3 || t.vertex[1] == 3 || t.vertex[2] == 3);
}

TEST(Mesh, APolygonHasTheColourOfItsFirstVertex) {
    MeshData data{
        .primitive = Primitive::Polygons,
        .positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 5}, {2, 0, 5}, {2, 2, 5}, {0, 2, 5}}};
    data.polygon_sizes = {3, 4};
    const MeshRef mesh = make_mesh(data);
    ASSERT_EQ(mesh->triangles().size(), 3u);
    EXPECT_EQ(mesh->triangles()[0], (Triangle{Vertices{0, 1, 2}, 0, 0, 7}));
    EXPECT_EQ(mesh->triangles()[1], (Triangle{Vertices{3, 4, 5}, 3, 1, 0b011}));
    EXPECT_EQ(mesh->triangles()[2], (Triangle{Vertices{3, 5, 6}, 3, 1, 0b110}));
}

// [R5.3]
TEST(Mesh, WithoutSizesAllVerticesAreOnePolygon) {
    const MeshRef mesh =
        make_mesh({.primitive = Primitive::Polygons,
                   .positions = {{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {2, 2, 0}, {0, 2, 0}}});
    EXPECT_EQ(mesh->triangles().size(), 3u);
    EXPECT_EQ(mesh->polygon_count(), 1u);
}

TEST(Mesh, LinesAndStripsOfLines) {
    const MeshRef separate = make_mesh(points(4, Primitive::Lines));
    EXPECT_EQ(separate->kind(), MeshKind::Lines);
    EXPECT_EQ(separate->lines().size(), 2u);
    EXPECT_EQ(separate->lines()[1], (std::array<std::uint32_t, 2>{2, 3}));
    const MeshRef strip = make_mesh(points(4, Primitive::LineStrip));
    EXPECT_EQ(strip->lines().size(), 3u);
    EXPECT_EQ(strip->lines()[1], (std::array<std::uint32_t, 2>{1, 2}));
    EXPECT_EQ(strip->polygon_count(), 3u);
}

TEST(Mesh, Points) {
    MeshData data = points(3, Primitive::Points);
    data.indices = {2, 2};
    const MeshRef mesh = make_mesh(data);
    EXPECT_EQ(mesh->kind(), MeshKind::Points);
    EXPECT_EQ(std::vector<std::uint32_t>(mesh->points().begin(), mesh->points().end()),
              (std::vector<std::uint32_t>{2, 2}));
}

// [R5.3] [R6.5]
TEST(Mesh, PolygonIdsAreTheGivenOnesOrTheOrdinals) {
    MeshData data = points(6, Primitive::Triangles);
    EXPECT_EQ(make_mesh(data)->polygon_id(1), 1u);
    data.polygon_ids = {70, 90};
    EXPECT_EQ(make_mesh(data)->polygon_id(1), 90u);
}

TEST(Mesh, NothingDrawsNothing) {
    EXPECT_EQ(make_mesh({})->polygon_count(), 0u);
    EXPECT_EQ(make_mesh({.primitive = Primitive::Polygons})->polygon_count(), 0u);
}

TEST(Mesh, AFlatTriangleIsKept) {
    EXPECT_EQ(make_mesh({.positions = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}})->triangles().size(), 1u);
}

// [R5.8] [R6.1]
TEST(Mesh, ErrorsSayWhatWasExpected) {
    EXPECT_EQ(error_of(points(7, Primitive::Triangles)),
              "mesh: 7 indices do not fit Triangles: a multiple of 3");
    EXPECT_EQ(error_of(points(6, Primitive::Quads)),
              "mesh: 6 indices do not fit Quads: a multiple of 4");
    EXPECT_EQ(error_of(points(2, Primitive::TriangleStrip)),
              "mesh: 2 indices do not fit TriangleStrip: 3 or more");
    EXPECT_EQ(error_of(points(1, Primitive::LineStrip)),
              "mesh: 1 index do not fit LineStrip: 2 or more");
    EXPECT_EQ(error_of(points(3, Primitive::Lines)),
              "mesh: 3 indices do not fit Lines: a multiple of 2");

    MeshData data = points(3, Primitive::Triangles);
    data.indices = {0, 1, 3};
    EXPECT_EQ(error_of(data), "mesh: index 2 is 3; there are 3 positions");
    data = points(3, Primitive::Triangles);
    data.normals.resize(2);
    EXPECT_EQ(error_of(data), "mesh: 2 normals for 3 positions; expected as many, or none");
    data = points(3, Primitive::Triangles);
    data.polygon_ids = {1, 2};
    EXPECT_EQ(error_of(data), "mesh: 2 polygon ids for 1 polygon; expected as many, or none");
    data = points(6, Primitive::Polygons);
    data.polygon_sizes = {4, 2};
    EXPECT_EQ(error_of(data), "mesh: polygon 1 has 2 vertices; expected 3 or more");
    data.polygon_sizes = {3, 4};
    EXPECT_EQ(error_of(data), "mesh: the polygon sizes add up to 7; there are 6 indices");
    data.primitive = Primitive::Triangles;
    EXPECT_EQ(error_of(data), "mesh: polygon_sizes are for Polygons only");
}

// [R5.8]
TEST(Mesh, ValuesMustBeFinite) {
    MeshData data = points(3, Primitive::Triangles);
    data.positions[1].z = std::numeric_limits<float>::infinity();
    EXPECT_EQ(error_of(data), "mesh: position 1 has a component that is not a finite number");
    data = points(3, Primitive::Triangles);
    data.texcoords = {{0, 0}, {0, 0}, {std::numeric_limits<float>::quiet_NaN(), 0}};
    EXPECT_EQ(error_of(data), "mesh: texcoord 2 has a component that is not a finite number");
}

}  // namespace
}  // namespace gw
