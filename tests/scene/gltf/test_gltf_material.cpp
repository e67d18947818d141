// Claims: alpha modes, vertex alphas, sides, sets of texture coordinates, mirrored and metallic-roughness
// maps of glTF reach the scene, where maps/finish.h finds them.
#include "scene/maps/patches.h"
#include "scene/maps/physical.h"
#include "tests/scene/folder.h"
#include "tests/scene/gltf/gltf_text.h"

#include <gtest/gtest.h>

namespace gw::scene {
namespace {

struct GltfSurface : testing::Test {
    Folder folder;

    /// The triangle with two sets of texture coordinates, one texture, and a material of this JSON.
    Scene scene(const std::string& material, const std::string& sampler = "{}") {
        const std::string bytes =
            triangle_bytes() + std::string(2, '\0') + bytes_of<float>({0, 0, 1, 0, 0, 1}) +
            bytes_of<std::uint8_t>({255, 255, 255, 0, 255, 255, 255, 128, 255, 255, 255, 255}) +
            bytes_of<float>({0.5f, 0, 0.75f, 0, 0.5f, 1});
        std::string text = replaced(triangle_json(R"(, "uri": ")" + data_uri(bytes) + "\""),
                                    R"("byteLength": 42)", R"("byteLength": 104)");
        text = replaced(text, R"("byteLength": 6})",
                        R"("byteLength": 6}, {"buffer": 0, "byteOffset": 44, "byteLength": 24},
                        {"buffer": 0, "byteOffset": 68, "byteLength": 12},
                        {"buffer": 0, "byteOffset": 80, "byteLength": 24})");
        text = replaced(text, R"("type": "SCALAR"})", R"("type": "SCALAR"},
            {"bufferView": 2, "componentType": 5126, "count": 3, "type": "VEC2"},
            {"bufferView": 3, "componentType": 5121, "count": 3, "type": "VEC4", "normalized": true},
            {"bufferView": 4, "componentType": 5126, "count": 3, "type": "VEC2"})");
        text = replaced(text, R"("POSITION": 0)",
                        R"("POSITION": 0, "TEXCOORD_0": 2, "COLOR_0": 3, "TEXCOORD_1": 4)");
        text = replaced(text, R"("indices": 1)", R"("indices": 1, "material": 0)");
        text = replaced(text, R"("meshes")",
                        R"("textures": [{"source": 0, "sampler": 0}], "samplers": [)" + sampler +
                            R"(], "images": [{"uri": "leaf.png"}], "materials": [)" + material +
                            R"(], "meshes")");
        SceneFile file = read_scene(folder.write("m.gltf", text));
        warnings.clear();
        for (const std::string& line : file.warnings) warnings.push_back(folder.relative(line));
        return file.scene;
    }
    const Material& material_of(const Scene& s) { return s.materials.at(s.objects.at(0).material); }
    std::vector<std::string> warnings;
};

const std::string leaf =
    R"("pbrMetallicRoughness": {"metallicFactor": 0, "baseColorFactor": [1, 1, 1, 0.5], "baseColorTexture": {"index": 0}})";

using Texcoords = std::vector<vec2>;

std::vector<float> alphas(const Scene& s) {
    std::vector<float> list;
    for (const vec4& color : s.objects.at(0).mesh->data().colors) list.push_back(color.w);
    return list;
}

}  // namespace

TEST_F(GltfSurface, BlendKeepsTheAlphaOfFactorTextureAndVertices) {
    const Scene s = scene("{" + leaf + R"(, "alphaMode": "BLEND"})");
    EXPECT_EQ(material_of(s).d, 0.5f);
    ASSERT_EQ(material_of(s).map_d.size(), 1u);
    EXPECT_EQ(material_of(s).map_d[0].file, folder.path() / "leaf.png");
    EXPECT_FALSE(material_of(s).d_cutoff);
    EXPECT_EQ(alphas(s), (std::vector<float>{0, 128.0f / 255, 1}));
    EXPECT_TRUE(warnings.empty());
}

TEST_F(GltfSurface, TheCutoffIsThatOfWhatVaries) {
    EXPECT_EQ(material_of(scene("{" + leaf + R"(, "alphaMode": "MASK", "alphaCutoff": 0.4})"))
                  .d_cutoff.value(),
              0.8f);
    EXPECT_EQ(material_of(scene("{" + leaf + R"(, "alphaMode": "MASK", "alphaCutoff": 0.4})")).d,
              1);
    EXPECT_EQ(material_of(scene("{" + leaf + R"(, "alphaMode": "MASK", "alphaCutoff": 0.6})")).d,
              0);
}

TEST_F(GltfSurface, AnOpaqueSurfaceHasNoAlpha) {
    const Scene s = scene("{" + leaf + "}");
    EXPECT_EQ(material_of(s).d, 1);
    EXPECT_TRUE(material_of(s).map_d.empty());
    EXPECT_TRUE(alphas(s).empty());
}

TEST_F(GltfSurface, SidesAreTheMaterials) {
    EXPECT_TRUE(scene("{}").objects.at(0).single_sided);
    EXPECT_FALSE(scene(R"({"doubleSided": true})").objects.at(0).single_sided);
    const auto file = folder.write("scene.toml", "[[object]]\nfile = \"m.gltf\"\n");
    EXPECT_FALSE(read_scene(file).scene.objects.at(0).single_sided);
    scene("{}");
    EXPECT_TRUE(read_scene(file).scene.objects.at(0).single_sided);
}

