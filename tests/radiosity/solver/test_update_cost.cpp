// Hemicubes after a change [F4]: going on never takes more of them than solving anew.
#include "radiosity/solver/solver.h"
#include "tests/radiosity/scenes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>

namespace gw::radiosity {
namespace {

const SolverOptions coarse{
    .form_factors = {.hemicube = 16,
                     .points = {.smallest_part = 2, .smallest_of_pixmap = 1.0 / 4}}};

/// What a user may change.
struct Setting {
    vec3 lamp{0.75f, 1.75f, 0.75f}, plate{0.3f, 0.4f, 0.4f};
    vec3 light{4}, second{0};
    float walls = 0.5f, board = 0.5f;
};

/// A room with a hanging lamp, a lying plate, a shining wall and a standing board.
scene::Scene room(const Setting& s) {
    scene::Scene scene = closed_box({2, 2, 2}, s.walls, 0);
    add_quad(scene, "lamp", s.lamp, {0.5f, 0, 0}, {0, 0, 0.5f});
    scene.materials.back().Ke = s.light;
    add_quad(scene, "plate", s.plate, {0, 0, 0.5f}, {0.5f, 0, 0}, s.board);
    add_quad(scene, "sign", {0.01f, 0.5f, 0.5f}, {0, 0.5f, 0}, {0, 0, 0.5f}, 0.2f);
    scene.materials.back().Ke = s.second;
    add_quad(scene, "board", {1.3f, 0, 0.5f}, {0, 1.2f, 0}, {0, 0, 1}, s.board);
    return scene;
}

PixmapModel model_of(const Setting& setting) {
    return make_model(room(setting), {.texels_per_unit = 3});
}

int solve(Solver& solver, double until) {
    int hemicubes = 0;
    while (books(solver.model(), solver.solution()).unshot_share() > until)
        hemicubes += solver.shoot()->hemicubes;
    return hemicubes;
}

struct Change {
    const char* name;
    Setting from, to;
};

std::vector<Change> changes() {
    std::vector<Change> all;
    const auto add = [&](const char* name, const std::function<void(Setting&)>& change,
                         const Setting& from = {}) {
        all.push_back({name, from, from});
        change(all.back().to);
    };
    add("lamp down a little", [](Setting& s) { s.lamp.y = 1.6f; });
    add("lamp aside", [](Setting& s) { s.lamp.x = 1.2f; });
    add("plate aside", [](Setting& s) { s.plate.x = 0.5f; });
    add("plate up", [](Setting& s) { s.plate.y = 1.5f; });
    add("plate a hair", [](Setting& s) { s.plate.x = 0.301f; });
    add("plate out of a corner",
        [](Setting& s) {
            s.plate = {0.6f, 0.6f, 0.6f};
        },
        {.plate = {0.05f, 0.05f, 0.05f}});
    add("lamp half", [](Setting& s) { s.light = vec3(2); });
    add("lamp next to nothing", [](Setting& s) { s.light = vec3(0.1f); });
    add("lamp ten times", [](Setting& s) { s.light = vec3(40); });
    add("lamp red", [](Setting& s) { s.light = {4, 0.1f, 0.1f}; });
    add("from the lamp to the sign", [](Setting& s) { std::swap(s.light, s.second); });
    add("a second light", [](Setting& s) { s.second = vec3(1); });
    add("the second light off", [](Setting& s) { s.second = vec3(0); }, {.second = vec3(3)});
    add("walls darker", [](Setting& s) { s.walls = 0.2f; });
    add("walls brighter", [](Setting& s) { s.walls = 0.8f; });
    add("walls black", [](Setting& s) { s.walls = 0; });
    add("board darker", [](Setting& s) { s.board = 0.1f; });
    add("board brighter", [](Setting& s) { s.board = 0.9f; });
    return all;
}

int from_solved(const Change& change, double until, Solution& solution) {
    Solver solver(model_of(change.from), coarse);
    solve(solver, until);
    solution = solver.solution();
    const Update update = solver.update(model_of(change.to));
    return update.hemicubes + solve(solver, until);
}

/// The form factors before the change are not known.
int from_resumed(const Change& change, double until, const Solution& solution) {
    Solver solver(model_of(change.from), coarse);
    solver.resume(solution);
    const Update update = solver.update(model_of(change.to));
    return update.hemicubes + solve(solver, until);
}

TEST(UpdateCost, IsNeverAboveThatOfSolvingAnew) {
    for (const double until : {0.1, 0.01})
        for (const Change& change : changes()) {
            SCOPED_TRACE(fmt::format("{}, until {}", change.name, until));
            Solver anew(model_of(change.to), coarse);
            const int all = solve(anew, until);
            Solution solution;
            const int solved = from_solved(change, until, solution),
                      resumed = from_resumed(change, until, solution);
            EXPECT_LE(solved, all);
            EXPECT_LE(resumed, all);
        }
}

}  // namespace
}  // namespace gw::radiosity
