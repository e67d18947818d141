// Claims: what gw view saves, gw render draws with the same bits, for every setting; while the view
// moves, less work is done and said; passes, algorithms and light are those of the layers.
#include "apps/view/orbit.h"
#include "apps/view/viewer.h"
#include "test_paths.h"
#include "tests/apps/scene_files.h"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

namespace gw::apps {
namespace {

using Kind = Input::Kind;

class ViewerTest : public SceneTest {
protected:
    ViewerTest() {
        write("room.toml", R"(background = [0.1, 0.1, 0.2]
texels = 2
[camera]
eye = [0, 2, 6]
at = [0, 0.5, 0]
[fog]
mode = "linear"
color = [0.5, 0.5, 0.5]
start = 4
end = 12
[[light]]
name = "left"
position = [-3, 5, 3]
Ia = 0.2
Id = 0.6
shadow = "volume"
[[light]]
name = "right"
position = [3, 5, 3]
Id = [0.5, 0.2, 0.1]
shadow = "map"
[[object]]
name = "floor"
shape = "rectangle"
width = 8
depth = 8
columns = 8
rows = 8
material = {Ka = 0.6, Kd = 0.6}
[[object]]
name = "ball"
shape = "sphere"
radius = 0.8
translate = [0, 1, 0]
material = {Kd = [0.2, 0.4, 0.8], Ks = 0.5, Ns = 30, illum = 3}
[[object]]
name = "lamp"
shape = "box"
width = 1
height = 0.1
depth = 1
translate = [0, 2.3, 0]
material = {Ka = 0, Kd = 0.5, Ke = 1}
)");
    }

    std::unique_ptr<Viewer> viewer(const std::string& scene, PictureOptions options = {}) const {
        options.scene = in(scene);
        if (options.size == Size{}) options.size = {64, 48};
        options.quiet = true;
        Session session;
        ViewedScene viewed = load_viewed_scene(options, in("."), session);
        const Settings settings{.picture = options, .camera = *viewed.scene.camera};
        return std::make_unique<Viewer>(std::move(viewed), settings);
    }

    static void press(Viewer& viewer, const std::vector<std::string>& keys) {
        for (const std::string& key : keys) viewer.handle({.kind = Kind::Key, .key = key});
        viewer.settle();
    }
    static void drag(Viewer& viewer, int x, int y, int to_x, int to_y, bool ctrl = false) {
        viewer.handle({.kind = Kind::Press, .x = x, .y = y, .ctrl = ctrl});
        viewer.handle({.kind = Kind::Move, .x = to_x, .y = to_y});
        viewer.handle({.kind = Kind::Release, .x = to_x, .y = to_y});
        viewer.settle();
    }

