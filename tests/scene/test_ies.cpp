// IES files and numbers of light: intensities, fluxes, symmetry; what is wrong is refused with its line.
#include "gw/base/elementary.h"
#include "scene/read_ies.h"
#include "scene/scene.h"
#include "tests/scene/folder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gw::scene {
namespace {

class Ies : public ::testing::Test {
protected:
    Photometry read(const std::string& text) {
        return read_ies(folder_.write("lamp.ies", text), folder_.warnings_list());
    }
    std::string refusal(const std::string& text) {
        return folder_.error([&] { read(text); });
    }
    Folder folder_;
};

/// Angles, then candela; multiplier 2, ballast 0.5, so that the values are as they stand.
std::string file_of(const std::string& vertical, const std::string& horizontal, int v, int h,
                    const std::string& candela, const std::string& type = "1") {
    return "IESNA:LM-63-1995\n[TEST] none\n[MANUFAC] ours\nTILT=NONE\n1 1000 2 " +
           std::to_string(v) + " " + std::to_string(h) + " " + type + " 2 0 0 0\n0.5 1 40\n" +
           vertical + "\n" + horizontal + "\n" + candela + "\n";
}

/// Of type B.
std::string flood_of(const std::string& vertical, const std::string& horizontal, int v, int h,
                     const std::string& candela) {
    return file_of(vertical, horizontal, v, h, candela, "2");
}

Light spot(const Photometry& web, const vec3& direction, double turn = 0) {
    return {.kind = LightKind::Spot,
            .direction = direction,
            .luminous = Luminous{dvec3(1), std::make_shared<const Photometry>(web), turn}};
}

}  // namespace

TEST_F(Ies, AConstantDistributionIsThePlainLamp) {
    const Photometry web = read(file_of("0 90 180", "0", 3, 1, "100 100 100"));
    EXPECT_NEAR(web.lumen(), 4 * pi * 100, 1e-9);
    const Light ies = spot(web, {0, -1, 0});
    const Light plain{.kind = LightKind::Point, .luminous = Luminous{dvec3(100), nullptr, 0}};
    for (const dvec3& d :
         {dvec3(0, -1, 0), dvec3(0, 1, 0), dvec3(0.6, 0, 0.8), dvec3(-0.48, 0.6, 0.64)})
        EXPECT_NEAR(intensity(ies, d).x, intensity(plain, d).x, 1e-10);
    EXPECT_NEAR(luminous_flux(ies).x, luminous_flux(plain).x, 1e-9);
}

// I cos has the flux pi I. Between angles the file is linear: below cos by a quarter of a per mille.
TEST_F(Ies, ALambertianDistributionHasPiTimesItsIntensity) {
    std::string angles, candela;
    for (int a = 0; a <= 90; ++a) {
        angles += std::to_string(a) + (a % 10 == 9 ? "\n" : " ");
        candela +=
            std::to_string(a == 90 ? 0 : 200 * std::cos(a * pi / 180)) + (a % 7 ? ", " : "\r\n");
    }
    const Photometry web = read(file_of(angles, "0", 91, 1, candela));
    EXPECT_NEAR(web.lumen(), pi * 200, pi * 200 * 1e-4);
    EXPECT_NEAR(web.at(30, 123), 200 * std::sqrt(0.75), 1e-4);
    EXPECT_EQ(web.at(91, 0), 0);  // the file ends at 90
}

TEST_F(Ies, ASpotsFluxIsItsIntegral) {
    Light light{
        .kind = LightKind::Spot, .direction = {0, -1, 0}, .cone_angle = 60, .spot_exponent = 3};
    light.luminous = Luminous{dvec3(80), nullptr, 0};
    double sum = 0;
    constexpr int steps = 20000;
    for (int i = 0; i < steps; ++i) {
        const double a = (i + 0.5) * pi / steps;
        sum +=
            intensity(light, {std::sin(a), -std::cos(a), 0}).x * 2 * pi * std::sin(a) * pi / steps;
    }
    EXPECT_NEAR(luminous_flux(light).x, sum, 1e-3 * sum);
    EXPECT_NEAR(sum, 80 * 2 * pi * (1 - 1.0 / 16) / 4, 1e-3 * sum);
}

