// Claims: a glTF file's meshes, places, materials, lights and cameras become those of a scene, by the
// rules of docs/scenes.md.
#include <gtest/gtest.h>

#include "tests/scene/folder.h"
#include "tests/scene/gltf/gltf_text.h"

#include <cmath>

namespace gw::scene {
namespace {

struct Gltf : testing::Test {
    Folder folder;

    Scene scene(const std::string& text) {
        const SceneFile file = read_scene(folder.write("m.gltf", text));
        warnings.clear();
        for (const std::string& line : file.warnings) warnings.push_back(folder.relative(line));
        return file.scene;
    }
    /// The material of the triangle, whose JSON this is.
    Material material(const std::string& json) {
        std::string text =
            replaced(triangle_gltf(), R"("indices": 1)", R"("indices": 1, "material": 0)");
        text = replaced(text, R"("meshes")", "\"materials\": [" + json + "], \"meshes\"");
        const Scene s = scene(text);
        return s.materials.at(s.objects.at(0).material);
    }
    /// The triangle's file with a light and a camera at its node.
    Scene lit(const std::string& node, const std::string& light) {
        std::string text = replaced(
            triangle_gltf(), R"("mesh": 0)",
            "\"mesh\": 0" + node + R"(, "extensions": {"KHR_lights_punctual": {"light": 0}})");
        return scene(replaced(
            text, R"("scene": 0)",
            R"("scene": 0, "extensions": {"KHR_lights_punctual": {"lights": [)" + light + "]}}"));
    }
    /// The triangle, and a light at a node of its own.
    Scene lit_from(const std::string& node, const std::string& light) {
        std::string text = replaced(triangle_gltf(), R"({"nodes": [0]})", R"({"nodes": [0, 1]})");
        text = replaced(text, R"("nodes": [{)", R"("nodes": [{)" + std::string("@"));
        const std::size_t at = text.find('@'), end = text.find('}', at);
        text.replace(end, 1,
                     "}, {" + node + R"("extensions": {"KHR_lights_punctual": {"light": 0}}})");
        text.erase(at, 1);
        return scene(replaced(
            text, R"("scene": 0)",
            R"("scene": 0, "extensions": {"KHR_lights_punctual": {"lights": [)" + light + "]}}"));
    }
    Strings warnings;
};

/// IEC 61966-2-1, in the library's own functions.
float srgb(double v) {
    return float(v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055);
}

#define EXPECT_NEAR_3(v, a, b, c) \
    EXPECT_NEAR((v).x, a, 1e-6);  \
    EXPECT_NEAR((v).y, b, 1e-6);  \
    EXPECT_NEAR((v).z, c, 1e-6)

}  // namespace

TEST_F(Gltf, ATriangleIsAnObjectWithAFlatNormal) {
    const Scene s = scene(triangle_gltf());
    ASSERT_EQ(s.objects.size(), 1u);
    EXPECT_EQ(s.objects[0].name, "leaf");
    const MeshData& mesh = s.objects[0].mesh->data();
    EXPECT_EQ(mesh.positions, (std::vector<vec3>{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}}));
    EXPECT_EQ(mesh.normals, (std::vector<vec3>(3, {0, 0, 1})));
    EXPECT_TRUE(warnings.empty());
}

TEST_F(Gltf, AGlbFileIsTheSameScene) {
    const auto file = folder.write("m.glb", glb(triangle_json(""), triangle_bytes()));
    EXPECT_EQ(read_scene(file).scene.objects.at(0).mesh->data(),
              scene(triangle_gltf()).objects.at(0).mesh->data());
}

TEST_F(Gltf, ABufferIsAFileBesideIt) {
    folder.write("a b.bin", triangle_bytes());
    const auto file = folder.write("m.gltf", triangle_json(R"(, "uri": "a%20b.bin")"));
    const SceneFile read = read_scene(file);
    EXPECT_EQ(read.scene.objects.at(0).mesh->data().positions.at(2), vec3(0, 3, 0));
    EXPECT_EQ(read.files, (std::vector{file, folder.path() / "a b.bin"}));
}

