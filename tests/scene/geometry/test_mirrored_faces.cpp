// Claims: the faces of a mirrored object show the eye the winding that they had; its picture is the
// mirror image of the plain one's under mirrored light.
#include "scene/geometry/mirrored_faces.h"

#include <gtest/gtest.h>

namespace gw::scene {
namespace {

using Indices = std::vector<std::uint32_t>;

MeshData data(Primitive primitive, std::size_t vertices) {
    MeshData data{.primitive = primitive};
    for (std::size_t i = 0; i < vertices; ++i)
        data.positions.emplace_back(float(i % 2), float(i / 2), 0);
    return data;
}

}  // namespace

TEST(MirroredFaces, EachFaceKeepsItsFirstCorner) {
    EXPECT_EQ(reversed(*make_mesh(data(Primitive::Triangles, 6))).indices,
              (Indices{0, 2, 1, 3, 5, 4}));
    EXPECT_EQ(reversed(*make_mesh(data(Primitive::Quads, 4))).indices, (Indices{0, 3, 2, 1}));
    MeshData polygons = data(Primitive::Polygons, 7);
    polygons.polygon_sizes = {3, 4};
    EXPECT_EQ(reversed(*make_mesh(polygons)).indices, (Indices{0, 2, 1, 3, 6, 5, 4}));
}

TEST(MirroredFaces, StripsAndFansBecomeTriangles) {
    for (const Primitive primitive : {Primitive::TriangleStrip, Primitive::TriangleFan}) {
        const MeshRef mesh = make_mesh(data(primitive, 5)), turned = make_mesh(reversed(*mesh));
        ASSERT_EQ(turned->triangles().size(), 3u);
        for (std::size_t i = 0; i < 3; ++i) {
            const auto &a = mesh->triangles()[i].vertex, &b = turned->triangles()[i].vertex;
            EXPECT_EQ(b, (std::array{a[0], a[2], a[1]}));
        }
    }
}

TEST(MirroredFaces, LinesStay) {
    EXPECT_EQ(reversed(*make_mesh(data(Primitive::Lines, 4))), data(Primitive::Lines, 4));
}

TEST(MirroredFaces, OnlyMirroredObjectsAreReversedAndShareTheirMesh) {
    Scene scene;
    const MeshRef mesh = make_mesh(data(Primitive::Triangles, 3));
    for (const double x : {1.0, -1.0, -2.0}) {
        scene.objects.push_back({.mesh = mesh});
        scene.objects.back().world_from_object[0].x = x;
    }
    reverse_mirrored(scene);
    EXPECT_EQ(scene.objects[0].mesh, mesh);
    EXPECT_EQ(scene.objects[1].mesh->data().indices, (Indices{0, 2, 1}));
    EXPECT_EQ(scene.objects[2].mesh, scene.objects[1].mesh);
}

}  // namespace gw::scene
