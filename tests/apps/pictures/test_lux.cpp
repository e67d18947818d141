// Claims of numbers of light in gw radiosity: illuminances at points and in views, and white.
#include "tests/apps/pictures.h"
#include "tests/apps/scene_files.h"

namespace gw::apps {
namespace {

/// A lamp of 100 cd, 0.5 m above a floor of reflectance 0.5: 400 lux at its foot. The eye sees the foot.
class Lux : public CommandTest {
protected:
    Lux() {
        for (const char* white : {"", "white = {lux = 400}\n"})
            write(*white ? "lux.toml" : "any.toml",
                  std::string("texels = 32\n") + white + R"([camera]
eye = [0.01, 0.4, 0.01]
at = [0.01, 0, 0.01]
up = [0, 0, -1]
fov = 2
[[object]]
shape = "rectangle"
name = "floor"
width = 2
depth = 2
material = { Kd = 0.5 }
)" + (*white ? "[[light]]\nname = \"bulb\"\nposition = [0, 0.5, 0]\ncandela = 100\n" : ""));
    }
};

}  // namespace

TEST_F(Lux, APointHasTheIntensityByTheSquareOfItsDistance) {
    const Outcome outcome = gw({"radiosity", "lux.toml", "-o", "out", "--size", "8x8", "--lux",
                                "--lux-at", "0,0.1,0", "--shares", "--exposure", "-1"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    double lux = 0;
    const auto at = outcome.out.find(" lux on floor, 0.1 from the point\n");
    ASSERT_NE(at, std::string::npos) << outcome.out;
    lux = std::stod(outcome.out.substr(outcome.out.rfind('\n', at) + 1));
    EXPECT_NEAR(lux, 400, 4);
    EXPECT_NE(outcome.out.find("share_1.exr: bulb, 100.0 %"), std::string::npos) << outcome.out;
    for (const float v : read_pixels(in("out/picture_lux.exr")).values) EXPECT_NEAR(v, 400, 6);
    // A surface of reflectance 0.5 under white, one stop darker.
    for (const float v : read_pixels(in("out/picture.png")).values) EXPECT_NEAR(v, 0.25, 0.004);
}

TEST_F(Lux, PassesShowTheSameLamp) {
    ASSERT_EQ(
        gw({"render", "lux.toml", "-o", "out.png", "--size", "8x8", "--renderer", "scanline"}).code,
        0);
    for (const float v : read_pixels(in("out.png")).values) EXPECT_NEAR(v, 0.5, 0.01);
}

TEST_F(Lux, NeedAWhite) {
    expect_refused(2, {"radiosity", "any.toml", "-o", "out", "--lux"}, {"has no unit", "white ="});
}

}  // namespace gw::apps
