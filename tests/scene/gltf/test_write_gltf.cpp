// Claims of the glTF writer: the reader of glTF reads back each triangle, its second texture
// coordinates, the picture's name, the camera.
#include "scene/gltf/read_gltf.h"
#include "scene/gltf/write_gltf.h"
#include "tests/scene/folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace gw::scene {
namespace {

WrittenScene triangles() {
    WrittenScene scene;
    scene.pictures = {{"a.png", "a.exr", 2}, {"b.png", "b.exr", 2}};
    scene.meshes = {{"floor",
                     0,
                     std::nullopt,
                     {{0, 0, 0}, {1, 0, 0}, {0, 0.1f, 2}},
                     {{0, 0}, {1, 0}, {0, 1}},
                     {{0.25f, 0.5f}, {0.75f, 0.5f}, {0.25f, 1}}},
                    {"wall",
                     1,
                     std::nullopt,
                     {{-1, 5, 0}, {1, 0, 0}, {0, 1, 1e-3f}},
                     {{0, 0}, {0, 0}, {0, 0}},
                     {{0, 0}, {1, 0}, {1, 1}}}};
    scene.camera =
        Camera{.eye = {1, 2, 3}, .at = {1, 0, -4}, .fov = 35, .near_plane = 0.5, .far_plane = 60};
    scene.aspect = 1.5;
    return scene;
}

Scene read_back(const WrittenScene& written, std::vector<std::string>& lines) {
    Folder folder;
    const GltfText text = write_gltf(written, "s.bin");
    folder.write("s.bin", text.bytes);
    Scene scene = read_gltf(folder.write("s.gltf", text.json), folder.warnings_list()).scene;
    lines = folder.warnings();
    return scene;
}

}  // namespace

TEST(WriteGltf, TheReaderFindsTrianglesPicturesAndCamera) {
    const WrittenScene written = triangles();
    std::vector<std::string> lines;
    const Scene scene = read_back(written, lines);
    EXPECT_EQ(lines, std::vector<std::string>{});
    ASSERT_EQ(scene.objects.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        const MeshData& mesh = scene.objects[i].mesh->data();
        EXPECT_EQ(scene.objects[i].name, written.meshes[i].name);
        EXPECT_EQ(mesh.positions, written.meshes[i].positions);
        EXPECT_EQ(mesh.texcoords, written.meshes[i].texcoord_1);
        const Material& material = scene.materials[scene.objects[i].material];
        ASSERT_EQ(material.map_Ke.size(), 1u);
        EXPECT_EQ(std::filesystem::path(material.map_Ke[0].file).filename(),
                  written.pictures[i].file);
        EXPECT_EQ(material.map_Ke[0].wrap_t, Wrap::Clamp);
        EXPECT_EQ(material.Ke, vec3(1));
        EXPECT_EQ(material.Kd, vec3(0));
    }
    ASSERT_TRUE(scene.camera);
    EXPECT_EQ(scene.camera->eye, dvec3(1, 2, 3));
    EXPECT_NEAR(scene.camera->fov, 35, 1e-12);
    EXPECT_EQ(scene.camera->near_plane, 0.5);
    EXPECT_EQ(scene.camera->far_plane, 60);
    const dvec3 way = scene.camera->at - scene.camera->eye;
    EXPECT_NEAR(way.y / way.z, -2.0 / -7, 1e-12);
}

/// Programs find it as any texture; viewers show the picture alone.
TEST(WriteGltf, ExtrasNameTheTextureBeside) {
    WrittenScene written = triangles();
    written.textures = {{"wood.png", Wrap::Clamp, Wrap::Repeat, dvec3(0.5, 0.25, 1)}};
    written.meshes[1].texture = 0;
    written.meshes.push_back(written.meshes[1]);
    const auto json = nlohmann::json::parse(write_gltf(written, "s.bin").json);
    ASSERT_EQ(json["materials"].size(), 2u);
    EXPECT_FALSE(json["materials"][0]["extras"].contains("own"));
    EXPECT_EQ(json["materials"][1]["extras"]["own"],
              nlohmann::json::parse(R"({"index": 2, "texCoord": 0, "mean": [0.5, 0.25, 1.0]})"));
    const auto& own = json["textures"][2];
    EXPECT_EQ(json["images"][own["source"].get<std::size_t>()]["uri"], "wood.png");
    const auto& sampler = json["samplers"][own["sampler"].get<std::size_t>()];
    EXPECT_EQ(sampler["wrapS"], 33071);
    EXPECT_EQ(sampler["wrapT"], 10497);
    for (const int mesh : {1, 2}) EXPECT_EQ(json["meshes"][mesh]["primitives"][0]["material"], 1);
    std::vector<std::string> lines;
    EXPECT_EQ(read_back(written, lines).materials.at(1).map_Ke.size(), 1u);
}

TEST(WriteGltf, TheReaderFindsAParallelCamera) {
    WrittenScene written = triangles();
    written.camera->ortho_height = 7;
    std::vector<std::string> lines;
    const Scene scene = read_back(written, lines);
    EXPECT_EQ(scene.camera->ortho_height, 7);
}

}  // namespace gw::scene
