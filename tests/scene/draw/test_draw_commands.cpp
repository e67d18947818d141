// How a scene becomes draw commands.
#include "scene/draw/draw_commands.h"

#include "scene/draw/shading.h"

#include <gtest/gtest.h>

namespace gw::scene {
namespace {

MeshRef two_triangles() {
    return make_mesh({.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
                      .texcoords = {{0, 0}, {1, 0}, {0, 1}, {1, 1}},
                      .indices = {0, 1, 2, 2, 1, 3}});
}

Scene three_objects() {
    Scene scene;
    scene.materials.resize(1);
    for (const char* name : {"a", "b", "c"})
        scene.objects.push_back({.name = name, .mesh = two_triangles()});
    scene.camera = Camera{};
    return scene;
}

template <typename T>
std::vector<const T*> all(const CommandList& list) {
    std::vector<const T*> found;
    for (const Command& c : list.commands)
        if (const T* t = std::get_if<T>(&c)) found.push_back(t);
    return found;
}

TEST(EyeLight, DirectionalPointsTowardsTheLight) {
    const View view = make_view({.eye = {0, 0, 5}}, {}, 8, 8);
    const gw::Light light = eye_light({.direction = {0, -1, 0}, .Id = vec3(0.5f)}, view);
    EXPECT_EQ(light.position, vec4(0, 1, 0, 0));
    EXPECT_EQ(light.Is, vec3(0.5f)) << "Is is Id where it is not given";
}

TEST(EyeLight, PointMovesWithTheEye) {
    const View view = make_view({.eye = {0, 0, 5}}, {}, 8, 8);
    const gw::Light light = eye_light({.kind = LightKind::Point,
                                       .position = {1, 2, 3},
                                       .Is = vec3(0),
                                       .quadratic_attenuation = 2},
                                      view);
    EXPECT_EQ(light.position, vec4(1, 2, -2, 1));
    EXPECT_EQ(light.Is, vec3(0));
    EXPECT_EQ(light.quadratic_attenuation, 2);
    EXPECT_EQ(light.spot_cos_cutoff, -1);
}

TEST(EyeLight, SpotHasItsConesCosine) {
    const View view = make_view({.eye = {0, 0, 5}}, {}, 8, 8);
    const gw::Light light =
        eye_light({.kind = LightKind::Spot, .direction = {0, 0, -1}, .cone_angle = 60}, view);
    EXPECT_EQ(light.spot_direction, vec3(0, 0, -1));
    EXPECT_NEAR(light.spot_cos_cutoff, 0.5, 1e-7);
}

TEST(Placed, IsEyeFromWorldTimesWorldFromObject) {
    const View view = make_view({.eye = {0, 0, 5}}, {}, 8, 8);
    Object object{.mesh = two_triangles()};
    object.world_from_object[3] = dvec4(1, 2, 3, 1);
    EXPECT_EQ(placed(object, view).eye_from_object[3], dvec4(1, 2, -2, 1));
}

TEST(MappedMesh, IsTheSameMeshWhereTheMapChangesNothing) {
    const MeshRef mesh = two_triangles();
    EXPECT_EQ(mapped_mesh(mesh, {}), mesh);
    const MeshRef moved = mapped_mesh(mesh, {.offset = {0.5f, 0}, .scale = {2, 3}});
    EXPECT_EQ(moved->data().texcoords[3], vec2(2.5f, 3));
    EXPECT_EQ(moved->data().positions, mesh->data().positions);
}

TEST(LightsObject, ByNameOrAll) {
    EXPECT_TRUE(lights_object({}, {.name = "a"}));
    EXPECT_TRUE(lights_object({.only = {"b", "a"}}, {.name = "a"}));
    EXPECT_FALSE(lights_object({.only = {"b"}}, {.name = "a"}));
}

TEST(PolygonIds, CountOverTheSceneFromOne) {
    const PolygonIds ids = polygon_ids(three_objects());
    EXPECT_EQ(ids.first, (std::vector<std::uint32_t>{1, 3, 5}));
    EXPECT_EQ(polygon_of(ids, 0), std::nullopt);
    EXPECT_EQ(polygon_of(ids, 1), (PolygonRef{0, 0}));
    EXPECT_EQ(polygon_of(ids, 4), (PolygonRef{1, 1}));
    EXPECT_EQ(polygon_of(ids, 6), (PolygonRef{2, 1}));
}

TEST(PolygonIds, AreDenseWhereMeshesAreNumberedOverTheScene) {
    Scene scene = three_objects();
    for (std::uint32_t i = 0; i < 3; ++i) {
        MeshData data = scene.objects[i].mesh->data();
        data.polygon_ids = {100 * i, 100 * i + 1};
        scene.objects[i].mesh = make_mesh(data);
    }
    const PolygonIds ids = polygon_ids(scene);
    EXPECT_EQ(ids.first, (std::vector<std::uint32_t>{1, 3, 5}));
    EXPECT_EQ(ids.lowest, (std::vector<std::uint32_t>{0, 100, 200}));
    EXPECT_EQ(polygon_of(ids, 6), (PolygonRef{2, 1}));
}

TEST(IdPass, DrawsEveryObjectWithItsIdentifiers) {
    const Scene scene = three_objects();
    const CommandList list = id_pass(scene, make_view(scene, 8, 8));
    ASSERT_EQ(all<SetState>(list).size(), 1u);
    EXPECT_EQ(all<SetState>(list)[0]->state->color_source, ColorSource::PolygonId);
    const auto draws = all<Draw>(list);
    ASSERT_EQ(draws.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(draws[i]->id_base, polygon_ids(scene).first[i]);
}

TEST(Components, AmbientHasTheDiffuseMapUnlessItHasItsOwn) {
    Material material;
    material.map_Kd.push_back({.file = "wood.png"});
    EXPECT_EQ(maps(material, Component::Ambient)[0].file, "wood.png");
    material.map_Ka.push_back({.file = "dark.png"});
    EXPECT_EQ(maps(material, Component::Ambient)[0].file, "dark.png");
    EXPECT_EQ(hardware_map(material)->file, "wood.png");
}

TEST(Components, ReflectionExistsThroughItsMap) {
    Material material{.Ks = vec3(1)};
    EXPECT_TRUE(has_component(material, Component::Specular));
    EXPECT_FALSE(has_component(material, Component::Reflection));
    material.refl.push_back({});
    EXPECT_TRUE(has_component(material, Component::Reflection));
}

}  // namespace
}  // namespace gw::scene
