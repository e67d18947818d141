// Claims: each section and key of a TOML scene lands in the scene as docs/scenes.md says.
#include <gtest/gtest.h>

#include "tests/scene/folder.h"
#include "tests/scene/gltf/gltf_text.h"

namespace gw::scene {
namespace {

struct Toml : testing::Test {
    Folder folder;
    Toml() {
        folder.write(
            "t.obj",
            "mtllib t.mtl\n" + triangle +
                "g a\nusemtl red\nf 1 2 3\ng b\nusemtl blue\nf 1 2 3\nf 3 2 1\ng c\nf 1 2 3\n");
        folder.write(
            "t.mtl",
            "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\nNs 5\nnewmtl unused\nmap_Kd no.png\n");
    }
    SceneFile file(const std::string& text) { return read_scene(folder.write("s.toml", text)); }
    Scene scene(const std::string& text) {
        return file(text + "\n[[object]]\nfile = 't.obj'\n").scene;
    }
    Scene object(const std::string& keys) {
        return file("[[object]]\nfile = 't.obj'\n" + keys).scene;
    }
};

using Ids = std::vector<std::uint32_t>;

}  // namespace

TEST_F(Toml, CameraKeys) {
    const Camera c =
        *scene(
             "[camera]\neye = [1, 2, 3]\nat = [0, 0.5, 0]\nup = [0, 0, 1]\nfov = 30\nnear = "
             "0.5\nfar = 100\northo = 2")
             .camera;
    EXPECT_EQ(c.eye, dvec3(1, 2, 3));
    EXPECT_EQ(c.at, dvec3(0, 0.5, 0));
    EXPECT_EQ(c.up, dvec3(0, 0, 1));
    EXPECT_EQ(c.fov, 30);
    EXPECT_EQ(c.near_plane, 0.5);
    EXPECT_EQ(c.far_plane, 100);
    EXPECT_EQ(c.ortho_height, 2);
    EXPECT_EQ(scene("camera = {}").camera->eye, dvec3(0, 0, 5));
}

TEST_F(Toml, LightKeys) {
    const Light l =
        scene(
            "[[light]]\nname = 'key'\nkind = 'spot'\nposition = [1, 2, 3]\ndirection = [0, -1, 0]\nIa = 0.1\n"
            "Id = [1, 0.5, 0]\nIs = 0.25\ncone = 20\nexponent = 8\nattenuation = [1, 0.5, 0.25]\nshadow = "
            "'volume'\n"
            "only = ['a', 'b']\narea = {shape = 'rectangle', u = [1, 0, 0], v = [0, 0, 2], samples = 25}")
            .lights.at(0);
    EXPECT_EQ(l.name, "key");
    EXPECT_EQ(l.kind, LightKind::Spot);
    EXPECT_EQ(l.position, vec3(1, 2, 3));
    EXPECT_EQ(l.direction, vec3(0, -1, 0));
    EXPECT_EQ(l.Ia, vec3(0.1f));
    EXPECT_EQ(l.Id, vec3(1, 0.5f, 0));
    EXPECT_EQ(l.Is, vec3(0.25f));
    EXPECT_EQ(l.cone_angle, 20);
    EXPECT_EQ(l.spot_exponent, 8);
    EXPECT_EQ(l.linear_attenuation, 0.5f);
    EXPECT_EQ(l.quadratic_attenuation, 0.25f);
    EXPECT_EQ(l.shadow, Shadow::Volume);
    EXPECT_EQ(l.only, (std::set<std::string>{"a", "b"}));
    EXPECT_EQ(l.area.shape, AreaLight::Shape::Rectangle);
    EXPECT_EQ(l.area.v, vec3(0, 0, 2));
    EXPECT_EQ(l.area.samples, 25);
}

TEST_F(Toml, LightsAreWhatTheirKeysSay) {
    const Scene s = scene(
        "[[light]]\nposition = [0, 1, 0]\n[[light]]\ndirection = [0, -1, 0]\n"
        "[[light]]\nposition = [0, 1, 0]\ndirection = [0, -1, 0]");
    EXPECT_EQ(s.lights[0].kind, LightKind::Point);
    EXPECT_EQ(s.lights[1].kind, LightKind::Directional);
    EXPECT_EQ(s.lights[2].kind, LightKind::Spot);
    EXPECT_FALSE(s.lights[0].Is);
    EXPECT_EQ(s.lights[0].area.shape, AreaLight::Shape::None);
}

TEST_F(Toml, FogAndBackground) {
    const Scene s = scene(
        "name = 'foggy'\nbackground = [0.1, 0.2, 0.3]\nfog = {mode = 'exp2', color = 0.5, density = 0.1, "
        "start = 1, end = 9}");
    EXPECT_EQ(s.name, "foggy");
    EXPECT_EQ(s.background, vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(s.fog->mode, FogMode::Exp2);
    EXPECT_EQ(s.fog->color, vec3(0.5f));
    EXPECT_EQ(s.fog->density, 0.1f);
    EXPECT_EQ(s.fog->start, 1);
    EXPECT_EQ(s.fog->end, 9);
}

TEST_F(Toml, FloatsAreTheNearestToTheirText) {
    // 1 + 2^-24 + 2^-60 is a tie once it went through a double.
    EXPECT_EQ(scene("background = [1.00000005960464477626, 1_0.5, +1e-1]").background,
              vec3(1.00000012f, 10.5f, 0.1f));
    EXPECT_EQ(scene("# \xc3\xa4\nname = '\xc3\xa4'\nfog = {color = 0x10, start = 0.1, end = 1}")
                  .fog->color,
              vec3(16));
    EXPECT_EQ(scene("fog = {end = 0.3}").fog->end, 0.3f);
}

TEST_F(Toml, MaterialKeys) {
    const auto map = folder.write("maps/my wood.png", "");
    const Scene s =
        file(
            "[material.shiny]\nKa = 0.1\nKd = [1, 0, 0]\nKs = 0.5\nKe = 0.25\nNs = 40\nNi = 1.5\nTr = "
            "0.25\nTf = [0, 1, 0]\n"
            "illum = 5\nmap_Ka = 'maps\\my wood.png'\n"
            "map_Kd = ['maps/my wood.png', {file = 'no.png', clamp = true, scale = 2, offset = [0.5, 0]}]\n"
            "map_Ks = {file = 'no.png', scale = [2, 3]}\nmap_Ke = 'e.png'\nrefl = 'sky.png'\nrefraction = "
            "'sky.png'\n"
            "[[object]]\nfile = 't.obj'\nmaterial = 'shiny'\n")
            .scene;
    ASSERT_EQ(s.materials.size(), 1u);
    const Material& m = s.materials[0];
    EXPECT_EQ(m.name, "shiny");
    EXPECT_EQ(m.Ka, vec3(0.1f));
    EXPECT_EQ(m.Kd, vec3(1, 0, 0));
    EXPECT_EQ(m.Ks, vec3(0.5f));
    EXPECT_EQ(m.Ke, vec3(0.25f));
    EXPECT_EQ(m.Ns, 40);
    EXPECT_EQ(m.Ni, 1.5f);
    EXPECT_EQ(m.d, 0.75f);
    EXPECT_EQ(m.Tf, vec3(0, 1, 0));
    EXPECT_EQ(m.illum, 5);
    EXPECT_EQ(m.map_Ka.at(0).file, map);
    EXPECT_EQ(m.map_Kd.at(1).wrap_t, Wrap::Clamp);
    EXPECT_EQ(m.map_Kd[1].scale, vec2(2));
    EXPECT_EQ(m.map_Kd[1].offset, vec2(0.5f, 0));
    EXPECT_EQ(m.map_Kd[1].origin.line, 12);
    EXPECT_EQ(folder.relative(m.map_Kd[1].origin.file), "s.toml");
    EXPECT_EQ(m.map_Ks.at(0).scale, vec2(2, 3));
    EXPECT_EQ(m.map_Ke.size() + m.refl.size() + m.refraction.size(), 3u);
}

TEST_F(Toml, MaterialsOfTheSceneComeBeforeThoseOfFiles) {
    const Scene s = scene("[material.red]\nKd = [0, 1, 0]");
    EXPECT_EQ(s.materials[0].Kd, vec3(0, 1, 0));
    EXPECT_EQ(s.materials[1].Kd, vec3(0, 0, 1));
    folder.write("more.mtl", "newmtl green\nKd 0 0.5 0\nnewmtl red\nKd 9 9 9\n");
    const Scene more =
        file(
            "mtllib = 'more.mtl'\n[material.red]\nKd = 0.5\n[[object]]\nfile = 't.obj'\nparts = ['a']\n"
            "[[object]]\nfile = 't.obj'\nmaterial = 'green'\n")
            .scene;
    EXPECT_EQ(more.materials[0].Kd, vec3(0.5f));
    EXPECT_EQ(more.materials[1].Kd, vec3(0, 0.5f, 0));
    EXPECT_EQ(more.materials.size(), 2u);
}

TEST_F(Toml, InlineMaterialsChangeThoseOfTheFile) {
    const Scene s =
        object("material = {Kd = [0, 1, 0], Ks = 1}\n[[object]]\nfile = 't.obj'\nparts = 'b'\n");
    ASSERT_EQ(s.materials.size(), 3u);
    EXPECT_EQ(s.materials[0].name, "red");
    EXPECT_EQ(s.materials[0].Kd, vec3(0, 1, 0));
    EXPECT_EQ(s.materials[1].name, "blue");
    EXPECT_EQ(s.materials[1].Ns, 5);
    EXPECT_EQ(s.materials[1].Ks, vec3(1));
    EXPECT_EQ(s.materials[2].Kd, vec3(0, 0, 1));  // another object's is as it was
    EXPECT_EQ(s.objects[3].material, 2u);
}

TEST_F(Toml, ObjectsBringPartsAndTheMaterialsTheyUse) {
    const Scene s = object("");
    EXPECT_EQ(s.name, "s");
    ASSERT_EQ(s.objects.size(), 3u);
    EXPECT_EQ(s.objects[0].name, "a");
    EXPECT_EQ(s.objects[2].name, "c");
    ASSERT_EQ(s.materials.size(), 2u);
    EXPECT_EQ(s.materials[0].name, "red");
    EXPECT_EQ(s.objects[1].material, 1u);
    EXPECT_EQ(s.objects[2].material, 1u);
    EXPECT_FALSE(s.camera || s.fog);
    EXPECT_TRUE(s.lights.empty());
}

TEST_F(Toml, ObjectsMayBeRenamedChosenAndHidden) {
    const Scene s =
        file(
            "[[light]]\nposition = [0, 9, 0]\nonly = 'hidden'\n[[object]]\nfile = 't.obj'\nname "
            "= 'all'\nparts = ['a', 'c']\n"
            "[[object]]\nfile = 't.obj'\nname = 'hidden'\nvisible = false\n")
            .scene;
    ASSERT_EQ(s.objects.size(), 2u);
    EXPECT_EQ(s.objects[0].name, "all");
    EXPECT_EQ(s.objects[1].name, "all");
    EXPECT_EQ(s.lights[0].only, std::set<std::string>{"hidden"});
}

TEST_F(Toml, CreaseIsTheObjects) {
    folder.write(
        "roof.obj",
        "s 1\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 -1\nv 2 1 -1\nf 1 2 3 4\nf 2 5 6 3\n");
    const Scene s =
        file(
            "[[object]]\nfile = 'roof.obj'\ncrease = 10\n[[object]]\nfile = 'roof.obj'\n"
            "[[object]]\nfile = 'roof.obj'\ncrease = 50\n")
            .scene;
    EXPECT_EQ(s.objects[0].mesh->vertex_count(), 8u);
    EXPECT_EQ(s.objects[1].mesh->vertex_count(), 6u);
    EXPECT_EQ(s.objects[2].mesh->vertex_count(), 6u);
}

TEST_F(Toml, PlacementsScaleRotateThenTranslate) {
    const Scene s = object(
        "scale = [2, 3, 4]\nrotate = {axis = [0, 0, 5], degrees = 90}\ntranslate = [10, 20, 30]\n");
    const dmat4& m = s.objects[0].world_from_object;
    EXPECT_EQ(m * dvec4(1, 0, 0, 1), dvec4(10, 22, 30, 1));
    EXPECT_EQ(m * dvec4(0, 1, 0, 1), dvec4(7, 20, 30, 1));
    EXPECT_EQ(m * dvec4(0, 0, 1, 1), dvec4(10, 20, 34, 1));
}

TEST_F(Toml, RotationsComeInThreeForms) {
    const dvec4 p(1, 2, 3, 1);
    EXPECT_EQ(object("rotate = [90, 0, 90]\n").objects[0].world_from_object * p, dvec4(3, 1, 2, 1));
    EXPECT_EQ(
        object("rotate = [{axis = [1, 0, 0], degrees = 90}, {axis = [0, 0, 1], degrees = 90}]\n")
                .objects[0]
                .world_from_object *
            p,
        dvec4(3, 1, 2, 1));
    EXPECT_EQ(
        object("rotate = {axis = [0, 1, 0], degrees = -90}\n").objects[0].world_from_object * p,
        dvec4(-3, 2, 1, 1));
}

TEST_F(Toml, MatricesAreWrittenRowByRow) {
    const Scene s = object("matrix = [1, 0, 0, 5,  0, 2, 0, 6,  0, 0, 3, 7,  0, 0, 0, 1]\n");
    EXPECT_EQ(s.objects[0].world_from_object * dvec4(1, 1, 1, 1), dvec4(6, 8, 10, 1));
}

TEST_F(Toml, BoundsAreInTheWorld) {
    const Bounds box = bounds(object("scale = 2\ntranslate = [1, 0, -1]\n"));
    EXPECT_FALSE(box.empty);
    EXPECT_EQ(box.low, dvec3(1, 0, -1));
    EXPECT_EQ(box.high, dvec3(3, 2, -1));
    EXPECT_TRUE(bounds(Scene{}).empty);
}

TEST_F(Toml, PolygonIdsRunThroughTheScene) {
    const Scene s = object("[[object]]\nfile = 't.obj'\nparts = 'b'\n");
    ASSERT_EQ(s.objects.size(), 4u);
    EXPECT_EQ(s.objects[0].mesh->data().polygon_ids, (Ids{0}));
    EXPECT_EQ(s.objects[1].mesh->data().polygon_ids, (Ids{1, 2}));
    EXPECT_EQ(s.objects[2].mesh->data().polygon_ids, (Ids{3}));
    EXPECT_EQ(s.objects[3].mesh->data().polygon_ids, (Ids{4, 5}));
}

TEST_F(Toml, WarningsOfItsFilesAreItsOwn) {
    folder.write("w.obj", triangle + "vp 0\nf 1 2 3\n");
    const SceneFile f = file("[[object]]\nfile = 'w.obj'\n[[object]]\nfile = 'w.obj'\n");
    ASSERT_EQ(f.warnings.size(), 1u);
    EXPECT_EQ(folder.relative(f.warnings[0]), "w.obj:4: vp statements are not drawn");
}

TEST_F(Toml, WarnsOfGlareOfAnObjectThatDoesNotEmit) {
    const std::string box = "[[object]]\nshape = 'box'\nglare = {}\n";
    const SceneFile dark = file(box);
    ASSERT_EQ(dark.warnings.size(), 1u);
    EXPECT_EQ(folder.relative(dark.warnings[0]),
              "s.toml:1: glare has no effect on an object that does not emit; expected Ke");
    EXPECT_EQ(file(box + "material = {Ke = 1}\n").warnings, Strings());
}

TEST_F(Toml, WarnsOfKeysThatHaveNoEffectBesideOthers) {
    const auto warning = [&](const std::string& section) {
        const SceneFile read = file(section + "\n[[object]]\nshape = 'box'\n");
        return read.warnings.size() == 1 ? folder.relative(read.warnings[0])
                                         : std::to_string(read.warnings.size());
    };
    const std::string
        point = " has no effect on a point light; expected position and direction, of a spot",
        sun = " has no effect on a directional light; expected a point light or a spot";
    EXPECT_EQ(warning("[[light]]\nposition = [0, 1, 0]\ncone = 20"),
              "s.toml:3: light.cone" + point);
    EXPECT_EQ(warning("[[light]]\ndirection = [0, -1, 0]\nattenuation = [1, 0, 1]"),
              "s.toml:3: light.attenuation" + sun);
    EXPECT_EQ(warning("[[light]]\nposition = [0, 1, 0]\ndirection = [0, -1, 0]\ncone = 20\n"
                      "attenuation = [1, 0, 1]"),
              "0");
    EXPECT_EQ(warning("[fog]\ndensity = 0.1"),
              "s.toml:2: fog.density has no effect in mode linear; expected mode exp or exp2");
    EXPECT_EQ(warning("[fog]\nmode = 'exp'\nend = 9"),
              "s.toml:3: fog.end has no effect in this mode; expected mode linear");
    EXPECT_EQ(warning("[fog]\nend = 9"), "0");
}

TEST_F(Toml, PartsOfGltfKeepTheirPlacesAndMaterials) {
    std::string text =
        replaced(triangle_gltf(), R"({"name": "leaf", "mesh": 0})",
                 R"({"name": "leaf", "mesh": 0, "translation": [1, 0, 0], "children": [1]},
           {"name": "bud", "mesh": 0, "translation": [0, 5, 0]})");
    text = replaced(text, R"("indices": 1)", R"("indices": 1, "material": 0)");
    text = replaced(
        text, R"("meshes")",
        R"("materials": [{"name": "green", "pbrMetallicRoughness": {"baseColorFactor": [0, 1, 0, 1], "metallicFactor": 0}}],
           "animations": [], "cameras": [], "meshes")");
    folder.write("m.gltf", text);
    const std::string object = "[[object]]\nfile = 'm.gltf'\n";
    const SceneFile whole = file(object + "scale = 2\ntranslate = [0, 0, 7]\n");
    EXPECT_TRUE(whole.warnings.empty());
    const auto& objects = whole.scene.objects;
    ASSERT_EQ(objects.size(), 2u);
    EXPECT_EQ(objects[0].name, "leaf");
    EXPECT_EQ(objects[1].name, "bud");
    EXPECT_EQ(objects[0].world_from_object * dvec4(2, 0, 0, 1), dvec4(6, 0, 7, 1));
    EXPECT_EQ(objects[1].world_from_object * dvec4(0, 3, 0, 1), dvec4(2, 16, 7, 1));
    EXPECT_EQ(objects[0].mesh->data().polygon_ids, (Ids{0}));
    EXPECT_EQ(objects[1].mesh->data().polygon_ids, (Ids{1}));
    EXPECT_EQ(whole.scene.materials.at(objects[1].material).Kd, vec3(0, 1, 0));

    const Scene bud = file(object + "parts = 'bud'\nname = 'b'\nmaterial = {Ks = 0.5}\n").scene;
    ASSERT_EQ(bud.objects.size(), 1u);
    EXPECT_EQ(bud.objects[0].name, "b");
    EXPECT_EQ(bud.materials.at(bud.objects[0].material).Kd, vec3(0, 1, 0));
    EXPECT_EQ(bud.materials.at(bud.objects[0].material).Ks, vec3(0.5f));
    const Scene red = file("[material.green]\nKd = [1, 0, 0]\n" + object).scene;
    EXPECT_EQ(red.materials.at(red.objects.at(0).material).Kd, vec3(1, 0, 0));
    EXPECT_EQ(folder.scene_error("s.toml", object + "crease = 30\n"),
              "s.toml:3: crease beside glTF; expected it beside an OBJ file");
    EXPECT_EQ(folder.scene_error("s.toml", object + "parts = 'leav'\n"),
              "s.toml:3: unknown part 'leav'; the nearest known is 'leaf'");
}

TEST_F(Toml, LightsAndCamerasOfGltfAreLeftOut) {
    std::string text =
        replaced(triangle_gltf(), R"("mesh": 0)",
                 R"("mesh": 0, "camera": 0, "extensions": {"KHR_lights_punctual": {"light": 0}})");
    text = replaced(
        text, R"("scene": 0)",
        R"("scene": 0, "cameras": [{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.5}}],
           "extensions": {"KHR_lights_punctual": {"lights": [{"type": "directional"}]}})");
    folder.write("m.gltf", text);
    const SceneFile read = file("[[object]]\nfile = 'm.gltf'\n");
    EXPECT_FALSE(read.scene.camera);
    EXPECT_TRUE(read.scene.lights.empty());
    ASSERT_EQ(read.warnings.size(), 2u);
    EXPECT_EQ(folder.relative(read.warnings[0]),
              "m.gltf: its camera is left out; the scene has its own");
    EXPECT_EQ(folder.relative(read.warnings[1]),
              "m.gltf: its lights are left out; the scene has its own");
}

}  // namespace gw::scene