TEST_F(Gltf, NodesTurnScaleAndMoveWhatIsBelowThem) {
    const std::string nodes =
        R"({"translation": [10, 0, 0], "children": [1]}, {"rotation": [0, 0, 1, 0], "scale": [2, 2, 2], "children": [2]}, {"name": "leaf", "mesh": 0})";
    const Scene s = scene(replaced(triangle_gltf(), R"({"name": "leaf", "mesh": 0})", nodes));
    const dvec4 p = s.objects.at(0).world_from_object * dvec4(2, 3, 1, 1);
    EXPECT_EQ(p, dvec4(10 - 4, -6, 2, 1));
}

TEST_F(Gltf, NodesOfOneMeshShareIt) {
    std::string text = replaced(
        triangle_gltf(), R"({"name": "leaf", "mesh": 0})",
        R"({"name": "leaf", "mesh": 0}, {"mesh": 0, "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 5,6,7,1]})");
    const Scene s = scene(replaced(text, R"("nodes": [0])", R"("nodes": [0, 1])"));
    ASSERT_EQ(s.objects.size(), 2u);
    EXPECT_EQ(s.objects[0].mesh, s.objects[1].mesh);
    EXPECT_EQ(s.objects[1].name, "meshes[0]");
    EXPECT_EQ(s.objects[1].world_from_object[3], dvec4(5, 6, 7, 1));
}

TEST_F(Gltf, ModesAreTheMachinesPrimitives) {
    const std::string with = "\"indices\": 1, \"mode\": ";
    const auto mesh = [&](int mode) {
        return scene(replaced(triangle_gltf(), R"("indices": 1)", with + std::to_string(mode)))
            .objects.at(0)
            .mesh;
    };
    EXPECT_EQ(mesh(0)->points().size(), 3u);
    EXPECT_EQ(mesh(1)->lines().size(), 1u);
    EXPECT_EQ(mesh(2)->lines().size(), 3u);
    EXPECT_EQ(mesh(3)->lines().size(), 2u);
    for (const int mode : {4, 5, 6}) EXPECT_EQ(mesh(mode)->triangles().size(), 1u) << mode;
}

TEST_F(Gltf, ASparseAccessorReplacesElements) {
    const std::string bytes =
        triangle_bytes() + std::string("\1\0", 2) + bytes_of<float>({7, 8, 9});
    std::string text =
        replaced(triangle_json(R"(, "uri": ")" + data_uri(bytes) + "\""), "42", "56");
    text = replaced(text, R"("byteLength": 6})",
                    R"("byteLength": 6}, {"buffer": 0, "byteOffset": 42, "byteLength": 2},
                    {"buffer": 0, "byteOffset": 44, "byteLength": 12})");
    text = replaced(
        text, R"("type": "VEC3")",
        R"("type": "VEC3", "sparse": {"count": 1, "indices": {"bufferView": 2, "componentType": 5123}, "values": {"bufferView": 3}})");
    EXPECT_EQ(scene(text).objects.at(0).mesh->data().positions,
              (std::vector<vec3>{{0, 0, 0}, {7, 8, 9}, {0, 3, 0}}));
}

TEST_F(Gltf, TextureCoordinatesGrowUpwards) {
    const std::string bytes = triangle_bytes() + std::string("\0\0\0\xff\xff\0", 6);
    std::string text =
        replaced(triangle_json(R"(, "uri": ")" + data_uri(bytes) + "\""), "42", "48");
    text = replaced(text, R"("byteLength": 6})",
                    R"("byteLength": 6}, {"buffer": 0, "byteOffset": 42, "byteLength": 6})");
    text = replaced(text, R"("type": "SCALAR"})", R"("type": "SCALAR"},
        {"bufferView": 2, "componentType": 5121, "count": 3, "type": "VEC2", "normalized": true})");
    text = replaced(text, R"("POSITION": 0)", R"("POSITION": 0, "TEXCOORD_0": 2)");
    EXPECT_EQ(scene(text).objects.at(0).mesh->data().texcoords,
              (std::vector<vec2>{{0, 1}, {0, 0}, {1, 1}}));
}

