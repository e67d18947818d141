// Changes of a solved scene [F4]: shooting the difference leads to what solving anew does.
#include "gw/error.h"
#include "radiosity/solver/solver.h"
#include "tests/radiosity/scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gw::radiosity {
namespace {

const SolverOptions coarse{
    .form_factors = {.hemicube = 32, .points = {.smallest_of_pixmap = 1.0 / 4}}};
constexpr double enough = 1e-3;

/// A room with a hanging lamp at height y.
scene::Scene room(float y, float emission = 4, float rho = 0.5f) {
    scene::Scene scene = closed_box({2, 2, 2}, rho, 0);
    add_quad(scene, "lamp", {0.75f, y, 0.75f}, {0.5f, 0, 0}, {0, 0, 0.5f}, 0, emission);
    return scene;
}

PixmapModel model_of(const scene::Scene& scene) {
    return make_model(scene, {.texels_per_unit = 3});
}

int solve(Solver& solver) {
    int hemicubes = 0;
    while (books(solver.model(), solver.solution()).unshot_share() > enough)
        hemicubes += solver.shoot()->hemicubes;
    return hemicubes;
}

/// The mean difference by the mean radiosity.
double difference(const Solver& a, const Solver& b) {
    double off = 0, sum = 0;
    for (std::size_t t = 0; t < a.model().texel_count(); ++t) {
        off += a.model().area[t] * std::abs(radiosity_at(a.model(), a.solution(), t).x -
                                            radiosity_at(b.model(), b.solution(), t).x);
        sum += b.model().area[t] * radiosity_at(b.model(), b.solution(), t).x;
    }
    return off / sum;
}

class UpdateTest : public testing::Test {
protected:
    Solver solver{model_of(room(1.75f)), coarse};
    void SetUp() override { solve(solver); }

    /// Updates to `scene`, solves on, and compares with solving anew. Returns hemicubes: updated,
    /// anew.
    std::pair<int, int> compare(const scene::Scene& scene, double allowed) {
        const Update update = solver.update(model_of(scene), 0);
        EXPECT_LT(books(solver.model(), solver.solution()).imbalance(), 1e-5);
        const int more = update.hemicubes + solve(solver);
        Solver anew(model_of(scene), coarse);
        const int all = solve(anew);
        EXPECT_LT(difference(solver, anew), allowed);
        return {more, all};
    }
};

TEST_F(UpdateTest, ADimmedLampDrawsNothingAnew) {
    EXPECT_EQ(compare(room(1.75f, 1), 3 * enough).first, 0);
}

TEST_F(UpdateTest, OtherReflectancesDrawNextToNothing) {
    const auto [more, anew] = compare(room(1.75f, 4, 0.4f), 5 * enough);
    EXPECT_LT(more, anew / 4);
}

/// What is shot after an update has the bits of a solver that never saw the scene before it.
void expect_shots_of_a_fresh_solver(Solver& solver) {
    Solver fresh(solver.model(), coarse);
    fresh.resume(solver.solution());
    for (int i = 0; i < 20 && solver.shoot(); ++i) fresh.shoot();
    EXPECT_EQ(solver.solution(), fresh.solution());
}

/// A board between lamp and floor, at this x.
scene::Scene room_with_board(float x) {
    scene::Scene scene = room(1.75f);
    add_quad(scene, "board", {x, 1, 0.5f}, {0, 0, 1}, {1, 0, 0}, 0.5f);
    return scene;
}

TEST(Update, KeepsNoFormFactorsAfterABlockerHasMoved) {
    Solver solver(model_of(room_with_board(0.1f)), coarse);
    solve(solver);
    solver.update(model_of(room_with_board(0.8f)), 0);
    expect_shots_of_a_fresh_solver(solver);
}

TEST_F(UpdateTest, KeepsNoFormFactorsOfAPatchThatBeginsToEmit) {
    scene::Scene glowing_floor = room(1.75f);
    glowing_floor.materials[0].Ke = vec3(1);
    solver.update(model_of(glowing_floor));
    expect_shots_of_a_fresh_solver(solver);
}

TEST_F(UpdateTest, ADarkSceneIsRefused) {
    EXPECT_THROW(solver.update(model_of(room(1.75f, 0))), Error);
    EXPECT_THROW(Solver(model_of(room(1.75f, 0)), coarse), Error);
}

TEST_F(UpdateTest, AMovedLampReachesAllAndTheSolutionBeginsAgain) {
    const auto [more, anew] = compare(room(1.5f), 5 * enough);
    EXPECT_EQ(more, anew);
    EXPECT_TRUE(solver.update(model_of(room(1.25f))).anew);
}

/// A small plate on the floor, at this x.
scene::Scene room_with_plate(float x) {
    scene::Scene scene = room(1.75f);
    add_quad(scene, "plate", {x, 0.1f, 0.2f}, {0, 0, 0.1f}, {0.1f, 0, 0}, 0.5f);
    return scene;
}

constexpr double tolerance = 0.005;

TEST(Update, OfASmallMoveTheDifferenceIsSent) {
    Solver solver(model_of(room_with_plate(0.2f)), coarse),
        anew(model_of(room_with_plate(0.3f)), coarse);
    solve(solver);
    const Update update = solver.update(model_of(room_with_plate(0.3f)), tolerance);
    EXPECT_FALSE(update.anew);
    EXPECT_GT(update.patches, 0u);
    EXPECT_LT(books(solver.model(), solver.solution()).imbalance(), 1e-5);
    EXPECT_LT(update.hemicubes + solve(solver), solve(anew));
    EXPECT_LT(difference(solver, anew), tolerance);
}

/// Old form factors are not known then, and would have to be drawn too.
TEST(Update, OfAResumedSolutionTakesNoMoreHemicubesThanSolvingAnew) {
    Solver solved(model_of(room_with_plate(0.2f)), coarse),
        anew(model_of(room_with_plate(0.6f)), coarse);
    solve(solved);
    Solver resumed(model_of(room_with_plate(0.2f)), coarse);
    resumed.resume(solved.solution());
    const Update update = resumed.update(model_of(room_with_plate(0.6f)), 0);
    EXPECT_LE(update.hemicubes + solve(resumed), solve(anew));
    EXPECT_LT(difference(resumed, anew), 5 * enough);
}

TEST_F(UpdateTest, AnotherSceneIsRefused) {
    scene::Scene more = room(1.75f);
    add_quad(more, "more", {0, 1, 0}, {0.1f, 0, 0}, {0, 0, 0.1f});
    EXPECT_THROW(solver.update(model_of(more)), Error);
}

}  // namespace
}  // namespace gw::radiosity