// Horizontal angles 0, 90, 180, 270 are +x, -z, -x, +z under a lamp that hangs down.
TEST_F(Ies, HorizontalAnglesAreDirections) {
    const Photometry web =
        read(file_of("0 90", "0 90 180 270 360", 2, 5, "9 1  9 2  9 3  9 4  9 1"));
    const Light down = spot(web, {0, -2, 0});
    EXPECT_NEAR(intensity(down, {1, 0, 0}).x, 1, 1e-9);
    EXPECT_NEAR(intensity(down, {0, 0, -1}).x, 2, 1e-9);
    EXPECT_NEAR(intensity(down, {-1, 0, 0}).x, 3, 1e-9);
    EXPECT_NEAR(intensity(down, {0, 0, 1}).x, 4, 1e-9);
    EXPECT_NEAR(intensity(down, {0, -1, 0}).x, 9, 1e-9);
    EXPECT_NEAR(intensity(down, {std::sqrt(0.5), 0, -std::sqrt(0.5)}).x, 1.5, 1e-9);
    EXPECT_NEAR(intensity(spot(web, {0, -1, 0}, 90), {0, 0, -1}).x, 1, 1e-9);
    // Turned from -y to +x, the shortest way: +x goes to +y.
    EXPECT_NEAR(intensity(spot(web, {1, 0, 0}), {0, 1, 0}).x, 1, 1e-9);
    EXPECT_NEAR(intensity(spot(web, {1, 0, 0}), {0, 0, -1}).x, 2, 1e-9);
    EXPECT_NEAR(intensity(spot(web, {0, 1, 0}), {1, 0, 0}).x, 1, 1e-9);
    EXPECT_EQ(intensity(spot(web, {0, 1, 0}), {0, -1, 0}).x, 0);
}

TEST_F(Ies, AnglesThatAreLeftOutFollowBySymmetry) {
    const Photometry quarter = read(file_of("0 90", "0 45 90", 2, 3, "9 1 9 2 9 3"));
    for (const auto& [angle, value] : {std::pair{0, 1},
                                       {45, 2},
                                       {90, 3},
                                       {135, 2},
                                       {180, 1},
                                       {225, 2},
                                       {270, 3},
                                       {315, 2},
                                       {-45, 2},
                                       {405, 2}})
        EXPECT_NEAR(quarter.at(90, angle), value, 1e-12) << angle;
    const Photometry half = read(file_of("0 90", "0 90 180", 2, 3, "9 1 9 2 9 3"));
    for (const auto& [angle, value] : {std::pair{0, 1}, {90, 2}, {180, 3}, {270, 2}})
        EXPECT_NEAR(half.at(90, angle), value, 1e-12) << angle;
    const Photometry across = read(file_of("0 90", "90 180 270", 2, 3, "9 1 9 2 9 3"));
    for (const auto& [angle, value] : {std::pair{90, 1}, {180, 2}, {270, 3}, {0, 2}, {45, 1}})
        EXPECT_NEAR(across.at(90, angle), angle == 45 ? 1.5 : value, 1e-12) << angle;
}

// Vertical angle 90 is +x and horizontal angle 90 is +z under a floodlight that shines down.
TEST_F(Ies, AnglesOfTypeBAreDirections) {
    const Photometry web = read(flood_of("-90 0 90", "-90 0 90", 3, 3, "1 2 3  4 9 5  6 7 8"));
    const Light down = spot(web, {0, -1, 0});
    EXPECT_NEAR(intensity(down, {0, -1, 0}).x, 9, 1e-9);
    EXPECT_NEAR(intensity(down, {1, 0, 0}).x, 5, 1e-9);
    EXPECT_NEAR(intensity(down, {-1, 0, 0}).x, 4, 1e-9);
    EXPECT_NEAR(intensity(down, {0, 0, 1}).x, 7, 1e-9);
    EXPECT_NEAR(intensity(down, {0, 0, -1}).x, 2, 1e-9);
    EXPECT_EQ(intensity(down, {0.6, 0.8, 0}).x, 0);
    // 60 degrees about the axis of z, then 30 towards it: cos 30 sin 60, -cos 30 cos 60, sin 30.
    const dvec3 oblique(0.75, -std::sqrt(3) / 4, 0.5);
    EXPECT_NEAR(intensity(down, oblique).x, 2.0 / 3 * (9 + 2 * 5) / 3 + (7 + 2 * 8) / 9.0, 1e-9);
    // Turned by 90 degrees: what was +x is -z.
    const Light turned = spot(web, {0, -1, 0}, 90);
    EXPECT_NEAR(intensity(turned, {0, 0, -1}).x, 5, 1e-9);
    EXPECT_NEAR(intensity(turned, {1, 0, 0}).x, 7, 1e-9);
    // Aimed along +x, the shortest way: +x goes to +y.
    EXPECT_NEAR(intensity(spot(web, {1, 0, 0}), {0, 1, 0}).x, 5, 1e-9);
}

