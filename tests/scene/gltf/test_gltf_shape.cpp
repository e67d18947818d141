// Claims: morph targets and skins move vertices as their formulas say, at rest and in films; vertex
// colours are drawn as the file has them; textures are turned.
#include "scene/draw/shading.h"
#include "tests/scene/folder.h"
#include "tests/scene/gltf/gltf_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gw::scene {
namespace {

/// A file of accessors, each with a buffer view of its own.
class Accessors {
public:
    template <class Number>
    int add(const std::vector<Number>& numbers, int component, const std::string& type) {
        const std::size_t components = type == "SCALAR" ? 1
                                       : type == "MAT4" ? 16
                                                        : std::size_t(type.back() - '0');
        const std::string more = bytes_of(numbers);
        views_ += (count_ ? ", " : "") +
                  ("{\"buffer\": 0, \"byteOffset\": " + std::to_string(bytes_.size())) +
                  ", \"byteLength\": " + std::to_string(more.size()) + "}";
        accessors_ += (count_ ? ", " : "") + ("{\"bufferView\": " + std::to_string(count_)) +
                      ", \"componentType\": " + std::to_string(component) +
                      ", \"count\": " + std::to_string(numbers.size() / components) +
                      ", \"type\": \"" + type + "\"}";
        bytes_ += more + std::string((4 - more.size() % 4) % 4, '\0');
        return count_++;
    }
    int vec3s(const std::vector<float>& numbers) { return add(numbers, 5126, "VEC3"); }

    std::string file(const std::string& rest) const {
        return R"({"asset": {"version": "2.0"}, "bufferViews": [)" + views_ +
               "], \"accessors\": [" + accessors_ + R"(], "buffers": [{"byteLength": )" +
               std::to_string(bytes_.size()) + ", \"uri\": \"" + data_uri(bytes_) + "\"}], " +
               rest + "}";
    }

private:
    std::string bytes_, views_, accessors_;
    int count_ = 0;
};

struct GltfShape : testing::Test {
    SceneFile read(const std::string& text) { return read_scene(folder.write("m.gltf", text)); }
    std::string error(const std::string& text) { return folder.scene_error("m.gltf", text); }
    Folder folder;
};

const std::vector<float> corners{0, 0, 0, 2, 0, 0, 0, 3, 0};

/// In the world.
dvec3 vertex(const Object& object, std::size_t i) {
    return dvec3(object.world_from_object * dvec4(dvec3(object.mesh->data().positions.at(i)), 1));
}

void expect_near(const dvec3& v, double x, double y, double z) {
    EXPECT_NEAR(v.x, x, 1e-6);
    EXPECT_NEAR(v.y, y, 1e-6);
    EXPECT_NEAR(v.z, z, 1e-6);
}

/// Two targets: one lifts vertex 1 by 4, one moves vertex 2 by 1 in x.
std::string morphed(const std::string& mesh, const std::string& node,
                    const std::string& animations = {}, Accessors a = {}) {
    const int p = a.vec3s(corners), lift = a.vec3s({0, 0, 0, 0, 0, 4, 0, 0, 0}),
              side = a.vec3s({0, 0, 0, 0, 0, 0, 1, 0, 0});
    return a.file(animations + R"("nodes": [{"mesh": 0)" + node +
                  R"(}], "meshes": [{"primitives": [{"attributes": {"POSITION": )" +
                  std::to_string(p) + R"(}, "targets": [{"POSITION": )" + std::to_string(lift) +
                  R"(}, {"POSITION": )" + std::to_string(side) + "}]}]" + mesh + "}]");
}

/// Vertex 0 belongs to joint 0, vertex 1 to joint 1, vertex 2 to both by 1 : 3. Joint 1 is a child of
/// joint 0, 1 above it at rest. The node of the mesh lies elsewhere, which must not matter.
std::string skinned(const std::string& joint, Accessors a = {}, const std::string& more = {}) {
    const std::string p = std::to_string(a.vec3s(corners)),
                      n = std::to_string(a.vec3s({0, 0, 1, 0, 0, 1, 0, 0, 1})),
                      j = std::to_string(
                          a.add<std::uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, 5121, "VEC4")),
                      w = std::to_string(
                          a.add<float>({1, 0, 0, 0, 0.5f, 0, 0, 0, 1, 3, 0, 0}, 5126, "VEC4"));
    std::vector<float> bind(32);
    for (std::size_t i = 0; i < 32; i += i % 16 == 15 ? 1 : 5) bind[i] = 1;
    bind[16 + 13] = -1;
    const std::string m = std::to_string(a.add(bind, 5126, "MAT4"));
    return a.file(more + R"("nodes": [{"mesh": 0, "skin": 0, "translation": [50, 0, 0]},
{"translation": [10, 0, 0], "children": [2]}, {"translation": [0, 1, 0])" +
                  joint + R"(}], "skins": [{"joints": [1, 2], "inverseBindMatrices": )" + m +
                  R"(}], "meshes": [{"primitives": [{"attributes": {"POSITION": )" + p +
                  R"(, "NORMAL": )" + n + R"(, "JOINTS_0": )" + j + R"(, "WEIGHTS_0": )" + w +
                  "}}]}]");
}

