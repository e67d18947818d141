// The Cornell box's colours are derived from the measured reflectances; scenes/models/cornell.obj
// names their source.
#include "scene/toml/read_scene.h"
#include "test_paths.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace gw::scene {
namespace {

constexpr int samples = 16;  // 400, 420, ... 700 nm
using Spectrum = std::array<double, samples>;

// Measured reflectances, every fifth of those published.
constexpr Spectrum white{0.343, 0.687, 0.745, 0.765, 0.745, 0.747, 0.725, 0.743,
                         0.733, 0.764, 0.740, 0.744, 0.712, 0.707, 0.751, 0.737};
constexpr Spectrum green{0.092, 0.095, 0.097, 0.104, 0.125, 0.285, 0.472, 0.441,
                         0.337, 0.250, 0.160, 0.126, 0.114, 0.120, 0.144, 0.159};
constexpr Spectrum red{0.040, 0.050, 0.059, 0.062, 0.060, 0.058, 0.057, 0.059,
                       0.067, 0.099, 0.287, 0.513, 0.609, 0.638, 0.642, 0.642};

// CIE 1931 2-degree colour matching functions at these wavelengths.
constexpr Spectrum x{0.0143, 0.1344, 0.3483, 0.2908, 0.0956, 0.0049, 0.0633, 0.2940,
                     0.5945, 0.9163, 1.0622, 0.8544, 0.4479, 0.1649, 0.0468, 0.0114};
constexpr Spectrum y{0.0004, 0.0040, 0.0230, 0.0600, 0.1390, 0.3230, 0.7100, 0.9540,
                     0.9950, 0.8700, 0.6310, 0.3810, 0.1750, 0.0610, 0.0170, 0.0041};
constexpr Spectrum z{0.0679, 0.6456, 1.7471, 1.6692, 0.8130, 0.2720, 0.0782, 0.0203,
                     0.0039, 0.0017, 0.0008, 0.0002, 0,      0,      0,      0};

// Linear R, G, B from X, Y, Z [IEC 61966-2-1].
constexpr double rgb_from_xyz[3][3] = {
    {3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}};

dvec3 rgb(const Spectrum& reflectance) {
    dvec3 sum(0), all(0);
    for (std::size_t i = 0; i < samples; ++i)
        for (int c = 0; c < 3; ++c) {
            const double w =
                rgb_from_xyz[c][0] * x[i] + rgb_from_xyz[c][1] * y[i] + rgb_from_xyz[c][2] * z[i];
            sum[c] += w * reflectance[i];
            all[c] += w;
        }
    return sum / all;
}

Scene cornell() {
    return read_scene(std::filesystem::path(GW_SOURCE_DIR) / "scenes" / "cornell.toml").scene;
}

TEST(Cornell, TheColoursAreThoseOfTheMeasuredReflectances) {
    const Scene scene = cornell();
    const auto expect = [&](const char* name, const Spectrum& reflectance) {
        const auto material = std::ranges::find(scene.materials, name, &Material::name);
        ASSERT_NE(material, scene.materials.end()) << name;
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(material->Kd[c], rgb(reflectance)[c], 0.0006) << name << " " << c;
        EXPECT_EQ(material->Ka, material->Kd);
    };
    expect("white", white);
    expect("green", green);
    expect("red", red);
}

double area(const Object& object) {
    double sum = 0;
    for (const Triangle& t : object.mesh->triangles()) {
        const auto p = [&](int k) {
            return dvec3(object.mesh->data().positions[t.vertex[std::size_t(k)]]);
        };
        sum += glm::length(glm::cross(p(1) - p(0), p(2) - p(0))) / 2;
    }
    return sum;
}

TEST(Cornell, TheCeilingLeavesTheLampOut) {
    double lamp = 0, ceiling = 0;
    for (const Object& object : cornell().objects) {
        if (object.name == "lamp") lamp += area(object);
        if (object.name == "ceiling") ceiling += area(object);
    }
    EXPECT_NEAR(lamp, 130 * 105, 1e-3);
    EXPECT_NEAR(ceiling, 556 * 559.2 - 130 * 105, 0.1);
}

// The camera's fov is the one of a film 25 mm high behind a lens of 35 mm: tan(fov / 2) = 12.5 /
// 35.
TEST(Cornell, TheCameraIsThePublishedOne) {
    const Camera camera = cornell().camera.value();
    EXPECT_EQ(camera.eye, dvec3(278, 273, -800));
    EXPECT_NEAR(std::tan(camera.fov / 2 * 3.14159265358979 / 180), 12.5 / 35, 1e-6);
}

}  // namespace
}  // namespace gw::scene