TEST_F(Gltf, AMetalIsItsHighlightAndARoughSurfaceHasAWideOne) {
    const Material rough = material(
        R"({"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.2, 0, 1], "metallicFactor": 0, "roughnessFactor": 0.5}})");
    EXPECT_NEAR_3(rough.Ka, srgb(0.54), srgb(0.24), srgb(0.04));
    EXPECT_NEAR_3(rough.Kd, srgb(0.5), srgb(0.2), 0);
    const double peak = 0.04 / (4.0 / 16);
    EXPECT_NEAR_3(rough.Ks, srgb(0.5 + peak) - srgb(0.5), srgb(0.2 + peak) - srgb(0.2), srgb(peak));
    // Where its highlight is half as high, so is GGX of a = 1 / 4 on the display.
    const double c = std::pow(0.5, 1 / double(rough.Ns)), a2 = 1.0 / 16;
    const double D = std::pow(a2 / (c * c * (a2 - 1) + 1), 2);
    EXPECT_NEAR(srgb(0.5 + peak * D) - srgb(0.5), rough.Ks.x / 2, 1e-6);
    const Material metal = material(
        R"({"pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0.25, 1], "roughnessFactor": 0.5}})");
    constexpr double in_Kd = 0.5 / 2, in_Ks = 1 - in_Kd;  // of the highlight, by roughness
    EXPECT_NEAR_3(metal.Kd, in_Kd, in_Kd * srgb(0.5), in_Kd * srgb(0.25));
    EXPECT_NEAR_3(metal.Ks, in_Ks, in_Ks * srgb(0.5), in_Ks * srgb(0.25));
}

TEST_F(Gltf, SpecularAndGlossinessAreF0AndRoughness) {
    const Material m = material(
        R"({"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}, "extensions": {"KHR_materials_pbrSpecularGlossiness":
        {"diffuseFactor": [0.5, 0.2, 0, 1], "specularFactor": [0.2, 0.1, 0], "glossinessFactor": 0.25}}})");
    const double peak = 1 / (4 * std::pow(0.75, 4)), left = 1 - 0.2, broad = 0.2 * 0.75 / 2;
    const double r = srgb(0.5 * left + 0.2 * peak) - srgb(0.5 * left);
    const double g = srgb(0.2 * left + 0.1 * peak) - srgb(0.2 * left);
    EXPECT_NEAR_3(m.Kd, srgb(0.5 * left) + r * broad, srgb(0.2 * left) + g * broad, 0);
    EXPECT_NEAR_3(m.Ks, r * (1 - broad), g * (1 - broad), 0);
    EXPECT_NEAR_3(m.Ka, srgb(0.5 * left + 0.2), srgb(0.2 * left + 0.1), 0);
}

TEST_F(Gltf, AnUnlitMaterialEmitsItsColour) {
    const Material m = material(
        R"({"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.2, 0, 1]}, "extensions": {"KHR_materials_unlit": {}}})");
    EXPECT_NEAR_3(m.Ke, srgb(0.5), srgb(0.2), 0);
    EXPECT_EQ(m.Ka, vec3(0));
    EXPECT_EQ(m.Kd, vec3(0));
    EXPECT_EQ(m.Ks, vec3(0));
}

TEST_F(Gltf, AlphaModesSetTheOpacity) {
    const std::string alpha = R"({"pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.25]})";
    EXPECT_EQ(material(alpha + "}").d, 1);
    EXPECT_EQ(material(alpha + R"(, "alphaMode": "BLEND"})").d, 0.25f);
    EXPECT_EQ(material(alpha + R"(, "alphaMode": "MASK", "alphaCutoff": 0.2})").d, 1);
    EXPECT_EQ(material(alpha + R"(, "alphaMode": "MASK"})").d, 0);
}

