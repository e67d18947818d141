// Shooting: the books, the furnace.
#include "radiosity/solver/solver.h"
#include "tests/radiosity/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

namespace gw::radiosity {
namespace {

// All surfaces emit E and reflect rho: B = E / (1 - rho) everywhere, in the corners too.
TEST(Solver, AFurnaceIsEquallyBrightEverywhere) {
    Solver solver(make_model(closed_box({1, 1.25f, 1.5f}, 0.5f, 1), {.texels_per_unit = 8}),
                  {.form_factors = {.hemicube = 64}});
    for (;;) {
        const Books b = books(solver.model(), solver.solution());
        EXPECT_LT(b.imbalance(), 1e-5);
        if (b.unshot_share() < 1e-4) break;
        solver.shoot();
    }
    double low = 1e9, high = 0;
    for (std::size_t t = 0; t < solver.model().texel_count(); ++t) {
        const double B = radiosity_at(solver.model(), solver.solution(), t).x;
        low = std::min(low, B);
        high = std::max(high, B);
    }
    EXPECT_GT(low, 2 * 0.995);
    EXPECT_LT(high, 2 * 1.005);
}

/// A box with one bright wall and different colours.
scene::Scene colored_box() {
    scene::Scene scene = closed_box({1, 1, 1}, 0.5f, 0);
    scene.materials[0].Ke = {1, 2, 3};
    scene.materials[1].Kd = {0.9f, 0.1f, 0.4f};
    scene.materials[2].Kd = {0, 1, 0.5f};
    return scene;
}

const SolverOptions coarse{
    .form_factors = {.hemicube = 32, .points = {.smallest_of_pixmap = 1.0 / 4}}};
const ModelOptions few_texels{.texels_per_unit = 4};

TEST(Solver, TheBooksBalanceAtEveryStepInEveryChannel) {
    Solver solver(make_model(colored_box(), few_texels), coarse);
    for (int i = 0; i < 40; ++i) {
        ASSERT_TRUE(solver.shoot());
        EXPECT_LT(books(solver.model(), solver.solution()).imbalance(), 1e-9);
    }
    const Books b = books(solver.model(), solver.solution());
    EXPECT_EQ(b.escaped, dvec3(0));
    EXPECT_NEAR(b.emitted.z / b.emitted.x, 3, 1e-6);
}

TEST(Solver, TheOpenSceneBalancesWithWhatEscapes) {
    scene::Scene scene = colored_box();
    scene.objects.pop_back();
    Solver solver(make_model(scene, few_texels), coarse);
    for (int i = 0; i < 20; ++i) solver.shoot();
    const Books b = books(solver.model(), solver.solution());
    EXPECT_LT(b.imbalance(), 1e-9);
    EXPECT_GT(b.escaped.x, 0.05 * b.emitted.x);
}

TEST(Solver, ThreadsAndKeptRowsMakeNoDifference) {
    const auto solved = [](int threads, std::size_t memory) {
        SolverOptions options = coarse;
        options.form_factors.threads = threads;
        options.row_memory = memory;
        Solver solver(make_model(colored_box(), few_texels), options);
        for (int i = 0; i < 30; ++i) solver.shoot();
        return solver.solution();
    };
    const Solution one = solved(1, std::size_t{1} << 30);
    EXPECT_EQ(one, solved(3, std::size_t{1} << 30));
    EXPECT_EQ(one, solved(2, 0));
}

TEST(Solver, ACanceledShotChangesNothing) {
    std::atomic<bool> cancel = false;
    SolverOptions options = coarse;
    options.form_factors.cancel = &cancel;
    Solver solver(make_model(colored_box(), few_texels), options);
    solver.shoot();
    const Solution before = solver.solution();
    cancel = true;
    EXPECT_THROW(solver.shoot(), FormFactors::Canceled);
    EXPECT_EQ(solver.solution(), before);
}

/// A floor under a lamp that hangs over one end: its patches are brighter on one side.
scene::Scene lit_floor() {
    scene::Scene scene;
    add_quad(scene, "floor", {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0.5f);
    add_quad(scene, "lamp", {0, 0.3f, 0}, {0.25f, 0, 0}, {0, 0, 0.25f}, 0, 1);
    add_quad(scene, "wall", {1, 0, 0}, {0, 0, 1}, {0, 1, 0}, 0.5f);
    return scene;
}

/// All light on the wall, when next to nothing is unshot.
double light_on_wall(int patch) {
    Solver solver(make_model(lit_floor(), {.texels_per_unit = 8, .patch = patch}),
                  {.form_factors = {.hemicube = 64}});
    while (books(solver.model(), solver.solution()).unshot_share() > 1e-5) solver.shoot();
    const PixmapModel& model = solver.model();
    const Pixmap& wall = model.pixmaps[2];
    double flux = 0;
    for (std::size_t t = wall.first; t < wall.first + wall.count(); ++t)
        flux += model.area[t] * solver.solution().H[t].x;
    return flux;
}

// A patch's quarters send their own light. If it sent the mean, the wall would have 8 % more light
// than from single texels.
TEST(Solver, LightStaysWhereItFellOnAPatch) {
    EXPECT_NEAR(light_on_wall(4) / light_on_wall(1), 1, 0.03);
}

TEST(Solver, QuartersSendTogetherWhatTheirPatchSends) {
    const PixmapModel model = make_model(lit_floor(), {.texels_per_unit = 8});
    FormFactors factors(model, {.hemicube = 32});
    int with_quarters = 0;
    for (std::size_t p = 0; p < model.patches.size(); ++p) {
        const std::vector<Row> quarters = factors.from_quarters(p);
        EXPECT_EQ(quarters.size() == 4, shooting_of(model, model.patches[p]).has_quarters);
        with_quarters += quarters.size() == 4 ? 1 : 0;
        double sum = 0;
        for (const Row& row : quarters) sum += row.sum() / double(quarters.size());
        EXPECT_NEAR(sum, 1, 1e-9);
        const Row whole = factors.from_patch(p), together = factors.combined(quarters);
        EXPECT_EQ(whole.texels, together.texels);
        EXPECT_EQ(whole.factors, together.factors);
    }
    EXPECT_GE(with_quarters, 8);
}

// Cohen's estimate is exact where all is evenly bright: before any shot the furnace shows its
// solution.
TEST(Solver, TheAmbientEstimateOfAFurnaceIsItsSolution) {
    const PixmapModel model = make_model(closed_box({1, 2, 1}, 0.75f, 1), few_texels);
    const Solution start = initial_solution(model);
    EXPECT_NEAR(radiosity_at(model, start, 0).x + model.rho[0].x * ambient(model, start).x, 4,
                1e-6);
}

}  // namespace
}  // namespace gw::radiosity
