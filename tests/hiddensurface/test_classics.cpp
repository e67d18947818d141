// Claims: on 1,050 random scenes of seven families, 150 of each, every algorithm that claims to be
// right agrees with the Z-buffer pixel by pixel, but for ties, edges made by splitting and, where
// it decides in the world, what the snap turns over; these are few. Ray casting, which asks every
// polygon at every pixel, runs one scene in ten.
#include "tests/hiddensurface/small_families.h"

#include <gtest/gtest.h>

#include <map>

namespace gw::hiddensurface {
namespace {

constexpr std::uint32_t scenes = 150, scenes_of_a_case = 25;
constexpr int width = 72, height = 54;

void add(Counts& sum, const Counts& counts) {
    for (const auto& [name, count] : count_names()) sum.*count += counts.*count;
}

void expect_few_differences(const Algorithm& algorithm, const Family& family, const Counts& sum) {
    EXPECT_GT(sum.pixels, 2000u);
    if (algorithm.in_world) {
        // As in test_families.cpp: on one plane, Newell's cuts are among what the snap turns over.
        const bool one_plane = family.snapped_one_in < 10 && algorithm.name == "newell";
        const std::uint64_t edges = sum.ties + sum.edges;
        EXPECT_LE(one_plane ? 0 : edges * 500, sum.pixels) << algorithm.name;
        EXPECT_LE((sum.snapped + (one_plane ? edges : 0)) * family.snapped_one_in, sum.pixels)
            << algorithm.name;
    } else {
        EXPECT_EQ(sum.edges, 0u) << algorithm.name;
        EXPECT_EQ(sum.snapped, 0u) << algorithm.name;
        EXPECT_LE(sum.ties * 500, sum.pixels) << algorithm.name;
    }
}

class Classics : public testing::TestWithParam<std::tuple<std::size_t, std::uint32_t>> {};

}  // namespace

TEST_P(Classics, AgreeWithTheZBuffer) {
    const Family& family = small_families()[std::get<0>(GetParam())];
    const std::uint32_t first = std::get<1>(GetParam()) * scenes_of_a_case + 1;
    std::map<std::string, Counts> sums;
    for (std::uint32_t seed = first; seed < first + scenes_of_a_case; ++seed) {
        Trial trial(family.scene(seed), vgx(), width, height);
        for (const Algorithm& algorithm : algorithms()) {
            if (algorithm.claim != Claim::Always || algorithm.uses_depth_plane) continue;
            if (algorithm.name == "ray-casting" && seed % 10 != 0) continue;
            const Counts counts = trial.run(algorithm.name).counts;
            EXPECT_EQ(counts.wrong, 0u) << algorithm.name << ", seed " << seed;
            EXPECT_EQ(counts.undecided, 0u) << algorithm.name << ", seed " << seed;
            add(sums[algorithm.name], counts);
        }
    }
    EXPECT_GE(sums.size(), 4u);
    for (const auto& [name, sum] : sums)
        if (name != "ray-casting") expect_few_differences(algorithm_named(name), family, sum);
}

// A window that is higher than wide, a single row, a single column: Warnock's quarters and the
// lists of lines are of every shape.
TEST(Windows, OfEveryShapeAgreeWithTheZBuffer) {
    for (const auto& [w, h] : {std::pair{37, 90}, {90, 37}, {1, 40}, {40, 1}, {33, 33}, {2, 65}}) {
        Trial trial(random_triangles(3, 40), vgx(), w, h);
        for (const Algorithm& algorithm : algorithms())
            if (algorithm.claim == Claim::Always) {
                EXPECT_EQ(trial.run(algorithm.name).counts.wrong, 0u)
                    << algorithm.name << ", " << w << "x" << h;
            }
    }
}

INSTANTIATE_TEST_SUITE_P(All, Classics,
                         testing::Combine(testing::Range<std::size_t>(0, small_families().size()),
                                          testing::Range(0u, scenes / scenes_of_a_case)),
                         [](const auto& tested) {
                             std::string name = small_families()[std::get<0>(tested.param)].name;
                             std::erase(name, ' ');
                             return name + std::to_string(std::get<1>(tested.param));
                         });

}  // namespace gw::hiddensurface