TEST_F(Ies, AnglesOfTypeBFrom0StandForBothSides) {
    const Photometry quarter = read(flood_of("0 45 90", "0 30", 3, 2, "9 5 1  4 3 2"));
    const Photometry whole =
        read(flood_of("-90 -45 0 45 90", "-30 0 30", 5, 3, "2 3 4 3 2  1 5 9 5 1  2 3 4 3 2"));
    for (const double v : {-90.0, -60.0, -10.0, 0.0, 45.0, 80.0})
        for (const double h : {-30.0, -5.0, 0.0, 20.0, 31.0})
            EXPECT_NEAR(quarter.at(v, h), whole.at(v, h), 1e-12) << v << " " << h;
    EXPECT_EQ(quarter.at(0, 31), 0);
    EXPECT_NEAR(quarter.lumen(), whole.lumen(), 1e-9);
}

TEST_F(Ies, TheFluxOfTypeBIsItsIntegral) {
    const auto lit = [&](const std::string& candela) {
        return read(flood_of("-90 90", "-90 90", 2, 2, candela));
    };
    EXPECT_NEAR(lit("50 50 50 50").lumen(), 2 * pi * 50, 1e-9);
    const Photometry web = lit("10 20 30 80");
    const Light light = spot(web, {0, -1, 0});
    constexpr int steps = 400;
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int k = 0; k < steps; ++k) {
            const double a = (i + 0.5) * pi / 2 / steps, b = (k + 0.5) * 2 * pi / steps;
            sum += std::sin(a) * intensity(light, {std::sin(a) * std::cos(b), -std::cos(a),
                                                   std::sin(a) * std::sin(b)})
                                     .x;
        }
    EXPECT_NEAR(web.lumen(), sum * pi / 2 / steps * 2 * pi / steps, 1e-3 * web.lumen());
}

TEST_F(Ies, VersionsDifferInTheSecondFactor) {
    const std::string body = "TILT=NONE\n1 -1 1 2 1 1 1 0 0 0 1 0.5 9\n0 180\n0\n10 10\n";
    EXPECT_EQ(read("IESNA91\n" + body).at(0, 0), 5);
    EXPECT_EQ(read("IESNA:LM-63-1995\n" + body).at(0, 0), 5);
    EXPECT_EQ(read("IESNA:LM-63-2002\n" + body).at(0, 0), 10);
    EXPECT_EQ(read("IES:LM-63-2019\n" + body).at(0, 0), 10);
    EXPECT_EQ(read(body).at(0, 0), 5);  // 1986: no first line
    EXPECT_EQ(read("a lamp of 1986\n" + body).at(0, 0), 5);
}

TEST_F(Ies, FactorsOfTiltAreLeftOutWithAWarning) {
    const std::string end = "1 -1 1 2 1 1 1 0 0 0 1 1 9\n0 180\n0\n10 10\n";
    EXPECT_EQ(read("IESNA91\nTILT=INCLUDE\n1\n2\n0 90\n1 1\n" + end).at(0, 0), 10);
    EXPECT_EQ(folder_.warnings(), Strings{});
    EXPECT_EQ(read("IESNA91\nTILT=INCLUDE\n1\n2\n0 90\n1 0.9\n" + end).at(0, 0), 10);
    ASSERT_EQ(folder_.warnings().size(), 1u);
    EXPECT_NE(folder_.warnings()[0].find("lamp.ies:6: factors of tilt are left out"),
              std::string::npos)
        << folder_.warnings()[0];
}

