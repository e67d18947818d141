// Form factors with closed forms: Howell's catalogue C-11, C-14, C-41, B-3, B-4.
#include "radiosity/hemicube/form_factors.h"
#include "tests/radiosity/scenes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

namespace gw::radiosity {
namespace {

double sum(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST(DeltaFormFactors, AddUpToOne) {
    for (int size : {8, 64, 512}) {
        const DeltaFormFactors delta = delta_form_factors(size);
        EXPECT_NEAR(sum(delta.top) + 4 * sum(delta.side), 1, 1e-12);
    }
}

/// The mean of patches' rows over an object, weighted by area.
double between(const PixmapModel& model, FormFactors& factors, const std::string& from,
               const std::string& to) {
    double f = 0, area = 0;
    for (std::size_t p = 0; p < model.patches.size(); ++p) {
        bool own = false;
        for (const Figure& figure : model.figures)
            own = own || (figure.name == from && figure.pixmap == model.patches[p].pixmap);
        if (!own) continue;
        const Row row = factors.from_patch(p);
        EXPECT_NEAR(sum(row.factors) + row.backs + row.escaped, 1, 1e-9);
        f += model.patches[p].area * to_object(model, row, to);
        area += model.patches[p].area;
    }
    return f / area;
}

// An observer draws a patch's hemicubes by itself, and finds the light that escaped.
TEST(FormFactors, ShowTheHemicubesOfAPatch) {
    scene::Scene scene;
    add_quad(scene, "a", {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0, 1);
    add_quad(scene, "b", {0, 1, 0}, {1, 0, 0}, {0, 0, 1});
    const PixmapModel model = make_model(scene, {.texels_per_unit = 4});
    FormFactors factors(model, {.hemicube = 64});
    const auto points = points_of(model, model.patches[0]);
    ASSERT_GT(points.size(), 1);
    HemicubePainter painter(64);
    IdBuffers buffers;
    std::array<double, 4> of_quarters{};
    for (std::size_t i = 0; i < points.size(); ++i) {
        painter.draw(model, factors.hemicube_on(points, i, 0), buffers);
        of_quarters[std::size_t(points[i].quarter)] +=
            points[i].share * escaping(buffers, delta_form_factors(64));
    }
    const double escaped = std::accumulate(of_quarters.begin(), of_quarters.end(), 0.0);
    EXPECT_GT(escaped, 0.1);
    EXPECT_EQ(escaped, factors.from_patch(0).escaped);
}

TEST(FormFactors, ParallelSquares) {
    scene::Scene scene;
    add_quad(scene, "a", {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0, 1);
    add_quad(scene, "b", {0, 1, 0}, {1, 0, 0}, {0, 0, 1});
    const PixmapModel model = make_model(scene, {.texels_per_unit = 4});
    FormFactors factors(model, {.hemicube = 512});
    EXPECT_NEAR(between(model, factors, "a", "b") / 0.19982489569838738, 1, 0.005);
}

TEST(FormFactors, PerpendicularSquares) {
    scene::Scene scene;
    add_quad(scene, "a", {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0, 1);
    add_quad(scene, "b", {0, 0, 0}, {0, 1, 0}, {0, 0, 1});
    const PixmapModel model = make_model(scene, {.texels_per_unit = 4});
    FormFactors factors(model, {.hemicube = 512});
    EXPECT_NEAR(between(model, factors, "a", "b") / 0.20004377607540315, 1, 0.005);
    EXPECT_NEAR(between(model, factors, "b", "a") / 0.20004377607540315, 1, 0.005);
}

/// From a point on the floor, looking up.
double from_point(const scene::Scene& scene, const std::string& to, const dvec3& at,
                  std::uint64_t seed) {
    const PixmapModel model = make_model(scene, {.texels_per_unit = 4});
    FormFactors factors(model, {.hemicube = 512, .seed = seed});
    return to_object(model, factors.from_points({{at, {0, 1, 0}, 1, 1}}, 0), to);
}

// B-4 four times: a point under the middle of a parallel square. Any turn of the hemicube serves.
TEST(FormFactors, APointUnderTheMiddleOfASquare) {
    scene::Scene scene;
    add_quad(scene, "square", {-0.5, 1, -0.5}, {1, 0, 0}, {0, 0, 1}, 0, 1);
    for (std::uint64_t seed = 0; seed < 4; ++seed)
        EXPECT_NEAR(from_point(scene, "square", {0, 0, 0}, seed) / 0.23945647046077354, 1, 0.002)
            << seed;
}

// B-3: a point before a perpendicular rectangle a wide and b high, at distance c from its lower
// corner: F = (atan(a / c) - c / sqrt(b^2 + c^2) atan(a / sqrt(b^2 + c^2))) / (2 pi).
TEST(FormFactors, APointBeforeAPerpendicularRectangle) {
    const double a = 0.75, b = 1.5, c = 0.5, d = std::sqrt(b * b + c * c);
    const double exact = (std::atan(a / c) - c / d * std::atan(a / d)) / (2 * 3.141592653589793);
    scene::Scene scene;
    add_quad(scene, "wall", {0, 0, 0}, {0, 0, float(a)}, {0, float(b), 0}, 0, 1);
    scene.objects[0].mesh = make_mesh(
        {.primitive = Primitive::Quads,
         .positions = {{0, 0, 0}, {0, float(b), 0}, {0, float(b), float(a)}, {0, 0, float(a)}}});
    EXPECT_NEAR(from_point(scene, "wall", {c, 0, 0}, 1) / exact, 1, 0.002);
}

// A square halfway hides exactly the middle of the one behind it: what is left is the difference.
TEST(FormFactors, AnOccluderTakesWhatItCovers) {
    scene::Scene scene;
    add_quad(scene, "far", {-1, 2, -1}, {2, 0, 0}, {0, 0, 2}, 0, 1);
    const double open = from_point(scene, "far", {0, 0, 0}, 1);
    add_quad(scene, "near", {-0.25, 1, -0.25}, {0.5, 0, 0}, {0, 0, 0.5});
    const double behind = from_point(scene, "far", {0, 0, 0}, 1),
                 before = from_point(scene, "near", {0, 0, 0}, 1);
    EXPECT_NEAR(open / 0.23945647046077354, 1, 0.002);
    EXPECT_NEAR(before + behind, open, 0.002 * open);
    EXPECT_GT(before, 0.05);
}

// C-41, discs r = 1, 1 at h = 1, as polygons of 96 sides, whose area is 0.9993 of the circle's.
TEST(FormFactors, CoaxialDiscs) {
    scene::Scene scene;
    const auto add_disc = [&](const char* name, float y, bool up) {
        MeshData disc{.primitive = Primitive::Polygons};
        for (int i = 0; i < 96; ++i) {
            const double t = (up ? -1 : 1) * 6.283185307179586 * i / 96;
            disc.positions.push_back(vec3(std::cos(t), y, std::sin(t)));
        }
        scene.materials.push_back({.name = name, .Kd = vec3(0), .Ke = vec3(1)});
        scene.objects.push_back(
            {.name = name, .mesh = make_mesh(disc), .material = scene.materials.size() - 1});
    };
    add_disc("a", 0, true);
    add_disc("b", 1, false);
    const PixmapModel model = make_model(scene, {.texels_per_unit = 4});
    FormFactors factors(model, {.hemicube = 128});
    EXPECT_NEAR(between(model, factors, "a", "b") / 0.38196601125010515, 1, 0.005);
}

}  // namespace
}  // namespace gw::radiosity
