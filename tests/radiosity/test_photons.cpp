// [F] The Cornell box against a light tracer: mean irradiances.
#include "radiosity/solver/solver.h"
#include "scene/toml/read_scene.h"
#include "test_paths.h"
#include "tests/radiosity/photons.h"
#include "tests/radiosity/scenes.h"

#include <gtest/gtest.h>

namespace gw::radiosity {
namespace {

double sum_of(const dvec3& v) { return v.x + v.y + v.z; }

/// Of a facet that has a pixmap of its own; with an estimate of the light that is yet to come.
double mean_irradiance(const Solver& solver, const Facet& facet) {
    const PixmapModel& model = solver.model();
    const Pixmap& pixmap = model.pixmaps[facet.pixmap];
    double flux = 0, area = 0;
    for (std::size_t t = pixmap.first; t < pixmap.first + pixmap.count(); ++t) {
        flux += model.area[t] * sum_of(solver.solution().H[t]);
        area += model.area[t];
    }
    return flux / area + sum_of(ambient(model, solver.solution()));
}

// The oracle's oracle: B = E / (1 - rho) in a furnace.
TEST(Photons, AFurnaceIsEquallyBrightEverywhere) {
    const scene::Scene scene = closed_box({1, 1.25f, 1.5f}, 0.5f, 1);
    const PixmapModel model = make_model(scene);
    for (const Irradiance& found : Photons(scene, model).trace(16, 4000)) {
        EXPECT_LT(found.standard_error, 0.01 * 3 * 2);
        EXPECT_NEAR(found.mean, 3 * 2, 5 * found.standard_error);
    }
}

/// The left wall's two facets share a pixmap.
bool is_compared(const std::string& name) { return name != "left_wall" && name != "lamp"; }

bool is_side(const Facet& facet, const std::string& name) {
    return (name == "short_block" || name == "tall_block") && facet.normal.y < 0.5;
}

// With the scene's texels and the default hemicubes and patches.
TEST(Photons, CornellBoxIsWithinOnePercentAndTheBlocksSidesWithinTwo) {
    const scene::Scene scene =
        scene::read_scene(GW_SOURCE_DIR "/scenes/radiosity/cornell.toml").scene;
    Solver solver(make_model(scene));
    while (books(solver.model(), solver.solution()).unshot_share() > 0.0001) solver.shoot();
    const auto reference = Photons(scene, solver.model()).trace(64, 40000);
    int compared = 0;
    for (std::size_t f = 0; f < reference.size(); ++f) {
        const Facet& facet = solver.model().facets[f];
        const std::string& name = solver.model().figures[facet.figure].name;
        if (!is_compared(name)) continue;
        ++compared;
        const bool side = is_side(facet, name);
        const auto [mean, standard_error] = reference[f];
        EXPECT_LT(standard_error, (side ? 0.018 : 0.003) * mean) << name;
        EXPECT_NEAR(mean_irradiance(solver, facet), mean,
                    (side ? 0.02 : 0.01) * mean + 3 * standard_error)
            << name << " " << facet.normal.x << " " << facet.normal.z;
    }
    EXPECT_EQ(compared, 14);
}

}  // namespace
}  // namespace gw::radiosity
