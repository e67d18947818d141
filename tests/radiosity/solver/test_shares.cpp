// Shares of lamps [F4]: they add up to the whole, and mixed they are the light of lamps in other
// strengths.
#include "radiosity/solver/shares.h"

#include "gw/error.h"
#include "radiosity/solver/solver.h"
#include "tests/radiosity/scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gw::radiosity {
namespace {

const FormFactorOptions coarse{.hemicube = 32, .points = {.smallest_of_pixmap = 1.0 / 4}};
const ModelOptions few_texels{.texels_per_unit = 4};

/// A box without its front: the floor is one lamp, left and right wall together another one.
scene::Scene box_with_two_lamps(float floor = 1, float walls = 1) {
    scene::Scene scene = closed_box({1, 1, 1}, 0.5f, 0);
    scene.objects.pop_back();
    scene.materials[1].Kd = {0.9f, 0.1f, 0.4f};
    scene.materials[0].Ke = floor * vec3(1, 2, 3);
    scene.materials[2].Ke = scene.materials[3].Ke = walls * vec3(0.5f, 0.25f, 4);
    scene.objects[2].name = scene.objects[3].name = "walls";
    return scene;
}

struct Solved {
    Solver solver;
    std::vector<Share> shares;

    Solved(const scene::Scene& scene, int shots) : solver(make_model(scene, few_texels), {coarse}) {
        shares = initial_shares(solver.model());
        std::vector<Solution> parts;
        for (const Share& share : shares) parts.push_back(share.solution);
        solver.follow(parts);
        for (int i = 0; i < shots; ++i) solver.shoot();
        for (std::size_t i = 0; i < shares.size(); ++i) shares[i].solution = solver.parts()[i];
    }
};

/// Of each texel's light.
constexpr double bound = 1e-9;

void expect_equal(const PixmapModel& model, const Solution& a, const Solution& b) {
    for (std::size_t t = 0; t < model.texel_count(); ++t)
        for (int c = 0; c < 3; ++c) {
            const double B = radiosity_at(model, b, t)[c];
            ASSERT_NEAR(a.H[t][c], b.H[t][c], bound * b.H[t][c]) << t;
            ASSERT_NEAR(a.unshot[t][c], b.unshot[t][c], bound * B) << t;
        }
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(a.escaped[c], b.escaped[c], bound * b.escaped[c]);
        EXPECT_NEAR(a.backs[c], b.backs[c], bound * b.backs[c]);
    }
    EXPECT_EQ(a.shots, b.shots);
}

}  // namespace

TEST(Shares, ALampIsAllObjectsOfAName) {
    EXPECT_EQ(lamps_of(make_model(box_with_two_lamps(), few_texels)),
              (std::vector<std::string>{"floor", "walls"}));
}

TEST(Shares, AddUpToTheWhole) {
    Solved solved(box_with_two_lamps(), 150);
    PixmapModel model = make_model(box_with_two_lamps(), few_texels);
    const Solution sum = mix(solved.shares, {dvec3(1), dvec3(1)}, model);
    EXPECT_EQ(model.E, solved.solver.model().E);
    expect_equal(model, sum, solved.solver.solution());
    EXPECT_GT(sum.escaped.x, 0.1);
    for (const Share& share : solved.shares)  // both have light that the other has not
        EXPECT_GT(share.solution.escaped.z, 0.1 * sum.escaped.z);
}

TEST(Shares, DoNotChangeTheWhole) {
    Solver alone(make_model(box_with_two_lamps(), few_texels), {coarse});
    for (int i = 0; i < 40; ++i) alone.shoot();
    EXPECT_EQ(alone.solution(), Solved(box_with_two_lamps(), 40).solver.solution());
}

// If all lamps are as many times as strong, the same patches shoot.
TEST(Shares, MixedAreTheSameShotsOfStrongerLamps) {
    Solved solved(box_with_two_lamps(), 60);
    for (const float k : {4.f, 0.3f}) {
        PixmapModel model = make_model(box_with_two_lamps(), few_texels);
        const Solution mixed = mix(solved.shares, {dvec3(k), dvec3(k)}, model);
        Solver anew(make_model(box_with_two_lamps(k, k), few_texels), {coarse});
        for (int i = 0; i < 60; ++i) anew.shoot();
        for (std::size_t t = 0; t < model.texel_count(); ++t)
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(model.E[t][c], anew.model().E[t][c], 1e-6 * model.E[t][c]);
        for (std::size_t t = 0; t < model.texel_count(); ++t)
            for (int c = 0; c < 3; ++c)  // 0.3 f is float32 in the scene
                ASSERT_NEAR(mixed.H[t][c], anew.solution().H[t][c], 1e-6 * mixed.H[t][c]);
        EXPECT_LT(books(model, mixed).imbalance(), bound);
    }
}