TEST_F(Ies, WhatIsWrongIsRefusedWithItsLine) {
    EXPECT_EQ(refusal(file_of("0 90", "0", 2, 1, "1")),
              "lamp.ies:9: ends here; expected candela from 0");
    EXPECT_EQ(refusal(file_of("0 90", "0", 2, 1, "1 x")),
              "lamp.ies:9: 'x' is no number; expected candela from 0");
    EXPECT_EQ(refusal(file_of("0 90", "0", 2, 1, "1 -1")),
              "lamp.ies:9: -1; expected candela from 0");
    EXPECT_EQ(refusal(file_of("0 90", "0", 2, 1, "1 nan")),
              "lamp.ies:9: 'nan' is no number; expected candela from 0");
    EXPECT_EQ(refusal(file_of("0 90", "0", 2, 1, "1 2 3")),
              "lamp.ies:9: '3' follows the last candela value; expected the end");
    EXPECT_EQ(refusal(file_of("0 90", "0", 2, 1, "0 0")),
              "lamp.ies:9: all candela are 0; expected a luminaire that shines");
    EXPECT_EQ(refusal(file_of("90 0", "0", 2, 1, "1 2")),
              "lamp.ies:7: 0 after 90; expected vertical angles of 0 to 180 that ascend");
    EXPECT_EQ(refusal(file_of("0 80", "0", 2, 1, "1 2")),
              "lamp.ies:7: vertical angles from 0 to 80; expected 0 to 90, 90 to 180 or 0 to 180");
    EXPECT_EQ(
        refusal(file_of("0 90", "0 100", 2, 2, "1 2 3 4")),
        "lamp.ies:8: horizontal angles from 0 to 100; expected 0, or 0 to 90, 180 or 360, or 90 "
        "to 270");
    EXPECT_EQ(refusal("IESNA91\nTILT=lamp.tlt\n"),
              "lamp.ies:2: TILT= names another file; expected TILT=NONE or TILT=INCLUDE");
    EXPECT_EQ(
        refusal("IESNA91\nTILT=NONE\n1 -1 1 2 1 3 1 0 0 0"),
        "lamp.ies:3: photometry of type 3, A, whose angles are of headlamps; expected 1, C, or 2, B");
    EXPECT_EQ(refusal(flood_of("-90 45", "0 90", 2, 2, "1 2 3 4")),
              "lamp.ies:7: vertical angles from -90 to 45; expected -90 to 90, or 0 to 90");
    EXPECT_EQ(refusal(flood_of("-90 90", "0", 2, 1, "1 2")),
              "lamp.ies:8: horizontal angles from 0 to 0; expected -90 to 90, or 0 to 90");
    EXPECT_EQ(refusal(flood_of("-90 91", "0 90", 2, 2, "1 2 3 4")),
              "lamp.ies:7: 91; expected vertical angles of -90 to 90");
    EXPECT_EQ(refusal("IESNA91\nTILT=NONE\n1 -1 1 2 1 4 1 0 0 0"),
              "lamp.ies:3: photometry of type 4; expected 1, C, or 2, B");
    EXPECT_EQ(refusal("IESNA91\nTILT=NONE\n1 -1 1 100000 100000 1"),
              "lamp.ies:3: 1e+10 candela values; expected at most 4e+06");
    EXPECT_EQ(refusal("no labels\n"), "lamp.ies:1: ends here; expected TILT= and the photometry");
    EXPECT_NE(refusal(""), "no error");
}

/// Every beginning of a file is refused, and any byte may be wrong: no crash, and one line.
TEST_F(Ies, DamagedFilesAreRefusedOrRead) {
    const std::string whole = file_of("0 90", "0 90", 2, 2, "11 12 13 14");
    const std::size_t last = whole.rfind("14");
    for (std::size_t size = 0; size <= last; ++size) {
        const std::string message = refusal(whole.substr(0, size));
        EXPECT_NE(message, "no error") << size;
        EXPECT_EQ(message.find('\n'), message.npos);
    }
    for (std::size_t at = 0; at < whole.size(); ++at)
        for (const char byte : {'\0', '\n', '-', '9', 'e', ' ', '\xff'}) {
            std::string damaged = whole;
            damaged[at] = byte;
            EXPECT_EQ(refusal(damaged).find('\n'), std::string::npos);
        }
}

