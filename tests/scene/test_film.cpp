// Claims: between keys values follow steps, lines and cubics; a scene's tracks and a glTF file's
// animation set what they name, at each instant of a picture.
#include <gtest/gtest.h>

#include "scene/film.h"
#include "scene/geometry/transform.h"
#include "tests/scene/folder.h"
#include "tests/scene/gltf/gltf_text.h"

#include <cmath>

namespace gw::scene {
namespace {

using Numbers = std::vector<double>;

const std::string still = R"(
[camera]
eye = [0, 0, 5]
[[light]]
name = "sun"
direction = [0, -1, 0]
[material.red]
Kd = [1, 0, 0]
[[object]]
name = "ball"
shape = "sphere"
material = "red"
translate = [1, 0, 0]
)";

struct FilmOf : testing::Test {
    Folder folder;
    SceneFile read(const std::string& tracks) {
        return read_scene(folder.write("s.toml", still + tracks));
    }
    Scene at(const std::string& tracks, double time) {
        SceneFile file = read(tracks);
        file.films.at(0).pose(file.scene, time);
        return file.scene;
    }
    std::string error(const std::string& tracks) {
        return folder.scene_error("s.toml", still + tracks);
    }
};

std::string track(const std::string& what, const std::string& times, const std::string& values) {
    return "[[track]]\n" + what + "\ntimes = " + times + "\nvalues = " + values + "\n";
}

}  // namespace

TEST(Keys, AreMetAndHeldBeforeAndAfter) {
    for (const auto kind : {Interpolation::Step, Interpolation::Linear, Interpolation::Smooth}) {
        const Keys keys{{1, 2, 4}, {0, 5, 10, 6, 30, 7}, 2, kind};
        EXPECT_EQ(keys.at(0), (Numbers{0, 5}));
        EXPECT_EQ(keys.at(1), (Numbers{0, 5}));
        EXPECT_EQ(keys.at(2), (Numbers{10, 6}));
        EXPECT_EQ(keys.at(4), (Numbers{30, 7}));
        EXPECT_EQ(keys.at(9), (Numbers{30, 7}));
    }
}

TEST(Keys, AreJoinedByStepsLinesAndCubics) {
    EXPECT_EQ((Keys{{0, 2}, {0, 8}, 1, Interpolation::Step}.at(1.5)), Numbers{0});
    EXPECT_EQ((Keys{{0, 2}, {0, 8}, 1, Interpolation::Linear}.at(1.5)), Numbers{6});
    // A cubic through points of the parabola t^2 whose slopes are its own is the parabola.
    const Keys parabola{{0, 1, 2, 3}, {0, 1, 4, 9}, 1, Interpolation::Smooth};
    EXPECT_EQ(parabola.at(1.5), Numbers{2.25});
    const Keys given{{0, 2}, {0, 4}, 1, Interpolation::Smooth, {0, 4}, {0, 0}};
    EXPECT_EQ(given.at(1), Numbers{1});
}

TEST(Film, OpensItsShutterAboutThePicturesTime) {
    const Film film{.rate = 10, .shutter = 0.5, .instants = 2, .seconds = 1, .pose = {}};
    EXPECT_EQ(film.pictures(), 11);
    const Numbers instants = film.instants_of(3);
    ASSERT_EQ(instants.size(), 2u);
    EXPECT_DOUBLE_EQ(instants[0], 0.2 - 0.0125);
    EXPECT_DOUBLE_EQ(instants[1], 0.2 + 0.0125);
    EXPECT_EQ((Film{.rate = 4, .pose = {}}.instants_of(3)), Numbers{0.5});
}

TEST_F(FilmOf, TracksSetCameraLightMaterialAndObject) {
    const std::string all =
        track("key = 'eye'", "[0, 2]", "[[0, 0, 5], [4, 0, 5]]") +
        track("key = 'fov'", "[0, 2]", "[20, 40]") +
        track("light = 'sun'\nkey = 'Id'", "[0, 2]", "[[0, 0, 0], [1, 0.5, 0]]") +
        track("material = 'red'\nkey = 'd'", "[0, 2]", "[1, 0]") +
        track("object = 'ball'\nkey = 'translate'", "[0, 2]", "[[0, 0, 0], [0, 6, 0]]");
    const Scene s = at(all, 1);
    EXPECT_EQ(s.camera->eye, dvec3(2, 0, 5));
    EXPECT_EQ(s.camera->fov, 30);
    EXPECT_EQ(s.lights.at(0).Id, vec3(0.5f, 0.25f, 0));
    EXPECT_EQ(s.materials.at(s.objects.at(0).material).d, 0.5f);
    EXPECT_EQ(s.objects.at(0).world_from_object[3], dvec4(1, 3, 0, 1));
}