    /// Saves view and picture as `stem`_view_001 and draws the view with the command.
    void expect_command_draws_the_same(Viewer& viewer, const std::string& stem) {
        press(viewer, {"s", "p"});
        const std::string view = stem + "_view_001.toml", picture = stem + "_view_001.png";
        EXPECT_EQ(viewer.message(), "saved " + picture);
        const Outcome drawn = gw({"render", view, "-o", "drawn.png", "--quiet"});
        EXPECT_EQ(drawn.code, 0) << drawn.err << bytes_of(in(view));
        EXPECT_EQ(bytes_of(in("drawn.png")), bytes_of(in(picture))) << bytes_of(in(view));
        EXPECT_FALSE(bytes_of(in(picture)).empty());
        for (const std::string& file : {view, picture}) std::filesystem::remove(in(file));
    }
};

}  // namespace

TEST_F(ViewerTest, BeginsWithThePictureOfTheCommand) {
    const auto shown = viewer("room.toml");
    shown->settle();
    press(*shown, {"p"});
    ASSERT_EQ(gw({"render", "room.toml", "-o", "drawn.png", "--size", "64x48"}).code, 0);
    EXPECT_EQ(bytes_of(in("drawn.png")), bytes_of(in("room_view_001.png")));
}

TEST_F(ViewerTest, SavesViewsThatTheCommandDrawsWithTheSameBits) {
    const auto shown = viewer("room.toml");
    for (const std::vector<std::string>& keys :
         std::vector<std::vector<std::string>>{{"Left", "Up"},
                                               {"1"},
                                               {"2"},
                                               {"1", "2"},
                                               {"g"},
                                               {"a", "a"},
                                               {"w"},
                                               {"w"},
                                               {"w"},
                                               {"e"},
                                               {"d"},
                                               {"t"},
                                               {"f"},
                                               {"r"},
                                               {"r"},
                                               {"r"},
                                               {"r"},
                                               {"+"}}) {
        press(*shown, keys);
        EXPECT_EQ(shown->frame().fault, "");
        expect_command_draws_the_same(*shown, "room");
    }
}

TEST_F(ViewerTest, SavesTheDefaultLightAndTheFittedCamera) {
    const auto shown = viewer("quad.obj");
    expect_command_draws_the_same(*shown, "quad");
    drag(*shown, 30, 20, 45, 28);
    expect_command_draws_the_same(*shown, "quad");
    press(*shown, {"1"});
    expect_command_draws_the_same(*shown, "quad");
}

TEST_F(ViewerTest, SavesAViewOfAView) {
    const auto first = viewer("room.toml");
    press(*first, {"1", "g", "Left", "s"});
    PictureOptions options;
    const auto again = viewer("room_view_001.toml", options);
    press(*again, {"1", "Up"});
    expect_command_draws_the_same(*again, "room_view_001");
}

TEST_F(ViewerTest, MouseOrbitsPansAndZooms) {
    const auto shown = viewer("room.toml");
    const scene::Camera before = shown->settings().camera;
    drag(*shown, 10, 10, 34, 10);
    const scene::Camera turned = shown->settings().camera;
    EXPECT_EQ(turned.at, before.at);
    EXPECT_NEAR(length(turned.eye - turned.at), length(before.eye - before.at), 1e-9);
    EXPECT_NEAR(turned.eye.y, before.eye.y, 1e-9);
    EXPECT_GT(length(turned.eye - before.eye), 1);
    shown->handle({.kind = Kind::Press, .x = 10, .y = 10, .shift = true});
    shown->handle({.kind = Kind::Move, .x = 20, .y = 10});
    shown->handle({.kind = Kind::Release, .x = 20, .y = 10});
    const scene::Camera moved = shown->settings().camera;
    EXPECT_NEAR(length((moved.eye - moved.at) - (turned.eye - turned.at)), 0, 1e-9);
    EXPECT_GT(length(moved.at - turned.at), 0.1);
    shown->handle({.kind = Kind::Wheel, .wheel = 1});
    EXPECT_NEAR(length(shown->settings().camera.eye - moved.at), 0.9 * length(moved.eye - moved.at),
                1e-9);
    press(*shown, {"Home"});
    EXPECT_EQ(shown->settings().camera.eye, before.eye);
}

TEST(Orbit, StaysOffThePoles) {
    scene::Camera camera{.eye = {0, 1, 5}};
    for (int i = 0; i < 40; ++i) camera = orbited(camera, 3, 10);
    EXPECT_LT(camera.eye.y, length(camera.eye));
    EXPECT_GT(camera.eye.y, 0.99 * length(camera.eye));
    for (int i = 0; i < 40; ++i) camera = orbited(camera, 3, -10);
    EXPECT_LT(camera.eye.y, -0.99 * length(camera.eye));
    scene::Camera above{.eye = {0, 5, 0}};
    EXPECT_LT(orbited(above, 0, -10).eye.y, 5);
}

TEST(LessWork, LeavesOutSamplesThenRaysThenPasses) {
    Settings settings;
    settings.picture.samples = 8;
    const auto steps = less_work(settings);
    ASSERT_EQ(steps.size(), 4u);
    EXPECT_EQ(steps[0].left_out, "");
    EXPECT_EQ(key_of(steps[0].settings), key_of(settings));
    EXPECT_EQ(steps[1].left_out, "1 sample");
    EXPECT_EQ(steps[2].left_out, "1 sample, no rays");
    EXPECT_EQ(steps[3].left_out, "1 sample, no rays, one pass");
    EXPECT_EQ(steps[3].settings.picture.renderer, "hardware");
    settings.picture = {{.renderer = "hardware"}};
    EXPECT_EQ(less_work(settings).size(), 1u);
}

TEST_F(ViewerTest, ShowsPassesWithThePapersTuple) {
    const auto shown = viewer("room.toml");
    press(*shown, {"Tab"});
    ASSERT_TRUE(shown->frame().by_pass);
    const auto& passes = shown->frame().passes;
    ASSERT_EQ(passes.size(), shown->frame().by_pass->passes());
    const auto named = [&](const std::string& name) {
        return std::find_if(passes.begin(), passes.end(),
                            [&](const FramePass& pass) { return pass.name == name; });
    };
    ASSERT_NE(named("ambient left"), passes.end());
    EXPECT_EQ(named("ambient left")->set, "(Ka=object, Kd=0, Ks=0, Ke=0, Map=ambient map)");
    const image::Picture first = shown->screen();
    press(*shown, std::vector<std::string>(passes.size(), "."));
    EXPECT_NE(shown->screen(), first);
    // The last pass's colour plane is the picture.
    press(*shown, {"z"});
    const image::Picture screen = shown->screen();
    press(*shown, {"Tab"});
    const image::Picture whole = shown->screen();
    for (int y = 0; y < 48; ++y)
        for (int i = 0; i < 3 * 64; ++i) {
            const auto at = std::size_t(3 * (screen.height - 1 - y) * screen.width + i);
            ASSERT_EQ(screen.values[at], whole.values[at]);
        }
}

TEST_F(ViewerTest, ShowsHiddenSurfaceAlgorithms) {
    const auto shown = viewer("room.toml");
    press(*shown, {"h"});
    EXPECT_EQ(shown->show(), Viewer::Show::Hidden);
    ASSERT_FALSE(shown->frame().notes.empty());
    EXPECT_FALSE(shown->frame().picture.values.empty());
    press(*shown, {"H"});
    EXPECT_EQ(shown->show(), Viewer::Show::Picture);
}

TEST_F(ViewerTest, LightGoesOnAfterChanges) {
    const auto shown = viewer("room.toml");
    press(*shown, {"l"});
    ASSERT_TRUE(shown->light());
    EXPECT_EQ(shown->light()->fault, "");
    EXPECT_GT(shown->light()->shots, 0);
    EXPECT_LE(shown->light()->unshot, 0.01);
    const auto mean_of = [](const image::Picture& picture) {
        double sum = 0;
        for (const auto v : picture.values) sum += v;
        return sum / double(picture.values.size());
    };
    const double before = mean_of(shown->frame().picture);
    // The lamp's lower side is at the top of the picture: dim it there.
    int x = -1, y = -1;
    for (int row = 0; row < 48 && y < 0; ++row) {
        shown->handle({.kind = Kind::Move, .x = 32, .y = row});
        shown->handle({.kind = Kind::Key, .key = "["});
        if (shown->message() == "lamp times 0.8") {
            x = 32;
            y = row;
        }
    }
    ASSERT_GE(y, 0) << "no lamp in the picture";
    shown->settle();
    EXPECT_LT(mean_of(shown->frame().picture), before);
    const auto emission = [&] {
        const Light now = *shown->light();
        for (const radiosity::Figure& figure : now.model->figures)
            if (figure.name == "lamp") return figure.E.x;
        return 0.0;
    };
    EXPECT_DOUBLE_EQ(emission(), double(0.8f));
    const auto middle = [&] {
        const Light now = *shown->light();
        return scene::bounds(now.model->drawn);
    };
    const dvec3 high = middle().high;
    drag(*shown, x, y, x + 200, y, true);
    EXPECT_GT(middle().high.x + middle().high.z, high.x + high.z) << "the lamp did not move";
    EXPECT_EQ(shown->light()->fault, "");
    press(*shown, {"s"});
    const std::string saved = bytes_of(in("room_view_001.toml"));
    EXPECT_NE(saved.find("--change 'lamp:dim=0.8'"), saved.npos) << saved;
    EXPECT_NE(saved.find("--change 'lamp:move="), saved.npos) << saved;
}

/// The words of the command in a saved view's first line.
std::vector<std::string> light_command_of(const std::string& view) {
    std::istringstream line(view.substr(0, view.find('\n')));
    std::vector<std::string> words;
    for (std::string word; line >> word;) {
        std::erase(word, '\'');
        words.push_back(word);
    }
    EXPECT_EQ(std::vector(words.begin(), words.begin() + 4),
              (std::vector<std::string>{"#", "The", "light:", "gw"}));
    return {words.begin() + 4, words.end()};
}

// Whatever the window shows of the light, before it has settled too: exposure, shots, camera, size
// and the window's profile, which the picture of the light does not have.
TEST_F(ViewerTest, SavesViewsWhoseLightTheCommandDrawsWithTheSameBits) {
    int number = 0;
    const auto expect_same = [&](Viewer& shown, const std::string& picture) {
        press(shown, {"s", "p"});
        const std::string name = fmt::format("room_view_{:03}", ++number);
        const Outcome outcome = gw(light_command_of(bytes_of(in(name + ".toml"))));
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(bytes_of(in("light/" + picture)), bytes_of(in(name + ".png")))
            << bytes_of(in(name + ".toml"));
    };
    const auto shown = viewer("room.toml");
    for (const std::vector<std::string>& keys :
         std::vector<std::vector<std::string>>{{"n"},
                                               {"n", "n"},
                                               {"x"},
                                               {"X", "X", "X"},
                                               {"Left", "Up"},
                                               {"+"},
                                               {"l", "f", "l"},
                                               {"l", "g", "1", "a", "l"},
                                               {"Space"}}) {
        press(*shown, keys);
        ASSERT_EQ(shown->show(), Viewer::Show::Light);
        expect_same(*shown, "picture.png");
    }
    const auto large = viewer("room.toml", {{.size = {100, 30}}});
    press(*large, {"l"});
    expect_same(*large, "picture.png");
    for (int row = 0; row < 30 && large->message() != "lamp times 1.25"; ++row) {
        large->handle({.kind = Kind::Move, .x = 50, .y = row});
        large->handle({.kind = Kind::Key, .key = "]"});
    }
    large->settle();
    expect_same(*large, "changed.png");
}

TEST_F(ViewerTest, SaysWhatCannotBeShown) {
    const auto shown = viewer("lamps.toml");
    press(*shown, {"l"});
    EXPECT_NE(shown->light()->fault.find("nothing emits light"), std::string::npos);
    press(*shown, {"l", "g"});
    EXPECT_EQ(shown->message(), "the scene has no fog");
    press(*shown, {"9"});
    EXPECT_EQ(shown->message(), "no light 9");
    EXPECT_TRUE(shown->frame().fault.empty());
}

TEST_F(ViewerTest, HistoryOfThePixelUnderTheMouse) {
    const auto shown = viewer("lamps.toml");
    shown->settle();
    const image::Picture before = shown->screen();
    shown->handle({.kind = Kind::Move, .x = 32, .y = 24});
    press(*shown, {"i"});
    EXPECT_NE(shown->screen(), before);
    press(*shown, {"i"});
    EXPECT_EQ(shown->message(), "");
    shown->handle({.kind = Kind::Move, .x = 3200, .y = 24});
    press(*shown, {"i"});
    EXPECT_EQ(shown->message(), "no pixel here");
}

TEST_F(ViewerTest, NeverSavesOverAnything) {
    const auto shown = viewer("room.toml");
    press(*shown, {"s", "s", "p"});
    EXPECT_TRUE(std::filesystem::exists(in("room_view_001.toml")));
    EXPECT_TRUE(std::filesystem::exists(in("room_view_002.toml")));
}

TEST_F(ViewerTest, NeedsADisplay) {
    const Outcome outcome =
        run_process({"/bin/sh", "-c",
                     "env -u DISPLAY -u WAYLAND_DISPLAY -u SDL_VIDEODRIVER '" GW_BIN_DIR
                     "/gw' view lamps.toml"},
                    {.folder = in(".")});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(outcome.err.substr(0, 22), "gw: gw view: no window");
    EXPECT_NE(outcome.err.find("expected a display"), std::string::npos);
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
    const Outcome wrong =
        run_process({"/bin/sh", "-c",
                     "env -u WAYLAND_DISPLAY -u SDL_VIDEODRIVER DISPLAY=:1234 '" GW_BIN_DIR
                     "/gw' view lamps.toml"},
                    {.folder = in(".")});
    EXPECT_EQ(wrong.code, 1);
    EXPECT_EQ(wrong.err.substr(0, 22), "gw: gw view: no window");
}

}  // namespace gw::apps
