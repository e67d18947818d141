// Claims of gw radiosity --shares and --mix: shares mixed as they are make the picture of the whole,
// light maps are linear in them, and what does not fit is refused.
#include "tests/apps/pictures.h"
#include "tests/apps/scene_files.h"

#include <cmath>

namespace gw::apps {
namespace {

class Shares : public CommandTest {
protected:
    Shares() {
        write("room.toml", R"(texels = 4
[camera]
eye = [0, 1, 0.9]
at = [0, 0.9, -1]
fov = 100
[material.wall]
Kd = [0.7, 0.6, 0.5]
[[object]]
shape = "room"
name = "room"
width = 2
height = 2
depth = 2
translate = [0, 1, 0]
material = "wall"
[[object]]
shape = "rectangle"
name = "lamp"
width = 0.8
depth = 0.8
rotate = [180, 0, 0]
translate = [0, 1.95, 0]
material = { Kd = 0 }
pixmap = { size = [2, 2], emission = 1 }
[[object]]
shape = "rectangle"
name = "window = a, b"
width = 0.5
depth = 1
rotate = [0, 0, -90]
translate = [-0.95, 1, 0]
material = { Kd = 0.5, Ke = [0.25, 0.5, 0.75] }
)");
    }

    Outcome run(std::vector<std::string> more) const {
        std::vector<std::string> words{"radiosity", "room.toml", "-o",    "out",    "--hemicube",
                                       "32",        "--size",    "64x48", "--units"};
        words.insert(words.end(), more.begin(), more.end());
        return gw(words);
    }

    /// EXR of float32 values are sums of shares of float32.
    void expect_sum(const char* name, const std::vector<std::pair<const char*, double>>& shares) {
        const Pixels sum = read_pixels(in(name));
        std::vector<Pixels> parts;
        for (const auto& [share, factor] : shares) parts.push_back(read_pixels(in(share)));
        for (std::size_t i = 0; i < sum.values.size(); ++i) {
            double expected = 0;
            for (std::size_t k = 0; k < parts.size(); ++k)
                expected += shares[k].second * double(parts[k].values.at(i));
            ASSERT_NEAR(double(sum.values[i]), expected, 1e-6 * expected) << name << " " << i;
        }
    }
};

}  // namespace

TEST_F(Shares, MixedAsTheyAreAreTheWhole) {
    const Outcome solved = run({"--shots", "30", "--shares", "--lightmaps", "--save"});
    ASSERT_EQ(solved.code, 0) << solved.err;
    // 0.64 x 3 of 0.64 x 3 + 0.5 x 1.5
    EXPECT_NE(solved.out.find("share_1.exr: lamp, 71.9 % of the emitted energy\n"
                              "share_2.exr: window = a, b, 28.1 % of the emitted energy\n"),
              std::string::npos)
        << solved.out;
    ASSERT_EQ(run({"--mix", "lamp=1", "--lightmaps"}).code, 0);
    const Pixels whole = read_pixels(in("out/picture.png")),
                 mixed = read_pixels(in("out/mixed.png"));
    ASSERT_EQ(whole.values.size(), mixed.values.size());
    for (std::size_t i = 0; i < whole.values.size(); ++i)
        ASSERT_NEAR(double(whole.values[i]), double(mixed.values[i]), 1.5 / 65535);
    expect_sum("out/mixed_light_map_1.exr", {{"out/light_map_1.exr", 1}});
    EXPECT_EQ(bytes_of(in("out/mixed_light_maps.bin")), bytes_of(in("out/light_maps.bin")));
}

TEST_F(Shares, LightMapsAreLinearInTheirStrengths) {
    ASSERT_EQ(run({"--shots", "30", "--shares", "--lightmaps"}).code, 0);
    expect_sum("out/light_map_1.exr",
               {{"out/share_1_light_map_1.exr", 1}, {"out/share_2_light_map_1.exr", 1}});
    const Outcome mixed = run({"--mix", "lamp=0.5", "--mix", "window = a, b=3", "--lightmaps"});
    ASSERT_EQ(mixed.code, 0) << mixed.err;
    EXPECT_NE(mixed.out.find("mixed of 30 shots, "), std::string::npos) << mixed.out;
    EXPECT_NE(mixed.out.find(": lamp 0.5, window = a, b 3\n"), std::string::npos) << mixed.out;
    expect_sum("out/mixed_light_map_1.exr",
               {{"out/share_1_light_map_1.exr", 0.5}, {"out/share_2_light_map_1.exr", 3}});
}

TEST_F(Shares, AreKeptThroughASave) {
    ASSERT_EQ(run({"--shots", "12", "--shares", "--save"}).code, 0);
    const std::string whole = bytes_of(in("out/share_2.exr"));
    ASSERT_EQ(run({"--shots", "5", "--shares", "--save"}).code, 0);
    ASSERT_NE(bytes_of(in("out/share_2.exr")), whole);
    ASSERT_EQ(run({"--shots", "12", "--shares", "--save", "--resume"}).code, 0);
    EXPECT_EQ(bytes_of(in("out/share_2.exr")), whole);
    ASSERT_EQ(run({"--shots", "14", "--save", "--resume"}).code, 0);
    expect_refused(1,
                   {"radiosity", "room.toml", "-o", "out", "--hemicube", "32", "--resume",
                    "--shares", "--shots", "15"},
                   {"share_1.exr", "has 12 shots; expected 14"});
}

TEST_F(Shares, ThatDoNotFitAreRefused) {
    expect_refused(1, {"radiosity", "room.toml", "-o", "out", "--mix", "lamp=1"},
                   {"share_1.exr: does not exist; expected a lamp's light, by --shares"});
    ASSERT_EQ(run({"--shots", "2", "--shares"}).code, 0);
    expect_refused(1, {"radiosity", "room.toml", "-o", "out", "--mix", "lamp=1"},
                   {"--hemicube 32", "expected --hemicube 128"});
    expect_refused(2, {"radiosity", "room.toml", "-o", "out", "--mix", "lump=1"},
                   {"no lamp 'lump'; expected one of lamp, window = a, b"});
    expect_refused(2, {"radiosity", "room.toml", "-o", "out", "--mix", "lamp"}, {"LAMP=FACTOR"});
    expect_refused(2, {"radiosity", "room.toml", "-o", "out", "--mix", "lamp=-1"}, {"lamp", "-1"});
    expect_refused(2, {"radiosity", "room.toml", "-o", "out", "--mix", "lamp=1", "--shots", "3"},
                   {"--mix solves nothing"});
    expect_refused(2, {"radiosity", "room.toml", "-o", "out", "--mix", "lamp=1", "--mix", "lamp=2"},
                   {"two factors"});
}

}  // namespace gw::apps