TEST_F(FilmOf, OneNumberIsAGreyOrAnEvenScale) {
    const Scene s = at(track("material = 'red'\nkey = 'Kd'", "[0, 1]", "[0.5, [1, 0, 0]]") +
                           track("object = 'ball'\nkey = 'scale'", "[0]", "[3]"),
                       0);
    EXPECT_EQ(s.materials.at(s.objects.at(0).material).Kd, vec3(0.5f));
    EXPECT_EQ(s.objects.at(0).world_from_object, translation({1, 0, 0}) * scaling(dvec3(3)));
    EXPECT_EQ(error(track("key = 'eye'", "[0]", "[5]")),
              "s.toml:17: track.values is 5; expected an array of 3 numbers");
}

TEST_F(FilmOf, TwoTracksOfOneThingAreAnError) {
    const std::string fov = track("key = 'fov'", "[0]", "[20]");
    EXPECT_EQ(error(fov + fov),
              "s.toml:18: track sets the same 'fov' as that of line 14; expected one track for it");
    EXPECT_EQ(error(fov + track("object = 'ball'\nkey = 'scale'", "[0]", "[1]")), "no error");
}

TEST_F(FilmOf, AnObjectTurnsAboutItsOwnOrigin) {
    const Scene s =
        at(track("object = 'ball'\nkey = 'rotate'", "[0, 1]", "[[0, 0, 0], [0, 0, 90]]") +
               track("object = 'ball'\nkey = 'scale'", "[0]", "[[2, 2, 2]]"),
           1);
    EXPECT_EQ(s.objects.at(0).world_from_object * dvec4(1, 0, 0, 1), dvec4(1, 2, 0, 1));
}

TEST_F(FilmOf, PosesDoNotDependOnThoseBefore) {
    SceneFile file =
        read(track("object = 'ball'\nkey = 'translate'", "[0, 2]", "[[0, 0, 0], [0, 6, 0]]"));
    file.films.at(0).pose(file.scene, 2);
    file.films.at(0).pose(file.scene, 1);
    EXPECT_EQ(file.scene.objects.at(0).world_from_object[3], dvec4(1, 3, 0, 1));
}

TEST_F(FilmOf, BadKeysAreOneErrorEach) {
    EXPECT_EQ(error(track("key = 'eyes'", "[0]", "[[0, 0, 5]]")).substr(0, 51),
              "s.toml:15: unknown value 'eyes'; the nearest known ");
    EXPECT_EQ(error(track("key = 'fov'", "[0, 0]", "[20, 30]")),
              "s.toml:16: track.times has 0 s after 0; expected increasing times");
    EXPECT_EQ(
        error(track("key = 'fov'", "[0, 1]", "[20]")),
        "s.toml:17: track.values is an array; expected an array of 2 values, one for each time");
    EXPECT_EQ(error(track("key = 'fov'", "[0]", "[200]")),
              "s.toml:17: track.values is 200; expected a number from 0.1 to 179");
    EXPECT_EQ(error(track("object = 'bal'\nkey = 'scale'", "[0]", "[[1, 1, 1]]")),
              "s.toml:15: unknown object 'bal'; the nearest known is 'ball'");
    EXPECT_EQ(error("[[track]]\nkey = 'fov'\n"), "s.toml:14: track has no times; expected it");
    EXPECT_EQ(error("[film]\nrate = 24\n"), "s.toml:14: film has no tracks; expected [[track]]");
    SceneFile file = read(track("key = 'at'", "[0, 1]", "[[0, 0, 0], [0, 0, 5]]"));
    EXPECT_EQ(folder.error([&] { file.films.at(0).pose(file.scene, 1); }),
              "camera at 1 s: at is the eye; expected another point");
}

