// Form factors of figures of many sizes, distances and angles, both ways, within half a percent:
// Howell's C-11, C-14 and C-41 over their parameters, and sums of Lambert's formula where there is
// no closed form.
#include "radiosity/hemicube/form_factors.h"
#include "tests/radiosity/oracle.h"
#include "tests/radiosity/scenes.h"

#include <gtest/gtest.h>

namespace gw::radiosity {
namespace {

void add(scene::Scene& scene, const std::string& name, const Quad& quad, float emission = 0) {
    add_quad(scene, name, vec3(quad.corner), vec3(quad.a), vec3(quad.b), 0, emission);
}

/// From one object to another: the mean of its patches' rows.
double between(const PixmapModel& model, const std::string& from, const std::string& to,
               int hemicube) {
    FormFactors factors(model, {.hemicube = hemicube});
    double f = 0, area = 0;
    for (std::size_t p = 0; p < model.patches.size(); ++p) {
        bool own = false;
        for (const Figure& figure : model.figures)
            own = own || (figure.name == from && figure.pixmap == model.patches[p].pixmap);
        if (!own) continue;
        f += model.patches[p].area * to_object(model, factors.from_patch(p), to);
        area += model.patches[p].area;
    }
    return f / area;
}

struct Case {
    const char* name;
    Quad a, b;
    double exact;  ///< from a to b
};

Quad up(double x, double y, double z, double width, double depth) {
    return {{x, y, z}, {0, 0, depth}, {width, 0, 0}};
}
Quad down(double x, double y, double z, double width, double depth) {
    return {{x, y, z}, {width, 0, 0}, {0, 0, depth}};
}
/// Of the plane x = 0 turned by an angle from the floor about the z axis, facing the floor's side.
Quad wedge(double cosine, double sine, double height, double depth) {
    return {{0, 0, 0}, {height * cosine, height * sine, 0}, {0, 0, depth}};
}
Quad moved(Quad quad, const dvec3& by) {
    quad.corner += by;
    return quad;
}

Case summed(const char* name, const Quad& a, const Quad& b) {
    return {name, a, b, quad_to_quad(a, b)};
}

std::vector<Case> cases() {
    const Quad floor = up(0, 0, 0, 1, 1), wall = wedge(0, 1, 1, 1);
    return {
        {"equal squares, near", floor, down(0, 0.25, 0, 1, 1), parallel_rectangles(1, 1, 0.25)},
        {"rectangles, far", up(0, 0, 0, 2, 1), down(0, 3, 0, 2, 1), parallel_rectangles(2, 1, 3)},
        {"a deep floor and a low wall", up(0, 0, 0, 2, 1), wedge(0, 1, 0.5, 1),
         perpendicular_rectangles(2, 0.5, 1)},
        {"a narrow floor and a high wall", up(0, 0, 0, 0.3, 2), wedge(0, 1, 3, 2),
         perpendicular_rectangles(0.3, 3, 2)},
        summed("parallel, beside each other", floor, down(0.7, 0.6, 1.2, 0.5, 2)),
        summed("perpendicular, apart", floor, moved(wall, {-0.4, 0.3, 0})),
        summed("a wedge of 60 degrees", floor, wedge(0.5, 0.8660254, 1, 1)),
        summed("a wedge of 120 degrees", floor, wedge(-0.5, 0.8660254, 1, 1)),
    };
}

class ClosedForms : public testing::TestWithParam<std::tuple<std::size_t, double>> {};

// With texels of a quarter, and with one texel for all: the form factor does not depend on the
// pixmap.
TEST_P(ClosedForms, BothWaysAndReciprocal) {
    const auto [number, texels] = GetParam();
    const Case c = cases()[number];
    scene::Scene scene;
    add(scene, "a", c.a, 1);
    add(scene, "b", c.b);
    const PixmapModel model = make_model(scene, {.texels_per_unit = texels});
    const double ab = between(model, "a", "b", 96), ba = between(model, "b", "a", 96);
    EXPECT_NEAR(ab / c.exact, 1, 0.005) << c.name;
    EXPECT_NEAR(ba / (c.exact * length(c.a.cross()) / length(c.b.cross())), 1, 0.005) << c.name;
}

INSTANTIATE_TEST_SUITE_P(Rectangles, ClosedForms,
                         testing::Combine(testing::Range<std::size_t>(0, cases().size()),
                                          testing::Values(0.3, 4.0)));

// A square hidden in part from all of another one by a third between them.
TEST(ClosedForms, AnOccluderBetweenTwoSquares) {
    const Quad floor = up(0, 0, 0, 1, 1), ceiling = down(0, 1, 0, 1, 1),
               between_them = up(0.3, 0.5, 0.2, 0.5, 0.4);
    scene::Scene scene;
    add(scene, "floor", floor, 1);
    add(scene, "ceiling", ceiling);
    add(scene, "screen", between_them);
    const PixmapModel model = make_model(scene, {.texels_per_unit = 8});
    EXPECT_NEAR(
        between(model, "floor", "ceiling", 64) / quad_to_quad_behind(floor, ceiling, between_them),
        1, 0.005);
}

// C-41: discs of different radii, as polygons of 96 sides, whose area is 0.9993 of the circle's.
TEST(ClosedForms, CoaxialDiscsOfDifferentRadii) {
    scene::Scene scene;
    const auto add_disc = [&](const char* name, double r, double y, bool faces_up) {
        MeshData disc{.primitive = Primitive::Polygons};
        for (int i = 0; i < 96; ++i) {
            const double t = (faces_up ? -1 : 1) * 2 * M_PI * i / 96;
            disc.positions.push_back(vec3(r * std::cos(t), y, r * std::sin(t)));
        }
        scene.materials.push_back({.name = name, .Kd = vec3(0), .Ke = vec3(1)});
        scene.objects.push_back(
            {.name = name, .mesh = make_mesh(disc), .material = scene.materials.size() - 1});
    };
    add_disc("small", 0.5, 0, true);
    add_disc("large", 1.5, 0.75, false);
    const PixmapModel model = make_model(scene, {.texels_per_unit = 4});
    EXPECT_NEAR(between(model, "small", "large", 64) / coaxial_discs(0.5, 1.5, 0.75), 1, 0.005);
    EXPECT_NEAR(between(model, "large", "small", 64) / coaxial_discs(1.5, 0.5, 0.75), 1, 0.005);
}

// A point looking at a sphere that is wholly over its horizon: (r / d)^2 cos.
TEST(ClosedForms, APointBeforeASphere) {
    constexpr int slices = 64, stacks = 32;
    MeshData ball;
    const auto at = [](int i, int j) {
        const double u = 2 * M_PI * i / slices, v = M_PI * j / stacks;
        return vec3(0.6 + 0.5 * std::sin(v) * std::cos(u), 1.2 + 0.5 * std::cos(v),
                    0.5 * std::sin(v) * std::sin(u));
    };
    for (int j = 0; j < stacks; ++j)
        for (int i = 0; i < slices; ++i)
            for (const auto& [di, dj] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
                ball.positions.push_back(at(i + di, j + dj));
    scene::Scene scene;
    scene.materials.push_back({.name = "glow", .Kd = vec3(0), .Ke = vec3(1)});
    scene.objects.push_back({.name = "ball", .mesh = make_mesh(ball)});
    const PixmapModel model = make_model(scene, {.texels_per_unit = 4});
    FormFactors factors(model, {.hemicube = 128});
    const double d2 = 0.6 * 0.6 + 1.2 * 1.2, exact = 0.25 / d2 * 1.2 / std::sqrt(d2);
    EXPECT_NEAR(
        to_object(model, factors.from_points({{{0, 0, 0}, {0, 1, 0}, 1, 1}}, 0), "ball") / exact, 1,
        0.005);
}

/// Squares of 16 x 16 texels, nearer to each other than a part of a texel: nothing passes the second.
TEST(ClosedForms, NothingLeaksThroughANearSurface) {
    for (double distance : {1e-2, 2e-3, 5e-4, 1e-4, 1e-5}) {
        scene::Scene scene;
        add(scene, "floor", up(0, 0, 0, 1, 1), 1);
        add(scene, "lid", down(0, distance, 0, 1, 1));
        add(scene, "behind", down(-1, 0.5, -1, 3, 3));
        const PixmapModel model = make_model(scene, {.texels_per_unit = 16});
        const double exact = parallel_rectangles(1, 1, distance);
        EXPECT_NEAR(between(model, "floor", "lid", 64), exact, 0.005 * exact) << distance;
        EXPECT_LT(between(model, "floor", "behind", 64), 1.005 - exact) << distance;
    }
}

}  // namespace
}  // namespace gw::radiosity
