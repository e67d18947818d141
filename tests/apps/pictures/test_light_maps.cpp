// Claims of gw radiosity --lightmaps: its EXR has the bits of the solution, its PNG the same values
// as a display shows them, and gw render draws its glTF as gw radiosity draws the solution, within a
// bound. Claims of --units: views have the radiosity, unclamped, and its false colours.
#include "apps/radiosity/light_maps.h"
#include "radiosity/display/light_atlas.h"
#include "radiosity/model/figures.h"
#include "scene/gltf/gltf_material.h"
#include "scene/toml/read_scene.h"
#include "tests/apps/pictures.h"
#include "tests/apps/scene_files.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace gw::apps {
namespace {

constexpr int shots = 40;

class LightMaps : public CommandTest {
protected:
    LightMaps() {
        write("box.toml", R"(texels = 8
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
shape = "icosphere"
name = "ball"
radius = 0.4
divisions = 2
translate = [0.2, 0.5, -0.4]
material = "wall"
[[object]]
shape = "rectangle"
name = "lamp"
width = 0.8
depth = 0.8
rotate = [180, 0, 0]
translate = [0, 1.95, 0]
material = { Kd = 0 }
pixmap = { size = [2, 2], emission = 3 }
)");
        const Outcome outcome =
            gw({"radiosity", "box.toml", "-o", "out", "--hemicube", "32", "--size", "64x48",
                "--shots", std::to_string(shots), "--exposure", "-0.5", "--lightmaps", "--units"});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_NE(outcome.out.find("1 light map; the brightest radiosity is 3, white in PNG is "
                                   "1.414"),
                  outcome.out.npos)
            << outcome.out;
        EXPECT_NE(outcome.out.find("picture_false.png, radiosity: red "), outcome.out.npos);
    }
};

double encoded(double linear) { return double(scene::encoded(dvec3(linear)).x); }

}  // namespace

TEST_F(LightMaps, HaveTheBitsOfTheSolution) {
    const scene::Scene scene = scene::read_scene(in("box.toml")).scene;
    radiosity::SolverOptions options;
    options.form_factors.hemicube = 32;
    radiosity::Solver solver(radiosity::make_model(scene, {}), options);
    for (int i = 0; i < shots; ++i) solver.shoot();
    const radiosity::PixmapModel& model = solver.model();
    const radiosity::LightAtlas atlas = radiosity::make_atlas(model);
    ASSERT_EQ(atlas.pages.size(), 1u);
    const std::vector<float> page =
        page_colors(atlas, 0, model, displayed_pixmaps(model, solver.solution(), true));
    const Pixels exr = read_pixels(in("out/light_map_1.exr")),
                 png = read_pixels(in("out/light_map_1.png"));
    ASSERT_EQ(exr.channels, 3);
    ASSERT_EQ(exr.width, atlas.pages[0].width);
    ASSERT_EQ(exr.height, atlas.pages[0].height);
    for (int y = 0; y < exr.height; ++y)
        for (int x = 0; x < exr.width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                const float v = page[std::size_t((exr.height - 1 - y) * exr.width + x) * 3 + c];
                EXPECT_EQ(exr.at(x, y)[c], v);
                const double shown = std::clamp(encoded(double(v) * std::sqrt(0.5)), 0.0, 1.0);
                EXPECT_NEAR(double(png.at(x, y)[c]), shown, 0.501 / 255);
            }
}

/// Textures are interpolated after their values were encoded for the display, pixmaps before.
TEST_F(LightMaps, AreDrawnAsTheSolutionIs) {
    const Outcome outcome = gw({"render", "out/light_maps.gltf", "-o", "again.png", "--renderer",
                                "hardware", "--size", "64x48", "--profile", "ideal"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "");
    const Pixels a = read_pixels(in("out/picture.png")), b = read_pixels(in("again.png"));
    ASSERT_EQ(a.values.size(), b.values.size());
    double sum = 0, most = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        const double off = std::abs(encoded(double(a.values[i])) - double(b.values[i]));
        sum += off;
        most = std::max(most, off);
    }
    EXPECT_LT(sum / double(a.values.size()), 1.0 / 255);
    EXPECT_LT(most, 0.1);
}

/// The picture's frame buffer has 2^-0.5 times the radiosity, clamped. Both round to nearest.
TEST_F(LightMaps, UnitsAreThePicturesRadiosities) {
    const Pixels picture = read_pixels(in("out/picture.png")),
                 units = read_pixels(in("out/picture_units.exr")),
                 colors = read_pixels(in("out/picture_false.png"));
    ASSERT_EQ(units.values.size(), picture.values.size());
    ASSERT_EQ(colors.values.size(), picture.values.size());
    float most = 0;
    for (std::size_t i = 0; i < units.values.size(); ++i) {
        most = std::max(most, units.values[i]);
        EXPECT_NEAR(std::min(1.0, double(units.values[i]) * std::sqrt(0.5)),
                    double(picture.values[i]), 4.0 / 65535);
    }
    EXPECT_EQ(most, 3);  // the lamp's, beyond white
    int lamp = 0;
    for (std::size_t i = 0; i < units.values.size(); i += 3) {
        const float mean = (units.values[i] + units.values[i + 1] + units.values[i + 2]) / 3;
        const std::vector<float> shown = colors.at(int(i / 3) % 64, int(i / 3) / 64);
        if (mean == 3) {
            EXPECT_EQ(shown, (std::vector{1.f, 0.f, 0.f}));
            ++lamp;
        }
        EXPECT_EQ(shown[0] + shown[1] + shown[2] > 0, mean > 0);
        // A ramp from red to blue: the brighter, the farther from blue.
        const float place = shown[2] - shown[0];
        for (std::size_t k = 0; k < i; k += 93) {
            const float other = (units.values[k] + units.values[k + 1] + units.values[k + 2]) / 3;
            const std::vector<float> beside = colors.at(int(k / 3) % 64, int(k / 3) / 64);
            if (other > mean + 0.01f) {
                EXPECT_LE(beside[2] - beside[0], place);
            }
        }
    }
    EXPECT_GT(lamp, 3);
}