// Both states lack the reflections of what is unshot, in all rho / (1 - rho) of it at most.
TEST(Shares, MixedAreTheLightOfLampsInOtherStrengths) {
    Solved solved(box_with_two_lamps(), 20);
    PixmapModel model = make_model(box_with_two_lamps(), few_texels);
    const Solution mixed = mix(solved.shares, {dvec3(0.5), dvec3(2, 3, 4)}, model);
    scene::Scene stronger = box_with_two_lamps(0.5f);
    stronger.materials[2].Ke = stronger.materials[3].Ke = {1, 0.75f, 16};
    Solver anew(make_model(stronger, few_texels), {coarse});
    EXPECT_EQ(model.E, anew.model().E);
    EXPECT_EQ(model.figures[2].E, anew.model().figures[2].E);
    for (int i = 0; i < 20; ++i) anew.shoot();
    const Books a = books(model, mixed), b = books(anew.model(), anew.solution());
    EXPECT_LT(a.imbalance(), bound);
    EXPECT_LT(a.unshot_share(), 0.1);
    EXPECT_GT(a.unshot_share(), 1e-4);
    dvec3 off(0);
    for (std::size_t t = 0; t < model.texel_count(); ++t) {
        const dvec3 d = radiosity_at(model, mixed, t) - radiosity_at(model, anew.solution(), t);
        off += model.area[t] * dvec3(std::abs(d.x), std::abs(d.y), std::abs(d.z));
    }
    for (int c = 0; c < 3; ++c)
        EXPECT_LE(off[c], 0.9 / 0.1 * (a.unshot[c] + b.unshot[c]) + bound * a.emitted[c]) << c;
}

TEST(Shares, GoOnBitForBitAfterTheyWereSaved) {
    const Solved whole(box_with_two_lamps(), 30), first(box_with_two_lamps(), 11);
    Solver rest(make_model(box_with_two_lamps(), few_texels), {coarse});
    rest.resume(first.solver.solution());
    std::vector<Solution> parts;
    for (std::size_t i = 0; i < 2; ++i) {
        const Saved saved = save_share(rest.model(), coarse, first.shares[i], i + 1, 2);
        parts.push_back(
            load_share(saved, rest.model(), coarse, first.shares[i].lamp, "file").solution);
    }
    rest.follow(parts);
    for (int i = 0; i < 19; ++i) rest.shoot();
    EXPECT_EQ(rest.parts(), whole.solver.parts());
}

TEST(Shares, OfAnotherLampOrKindAreRefused) {
    const Solved solved(box_with_two_lamps(), 3);
    const PixmapModel& model = solved.solver.model();
    const Saved share = save_share(model, coarse, solved.shares[0], 1, 2),
                whole = save(model, coarse, solved.solver.solution());
    const auto refusal = [&](const auto& load) {
        try {
            load();
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(refusal([&] { load_share(share, model, coarse, "walls", "f"); }),
              "f: has the light of 'floor'; expected that of 'walls'");
    EXPECT_EQ(refusal([&] { load_share(whole, model, coarse, "floor", "f"); }),
              "f: holds 'radiosity pixmaps'; expected radiosity share");
    EXPECT_EQ(refusal([&] { load(share, model, coarse, "f"); }),
              "f: holds 'radiosity share'; expected radiosity pixmaps");
    std::vector<Share> shares = solved.shares;
    shares[1].solution.shots = 2;
    EXPECT_EQ(refusal([&] {
                  check_same_shots(shares, {"a", "b"}, 3);
              }),
              "b: has 2 shots; expected 3, as the solution beside it");
}

/// Two lamps in one pixmap, with a texel that both cover.
TEST(Shares, DivideATexelThatTwoLampsCover) {
    scene::Scene scene = closed_box({1, 1, 1}, 0.5f, 0);
    for (const auto& [name, low, high, Ke] :
         {std::tuple{"a", 0.f, 0.5f, 1.f}, std::tuple{"b", 0.5f, 1.f, 3.f}}) {
        add_quad(scene, name, {0.2f + 0.2f * low, 0.5f, 0.2f}, {0, 0, 0.2f},
                 {0.2f * (high - low), 0, 0}, 0, Ke);
        scene.objects.back().mesh =
            make_mesh({.primitive = Primitive::Quads,
                       .positions = scene.objects.back().mesh->data().positions,
                       .texcoords = {{0, low}, {1, low}, {1, high}, {0, high}}});
        scene.objects.back().pixmap = {.name = "both", .width = 1, .height = 1, .given_st = true};
    }
    const PixmapModel model = make_model(scene, few_texels);
    const std::vector<Share> shares = initial_shares(model);
    ASSERT_EQ(shares.size(), 2u);
    const std::size_t t = model.pixmaps.back().first;
    EXPECT_NEAR(model.E[t].x, 2, 1e-6);
    EXPECT_NEAR(shares[0].E[t].x, 0.5, 1e-6);
    EXPECT_NEAR(shares[1].E[t].x, 1.5, 1e-6);
}

}  // namespace gw::radiosity