TEST_F(Gltf, AnEmbeddedPictureIsKeptAsItsBytes) {
    std::string text =
        replaced(triangle_gltf(), R"("indices": 1)", R"("indices": 1, "material": 0)");
    text = replaced(text, R"("meshes")",
                    R"("textures": [{"source": 0, "sampler": 0}], "samplers": [{"wrapS": 33071}],
                    "images": [{"uri": "data:image/png;base64,QUJD"}],
                    "materials": [{"pbrMetallicRoughness": {"metallicFactor": 0, "baseColorTexture": {"index": 0,
                    "extensions": {"KHR_texture_transform": {"scale": [2, 4], "offset": [0.5, 0.25]}}}}}], "meshes")");
    const Scene s = scene(text);
    const Map& map = s.materials.at(s.objects.at(0).material).map_Kd.at(0);
    EXPECT_EQ(*map.bytes, "ABC");
    EXPECT_EQ(folder.relative(map.file.string()), "m.gltf: images[0]");
    EXPECT_EQ(map.wrap_s, Wrap::Clamp);
    EXPECT_EQ(map.wrap_t, Wrap::Repeat);
    EXPECT_EQ(map.scale, vec2(2, 4));
    EXPECT_EQ(map.offset, vec2(0.5f, 1 - 4 - 0.25f));
    EXPECT_EQ(
        warnings,
        (Strings{"m.gltf: object 'leaf' has no texture coordinates of set 0 for its texture"}));
}

TEST_F(Gltf, LightsShineAlongTheirNodesMinusZ) {
    const std::string turned =
        R"(, "rotation": [-0.7071067811865476, 0, 0, 0.7071067811865476], "translation": [1, 5, 0])";
    const Scene sun = lit(
        turned, R"({"type": "directional", "intensity": 3.141592653589793, "color": [1, 0.5, 0]})");
    ASSERT_EQ(sun.lights.size(), 1u);
    EXPECT_EQ(sun.lights[0].name, "leaf");
    EXPECT_EQ(sun.lights[0].kind, LightKind::Directional);
    EXPECT_NEAR_3(sun.lights[0].direction, 0, -1, 0);
    EXPECT_NEAR_3(sun.lights[0].Id, 1, srgb(0.5), 0);
    const Scene spot = lit(
        turned,
        R"({"type": "spot", "spot": {"innerConeAngle": 0, "outerConeAngle": 0.5235987755982988}})");
    EXPECT_EQ(spot.lights.at(0).position, vec3(1, 5, 0));
    EXPECT_NEAR(spot.lights[0].cone_angle, 30, 1e-9);
    // cos^e of the angle whose square of (cos - cos 30) / (1 - cos 30) is a half
    const double middle = std::cos(std::acos(-1) / 6) * (1 - std::sqrt(0.5)) + std::sqrt(0.5);
    EXPECT_NEAR(std::pow(middle, double(spot.lights[0].spot_exponent)), 0.5, 1e-6);
}

TEST_F(Gltf, LightsBeyondWhiteAreDividedByOneNumber) {
    const Scene s = lit("", R"({"type": "directional", "intensity": 31.45, "color": [1, 0.5, 0]})");
    EXPECT_NEAR_3(s.lights.at(0).Id, 1, srgb(0.5), 0);
    EXPECT_EQ(
        warnings,
        (Strings{
            "m.gltf: its lights give 10.01 times white on bright surfaces; expected at most 1, so all are divided by it"}));
}

/// The triangle 2 wide and 3 high lies in z = 0: light counts where it falls, not where it is.
TEST_F(Gltf, WhiteGoesByTheLightOnSurfaces) {
    const auto white = [&](const std::string& node, const std::string& kind) {
        const std::string light = "{\"type\": \"" + kind + R"(", "intensity": 31.41592653589793})";
        return lit_from(node, light).white / std::acos(-1);
    };
    EXPECT_NEAR(white("", "directional"), 10, 1e-4);
    const std::string askew = R"("rotation": [0.5, 0, 0, 0.8660254037844386], )";  // by 60 degrees
    EXPECT_NEAR(white(askew, "directional"), 5, 1e-4);
    const std::string above = R"("translation": [0.7, 1, 1], )";
    const double straight = white(above, "point");  // 10 below the lamp, 1.6 at the far corners
    EXPECT_GT(straight, 7);
    EXPECT_LT(straight, 10);
    EXPECT_GT(white(above, "spot"), 7);
    const std::string away = R"("rotation": [1, 0, 0, 0], )";
    EXPECT_EQ(white(away + above, "spot"), 1);
    // A hand's breadth above the middle of the box, where it would give 1,000 times white.
    EXPECT_LT(white(R"("translation": [1, 1.5, 0.1], )", "point"), 500);
}