TEST_F(FilmOf, GltfNodesMoveAsTheirSamplersSay) {
    const auto place = [&](const std::string& text, double time) {
        SceneFile file = read_scene(folder.write("m.gltf", text));
        file.films.at(0).pose(file.scene, time);
        return file.scene.objects.at(0).world_from_object;
    };
    const std::vector<float> way{0, 0, 0, 4, 8, 0};
    EXPECT_EQ(place(animated("translation", way, "VEC3"), 0.5)[3], dvec4(1, 2, 0, 1));
    EXPECT_EQ(place(animated("translation", way, "VEC3", "STEP"), 1.9)[3], dvec4(0, 0, 0, 1));
    // in-slope, value, out-slope of each key: a curve from 0 with slope 0 to 4 with slope 4, t^2
    EXPECT_EQ(place(animated("translation", {0, 0, 0, 0, 0, 0, 0, 0, 0, 4, 0, 0, 4, 0, 0, 0, 0, 0},
                             "VEC3", "CUBICSPLINE"),
                    1)[3],
              dvec4(1, 0, 0, 1));
    // From 0 to 180 degrees about z: 45 degrees after a quarter of the time.
    const dmat4 turned = place(animated("rotation", {0, 0, 0, 1, 0, 0, 1, 0}, "VEC4"), 0.5);
    EXPECT_NEAR(turned[0].x, std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(turned[0].y, std::sqrt(0.5), 1e-15);
}

TEST_F(FilmOf, EachGltfAnimationIsAFilm) {
    SceneFile file = read_scene(
        folder.write("m.gltf", with_hop(animated("translation", {1, 1, 1, 4, 8, 2}, "VEC3"))));
    ASSERT_EQ(file.films.size(), 2u);
    EXPECT_EQ(file.films[0].name, "hop");
    EXPECT_EQ(file.films[1].name, "");
    file.films[1].pose(file.scene, 2);
    EXPECT_EQ(file.scene.objects.at(0).world_from_object[3], dvec4(4, 8, 2, 1));
    file.films[0].pose(file.scene, 2);
    EXPECT_EQ(file.scene.objects.at(0).world_from_object, scaling({4, 8, 2}));
}

/// Scaled from nothing to a flat shape: no matrix is singular, and the flat one keeps its normals.
TEST_F(FilmOf, GltfScalesOf0HideOrFlatten) {
    const std::string text = animated("scale", {0, 0, 0, 2, 2, 0}, "VEC3", "STEP");
    SceneFile file = read_scene(folder.write(
        "m.gltf", replaced(text, R"("mesh": 0})", R"("mesh": 0, "scale": [0, 0, 0]})")));
    EXPECT_EQ(file.warnings, Strings{});
    ASSERT_EQ(file.scene.objects.size(), 1u);
    file.films.at(0).pose(file.scene, 0);
    EXPECT_EQ(file.scene.objects[0].world_from_object, scaling(dvec3(1e-9)));
    file.films.at(0).pose(file.scene, 2);
    const dmat4 flat = file.scene.objects[0].world_from_object;
    EXPECT_EQ(flat[0], dvec4(2, 0, 0, 0));
    EXPECT_EQ(flat[1], dvec4(0, 2, 0, 0));
    EXPECT_NEAR(flat[2].z, std::sqrt(8) * 1e-6, 1e-18);
}

TEST_F(FilmOf, AViewKeepsItsCameraAndItsLights) {
    folder.write("s.toml",
                 still + "[[light]]\nname = 'moon'\ndirection = [0, 0, -1]\n" +
                     track("key = 'eye'", "[0, 2]", "[[0, 0, 5], [4, 0, 5]]") +
                     track("light = 'moon'\nkey = 'Ia'", "[0, 2]", "[[0, 0, 0], [1, 1, 1]]"));
    const auto at_1 = [&](const std::string& view) {
        SceneFile file = read_scene(folder.write("v.toml", "base = 's.toml'\n" + view));
        file.films.at(0).pose(file.scene, 1);
        return file.scene;
    };
    EXPECT_EQ(at_1("").camera->eye, dvec3(2, 0, 5));
    const Scene own = at_1("lights_off = [1]\n[camera]\neye = [0, 9, 9]\n");
    EXPECT_EQ(own.camera->eye, dvec3(0, 9, 9));
    ASSERT_EQ(own.lights.size(), 1u);
    EXPECT_EQ(own.lights[0].Ia, vec3(0.5f));
    const Scene dark = at_1("lights_off = [1, 2]\n");
    ASSERT_EQ(dark.lights.size(), 1u);
    EXPECT_EQ(dark.lights[0].Id, vec3(0));
}

TEST_F(FilmOf, BadGltfSamplersAreOneErrorEach) {
    const std::string good = animated("translation", {0, 0, 0, 4, 8, 0}, "VEC3");
    const auto with = [&](const std::string& from, const std::string& to) {
        return folder.scene_error("m.gltf", replaced(good, from, to));
    };
    EXPECT_EQ(with("\"output\": 3", "\"output\": 2"),
              "m.gltf: accessors[2].type is 'SCALAR'; expected VEC3");
    EXPECT_EQ(with("LINEAR", "CUBICSPLINE"),
              "m.gltf: animations[0].samplers[0].output has 2 elements; expected 6 for 2 times");
    EXPECT_EQ(
        with("LINEAR", "LINER"),
        "m.gltf: animations[0].samplers[0].interpolation is 'LINER'; expected STEP, LINEAR or CUBICSPLINE");
    EXPECT_EQ(
        with("\"sampler\": 0", "\"sampler\": 1"),
        "m.gltf: animations[0].channels[0].sampler is 1; expected a whole number from 0 to 0");
    EXPECT_EQ(
        with("\"node\": 0", "\"node\": 1"),
        "m.gltf: animations[0].channels[0].target.node is 1; expected a whole number from 0 to 0");
}

}  // namespace gw::scene