TEST(NumbersOfLight, OfATomlLightAreCandelaAndWhite) {
    Folder folder;
    folder.write("even.ies", file_of("0 180", "0", 2, 1, "50 50"));
    const std::string object = "[[object]]\nshape = \"box\"\n";
    const auto lights = [&](const std::string& text) {
        return read_scene(folder.write("s.toml", "white = {nit = 100}\n" + object + text)).scene;
    };
    const Scene scene = lights(
        "[[light]]\nposition = [0, 2, 0]\nlumen = 400\n"
        "[[light]]\nposition = [0, 2, 0]\ndirection = [0, -1, 0]\ncone = 90\nexponent = 1\nlumen = 300\n"
        "[[light]]\nposition = [0, 2, 0]\ndirection = [0, -1, 0]\nies = \"even.ies\"\n"
        "[[light]]\nposition = [0, 2, 0]\ndirection = [0, -1, 0]\nies = \"even.ies\"\nlumen = 800\n"
        "[[light]]\nposition = [0, 2, 0]\ncandela = 30\ncolor = [1, 0, 0]\n"
        "[[light]]\ndirection = [0, -1, 0]\nlux = 157\n");
    EXPECT_NEAR(scene.white, 100 * pi, 1e-9);
    EXPECT_NEAR(scene.lights[0].luminous->candela.x, 400 / (4 * pi), 1e-9);
    EXPECT_NEAR(scene.lights[1].luminous->candela.x, 300 / pi, 1e-9);
    EXPECT_EQ(scene.lights[2].luminous->candela.x, 1);
    EXPECT_NEAR(luminous_flux(scene.lights[3]).x, 800, 1e-9);
    EXPECT_NEAR(scene.lights[4].luminous->candela.x, 30 / 0.2126, 1e-9);
    EXPECT_NEAR(luminance_of(scene.lights[4].luminous->candela), 30, 1e-9);
    EXPECT_NEAR(scene.lights[5].Id.x, 157 / (100 * pi), 1e-6);
    // Passes divide by the square of the distance.
    EXPECT_NEAR(scene.lights[0].Id.x, 400 / (4 * pi) / (100 * pi), 1e-6);
    EXPECT_EQ(scene.lights[0].quadratic_attenuation, 1);
    EXPECT_EQ(scene.lights[0].constant_attenuation, 0);
}

TEST(NumbersOfLight, ThatContradictAreRefused) {
    Folder folder;
    const std::string object = "[[object]]\nshape = \"box\"\n[[light]]\nposition = [0, 2, 0]\n";
    const auto refusal = [&](const std::string& light) {
        return folder.scene_error("s.toml", "white = {lux = 500}\n" + object + light);
    };
    EXPECT_NE(folder.scene_error("s.toml", object + "candela = 3\n").find("has no white"),
              std::string::npos);
    EXPECT_EQ(refusal("candela = 3\nlumen = 2\n"),
              "s.toml:7: light.lumen beside light.candela; expected one of them");
    EXPECT_EQ(refusal("Id = 1\nlumen = 2\n"),
              "s.toml:6: light.Id beside a number of light; expected one of them");
    EXPECT_EQ(refusal("lux = 3\n"), "s.toml:6: lux of a lamp; expected candela or lumen");
    EXPECT_EQ(
        refusal("turn = 3\n"),
        "s.toml:6: light.turn beside no number of light; expected candela, lumen, lux or ies");
    EXPECT_NE(
        refusal("direction = [0, -1, 0]\nies = \"none.ies\"\n").find("'none.ies' does not exist"),
        std::string::npos);
    EXPECT_NE(folder.scene_error("s.toml", "white = 500\n" + object).find("{lux = 500}"),
              std::string::npos);
    EXPECT_NE(refusal("[[object]]\nshape = \"box\"\npixmap = {lumen = 2, nit = 3}\n")
                  .find("expected one of them"),
              std::string::npos);
}

}  // namespace gw::scene
