// The error of superposed pictures falls as theory says: faster than that of random samples.
#include "apps/study/convergence.h"
#include "tests/apps/study/study_scenes.h"

#include <gtest/gtest.h>

namespace gw::study {
namespace {

constexpr ConvergenceOptions small{.largest = 64, .reference = 1024, .width = 48, .height = 36};

std::vector<ProfileError> errors_of(scene::Scene scene, const std::vector<Profile>& profiles) {
    const auto make = [](const Profile& profile) {
        return make_fast(profile, small.width, small.height);
    };
    return convergence(std::move(scene), profiles, make, small, [](const std::string&) {});
}

TEST(Convergence, OfEdgesIsFasterThanThatOfRandomSamples) {
    scene::Scene s = card();
    s.lights[0].area = {};
    const auto errors = errors_of(s, {vgx(), ideal()});
    ASSERT_EQ(errors[1].rms.size(), 6u);
    EXPECT_LT(errors[1].law.exponent, -0.65);  // random: -0.5; theory: -0.75
    EXPECT_GT(errors[1].law.exponent, -1.1);
    // The 8x8 grid and 8 bits end the fall, below half a level, not before.
    EXPECT_LT(errors[0].law.exponent, -0.55);
    EXPECT_LT(errors[0].rms.back().y, 1);
}

TEST(Convergence, OfSoftShadowsToo) {
    const auto errors = errors_of(card(), {ideal()});
    EXPECT_LT(errors[0].law.exponent, -0.55);  // random: -0.5; theory: -0.625
    EXPECT_GT(errors[0].law.exponent, -1.1);
}

TEST(Convergence, EveryDoublingHelps) {
    const auto errors = errors_of(card(), {ideal()});
    for (std::size_t i = 1; i < errors[0].rms.size(); ++i)
        EXPECT_LT(errors[0].rms[i].y, errors[0].rms[i - 1].y) << errors[0].rms[i].x << " samples";
}

}  // namespace
}  // namespace gw::study
