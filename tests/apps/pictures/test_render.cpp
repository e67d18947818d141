// gw render: what it writes.
#include "tests/apps/pictures.h"
#include "tests/apps/scene_files.h"

#include <nlohmann/json.hpp>

#include <regex>

namespace gw::apps {

using Render = SceneTest;

TEST_F(Render, WritesThePictureInEachUsualFormatAndNothingElse) {
    for (const std::string name : {"a.png", "a.exr", "a.tif"}) {
        const auto before = names();
        const Outcome outcome = render({"lamps.toml", "-o", name});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(outcome.out + outcome.err, "");
        EXPECT_EQ(names().size(), before.size() + 1);
        const Pixels pixels = read_pixels(in(name));
        EXPECT_EQ(pixels.width, 16);
        EXPECT_EQ(pixels.height, 16);
        ASSERT_EQ(pixels.channels, 3);
        EXPECT_EQ(pixels.at(0, 0), (std::vector<float>{0, 0, 0}));
        EXPECT_GT(pixels.at(8, 8)[0], pixels.at(8, 8)[1]);  // lamp 2 is reddish
        EXPECT_GT(pixels.at(8, 8)[1], pixels.at(8, 8)[2]);
        EXPECT_GT(pixels.at(8, 8)[2], 0);
    }
}

// OpenImageIO's libraries take longer to load than most pictures to draw (docs/decisions/009).
TEST_F(Render, LoadsOtherFormatsOnlyWherePngIsNotEnough) {
    ::setenv("LD_DEBUG", "libs", 1);
    const Outcome png = render({"lamps.toml", "-o", "a.png"}),
                  tif = render({"lamps.toml", "-o", "a.tif"});
    ::unsetenv("LD_DEBUG");
    EXPECT_EQ(png.code + tif.code, 0);
    EXPECT_NE(png.err.find("libpng"), png.err.npos);
    EXPECT_EQ(png.err.find("OpenImageIO"), png.err.npos);
    EXPECT_NE(tif.err.find("OpenImageIO"), tif.err.npos);
}

TEST_F(Render, DrawsABareObjWithCameraAndLightFitted) {
    EXPECT_EQ(render({"quad.obj", "-o", "a.png"}).code, 0);
    const Pixels pixels = read_pixels(in("a.png"));
    EXPECT_GT(pixels.at(8, 8)[0], 0.1f);
}

TEST_F(Render, WritesTheProfilesBits) {
    EXPECT_EQ(render({"lamps.toml", "-o", "vgx.tif"}).code, 0);
    EXPECT_EQ(render({"lamps.toml", "-o", "reality.tif", "--profile", "reality"}).code, 0);
    EXPECT_EQ(judge::stored_in<float>(in("vgx.tif")).spec.format, judge::Sample::U8);
    EXPECT_EQ(judge::stored_in<float>(in("reality.tif")).spec.format, judge::Sample::U16);
}

TEST_F(Render, TakesAProfileFromAFile) {
    write("mine.toml", "base = \"ideal\"\ncolor_bits = 12\nlit_bits = 12\n");
    EXPECT_EQ(
        render({"lamps.toml", "-o", "a.png", "--profile", "mine.toml", "--manifest", "m.json"})
            .code,
        0);
    const auto profile = nlohmann::json::parse(bytes_of(in("m.json")))["profile"];
    EXPECT_EQ(profile["name"], "mine");
    EXPECT_EQ(profile["color_bits"], 12);
    EXPECT_EQ(profile["subpixel_bits"], 8);
}

TEST_F(Render, GivesTheSameFilesForAnyNumberOfThreads) {
    EXPECT_EQ(render({"lamps.toml", "-o", "a.png", "--threads", "1", "--manifest", "a.json"}).code,
              0);
    EXPECT_EQ(render({"lamps.toml", "-o", "b.png", "--threads", "2", "--manifest", "b.json"}).code,
              0);
    EXPECT_TRUE(bytes_of(in("a.png")) == bytes_of(in("b.png")));
    EXPECT_EQ(bytes_of(in("a.json")), bytes_of(in("b.json")));
}

TEST_F(Render, PrintsPeakMemory) {
    const Outcome outcome = render({"lamps.toml", "-o", "a.png", "--memory"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(std::regex_match(outcome.out, std::regex("peak memory: [1-9][0-9]* MB\n")))
        << outcome.out;
}

TEST_F(Render, CameraOptionsReplaceTheScenes) {
    EXPECT_EQ(render({"lamps.toml", "-o", "a.png"}).code, 0);
    EXPECT_EQ(render({"lamps.toml", "-o", "same.png", "--eye", "0,0,5", "--at", "0,0,0"}).code, 0);
    EXPECT_TRUE(bytes_of(in("a.png")) == bytes_of(in("same.png")));
    EXPECT_EQ(render({"lamps.toml", "-o", "aside.png", "--eye", "100,0,5", "--at", "100,0,0"}).code,
              0);
    EXPECT_EQ(read_pixels(in("aside.png")).at(8, 8), (std::vector<float>{0, 0, 0}));
}

TEST_F(Render, TurntableNumbersItsPicturesAndStartsAtTheCamera) {
    EXPECT_EQ(render({"lamps.toml", "-o", "a.png"}).code, 0);
    EXPECT_EQ(render({"lamps.toml", "-o", "t.png", "--turntable", "3"}).code, 0);
    EXPECT_EQ(names(), (std::vector<std::string>{"a.png", "lamps.toml", "quad.obj", "t_001.png",
                                                 "t_002.png", "t_003.png"}));
    EXPECT_TRUE(bytes_of(in("a.png")) == bytes_of(in("t_001.png")));
    EXPECT_FALSE(bytes_of(in("a.png")) == bytes_of(in("t_002.png")));
}

TEST_F(Render, TwoProcessesWithHalfTheFramesEachMakeTheFilesOfOne) {
    EXPECT_EQ(render({"lamps.toml", "-o", "one.png", "--turntable", "3"}).code, 0);
    EXPECT_EQ(render({"lamps.toml", "-o", "two.png", "--turntable", "3", "--frames", "1"}).code, 0);
    EXPECT_FALSE(std::filesystem::exists(in("two_002.png")));
    EXPECT_EQ(render({"lamps.toml", "-o", "two.png", "--turntable", "3", "--frames", "2-3"}).code,
              0);
    for (const std::string number : {"_001.png", "_002.png", "_003.png"})
        EXPECT_TRUE(bytes_of(in("one" + number)) == bytes_of(in("two" + number))) << number;
}

TEST_F(Render, ComponentsAddUpToTheirSumWhichIsThePicture) {
    EXPECT_EQ(render({"lamps.toml", "-o", "a.png", "--components", "parts"}).code, 0);
    EXPECT_TRUE(bytes_of(in("a.png")) == bytes_of(in("parts/sum.png")));
    const Pixels picture = read_pixels(in("a.png"));
    std::vector<int> sum(picture.values.size());
    EXPECT_EQ(names("parts"),
              (std::vector<std::string>{"ambient.png", "diffuse.png", "emission.png", "index.html",
                                        "index.json", "reflection.png", "refraction.png",
                                        "specular.png", "sum.png"}));
    for (const std::string& name : names("parts")) {
        if (name.starts_with("index")) continue;
        const Pixels part = read_pixels(in("parts/" + name));
        for (std::size_t i = 0; i < sum.size() && name != "sum.png"; ++i) {
            sum[i] += static_cast<int>(std::lround(part.values[i] * 255));
        }
    }
    for (std::size_t i = 0; i < sum.size(); ++i) {
        ASSERT_EQ(std::min(sum[i], 255), std::lround(picture.values[i] * 255)) << i;
    }
}

TEST_F(Render, SamplesSoftenTheEdgesOnly) {
    EXPECT_EQ(render({"quad.obj", "-o", "one.png", "--eye", "0.3,0.2,4"}).code, 0);
    EXPECT_EQ(render({"quad.obj", "-o", "many.png", "--eye", "0.3,0.2,4", "--samples", "16"}).code,
              0);
    const Pixels one = read_pixels(in("one.png")), many = read_pixels(in("many.png"));
    EXPECT_EQ(one.at(8, 8), many.at(8, 8));
    EXPECT_EQ(one.at(0, 0), many.at(0, 0));
    EXPECT_FALSE(one.values == many.values);
}

TEST_F(Render, PlanesHoldTheMachinesValues) {
    EXPECT_EQ(render({"lamps.toml", "-o", "a.png", "--planes", "planes"}).code, 0);
    EXPECT_EQ(names("planes"),
              (std::vector<std::string>{"accum.exr", "accum.png", "color.exr", "color.png",
                                        "depth.exr", "depth.png", "ids.exr", "ids.png",
                                        "index.html", "index.json", "stencil.exr", "stencil.png"}));
    EXPECT_TRUE(bytes_of(in("a.png")) == bytes_of(in("planes/color.png")));
    const auto depth = judge::stored_in<std::uint32_t>(in("planes/depth.exr")).values;
    ASSERT_EQ(depth.size(), 16u * 16u);
    EXPECT_EQ(depth[0], (1u << 24) - 1);
    EXPECT_LT(depth[8 * 16 + 8], (1u << 24) - 1);
    const auto ids = judge::stored_in<std::uint32_t>(in("planes/ids.exr")).values;
    ASSERT_EQ(ids.size(), 16u * 16u);
    EXPECT_EQ(ids[0], 0u);
    EXPECT_EQ(ids[8 * 16 + 8], 1u);
}

TEST_F(Render, ManifestHasCountersAndDigestsOfEveryPass) {
    EXPECT_EQ(render({"lamps.toml", "-o", "a.png", "--manifest", "m.json"}).code, 0);
    const auto json = nlohmann::json::parse(bytes_of(in("m.json")));
    EXPECT_EQ(json["renderer"], "multipass");
    EXPECT_EQ(json["profile"]["name"], "vgx");
    EXPECT_EQ(json["passes"][0]["name"], "depth");
    EXPECT_EQ(json["passes"][0]["counters"]["written"], 64);
    for (const auto& pass : json["passes"]) {
        for (const char* plane : {"color", "depth", "stencil", "accum"}) {
            EXPECT_EQ(pass["digests"][plane].get<std::string>().size(), 32u);
        }
    }
    EXPECT_NE(json["passes"][0]["digests"]["color"], json["passes"].back()["digests"]["color"]);
}

TEST_F(Render, GammaAndExposureChangeThePictureOnlyWhereAsked) {
    EXPECT_EQ(render({"lamps.toml", "-o", "a.png"}).code, 0);
    EXPECT_EQ(render({"lamps.toml", "-o", "plain.png", "--gamma", "1", "--exposure", "0"}).code, 0);
    EXPECT_EQ(render({"lamps.toml", "-o", "dark.png", "--exposure", "-1"}).code, 0);
    EXPECT_TRUE(bytes_of(in("a.png")) == bytes_of(in("plain.png")));
    const float value = read_pixels(in("a.png")).at(8, 8)[2];
    EXPECT_EQ(std::lround(read_pixels(in("dark.png")).at(8, 8)[2] * 255),
              std::lround(value * 255 / 2.0));
}

TEST_F(Render, ReplacesAPictureThatIsThere) {
    write("a.png", "old");
    EXPECT_EQ(render({"lamps.toml", "-o", "a.png"}).code, 0);
    EXPECT_EQ(read_pixels(in("a.png")).width, 16);
}

TEST_F(Render, ReadsNamesWithBlanksAndOfOtherAlphabets) {
    std::filesystem::create_directory(in("my ünits"));
    std::filesystem::copy_file(in("quad.obj"), in("my ünits/the quad.obj"));
    EXPECT_EQ(render({"my ünits/the quad.obj", "-o", "my ünits/the picture.png"}).code, 0);
    EXPECT_EQ(read_pixels(in("my ünits/the picture.png")).width, 16);
}

TEST_F(Render, WarnsOnStandardErrorUnlessQuiet) {
    write("odd.obj", "bevel on\n" + bytes_of(in("quad.obj")));
    const Outcome outcome = render({"odd.obj", "-o", "a.png"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err.substr(0, 23), "gw: warning: odd.obj:1:");
    EXPECT_EQ(render({"odd.obj", "-o", "a.png", "--quiet"}).err, "");
}

/// A shining square with the shadow of a small one on it, and a lamp that glows.
class LeftOut : public SceneTest {
protected:
    /// Lines of the scene, of the small square's material and of the lamp, of the light, of the
    /// camera (none: it is parallel), and of the small square.
    struct Lines {
        std::string scene, square, lamp, light, camera, object;
    };
    struct Effect {
        const char* name;
        Lines one, other;  ///< its parameters differ
    };
    inline static const std::string volume = "shadow = \"volume\"";
    inline static const std::vector<Effect> effects{
        {"translucency", {.square = "d = 0.25"}, {.square = "d = 0.5"}},
        {"fog", {.scene = "fog = {start = 0, end = 9}"}, {.scene = "fog = {start = 0, end = 7}"}},
        {"glare",
         {.lamp = "glare = {radius = 1, samples = 4, strength = 0.25}"},
         {.lamp = "glare = {radius = 1, samples = 4, strength = 0.5}"}},
        {"reflection_in_shadow = false",
         {.scene = "reflection_in_shadow = true", .light = volume},
         {.scene = "reflection_in_shadow = false", .light = volume}},
        {"shadows", {}, {.light = volume}},
        {"reflections",
         {.scene = "background = 0.5", .square = "Ks = 0.5"},
         {.scene = "background = 0.5", .square = "Ks = 0.5\nillum = 3"}},
        {"motion", {.object = "move = [0.5, 0, 0]"}, {.object = "move = [1, 0, 0]"}},
        {"aperture",
         {.camera = "fov = 45\naperture = 0.1"},
         {.camera = "fov = 45\naperture = 0.4"}},
        {"soft lights",
         {.light = volume +
                   "\narea = {shape = \"disc\", u = [0.1, 0, 0], v = [0, 0.1, 0], samples = 4}"},
         {.light = volume +
                   "\narea = {shape = \"disc\", u = [0.5, 0, 0], v = [0, 0.5, 0], samples = 4}"}},
    };

    Outcome draw(const Lines& lines, const std::string& renderer, const std::string& file) const {
        write_pixel(in("white.png"), {255, 255, 255});
        write("s.toml", lines.scene + R"(
[camera]
eye = [0, 0, 5]
)" + (lines.camera.empty() ? "ortho = 4" : lines.camera) +
                            R"(
[[light]]
direction = [0.7, 0, -1]
)" + lines.light + R"(
[[object]]
file = "quad.obj"
material = {Ka = 0, Kd = 0.25, Ks = 0.5, refl = "white.png"}
[[object]]
file = "quad.obj"
scale = 0.4
translate = [-0.5, 0, 1]
)" + lines.object + R"(
[object.material]
Kd = [0, 0.5, 1]
)" + lines.square + R"(
[[object]]
file = "quad.obj"
scale = 0.2
translate = [1.5, 1.5, 0]
material = {Ka = 0, Kd = 0, Ke = 1}
)" + lines.lamp);
        return render({"s.toml", "-o", file, "--renderer", renderer, "--samples", "4"});
    }
    /// Without one, some effects cannot be seen.
    static std::string also(const Lines& lines, const std::string& renderer) {
        const bool has_none = renderer == "hardware" || renderer == "scanline";
        return has_none && lines.light.starts_with(volume) ? "shadows" : "";
    }
    static std::string warning(const std::string& renderer, const std::string& left_out) {
        return "gw: warning: renderer '" + renderer + "' leaves out of this scene: " + left_out +
               "\n";
    }
};

/// A renderer says of an effect in one line that it leaves it out: then the picture does not depend
/// on the effect's parameters. Or it says nothing: then it does.
TEST_F(LeftOut, IsSaidExactlyWhereThePictureLacksTheEffect) {
    int warnings = 0;
    for (const std::string renderer :
         {"hardware", "multipass", "scanline", "raytrace", "adaptive"}) {
        EXPECT_EQ(draw({}, renderer, "a.png").err, "") << renderer;
        for (const Effect& effect : effects) {
            ASSERT_EQ(draw(effect.one, renderer, "a.png").code, 0);
            const std::string said = draw(effect.other, renderer, "b.png").err;
            const bool lacks = bytes_of(in("a.png")) == bytes_of(in("b.png"));
            const std::string name = lacks ? effect.name : "",
                              shadows = name == "shadows" ? "" : also(effect.other, renderer);
            const std::string names = shadows + (shadows != "" && lacks ? ", " : "") + name;
            EXPECT_EQ(said, names.empty() ? "" : warning(renderer, names))
                << renderer << ' ' << effect.name;
            warnings += lacks;
        }
    }
    EXPECT_EQ(warnings, 4 + 6 + 1 + 5) << "of hardware, scanline, raytrace and adaptive";
}

TEST_F(LeftOut, IsSaidByCommandsToo) {
    const std::string says = " leaves out of this scene: ";
    draw({.square = "d = 0.5", .light = volume, .object = "move = [1, 0, 0]"}, "raytrace", "a.png");
    const auto said = [&](std::vector<std::string> command) {
        command.insert(command.begin() + 1, {"s.toml", "--size", "8x6"});
        const Outcome outcome = gw(command);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.err;
    };
    EXPECT_EQ(said({"cast", "-o", "a.png"}),
              "gw: warning: gw cast" + says + "shadows, maps, translucency, motion\n");
    EXPECT_EQ(said({"hidden", "--algorithm", "newell"}),
              "gw: warning: gw hidden" + says + "translucency, motion\n");
    EXPECT_EQ(said({"compare", "-o", "differences"}),
              "gw: warning: gw compare" + says + "motion\n");
    EXPECT_EQ(said({"cast", "-o", "a.png", "--quiet"}), "");
}

TEST_F(LeftOut, IsOneLineForAllEffects) {
    const Lines all{effects[1].one.scene + "\n" + effects[3].other.scene, effects[0].one.square,
                    effects[2].one.lamp};
    EXPECT_EQ(draw(all, "scanline", "a.png").err,
              warning("scanline", "translucency, fog, glare, reflection_in_shadow = false"));
    EXPECT_EQ(render({"s.toml", "-o", "a.png", "--renderer", "scanline", "--quiet"}).err, "");
}

}  // namespace gw::apps