/// A quarter turn about z: x, y, z, w.
const std::string quarter = R"(, "rotation": [0, 0, 0.70710678118654752, 0.70710678118654752])";

}  // namespace

TEST_F(GltfShape, NormalsOfLengthZeroAreTheFaces) {
    const auto file = [&](const std::vector<float>& normals) {
        Accessors a;
        const std::string p = std::to_string(a.vec3s(corners)),
                          n = std::to_string(a.vec3s(normals));
        return read(a.file(R"("nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {)"
                           R"("POSITION": )" +
                           p + R"(, "NORMAL": )" + n + "}}]}]"));
    };
    const SceneFile none = file(std::vector<float>(9));
    expect_near(dvec3(none.scene.objects.at(0).mesh->data().normals.at(0)), 0, 0, 1);
    ASSERT_EQ(none.warnings.size(), 1u);
    EXPECT_NE(
        none.warnings[0].find("3 of its normals have length 0: the faces' own normals stand in"),
        std::string::npos)
        << none.warnings[0];
    const SceneFile one = file({1, 0, 0, 0, 0, 0, 1, 0, 0});
    expect_near(dvec3(one.scene.objects.at(0).mesh->data().normals.at(0)), 1, 0, 0);
    ASSERT_EQ(one.warnings.size(), 1u);
}

TEST_F(GltfShape, MorphTargetsAddByTheirWeights) {
    const Object o = read(morphed(R"(, "weights": [0.5, 2])", "")).scene.objects.at(0);
    expect_near(vertex(o, 0), 0, 0, 0);
    expect_near(vertex(o, 1), 2, 0, 2);
    expect_near(vertex(o, 2), 2, 3, 0);
    // the face is flat: its normal is that of the moved triangle, (2, 0, 2) x (2, 3, 0)
    const double size = std::sqrt(36.0 + 16 + 36);
    expect_near(dvec3(o.mesh->data().normals.at(0)), -6 / size, 4 / size, 6 / size);
    // the node's weights come before the mesh's
    expect_near(
        vertex(
            read(morphed(R"(, "weights": [0.5, 2])", R"(, "weights": [0.25])")).scene.objects.at(0),
            1),
        2, 0, 1);
    expect_near(vertex(read(morphed("", "")).scene.objects.at(0), 1), 2, 0, 0);
}

