// Claims: what a picture cannot show right is said in one line that names the objects.
#include "scene/draw/nearest.h"
#include "scene/validate/warnings_of.h"

#include <gtest/gtest.h>

#include "scene/draw/fit.h"
#include "scene/validate/coincident.h"
#include "scene/validate/shadow_maps.h"
#include "tests/scene/folder.h"

namespace gw::scene {
namespace {

void add_quad(Scene& scene, const std::string& name, const std::vector<vec3>& corners) {
    Object object{.name = name,
                  .mesh = make_mesh({.primitive = Primitive::Quads, .positions = corners}),
                  .material = scene.materials.size()};
    scene.objects.push_back(object);
    scene.materials.push_back({.name = name});
}

std::vector<vec3> level(float y, float half, bool down, float x = 0) {
    std::vector<vec3> corners{
        {x - half, y, -half}, {x - half, y, half}, {x + half, y, half}, {x + half, y, -half}};
    if (down) std::swap(corners[1], corners[3]);
    return corners;
}

Scene room(float lamp_y, bool lamp_first, bool lamp_down = true, float x = 0) {
    Scene scene;
    if (lamp_first) add_quad(scene, "lamp", level(lamp_y, 65, lamp_down, x));
    add_quad(scene, "ceiling", level(548.8f, 278, true));
    if (!lamp_first) add_quad(scene, "lamp", level(lamp_y, 65, lamp_down, x));
    return scene;
}

using Pair = std::pair<std::size_t, std::size_t>;

TEST(Coincident, ALampInTheCeilingsPlaneInEitherOrder) {
    EXPECT_EQ(coincident_objects(room(548.8f, true)), (Pair{0, 1}));
    EXPECT_EQ(coincident_objects(room(548.8f, false)), (Pair{0, 1}));
    EXPECT_FALSE(coincident_objects(room(548.7f, true))) << "a little below it";
}

TEST(Coincident, NotABoxOnAFloor) {
    EXPECT_FALSE(coincident_objects(room(548.8f, true, false))) << "they look opposite ways";
    EXPECT_FALSE(coincident_objects(room(548.8f, true, true, 343))) << "side by side";
    EXPECT_TRUE(coincident_objects(room(548.8f, true, true, 342)));
    Scene alike = room(548.8f, true);
    alike.objects[1].material = alike.objects[0].material;
    EXPECT_FALSE(coincident_objects(alike)) << "the same colour either way";
}

/// A lamp `distance` below a shade, over a plain of this reach.
Scene shaded_lamp(LightKind kind, float distance, float reach) {
    Scene scene;
    add_quad(scene, "shade", level(10 + distance, 1, true));
    add_quad(scene, "plain", level(0, reach, false));
    scene.lights.push_back({.name = "bulb",
                            .kind = kind,
                            .position = {0, 10, 0},
                            .direction = {0, 1, 0},
                            .cone_angle = 40,
                            .shadow = Shadow::Map});
    return scene;
}

TEST(ShadowMaps, NameWhatIsNearerToALightThanItsMap) {
    for (const LightKind kind : {LightKind::Point, LightKind::Spot}) {
        EXPECT_EQ(cut_by_shadow_map(shaded_lamp(kind, 0.5f, 10000)), "");
        const std::string line = cut_by_shadow_map(shaded_lamp(kind, 0.125f, 10000));
        EXPECT_EQ(
            line,
            "light 'bulb': object 'shade' comes as near as 0.125, where it casts no shadow: the "
            "shadow map begins at 0.2158, a 65536th of the scene's reach; expected shadow = "
            "\"volume\"");
        Scene scene = shaded_lamp(kind, 0.125f, 10000);
        scene.lights[0].shadow = Shadow::Volume;
        EXPECT_EQ(cut_by_shadow_map(scene), "");
        scene.lights[0].shadow = Shadow::Map;
        scene.objects[0].casts_shadow = false;
        EXPECT_EQ(cut_by_shadow_map(scene), "");
    }
}

TEST(ShadowMaps, DoNotNameWhatASpotLeavesDark) {
    Scene scene = shaded_lamp(LightKind::Spot, 0.125f, 10000);
    scene.lights[0].direction = {0, -1, 0};
    EXPECT_EQ(cut_by_shadow_map(scene), "");
    EXPECT_EQ(cut_by_shadow_map(shaded_lamp(LightKind::Point, 0, 10000)), "") << "edge-on";
}

TEST(SceneMaps, NameWhatIsNearerToAMirrorThanItsMap) {
    Scene scene = shaded_lamp(LightKind::Point, 0.125f, 10000);
    scene.lights.clear();
    add_quad(scene, "mirror", level(10, 1, false));
    EXPECT_EQ(cut_by_scene_map(scene), "");
    scene.materials[2].refl = {Map{.from_scene = 64}};
    EXPECT_EQ(cut_by_scene_map(scene),
              "object 'mirror': object 'shade' comes as near as 0.125, where it is not reflected: "
              "the map of the scene begins at 0.3053, a 65536th of the scene's reach; expected a "
              "renderer by rays");
    scene.objects.erase(scene.objects.begin());
    EXPECT_EQ(cut_by_scene_map(scene), "");
}

TEST(WarningsOf, NameWhatIsNotShown) {
    Scene scene = room(548.8f, true);
    add_quad(scene, "far", {{0, 0, -1e8f}, {1, 0, -1e8f}, {0, 1, -1e8f}, {0, 0, -1e8f}});
    scene.objects.push_back(
        {.name = "wire",
         .mesh = make_mesh({.primitive = Primitive::Lines, .positions = {{0, 1, 0}, {1, 1, 0}}})});
    scene.camera = Camera{.eye = {0, 0, 800}, .at = {0, 0, 0}};
    const View view = make_view(scene, 64, 48);
    const std::string shared =
        "objects 'lamp' and 'ceiling' share a part of a plane: which of them is seen there depends "
        "on rounding; expected them a little apart";
    const std::string lines =
        "lines and points are left out, as of object 'wire'; expected renderer multipass or "
        "hardware for them";
    EXPECT_EQ(warnings_of(scene, view, DrawnBy::Rays), (Strings{lines, shared}));
    const Strings passes = warnings_of(scene, view, DrawnBy::Passes);
    ASSERT_EQ(passes.size(), 2u);
    EXPECT_EQ(passes[0].substr(0, 25), "object 'wire' is cut off:");
    EXPECT_EQ(passes[1], shared);
    EXPECT_EQ(warnings_of(scene, view, DrawnBy::Depth).size(), 3u);
    EXPECT_EQ(warnings_of(room(548.7f, true), view, DrawnBy::Depth), Strings());
}

/// A spot straight down on the middle of a floor lights none of its corners.
TEST(WarningsOf, NameASpotBetweenVerticesWherePassesDraw) {
    Scene scene;
    add_quad(scene, "floor", level(0, 5, false));
    scene.lights.push_back({.name = "lamp",
                            .kind = LightKind::Spot,
                            .position = {0, 3, 0},
                            .direction = {0, -1, 0},
                            .cone_angle = 20});
    const View view = fitted_view({.eye = dvec3(0, 5, 8)}, scene, bounds(scene), 32, 24);
    EXPECT_EQ(
        warnings_of(scene, view, DrawnBy::Passes),
        (Strings{"object 'floor' has no vertex in the cone of spot 'lamp' that shines on it, and "
                 "passes light vertices: expected it divided (divide = N), or --renderer "
                 "raytrace"}));
    EXPECT_EQ(warnings_of(scene, view, DrawnBy::Rays), Strings());
    scene.lights[0].cone_angle = 70;  // the corners are at 67 degrees
    EXPECT_EQ(warnings_of(scene, view, DrawnBy::Passes), Strings());
    scene.lights[0].cone_angle = 20;
    scene.lights[0].direction = {0, 1, 0};
    EXPECT_EQ(warnings_of(scene, view, DrawnBy::Passes), Strings());
    scene.lights[0].direction = {0, -1, 0};
    scene.lights[0].only = {"wall"};
    EXPECT_EQ(warnings_of(scene, view, DrawnBy::Passes), Strings());
}

void add_texcoords(Object& object) {
    MeshData data = object.mesh->data();
    data.texcoords.resize(data.positions.size());
    object.mesh = make_mesh(data);
}

TEST(WarningsOf, NameAMapWithoutTextureCoordinates) {
    Scene scene;
    add_quad(scene, "floor", level(0, 5, false));
    const View view = fitted_view({.eye = dvec3(0, 5, 8)}, scene, bounds(scene), 32, 24);
    const std::vector<std::uint16_t> texel(4, 65535), texels(8, 65535);
    scene.materials[0].map_Kd = {
        Map{.file = "maps/wood.png", .texture = make_texture("wood", 1, 1, texel)}};
    EXPECT_EQ(warnings_of(scene, view, DrawnBy::Rays), Strings()) << "the one texel";
    scene.materials[0].map_Kd[0].texture = make_texture("wood", 2, 1, texels);
    for (const DrawnBy by : {DrawnBy::Passes, DrawnBy::Depth, DrawnBy::Rays})
        EXPECT_EQ(
            warnings_of(scene, view, by),
            (Strings{"object 'floor' has no texture coordinates for wood.png: one texel of it "
                     "is everywhere; expected some (vt)"}));
    add_texcoords(scene.objects[0]);
    EXPECT_EQ(warnings_of(scene, view, DrawnBy::Rays), Strings());
}

TEST(WarningsOf, NameAMapOfKdWithAnAlphaThatIsNotUsed) {
    Scene scene;
    add_quad(scene, "leaf", level(0, 5, false));
    add_texcoords(scene.objects[0]);
    const View view = fitted_view({.eye = dvec3(0, 5, 8)}, scene, bounds(scene), 32, 24);
    std::vector<std::uint16_t> texels(8, 65535);
    const auto warnings = [&] {
        scene.materials[0].map_Kd = {
            Map{.file = "maps/leaf.png", .texture = make_texture("leaf", 2, 1, texels)}};
        return warnings_of(scene, view, DrawnBy::Passes);
    };
    EXPECT_EQ(warnings(), Strings()) << "opaque";
    texels[7] = 0;
    EXPECT_EQ(warnings(), (Strings{"object 'leaf' has a map of Kd, leaf.png, whose alpha is not "
                                   "used; expected map_d with it for opacity"}));
    scene.materials[0].is_encoded = true;
    EXPECT_EQ(warnings(), Strings()) << "glTF's alphaMode says whether alpha counts";
}

TEST(WarningsOf, NameWhatRadiosityLeavesOut) {
    Scene scene = room(548.7f, true);
    EXPECT_EQ(left_out_by_radiosity(scene), std::vector<std::string>());
    scene.materials[1].d = 0.5f;
    scene.materials[1].map_Kd = {Map{.file = "maps/wood.png"}};
    EXPECT_EQ(left_out_by_radiosity(scene),
              (std::vector<std::string>{
                  "object 'ceiling' has opacity 0.5; radiosity takes it as opaque: expected d 1",
                  "object 'ceiling' has a map of Kd, wood.png; radiosity reflects the mean of "
                  "its texels everywhere: expected no map"}));
}

TEST(WarningsOf, NameColorsOf255) {
    Scene scene = room(548.7f, true);
    const View view = fitted_view({.eye = dvec3(0, 5, 800)}, scene, bounds(scene), 32, 24);
    scene.materials[1].Kd = {1.5f, 0, 0};
    EXPECT_EQ(warnings_of(scene, view, DrawnBy::Rays), Strings()) << "a bright surface";
    scene.materials[1].Kd = {128, 0, 255};
    EXPECT_EQ(warnings_of(scene, view, DrawnBy::Rays),
              (Strings{"object 'ceiling' has Kd 255; expected 0 to 1, not 0 to 255"}));
    scene.fog = Fog{.color = vec3(128)};
    EXPECT_EQ(warnings_of(scene, view, DrawnBy::Rays),
              (Strings{"the fog is 128; expected 0 to 1, not 0 to 255"}));
    scene.background = vec3(255, 0, 0);
    EXPECT_EQ(warnings_of(scene, view, DrawnBy::Rays),
              (Strings{"the background is 255; expected 0 to 1, not 0 to 255"}));
}

TEST(WarningsOf, NameNormalsThatLookTheOtherWayThanTheirFaces) {
    Scene scene;
    add_quad(scene, "floor", level(0, 5, false));
    const View view = fitted_view({.eye = dvec3(0, 5, 8)}, scene, bounds(scene), 32, 24);
    MeshData data = scene.objects[0].mesh->data();
    data.normals.assign(4, {0, 1, 0});
    scene.objects[0].mesh = make_mesh(data);
    EXPECT_EQ(warnings_of(scene, view, DrawnBy::Passes), Strings());
    data.normals.assign(4, {0, -1, 0});
    scene.objects[0].mesh = make_mesh(data);
    EXPECT_EQ(warnings_of(scene, view, DrawnBy::Passes),
              (Strings{"object 'floor' has faces that are clockwise seen from where their normals "
                       "point, so it is lit from behind; expected them counter-clockwise"}));
}

TEST(WarningsOf, NameNormalsOfLength0) {
    Scene scene;
    add_quad(scene, "floor", level(0, 5, false));
    const View view = fitted_view({.eye = dvec3(0, 5, 8)}, scene, bounds(scene), 32, 24);
    MeshData data = scene.objects[0].mesh->data();
    data.normals.assign(4, {0, 1, 0});
    data.normals[2] = vec3(0);
    scene.objects[0].mesh = make_mesh(data);
    EXPECT_EQ(warnings_of(scene, view, DrawnBy::Rays),
              (Strings{"object 'floor' has normals of length 0, which no light reaches; expected "
                       "others, or none"}));
}

TEST(WarningsOf, NameALightThatRadiosityLeavesOut) {
    Scene scene = room(548.7f, true);
    scene.lights = {{.name = "highlights", .Id = {0, 0, 0}},
                    {.name = "lamp", .luminous = Luminous{}},
                    default_light({})};
    EXPECT_EQ(left_out_by_radiosity(scene), Strings());
    scene.lights.push_back({.name = scene.objects[0].name});  // its light for passes
    EXPECT_EQ(left_out_by_radiosity(scene), Strings());
    scene.lights.push_back({.name = "key"});
    EXPECT_EQ(
        left_out_by_radiosity(scene),
        (Strings{"light 'key' is not in candela or lumen, so radiosity leaves it out; expected "
                 "one of these, or an object that emits"}));
}

TEST(WarningsOf, ASceneWithoutObjectsIsNamedByEveryRenderer) {
    for (const DrawnBy by : {DrawnBy::Passes, DrawnBy::Depth, DrawnBy::Rays})
        EXPECT_EQ(warnings_of({}, {}, by),
                  Strings{"the scene has nothing to draw; expected an object"});
}

TEST(EmptyPicture, IsOneOfTheBackgroundAlone) {
    Scene scene = room(548.7f, true);
    std::vector<Rgba> picture(12, Rgba{0, 0, 0, 255});
    EXPECT_NE(empty_picture(scene, picture, 8), "");
    picture[7][1] = 1;
    EXPECT_EQ(empty_picture(scene, picture, 8), "");
    scene.background = {0.5f, 0.5f, 0.5f};
    EXPECT_EQ(empty_picture(scene, picture, 8), "") << "something dark stands before it";
    picture.assign(12, Rgba{128, 128, 128, 255});
    EXPECT_NE(empty_picture(scene, picture, 8), "");
    EXPECT_EQ(empty_picture({}, picture, 8), "") << "nothing to see";
}

}  // namespace
}  // namespace gw::scene