/// The EXR has radiosities, RGBM 2^-0.5 of them, within the bound of image/rgbm.h.
TEST_F(LightMaps, InRgbmAreTheExactOnesWithinTheirBound) {
    const Outcome outcome =
        gw({"radiosity", "box.toml", "-o", "rgbm", "--hemicube", "32", "--size", "64x48", "--shots",
            std::to_string(shots), "--exposure", "-0.5", "--lightmaps", "--rgbm", "4"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const Pixels exr = read_pixels(in("rgbm/light_map_1.exr")),
                 png = read_pixels(in("rgbm/light_map_1_rgbm.png"));
    ASSERT_EQ(png.channels, 4);
    ASSERT_EQ(png.width, exr.width);
    for (int y = 0; y < exr.height; ++y)
        for (int x = 0; x < exr.width; ++x) {
            const std::vector<float> B = exr.at(x, y), m = png.at(x, y);
            const double most = std::sqrt(0.5) * double(std::max({B[0], B[1], B[2]}));
            for (std::size_t c = 0; c < 3; ++c)
                ASSERT_NEAR(double(m[c]) * double(m[3]) * 4, std::sqrt(0.5) * double(B[c]),
                            (most + 4.0 / 255) / 510 * (1 + 1e-5));
        }
    const std::string gltf = bytes_of(in("rgbm/light_maps.gltf"));
    EXPECT_NE(gltf.find("\"light_map_1_rgbm.png\""), gltf.npos);
    expect_refused(2, {"radiosity", "box.toml", "-o", "no", "--rgbm", "4"},
                   {"--lightmaps beside it"});
}

/// Linear texels 1, 0.2, 0.4, 0 in red, twice each way: the glTF has them as a display shows them, and
/// their mean as light.
TEST_F(LightMaps, NameTheTexturesThatSurfacesHave) {
    write("dots.ppm", "P3 2 2 255 255 0 51  51 0 51  102 0 51  0 0 51\n");
    write("floor.toml",
          bytes_of(in("box.toml")) +
              "[[object]]\nshape = \"rectangle\"\nname = \"mat\"\nwidth = 1\ndepth = 1\n"
              "translate = [0, 0.1, 0]\nmaterial = \"mat\"\n"
              "[material.mat]\nKd = 0.5\nmap_Kd = { file = \"dots.ppm\", scale = [2, 2] }\n");
    const Outcome outcome = gw({"radiosity", "floor.toml", "-o", "own", "--hemicube", "16",
                                "--shots", "2", "--size", "8x8", "--lightmaps", "--quiet"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Pixels own = read_pixels(in("own/own_texture_1.png"));
    ASSERT_EQ(own.width, 2);
    const double red[] = {1, 0.2, 0.4, 0};
    for (int i = 0; i < 4; ++i) {
        EXPECT_NEAR(double(own.at(i % 2, i / 2)[0]), encoded(red[i]), 0.501 / 255);
        EXPECT_EQ(own.at(i % 2, i / 2)[1], 0);
    }
    const auto gltf = nlohmann::json::parse(bytes_of(in("own/light_maps.gltf")));
    std::size_t named = 0;
    for (const auto& mesh : gltf["meshes"]) {
        const auto& primitive = mesh["primitives"][0];
        const auto& extras = gltf["materials"][primitive["material"].get<std::size_t>()]["extras"];
        EXPECT_EQ(extras.contains("own"), mesh["name"] == "mat");
        if (!extras.contains("own")) continue;
        ++named;
        EXPECT_NEAR(extras["own"]["mean"][0].get<double>(), 0.4, 1e-9);
        EXPECT_NEAR(extras["own"]["mean"][2].get<double>(), 0.2, 1e-9);
        const auto& texture = gltf["textures"][extras["own"]["index"].get<std::size_t>()];
        EXPECT_EQ(gltf["images"][texture["source"].get<std::size_t>()]["uri"], "own_texture_1.png");
    }
    EXPECT_EQ(named, 1u);
}

TEST_F(LightMaps, AreRefusedWithoutAPicture) {
    expect_refused(2, {"radiosity", "box.toml", "--form-factor", "lamp", "ball", "--lightmaps"},
                   {"--lightmaps"});
}

}  // namespace gw::apps