TEST_F(GltfShape, WeightsOfMorphTargetsAreAFilm) {
    const auto lifted = [&](const std::string& interpolation, const std::vector<float>& values,
                            double time) {
        Accessors a;
        const int times = a.add<float>({0, 2}, 5126, "SCALAR"),
                  weights = a.add(values, 5126, "SCALAR");
        SceneFile file = read(morphed(
            "", "",
            R"("animations": [{"channels": [{"sampler": 0, "target": {"node": 0, "path": "weights"}}],
"samplers": [{"input": )" +
                std::to_string(times) + ", \"output\": " + std::to_string(weights) +
                R"(, "interpolation": ")" + interpolation + "\"}]}], ",
            a));
        const std::vector<std::uint32_t> ids = file.scene.objects.at(0).mesh->data().polygon_ids;
        file.films.at(0).pose(file.scene, time);
        EXPECT_EQ(file.scene.objects.at(0).mesh->data().polygon_ids, ids);
        return file.scene.objects.at(0);
    };
    const Object half = lifted("LINEAR", {0, 0, 1, 8}, 0.5);
    expect_near(vertex(half, 1), 2, 0, 1);
    expect_near(vertex(half, 2), 2, 3, 0);
    expect_near(vertex(lifted("STEP", {0, 0, 1, 8}, 2), 2), 8, 3, 0);
    // in-slopes, values, out-slopes: t^2 / 4 of the first target, 0 of the second
    expect_near(vertex(lifted("CUBICSPLINE", {0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0}, 1), 1), 2, 0, 1);
}

TEST_F(GltfShape, SkinsFollowTheirJoints) {
    const Object rest = read(skinned("")).scene.objects.at(0);
    for (std::size_t i = 0; i < 3; ++i)
        expect_near(vertex(rest, i), 10 + double(corners[3 * i]), double(corners[3 * i + 1]), 0);
    const Object o = read(skinned(quarter)).scene.objects.at(0);
    expect_near(vertex(o, 0), 10, 0, 0);
    // about (10, 1): (2, -1) becomes (1, 2)
    expect_near(vertex(o, 1), 11, 3, 0);
    // (0, 3) by joint 0, (0, 2) about (10, 1), which becomes (-2, 0), by joint 1
    expect_near(vertex(o, 2), 10 - 0.75 * 2, 0.25 * 3 + 0.75 * 1, 0);
    expect_near(dvec3(o.mesh->data().normals.at(1)), 0, 0, 1);
}