TEST_F(Gltf, ConesWithoutARampAreEven) {
    const auto exponent = [&](const std::string& cones) {
        return lit("", R"({"type": "spot", "spot": {)" + cones + "}}").lights.at(0).spot_exponent;
    };
    EXPECT_EQ(exponent(R"("innerConeAngle": 0.5, "outerConeAngle": 0.5)"), 0);
    EXPECT_GT(exponent(R"("innerConeAngle": 0.3, "outerConeAngle": 0.5)"), 0);
    const std::string right_in_float = R"("outerConeAngle": 1.5707963705062866)";
    EXPECT_EQ(
        lit("", R"({"type": "spot", "spot": {)" + right_in_float + "}}").lights.at(0).cone_angle,
        90);
}

/// pi lux are white; at the triangle, 3 cd 5 m away are less.
TEST_F(Gltf, LampsKeepTheirCandelaForRadiosity) {
    const Scene lamp = lit(R"(, "translation": [0, 5, 0])",
                           R"({"type": "point", "intensity": 3, "color": [1, 0.5, 0]})");
    ASSERT_TRUE(lamp.lights.at(0).luminous);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(lamp.lights[0].luminous->candela[c], 3 * (c == 0 ? 1 : c == 1 ? 0.5 : 0), 1e-6);
    const Scene sun = lit("", R"({"type": "directional", "intensity": 31.41592653589793})");
    EXPECT_NEAR(sun.white, 10 * std::acos(-1), 1e-5);
    EXPECT_FALSE(sun.lights.at(0).luminous);
    EXPECT_EQ(scene(triangle_gltf()).white, 0);  // without lights, light has no unit
}

TEST_F(Gltf, BesideLampsSurfacesEmitPiTimesTheirNit) {
    std::string text =
        replaced(triangle_gltf(), R"("mesh": 0)",
                 R"("mesh": 0, "extensions": {"KHR_lights_punctual": {"light": 0}})");
    text = replaced(text, R"("indices": 1)", R"("indices": 1, "material": 0)");
    text = replaced(text, R"("scene": 0)",
                    R"("scene": 0, "materials": [{"emissiveFactor": [1, 0.5, 0], "extensions":
            {"KHR_materials_emissive_strength": {"emissiveStrength": 4}}}],
            "extensions": {"KHR_lights_punctual": {"lights": [{"type": "directional"}]}})");
    const Scene s = scene(text);
    ASSERT_TRUE(s.objects.at(0).pixmap.emission);
    EXPECT_NEAR_3(*s.objects[0].pixmap.emission, 4 * std::acos(-1), 2 * std::acos(-1), 0);
}

TEST_F(Gltf, TheFirstCameraIsTheEye) {
    std::string text = replaced(triangle_gltf(), R"("mesh": 0)",
                                R"("mesh": 0, "camera": 0, "translation": [0, 0, 9])");
    text = replaced(
        text, R"("scene": 0)",
        R"("scene": 0, "cameras": [{"type": "perspective", "perspective": {"yfov": 0.5235987755982988, "znear": 0.5}}])");
    const Camera camera = scene(text).camera.value();
    EXPECT_EQ(camera.eye, dvec3(0, 0, 9));
    EXPECT_EQ(camera.at, dvec3(0, 0, 8));
    EXPECT_EQ(camera.up, dvec3(0, 1, 0));
    EXPECT_NEAR(camera.fov, 30, 1e-9);
    EXPECT_EQ(camera.near_plane, 0.5);
    EXPECT_EQ(camera.far_plane, 0);
}

TEST_F(Gltf, WhatIsLeftOutIsOneWarningEach) {
    std::string text =
        replaced(triangle_gltf(), R"("scene": 0)", R"("scene": 0, "extensionsUsed": ["EXT_new"])");
    text =
        replaced(text, R"("indices": 1)",
                 R"("indices": 1, "material": 0, "targets": [{"POSITION": 0, "TEXCOORD_0": 0}])");
    text = replaced(text, R"("meshes")",
                    R"("materials": [{"name": "bark", "normalTexture": {"index": 0}}], "meshes")");
    scene(text);
    EXPECT_EQ(warnings,
              (Strings{"m.gltf: extension EXT_new is left out",
                       "m.gltf: material 'bark': its normalTexture is left out",
                       "m.gltf: object 'leaf': its morph targets do not change TEXCOORD_0"}));
}

}  // namespace gw::scene
