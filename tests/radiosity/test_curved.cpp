// Curved figures against light in closed form or summed by numerical integration: the sphere has the
// light of a sphere, and no chart's border is seen in it [F2.3].
#include "radiosity/display/displayed_pixmaps.h"
#include "radiosity/solver/solver.h"
#include "scene/scene_builder.h"
#include "scene/toml/shape_table.h"
#include "tests/radiosity/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace gw::radiosity {
namespace {

constexpr double radius = 0.6;

void add_sphere(scene::Scene& scene, int slices, int stacks, const dvec3& at) {
    const auto& shapes = scene::shapes();
    const auto shape = std::find_if(shapes.begin(), shapes.end(),
                                    [](const auto& s) { return s.name == "sphere"; });
    std::vector<double> values;
    for (const auto& p : shape->parameters)
        values.push_back(p.name == "radius" ? radius : p.name == "slices" ? slices : stacks);
    std::uint32_t next = 0;
    scene.materials.push_back({.name = "ball", .Kd = vec3(0.5f)});
    scene.objects.push_back({.name = "ball",
                             .mesh = scene::make_numbered_mesh(shape->make(values), next),
                             .material = scene.materials.size() - 1});
    scene.objects.back().world_from_object[3] = dvec4(at, 1);
}

/// The irradiance of a sphere's point from a lamp of side 1 in the plane y = height, facing down,
/// that emits 1: a sum over 16 x 16 parts of the lamp.
double light_of_lamp(const dvec3& p, const dvec3& n, double height) {
    constexpr int parts = 16;
    double sum = 0;
    for (int j = 0; j < parts; ++j)
        for (int i = 0; i < parts; ++i) {
            const dvec3 d = dvec3((i + 0.5) / parts - 0.5, height, (j + 0.5) / parts - 0.5) - p;
            const double d2 = dot3(d, d), cosines = dot3(n, d) * d.y;
            if (cosines > 0) sum += cosines / (M_PI * d2 * d2);
        }
    return sum / (parts * parts);
}

struct Errors {
    double relative = 0;  ///< rms, where the light is more than a tenth of the brightest
    double largest = 0;   ///< in parts of the brightest light
};

/// What is displayed in the middles of all facets of the ball, against exact(p, n) of the sphere.
template <class Exact>
Errors errors(const Solver& solver, bool with_ambient, const dvec3& center, Exact exact) {
    const PixmapModel& model = solver.model();
    const DisplayedPixmaps colors = displayed_pixmaps(model, solver.solution(), with_ambient);
    std::vector<std::array<double, 3>> points;  // area, shown, wanted
    double brightest = 0;
    for (const Facet& facet : model.facets) {
        if (model.figures[facet.figure].name != "ball") continue;
        const Triangle2& t = facet.triangles.front();
        const dvec2 middle = (t[0] + t[1] + t[2]) / 3.0;
        const dvec3 out = facet.at(middle) - center, n = out / length(out);
        points.push_back(
            {length(cross3(facet.at(t[1]) - facet.at(t[0]), facet.at(t[2]) - facet.at(t[0]))),
             colors.at(facet.pixmap, middle).x, exact(center + radius * n, n)});
        brightest = std::max(brightest, points.back()[2]);
    }
    double squares = 0, area = 0, largest = 0;
    for (const auto& [a, shown, wanted] : points) {
        largest = std::max(largest, std::abs(shown - wanted) / brightest);
        if (wanted < brightest / 10) continue;
        squares += a * (shown / wanted - 1) * (shown / wanted - 1);
        area += a;
    }
    return {std::sqrt(squares / area), largest};
}

/// The largest difference of displayed colours at a point that several charts share, in parts of its
/// light; points of little light are left out.
double largest_step(const PixmapModel& model, const DisplayedPixmaps& colors, double least) {
    std::map<std::array<float, 3>, std::vector<double>> at;
    for (const scene::Object& object : model.drawn.objects) {
        if (object.name != "ball") continue;
        for (const Triangle& t : object.mesh->triangles()) {
            const Facet& facet = model.facets[object.mesh->polygon_id(t.polygon)];
            for (std::uint32_t v : t.vertex) {
                const vec3& p = object.mesh->data().positions[v];
                at[{p.x, p.y, p.z}].push_back(colors.at(facet.pixmap, facet.texel_of(dvec3(p))).x);
            }
        }
    }
    double worst = 0;
    for (const auto& [p, values] : at) {
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        if (*high > least) worst = std::max(worst, (*high - *low) / *high);
    }
    return worst;
}

struct Resolution {
    double texels = 0, relative = 0, largest = 0;
};

class UnderALamp : public testing::TestWithParam<Resolution> {};

TEST_P(UnderALamp, ASphereHasTheLightOfASphere) {
    constexpr double height = 2;
    const auto [texels, relative, largest] = GetParam();
    scene::Scene scene;
    add_sphere(scene, 256, 128, dvec3(0));
    add_quad(scene, "lamp", {-0.5f, height, -0.5f}, {1, 0, 0}, {0, 0, 1}, 0, 10);
    Solver solver(make_model(scene, {.texels_per_unit = texels}));
    while (books(solver.model(), solver.solution()).unshot_share() > 1e-3) solver.shoot();
    const Errors found = errors(solver, false, dvec3(0), [&](const dvec3& p, const dvec3& n) {
        return 0.5 * 10 * light_of_lamp(p, n, height);
    });
    EXPECT_LT(found.relative, relative);
    EXPECT_LT(found.largest, largest);
    const DisplayedPixmaps colors = displayed_pixmaps(solver.model(), solver.solution(), false);
    EXPECT_LT(largest_step(solver.model(), colors, 0.1), 0.02);
}

INSTANTIATE_TEST_SUITE_P(Resolutions, UnderALamp,
                         testing::Values(Resolution{12, 0.012, 0.02}, Resolution{30, 0.004, 0.01}));

// In a lit room the sphere's light changes slowly: no border of a chart is seen.
TEST(Curved, NoChartsBorderIsSeenInARoom) {
    scene::Scene scene = closed_box({6, 3, 6}, 0.5f, 0);
    for (scene::Material& m : scene.materials)
        if (m.name == "ceiling") m.Ke = vec3(1);
    add_sphere(scene, 64, 32, {3, 1, 3});
    Solver solver(make_model(scene), {.form_factors = {.hemicube = 64}});
    while (books(solver.model(), solver.solution()).unshot_share() > 0.02) solver.shoot();
    const DisplayedPixmaps colors = displayed_pixmaps(solver.model(), solver.solution(), true);
    EXPECT_LT(largest_step(solver.model(), colors, 0), 0.015);
}

// In a furnace every point of a sphere has E / (1 - rho), at the borders of charts too.
TEST(Curved, ASphereInAFurnaceIsEquallyBright) {
    scene::Scene scene = closed_box({3, 3, 3}, 0.5f, 1);
    add_sphere(scene, 48, 24, {1.4, 1.5, 1.6});
    scene.materials.back().Ke = vec3(1);
    Solver solver(make_model(scene, {.texels_per_unit = 6}), {.form_factors = {.hemicube = 64}});
    while (books(solver.model(), solver.solution()).unshot_share() > 1e-4) solver.shoot();
    const Errors found = errors(solver, true, {1.4, 1.5, 1.6}, [](auto&&...) { return 2.0; });
    EXPECT_LT(found.relative, 0.005);
    EXPECT_LT(found.largest, 0.02);
}

}  // namespace
}  // namespace gw::radiosity
