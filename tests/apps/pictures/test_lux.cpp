// Claims of numbers of light in gw radiosity: illuminances at points and in views, and white.
#include "tests/apps/pictures.h"
#include "tests/apps/scene_files.h"

#include <algorithm>

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

/// Each pixel's colour is that of its value on the scale that is printed, whatever else is in view.
TEST_F(Lux, FalseColoursAreThoseOfTheScale) {
    std::string text = bytes_of(in("lux.toml"));
    write("wide.toml", text.replace(text.find("fov = 2"), 7, "fov = 70"));
    const Outcome outcome = gw({"radiosity", "wide.toml", "-o", "out", "--size", "24x24", "--lux"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::vector<float> lux = read_pixels(in("out/picture_lux.exr")).values;
    const double red = double(*std::max_element(lux.begin(), lux.end()));
    EXPECT_GT(red, 350);
    EXPECT_LT(double(*std::min_element(lux.begin(), lux.end())), 300);
    const Pixels colors = read_pixels(in("out/picture_lux.png"));
    for (std::size_t i = 0; i < lux.size(); ++i) {
        const double t = 1 - double(lux[i]) / red;  // 0 red, 1/4 yellow, 1/2 green
        const auto channel = [](double v) { return std::clamp(v, 0.0, 1.0); };
        EXPECT_NEAR(double(colors.values[3 * i]), channel(2 - 4 * t), 0.003) << lux[i];
        EXPECT_NEAR(double(colors.values[3 * i + 1]), channel(t < 0.5 ? 4 * t : 4 - 4 * t), 0.003);
        EXPECT_NEAR(double(colors.values[3 * i + 2]), channel(4 * t - 2), 0.003);
    }
    const std::string scale = bytes_of(in("out/picture_lux_scale.svg"));
    const std::size_t printed = outcome.out.find("red ") + 4;
    const std::string number =
        outcome.out.substr(printed, outcome.out.find(' ', printed) - printed);
    EXPECT_NEAR(std::stod(number), red, red * 1e-3);
    EXPECT_NE(scale.find(">" + number + "<"), std::string::npos) << scale;
    EXPECT_NE(scale.find(">0 lux<"), std::string::npos) << scale;
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