TEST_F(GltfSurface, MapsMayRepeatMirrored) {
    const Scene s = scene("{" + leaf + "}", R"({"wrapS": 33648, "wrapT": 10497})");
    EXPECT_EQ(material_of(s).map_Kd.at(0).wrap_s, Wrap::MirroredRepeat);
    EXPECT_EQ(material_of(s).map_Kd.at(0).wrap_t, Wrap::Repeat);
    EXPECT_TRUE(warnings.empty());
}

const Texcoords first_set{{0, 1}, {1, 1}, {0, 0}}, second_set{{0.5f, 1}, {0.75f, 1}, {0.5f, 0}};

TEST_F(GltfSurface, ATextureHasTheSetThatItNames) {
    const auto set_of = [&](const std::string& info) {
        const Scene s =
            scene(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0)" + info + "}}}");
        EXPECT_EQ(warnings, std::vector<std::string>{});
        EXPECT_FALSE(material_of(s).map_Kd.at(0).is_mean);
        return s.objects.at(0).mesh->data().texcoords;
    };
    const std::string transform = R"("extensions": {"KHR_texture_transform": {"texCoord": 1}})";
    EXPECT_EQ(set_of(""), first_set);
    EXPECT_EQ(set_of(R"(, "texCoord": 1)"), second_set);
    EXPECT_EQ(set_of(", " + transform), second_set);
    EXPECT_EQ(set_of(R"(, "texCoord": 5, )" + transform), second_set);
}

TEST_F(GltfSurface, TexturesOfTwoSetsGetPatchesOfTheirMesh) {
    const Scene s = scene(R"({"name": "lamp", "emissiveFactor": [1, 1, 1],
"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 1}},
"emissiveTexture": {"index": 0}})");
    EXPECT_EQ(warnings, std::vector<std::string>{});
    const Map &Kd = material_of(s).map_Kd.at(0), &Ke = material_of(s).map_Ke.at(0);
    ASSERT_TRUE(Kd.patched && Ke.patched);
    EXPECT_EQ(Kd.patched->st, second_set);
    EXPECT_EQ(Ke.patched->st, first_set);
    EXPECT_FALSE(Kd.is_mean || Ke.is_mean);
    const Patches& patches = Kd.patched->patches;
    EXPECT_EQ(s.objects.at(0).mesh->data().texcoords,
              (Texcoords{patches.st(0, 0), patches.st(0, 1), patches.st(0, 2)}));
}

TEST_F(GltfSurface, ATextureOfASetThatTheMeshLacksIsItsMeanWithAWarning) {
    const Scene s = scene(R"({"name": "lamp", "emissiveFactor": [1, 1, 1],
"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 1}},
"emissiveTexture": {"index": 0, "texCoord": 7}})");
    EXPECT_EQ(warnings, (std::vector<std::string>{
                            "m.gltf: object 'leaf': its textures with texCoord 7 are drawn with "
                            "their mean: it has not both sets, no triangles, or too many"}));
    EXPECT_EQ(s.objects.at(0).mesh->data().texcoords, second_set);
    EXPECT_FALSE(material_of(s).map_Kd.at(0).is_mean);
    EXPECT_TRUE(material_of(s).map_Ke.at(0).is_mean);
}

TEST_F(GltfSurface, TexturesOfThreeSetsAreTheirMeansWithAWarning) {
    const Scene s = scene(R"({"name": "lamp", "emissiveFactor": [1, 1, 1],
"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 1},
"metallicRoughnessTexture": {"index": 0, "texCoord": 2}}, "emissiveTexture": {"index": 0}})");
    EXPECT_EQ(warnings,
              (std::vector<std::string>{
                  "m.gltf: material 'lamp': its emissiveTexture has texCoord 0 beside textures "
                  "with 1 and 2; expected at most two, so all but those with the first are drawn "
                  "with their mean"}));
    EXPECT_FALSE(material_of(s).map_Kd.at(0).is_mean);
    EXPECT_TRUE(material_of(s).map_metal.at(0).is_mean);
    EXPECT_TRUE(material_of(s).map_Ke.at(0).is_mean);
}

TEST_F(GltfSurface, AMetallicRoughnessMapGoesWithItsFactors) {
    const Scene s = scene(
        R"({"pbrMetallicRoughness": {"roughnessFactor": 0.25, "metallicRoughnessTexture": {"index": 0}}})");
    const Material& m = material_of(s);
    ASSERT_EQ(m.map_metal.size(), 1u);
    EXPECT_EQ(m.map_metal[0].file, folder.path() / "leaf.png");
    EXPECT_EQ(m.physical->roughness, 0.25);
    EXPECT_EQ(m.physical->metallic, 1);
    EXPECT_TRUE(warnings.empty());
}

TEST_F(GltfSurface, SpecularGlossinessReplacesMetallicRoughness) {
    const Scene s = scene(
        R"({"name": "old", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 1}},
"extensions": {"KHR_materials_pbrSpecularGlossiness": {"glossinessFactor": 0.75,
"diffuseTexture": {"index": 0}, "specularGlossinessTexture": {"index": 0}}}})");
    EXPECT_TRUE(warnings.empty());
    EXPECT_EQ(s.objects.at(0).mesh->data().texcoords, first_set);
    EXPECT_EQ(material_of(s).map_Kd.size(), 1u);
    ASSERT_EQ(material_of(s).map_metal.size(), 1u);
    EXPECT_EQ(material_of(s).physical->F0, dvec3(1));
    EXPECT_EQ(material_of(s).physical->roughness, 0.25);
}

}  // namespace gw::scene