TEST_F(GltfShape, JointsMoveInFilms) {
    Accessors a;
    const int times = a.add<float>({0, 1}, 5126, "SCALAR");
    const int turns = a.add<float>({0, 0, 0, 1, 0, 0, 0.70710678f, 0.70710678f}, 5126, "VEC4");
    SceneFile file = read(skinned(
        "", a,
        R"("animations": [{"channels": [{"sampler": 0, "target": {"node": 2, "path": "rotation"}}],
"samplers": [{"input": )" +
            std::to_string(times) + ", \"output\": " + std::to_string(turns) + "}]}], "));
    expect_near(vertex(file.scene.objects.at(0), 1), 12, 0, 0);
    file.films.at(0).pose(file.scene, 1);
    expect_near(vertex(file.scene.objects.at(0), 1), 11, 3, 0);
    file.films.at(0).pose(file.scene, 0);
    expect_near(vertex(file.scene.objects.at(0), 1), 12, 0, 0);
}

TEST_F(GltfShape, BadSkinsAreOneErrorEach) {
    const std::string good = skinned("");
    EXPECT_EQ(error(replaced(good, "\"joints\": [1, 2]", "\"joints\": [1]")),
              "m.gltf: nodes[0].skin has 1 joints; expected at least 2, which the mesh names");
    EXPECT_EQ(
        error(replaced(good, "\"joints\": [1, 2]", "\"joints\": [1, 2, 1]")),
        "m.gltf: skins[0].inverseBindMatrices has 2 elements; expected 3, one for each joint");
    EXPECT_EQ(error(replaced(good, "\"joints\": [1, 2]", "\"joints\": [1, 3]")),
              "m.gltf: skins[0].joints[1] is 3; expected a whole number from 0 to 2");
    EXPECT_EQ(error(replaced(good, "\"nodes\": [{\"mesh\"",
                             "\"scenes\": [{\"nodes\": [0]}], \"nodes\": [{\"mesh\"")),
              "m.gltf: skins[0].joints[0] is not in the scene; expected a node of it");
    EXPECT_EQ(error(replaced(good, "[0, 1, 0]", "[0, -1e18, 0], \"scale\": [1, 1e17, 1]")),
              "m.gltf: nodes[0] has a vertex beyond 1e18, its skin included; expected less");
}

TEST_F(GltfShape, InstancesOfOneNodeMoveWithIt) {
    Accessors a;
    const std::string p = std::to_string(a.vec3s(corners)),
                      t = std::to_string(a.vec3s({1, 0, 0, 0, 7, 0})),
                      r = std::to_string(
                          a.add<float>({0, 0, 0, 1, 0, 0, 0.70710678f, 0.70710678f}, 5126, "VEC4")),
                      s = std::to_string(a.vec3s({2, 2, 2, 1, 1, 1})),
                      times = std::to_string(a.add<float>({0, 1}, 5126, "SCALAR")),
                      way = std::to_string(a.vec3s({0, 0, 5, 0, 0, 9}));
    const std::string text = a.file(
        R"("extensionsRequired": ["EXT_mesh_gpu_instancing"], "extensionsUsed": ["EXT_mesh_gpu_instancing"],
"animations": [{"channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}],
"samplers": [{"input": )" +
        times + ", \"output\": " + way +
        R"(}]}], "nodes": [{"mesh": 0, "translation": [0, 0, 5], "extensions": {"EXT_mesh_gpu_instancing": {"attributes":
{"TRANSLATION": )" +
        t + ", \"ROTATION\": " + r + ", \"SCALE\": " + s +
        R"(}}}}], "meshes": [{"primitives": [{"attributes": {"POSITION": )" + p + "}}]}]");
    SceneFile file = read(text);
    ASSERT_EQ(file.scene.objects.size(), 2u);
    EXPECT_EQ(file.scene.objects[0].mesh, file.scene.objects[1].mesh);
    expect_near(vertex(file.scene.objects[0], 1), 5, 0, 5);
    expect_near(vertex(file.scene.objects[1], 1), 0, 9, 5);
    file.films.at(0).pose(file.scene, 1);
    expect_near(vertex(file.scene.objects[0], 1), 5, 0, 9);
    expect_near(vertex(file.scene.objects[1], 1), 0, 9, 9);
    EXPECT_EQ(
        error(replaced(text, "\"SCALE\": " + s, "\"SCALE\": " + p)),
        "m.gltf: nodes[0].extensions.EXT_mesh_gpu_instancing.attributes.SCALE has 3 elements; "
        "expected 2, as the others have");
}

TEST_F(GltfShape, VertexColoursAreInterpolatedAsLight) {
    Accessors a;
    const std::string p = std::to_string(a.vec3s({0, 0, 0, 2, 0, 0, 0, 3, 0, 2, 3, 0})),
                      c = std::to_string(a.vec3s({1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2f, 0.6f, 0.4f})),
                      i = std::to_string(a.add<std::uint16_t>({0, 1, 2, 2, 1, 3}, 5123, "SCALAR"));
    const SceneFile file =
        read(a.file(R"("nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"indices": )" + i +
                    R"(, "attributes": {"POSITION": )" + p + R"(, "COLOR_0": )" + c + "}}]}]"));
    EXPECT_TRUE(file.warnings.empty());
    const Object& o = file.scene.objects.at(0);
    const Map& map = file.scene.materials.at(o.material).map_Kd.at(0);
    const std::vector<vec2>& st = o.mesh->data().texcoords;
    const std::vector<dvec3> light{{1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                                   {0, 0, 1}, {0, 1, 0}, {0.2, 0.6, 0.4}};
    ASSERT_EQ(st.size(), light.size());
    const auto encode = [](double v) {
        return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
    };
    const auto check = [&](std::size_t first, double u, double v, double tolerance) {
        const auto mean = [&](const auto& list) {
            return (1 - u - v) * list(first) + u * list(first + 1) + v * list(first + 2);
        };
        const dvec3 expected = mean([&](std::size_t k) { return light[k]; });
        const dvec3 shown =
            sample(map, mean([&](std::size_t k) { return dvec2(st[k]); }), dvec2(0), dvec2(0));
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(shown[k], encode(expected[k]), tolerance) << first << " " << u << " " << v;
    };
    for (const std::size_t first : {0u, 3u}) {
        check(first, 0, 0, 1e-4);
        check(first, 1, 0, 1e-4);
        check(first, 0, 1, 1e-4);
        check(first, 3.0 / 7, 2.0 / 7, 1e-4);  // a texel
        check(first, 0.5, 0.25, 0.02);         // between texels, where sRGB bends
        check(first, 0.5, 0.5, 0.11);          // the third side: a texel beyond it would be below 0
    }
}

TEST_F(GltfShape, AMaterialWithATextureHasTheMeanOfVertexColours) {
    Accessors a;
    const std::string p = std::to_string(a.vec3s(corners)),
                      c = std::to_string(a.vec3s({1, 0, 0, 0, 1, 0, 0, 0, 1})),
                      st = std::to_string(a.add<float>({0, 0, 1, 0, 0, 1}, 5126, "VEC2"));
    const SceneFile file = read(a.file(
        R"("nodes": [{"mesh": 0, "name": "n"}], "images": [{"uri": "data:image/png;base64,QUJD"}],
"textures": [{"source": 0}], "materials": [{"pbrMetallicRoughness": {"metallicFactor": 0, "baseColorTexture": {"index": 0}}}],
"meshes": [{"primitives": [{"material": 0, "attributes": {"POSITION": )" +
        p + R"(, "COLOR_0": )" + c + R"(, "TEXCOORD_0": )" + st + "}}]}]"));
    ASSERT_EQ(file.warnings.size(), 1u);
    EXPECT_EQ(
        folder.relative(file.warnings[0]),
        "m.gltf: object 'n': its vertex colours beside a texture are drawn as means of triangles, in at most 64 colours");
    const Material& m = file.scene.materials.at(file.scene.objects.at(0).material);
    EXPECT_NEAR(double(m.Kd.x), 1.055 * std::pow(1.0 / 3, 1 / 2.4) - 0.055, 1e-6);
}

TEST_F(GltfShape, TexturedTrianglesOfOneColourKeepIt) {
    Accessors a;
    const std::string p = std::to_string(
                          a.vec3s({0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 1, 2, 0, 1, 0, 3, 1})),
                      c = std::to_string(
                          a.vec3s({1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0})),
                      st = std::to_string(
                          a.add<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, 5126, "VEC2"));
    const SceneFile file = read(a.file(
        R"("nodes": [{"mesh": 0, "name": "n"}], "images": [{"uri": "data:image/png;base64,QUJD"}],
"textures": [{"source": 0}], "materials": [{"pbrMetallicRoughness": {"metallicFactor": 0, "baseColorTexture": {"index": 0}}}],
"meshes": [{"primitives": [{"material": 0, "attributes": {"POSITION": )" +
        p + R"(, "COLOR_0": )" + c + R"(, "TEXCOORD_0": )" + st + "}}]}]"));
    EXPECT_TRUE(file.warnings.empty());
    ASSERT_EQ(file.scene.objects.size(), 2u);
    for (const Object& o : file.scene.objects) {
        const Material& m = file.scene.materials.at(o.material);
        const bool is_red = vertex(o, 0).z == 0;
        EXPECT_EQ(m.Kd, is_red ? vec3(1, 0, 0) : vec3(0, 1, 0));
        EXPECT_EQ(m.map_Kd.size(), 1u);
        EXPECT_EQ(o.mesh->triangles().size(), 1u);
    }
}

/// 90 triangles from black to red: too many colours for exact ones, and each is drawn near its own.
TEST_F(GltfShape, TexturedTrianglesOfManyColoursHaveNearOnes) {
    Accessors a;
    constexpr int n = 90;
    std::vector<float> p, c, st;
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < 3; ++k) {
            p.insert(p.end(), {float(k == 1), float(k == 2), float(i)});
            c.insert(c.end(), {float(i) / (n - 1), 0, 0});
            st.insert(st.end(), {float(k == 1), float(i)});
        }
    const std::string positions = std::to_string(a.vec3s(p)), colors = std::to_string(a.vec3s(c)),
                      texcoords = std::to_string(a.add<float>(st, 5126, "VEC2"));
    const SceneFile file = read(a.file(
        R"("nodes": [{"mesh": 0}], "images": [{"uri": "data:image/png;base64,QUJD"}],
"textures": [{"source": 0}], "materials": [{"pbrMetallicRoughness": {"metallicFactor": 0, "baseColorTexture": {"index": 0}}}],
"meshes": [{"primitives": [{"material": 0, "attributes": {"POSITION": )" +
        positions + R"(, "COLOR_0": )" + colors + R"(, "TEXCOORD_0": )" + texcoords + "}}]}]"));
    EXPECT_TRUE(file.warnings.empty());
    EXPECT_LE(file.scene.objects.size(), 64u);
    std::vector<bool> found(n);
    for (const Object& o : file.scene.objects) {
        const double Kd = double(file.scene.materials.at(o.material).Kd.x);
        const double light = Kd <= 0.04045 ? Kd / 12.92 : std::pow((Kd + 0.055) / 1.055, 2.4);
        const MeshData& mesh = o.mesh->data();
        for (std::size_t corner = 0; corner < mesh.positions.size(); ++corner) {
            const double i = double(mesh.positions[corner].z);
            found.at(std::size_t(i)) = true;
            EXPECT_NEAR(light, i / (n - 1), 1.0 / 63);
            EXPECT_EQ(mesh.texcoords[corner].y, float(1 - i));
        }
    }
    EXPECT_EQ(std::ranges::count(found, true), n);
}

// The extension's own example: the lower left quarter of the picture, turned clockwise by 90 degrees.
TEST_F(GltfShape, TexturesAreTurned) {
    Accessors a;
    const std::string p = std::to_string(a.vec3s(corners)),
                      st = std::to_string(a.add<float>({0, 0, 1, 0, 0, 1}, 5126, "VEC2"));
    const SceneFile file = read(a.file(
        R"("nodes": [{"mesh": 0}], "images": [{"uri": "data:image/png;base64,QUJD"}],
"textures": [{"source": 0}], "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0,
"extensions": {"KHR_texture_transform": {"offset": [0, 1], "rotation": 1.5707963267948966, "scale": [0.5, 0.5]}}}}}],
"meshes": [{"primitives": [{"material": 0, "attributes": {"POSITION": )" +
        p + R"(, "TEXCOORD_0": )" + st + "}}]}]"));
    EXPECT_TRUE(file.warnings.empty());
    const Object& o = file.scene.objects.at(0);
    const Map& map = file.scene.materials.at(o.material).map_Kd.at(0);
    EXPECT_EQ(map.scale, vec2(1));
    EXPECT_EQ(map.offset, vec2(0));
    // u, v of glTF, v downwards: (0, 0) -> (0, 1), (1, 0) -> (0, 0.5), (0, 1) -> (0.5, 1)
    const std::vector<dvec2> expected{{0, 0}, {0, 0.5}, {0.5, 0}};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(double(o.mesh->data().texcoords.at(i).x), expected[i].x, 1e-6) << i;
        EXPECT_NEAR(double(o.mesh->data().texcoords.at(i).y), expected[i].y, 1e-6) << i;
    }
}

}  // namespace gw::scene
