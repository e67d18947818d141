// Claims: a solution whose light neither escapes nor is absorbed is noticed, and no other one is.
#include "radiosity/solver/stall.h"

#include "radiosity/solver/solver.h"

#include <gtest/gtest.h>

#include "tests/radiosity/scenes.h"

namespace gw::radiosity {
namespace {

/// Shots until the share is small or stays; the share then.
std::pair<int, double> solve(float rho) {
    Solver solver(make_model(closed_box({1, 1, 1}, rho, 1), {.texels_per_unit = 2}),
                  {.form_factors = {.hemicube = 16}});
    Stall stall(solver.model().patches.size());
    double share = 1;
    int shots = 0;
    do {
        if (!solver.shoot()) break;
        share = books(solver.model(), solver.solution()).unshot_share();
        ++shots;
    } while (share > 0.01 && !stall.after_shot(share) && shots < 100000);
    return {shots, share};
}

TEST(Stall, EndsARoomOfReflectanceOne) {
    const auto [shots, share] = solve(1);
    EXPECT_LT(shots, 200);
    EXPECT_NEAR(share, 1, 0.01);
}

TEST(Stall, LetsARoomThatAbsorbsALittleGoOn) {
    for (const float rho : {0.5f, 0.9f, 0.99f}) EXPECT_LE(solve(rho).second, 0.01) << rho;
}

}  // namespace
}  // namespace gw::radiosity
