// Saved pixmaps [F4]: going on later gives the same bits; what does not fit is refused with a
// reason.
#include "gw/error.h"
#include "radiosity/solver/saved.h"
#include "radiosity/solver/solver.h"
#include "tests/radiosity/scenes.h"

#include <gtest/gtest.h>

namespace gw::radiosity {
namespace {

const FormFactorOptions coarse_hemicubes{.hemicube = 32, .points = {.smallest_of_pixmap = 1.0 / 4}};

PixmapModel box(float rho = 0.5f) {
    return make_model(closed_box({1, 1, 1}, rho, 1), {.texels_per_unit = 4});
}

Solution shots(Solver& solver, int count) {
    for (int i = 0; i < count; ++i) solver.shoot();
    return solver.solution();
}

TEST(Saved, NShotsAreKShotsSavedLoadedAndTheRest) {
    Solver whole(box(), {.form_factors = coarse_hemicubes}),
        first(box(), {.form_factors = coarse_hemicubes}),
        rest(box(), {.form_factors = coarse_hemicubes});
    const Solution expected = shots(whole, 30);
    const Saved saved = save(first.model(), coarse_hemicubes, shots(first, 11));
    rest.resume(load(saved, rest.model(), coarse_hemicubes, "file"));
    EXPECT_EQ(shots(rest, 19), expected);
}

std::string refusal(const Saved& saved, const PixmapModel& model,
                    const FormFactorOptions& options = coarse_hemicubes) {
    try {
        load(saved, model, options, "file");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(Saved, WhatDoesNotFitIsRefusedWithAReason) {
    Solver solver(box(), {.form_factors = coarse_hemicubes});
    const Saved saved = save(solver.model(), coarse_hemicubes, shots(solver, 3));
    EXPECT_EQ(refusal(saved, box()), "");
    EXPECT_NE(refusal(saved, box(0.25f)).find("same figures, materials"), std::string::npos);
    EXPECT_EQ(refusal(saved, box(), {.hemicube = 64, .seed = 3}),
              "file: was computed with --hemicube 32 --parts 64 --seed 0; expected --hemicube 64 "
              "--parts 64 --seed 3");
    EXPECT_EQ(refusal(saved, box(), {.hemicube = 32}),
              "file: was computed by another version of gw; expected one of this version");
    Saved other = saved;
    other.facts["version"] = "0";
    EXPECT_NE(refusal(other, box()).find("version '0'"), std::string::npos);
    other = saved;
    other.pixmaps[2].values[17] += 1;
    EXPECT_NE(refusal(other, box()).find("checksum"), std::string::npos);
    other = saved;
    other.facts.erase("objects");  // as files of earlier versions
    EXPECT_EQ(refusal(other, box()), "");
    other = saved;
    other.facts.clear();
    EXPECT_NE(refusal(other, box()).find("expected radiosity pixmaps"), std::string::npos);
}

// The same figures under other names: a change that is asked for by name would fall elsewhere.
TEST(Saved, ObjectsOfOtherNamesAreRefused) {
    Solver solver(box(), {.form_factors = coarse_hemicubes});
    const Saved saved = save(solver.model(), coarse_hemicubes, shots(solver, 3));
    scene::Scene scene = closed_box({1, 1, 1}, 0.5f, 1);
    std::swap(scene.objects[0].name, scene.objects[1].name);
    const std::string said = refusal(saved, make_model(scene, {.texels_per_unit = 4}));
    EXPECT_NE(said.find("was computed for objects named floor, ceiling, left"), std::string::npos)
        << said;
    EXPECT_NE(said.find("expected ceiling, floor, left"), std::string::npos) << said;
}

TEST(Storable, IsAHeadAndARest) {
    for (double v : {0.1, -1e-30, 12345.678, 1.0 / 3}) {
        const double s = storable(v);
        EXPECT_EQ(storable(s), s);
        EXPECT_NEAR(s / v, 1, 1e-14);
    }
}

}  // namespace
}  // namespace gw::radiosity
