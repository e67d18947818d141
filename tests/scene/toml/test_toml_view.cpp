// Claims: a view's keys change its base and nothing else; what to_toml writes is read back as the
// same numbers; every mistake is one error with file and line.
#include <gtest/gtest.h>

#include "gw/error.h"
#include "scene/toml/toml_view.h"
#include "tests/scene/folder.h"

namespace gw::scene {
namespace {

constexpr const char* base_text = R"(background = [0.1, 0.2, 0.3]
[camera]
eye = [1, 2, 3]
[fog]
[[light]]
name = "a"
direction = [0, -1, 0]
[[light]]
name = "b"
direction = [1, -1, 0]
[[object]]
shape = "box"
)";

struct TomlView : testing::Test {
    Folder folder;
    TomlView() { folder.write("base.toml", base_text); }

    Scene read(const std::string& text) {
        folder.write("view.toml", text);
        return read_scene(folder / "view.toml").scene;
    }
    std::string error_of(const std::string& text) {
        try {
            read(text);
        } catch (const Error& error) {
            const std::string what = error.what();
            return what.substr(what.rfind('/') + 1);
        }
        return "no error";
    }
};

}  // namespace

TEST_F(TomlView, KeepsAllThatItDoesNotName) {
    const Scene scene = read("base = 'base.toml'\n");
    EXPECT_EQ(scene.name, "view");
    EXPECT_EQ(scene.camera->eye, dvec3(1, 2, 3));
    EXPECT_EQ(scene.lights.size(), 2u);
    EXPECT_TRUE(scene.fog);
    EXPECT_EQ(scene.objects.size(), 1u);
}

TEST_F(TomlView, IsReadBackAsItWasWritten) {
    SavedView view{.base = "base.toml",
                   .camera = {.eye = {0.1, 1.0 / 3, -1e-7},
                              .at = {1e10, 0, 2},
                              .up = {0, 0, 1},
                              .fov = 33.3,
                              .near_plane = 0.125,
                              .far_plane = 77,
                              .aperture = 0.01,
                              .focus = 4},
                   .fog = false,
                   .lights_off = {0},
                   .light = Light{.name = "say \"so\"",
                                  .direction = {0.1f, -0.7f, 1e-8f},
                                  .Ia = vec3(0.3f),
                                  .Id = vec3(0.1f, 0.2f, 0.3f),
                                  .Is = vec3(0.7f)},
                   .options = {{"samples", "4"}, {"profile", "my profile.toml"}}};
    const Scene scene = read(to_toml(view));
    EXPECT_EQ(scene.camera->eye, view.camera.eye);
    EXPECT_EQ(scene.camera->at, view.camera.at);
    EXPECT_EQ(scene.camera->up, view.camera.up);
    EXPECT_EQ(scene.camera->fov, view.camera.fov);
    EXPECT_EQ(scene.camera->near_plane, view.camera.near_plane);
    EXPECT_EQ(scene.camera->far_plane, view.camera.far_plane);
    EXPECT_EQ(scene.camera->aperture, view.camera.aperture);
    EXPECT_EQ(scene.camera->focus, view.camera.focus);
    view.camera = {.eye = {0, 0, 9}, .ortho_height = 1.0 / 7};
    EXPECT_EQ(read(to_toml(view)).camera->ortho_height, 1.0 / 7);
    EXPECT_FALSE(scene.fog);
    ASSERT_EQ(scene.lights.size(), 2u);
    EXPECT_EQ(scene.lights[0].name, "b");
    EXPECT_EQ(scene.lights[1].name, "say \"so\"");
    EXPECT_EQ(scene.lights[1].direction, view.light->direction);
    EXPECT_EQ(scene.lights[1].Ia, view.light->Ia);
    EXPECT_EQ(scene.lights[1].Id, view.light->Id);
    EXPECT_EQ(*scene.lights[1].Is, *view.light->Is);
    const auto options = saved_options(folder / "view.toml");
    ASSERT_EQ(options.size(), 2u);
    EXPECT_EQ(options[1].name, "profile");
    EXPECT_EQ(options[1].word, "my profile.toml");
    EXPECT_GT(options[1].origin.line, 1);
}

TEST_F(TomlView, WithoutLightsHasABlackOne) {
    const Scene scene = read("base = 'base.toml'\nlights_off = [1, 2]\n");
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].Id, vec3(0));
    EXPECT_EQ(scene.lights[0].Ia, vec3(0));
}

TEST_F(TomlView, OfAViewChangesIt) {
    folder.write("inner.toml",
                 "# first\n\nbase = 'base.toml'\nlights_off = [1]\n[picture]\nsamples = 2\n");
    const Scene scene = read("base = 'inner.toml'\nfog = false\n[picture]\nsamples = 8\n");
    EXPECT_EQ(scene.lights.size(), 1u);
    EXPECT_FALSE(scene.fog);
    const auto options = saved_options(folder / "view.toml");
    ASSERT_EQ(options.size(), 2u);
    EXPECT_EQ(options[0].word, "8");
    EXPECT_EQ(options[1].word, "2");
}

TEST_F(TomlView, NamesEveryMistake) {
    EXPECT_EQ(error_of("base = 'none.toml'\n"),
              "view.toml:1: base 'none.toml' does not exist; expected a scene");
    EXPECT_EQ(error_of("base = ''\n"),
              "view.toml:1: base names no file; expected a scene's file name");
    EXPECT_EQ(error_of("fog = false\nbase = 'base.toml'\n"),
              "view.toml:2: base stands behind 'fog'; expected it as the first statement");
    EXPECT_EQ(error_of("base = 'base.toml'\nlights_off = [3]\n").substr(0, 12), "view.toml:2:");
    EXPECT_EQ(error_of("base = 'base.toml'\nlights_off = 1\n"),
              "view.toml:2: lights_off is 1; expected an array of lights' numbers");
    EXPECT_NE(
        error_of("base = 'base.toml'\n[[object]]\nshape = 'box'\n").find("unknown key 'object'"),
        std::string::npos);
    EXPECT_NE(error_of("base = 'view.toml'\n").find("expected a scene that is no view"),
              std::string::npos);
    EXPECT_EQ(error_of("base = 7\n").substr(0, 12), "view.toml:1:");
}

TEST_F(TomlView, IsKnownByItsFirstStatement) {
    folder.write("view.toml", "\xEF\xBB\xBF# text\n\n  base= 'base.toml'\n");
    EXPECT_TRUE(is_view(folder / "view.toml"));
    folder.write("view.toml", "name = 'x'\nbase = 'base.toml'\n");
    EXPECT_FALSE(is_view(folder / "view.toml"));
    EXPECT_FALSE(is_view(folder / "base.toml"));
    EXPECT_FALSE(is_view(folder / "missing.toml"));
}

}  // namespace gw::scene
