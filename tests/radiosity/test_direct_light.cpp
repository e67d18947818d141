// Lamps in candela and lumen: illuminances in closed form.
#include "radiosity/solver/direct_light.h"

#include "gw/base/elementary.h"
#include "radiosity/display/displayed_pixmaps.h"
#include "radiosity/display/nearest_point.h"
#include "radiosity/solver/shares.h"
#include "radiosity/solver/solver.h"
#include "tests/radiosity/scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gw::radiosity {
namespace {

constexpr double candela = 300;

scene::Light point_light(const vec3& position, double I = candela) {
    return {.name = "lamp",
            .kind = scene::LightKind::Point,
            .position = position,
            .luminous = scene::Luminous{dvec3(I), nullptr, 0}};
}

/// 2 x 2, facing up, about the origin.
scene::Scene floor_of(float rho = 0) {
    scene::Scene scene;
    add_quad(scene, "floor", {-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, rho);
    return scene;
}

PixmapModel lit(const scene::Scene& scene, double texels = 8, int hemicube = 128) {
    PixmapModel model = make_model(scene, {.texels_per_unit = texels});
    add_direct_light(scene, model, {.hemicube = hemicube});
    return model;
}

/// Of a rectangle (x0, x1) x (z0, z1) in the plane that is h below.
double solid_angle(double x0, double x1, double z0, double z1, double h) {
    const auto part = [&](double x, double z) {
        return std::atan(x * z / (h * std::sqrt(x * x + z * z + h * h)));
    };
    return part(x1, z1) - part(x0, z1) - part(x1, z0) + part(x0, z0);
}

}  // namespace

// The mean over a texel is I times its solid angle by its area: I / d² below the lamp.
TEST(DirectLight, OfAPointFallsWithTheSquareOfTheDistance) {
    for (const double h : {0.5, 1.0, 2.0, 5.0}) {  // the last one is beyond the scene's extent
        scene::Scene scene = floor_of();
        scene.lights = {point_light({0, float(h), 0})};
        const PixmapModel model = lit(scene, 8, h > 2 ? 256 : 128);
        ASSERT_EQ(model.texel_count(), 256u);
        for (std::size_t t = 0; t < 256; ++t) {
            const dvec3 p = model.middle[t];
            const double s = 1.0 / 16,
                         expected = candela * solid_angle(p.x - s, p.x + s, p.z - s, p.z + s, h) /
                                    (4 * s * s);
            EXPECT_NEAR(model.direct[0].H[t].x, expected, 0.01 * expected) << h << " " << t;
        }
        EXPECT_NEAR(model.direct[0].emitted.x, 4 * pi * candela, 1e-9);
        const double seen = solid_angle(-1, 1, -1, 1, h) / (4 * pi);
        EXPECT_NEAR(model.direct[0].escaped.x, 4 * pi * candela * (1 - seen),
                    0.002 * 4 * pi * candela);
    }
}

TEST(DirectLight, IsBrightestAtTheFootOfTheLamp) {
    scene::Scene scene = floor_of();
    scene.lights = {point_light({0, 2, 0})};
    const PixmapModel model = lit(scene, 32, 256);
    const SurfacePoint at = nearest_point(model, {0.01, -0.5, 0.01});
    EXPECT_NEAR(at.distance, 0.5, 1e-9);
    const DisplayedPixmaps lux = displayed_irradiance(model, initial_solution(model), true);
    EXPECT_NEAR(lux.at(model.facets[at.facet].pixmap, at.uv).x, candela / 4, 0.005 * candela / 4);
}

TEST(DirectLight, IsStoppedByWhatStandsInItsWay) {
    scene::Scene scene = floor_of();
    add_quad(scene, "shade", {-0.25f, 0.5f, -0.25f}, {0.5f, 0, 0}, {0, 0, 0.5f});  // faces down
    add_quad(scene, "top", {-0.25f, 0.51f, -0.25f}, {0, 0, 0.5f}, {0.5f, 0, 0});   // faces up
    scene.lights = {point_light({0, 1, 0})};
    const PixmapModel model = lit(scene);
    for (std::size_t t = 0; t < 256; ++t) {
        const dvec3 p = model.middle[t];
        const double out = std::max(std::abs(p.x), std::abs(p.z));
        if (out < 0.4) {
            EXPECT_EQ(model.direct[0].H[t].x, 0) << t;
        } else if (out > 0.6) {
            EXPECT_GT(model.direct[0].H[t].x, 50) << t;
        }
    }
}

TEST(DirectLight, OfAClosedRoomArrivesWhole) {
    scene::Scene scene = closed_box({1, 1.5f, 2}, 0.5f, 0);
    scene.lights = {point_light({0.3f, 1.2f, 0.7f}), point_light({0.7f, 0.2f, 1.7f}, 100)};
    scene.lights[1].name = "other";
    Solver solver(lit(scene), {.form_factors = {.hemicube = 64}});
    for (const DirectLight& light : solver.model().direct)
        EXPECT_NEAR(light.escaped.x / light.emitted.x, 0, 0.002) << light.name;
    for (int i = 0; i < 20; ++i) {
        EXPECT_LT(books(solver.model(), solver.solution()).imbalance(), 1e-9);
        solver.shoot();
    }
    EXPECT_EQ(lamps_of(solver.model()), (std::vector<std::string>{"lamp", "other"}));
}

TEST(DirectLight, OfADistributionWithoutDirectionIsThePlainLamps) {
    scene::Scene plain = floor_of();
    plain.lights = {point_light({0.2f, 1, 0})};
    scene::Scene ies = plain;
    ies.lights[0].kind = scene::LightKind::Spot;
    ies.lights[0].luminous->candela = dvec3(1);
    ies.lights[0].luminous->web = std::make_shared<const scene::Photometry>(
        scene::Photometry{.vertical = {0, 90, 180},
                          .horizontal = {0},
                          .candela = {candela, candela, candela},
                          .name = "even"});
    const PixmapModel a = lit(plain), b = lit(ies);
    for (std::size_t t = 0; t < a.texel_count(); ++t)
        EXPECT_NEAR(a.direct[0].H[t].x, b.direct[0].H[t].x, 1e-9 * a.direct[0].H[t].x);
}

// A share of a lamp in candela is a share as others.
TEST(DirectLight, IsAShare) {
    scene::Scene scene = closed_box({1, 1, 1}, 0.5f, 0);
    scene.materials[1].Ke = vec3(100);
    scene.lights = {point_light({0.5f, 0.5f, 0.5f})};
    Solver solver(lit(scene, 4), {.form_factors = {.hemicube = 32}});
    std::vector<Share> shares = initial_shares(solver.model());
    ASSERT_EQ(shares.size(), 2u);
    solver.follow({shares[0].solution, shares[1].solution});
    for (int i = 0; i < 20; ++i) solver.shoot();
    for (std::size_t i = 0; i < 2; ++i) shares[i].solution = solver.parts()[i];
    PixmapModel model = lit(scene, 4);
    const Solution sum = mix(shares, {dvec3(1), dvec3(1)}, model);
    for (std::size_t t = 0; t < model.texel_count(); ++t)
        EXPECT_NEAR(sum.H[t].x, solver.solution().H[t].x, 1e-9 * sum.H[t].x);
    const Solution twice = mix(shares, {dvec3(0), dvec3(2)}, model);
    EXPECT_NEAR(books(model, twice).emitted.x, 8 * pi * candela, 1e-6);
    EXPECT_LT(books(model, twice).imbalance(), 1e-9);
}

// The lamp goes, its light is taken back, and only the difference is sent.
TEST(DirectLight, OfAMovedLampIsTheNewOnes) {
    scene::Scene scene = closed_box({1, 1, 1}, 0.5f, 0);
    scene.lights = {point_light({0.3f, 0.5f, 0.5f})};
    Solver solver(lit(scene, 4), {.form_factors = {.hemicube = 32}});
    for (int i = 0; i < 60; ++i) solver.shoot();
    scene.lights[0].position = {0.7f, 0.4f, 0.5f};
    scene.objects[0].pixmap.emission = vec3(1);
    solver.update(lit(scene, 4));
    Solver anew(lit(scene, 4), {.form_factors = {.hemicube = 32}});
    for (int i = 0; i < 60; ++i) {
        solver.shoot();
        anew.shoot();
    }
    EXPECT_LT(books(solver.model(), solver.solution()).imbalance(), 1e-9);
    for (std::size_t t = 0; t < anew.model().texel_count(); ++t) {
        const double B = radiosity_at(anew.model(), anew.solution(), t).x;
        EXPECT_NEAR(radiosity_at(solver.model(), solver.solution(), t).x, B, 0.01 * B) << t;
    }
}

// E = pi L R² / (R² + h²) at the foot of a disc of luminance L, and L = lumen / (pi area).
TEST(DirectLight, OfALambertianDiscInLumen) {
    constexpr double lumen = 1000, R = 0.5, h = 1;
    for (const int slices : {64, 128}) {
        scene::Scene scene = floor_of();
        MeshData disc{.positions = {{0, float(h), 0}}};
        for (int i = 0; i < slices; ++i) {
            const double a = 2 * pi * i / slices;
            disc.positions.push_back({float(R * std::cos(a)), float(h), float(R * std::sin(a))});
            disc.indices.insert(disc.indices.end(),
                                {0u, std::uint32_t(i + 1), std::uint32_t((i + 1) % slices + 1)});
        }
        scene.materials.push_back({.name = "lamp", .Kd = vec3(0)});
        scene.objects.push_back(
            {.name = "lamp", .mesh = make_mesh(std::move(disc)), .material = 1});
        scene.objects.back().pixmap.lumen = lumen;
        Solver solver(make_model(scene, {.texels_per_unit = 24}),
                      {.form_factors = {.hemicube = 128}});
        const PixmapModel& model = solver.model();
        EXPECT_NEAR(books(model, solver.solution()).emitted.x, lumen, 1e-3);
        while (solver.shoot()) {
        }
        const SurfacePoint at = nearest_point(model, {0, -1, 0});
        const double L = lumen / (pi * pi * R * R), expected = pi * L * R * R / (R * R + h * h),
                     lux = displayed_irradiance(model, solver.solution(), false)
                               .at(model.facets[at.facet].pixmap, at.uv)
                               .x;
        EXPECT_NEAR(lux, expected, 0.01 * expected) << slices;
    }
}

}  // namespace gw::radiosity
