// The golden suite: every pass of every figure, small, on each profile, is as the manifests in
// tests/golden say. They change only by `gw golden tests/golden --update`.
#include "apps/figures/figure_table.h"
#include "gw/profile.h"
#include "test_paths.h"
#include "tests/apps/support/examples.h"

#include <set>

namespace gw::apps {

/// A figure and one profile; "": all.
using GoldenRun = std::pair<std::string, std::string>;

class Golden : public ExampleTest, public testing::WithParamInterface<GoldenRun> {};

/// Those that take seconds are a test for each profile, which run side by side.
std::vector<GoldenRun> golden_runs() {
    static const std::set<std::string> long_ones{"fig5",  "focus",   "glare",
                                                 "lamps", "shadows", "soft"};
    std::vector<GoldenRun> runs;
    for (const Figure& figure : figures()) {
        if (!long_ones.contains(figure.name))
            runs.push_back({figure.name, ""});
        else
            for (const Profile& profile : paper_profiles())
                runs.push_back({figure.name, profile.name});
    }
    return runs;
}

TEST_P(Golden, EveryPassIsAsItWas) {
    const auto& [figure, profile] = GetParam();
    std::vector<std::string> words{"golden", GW_SOURCE_DIR "/tests/golden", "--only", figure};
    if (!profile.empty()) words.insert(words.end(), {"--profile", profile});
    const Outcome outcome = gw(words);
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    EXPECT_NE(outcome.out.find(": all unchanged\n"), std::string::npos) << outcome.out;
}

std::string name_of(const testing::TestParamInfo<GoldenRun>& run) {
    const auto& [figure, profile] = run.param;
    return profile.empty() ? figure : figure + "_" + profile;
}

INSTANTIATE_TEST_SUITE_P(All, Golden, testing::ValuesIn(golden_runs()), name_of);

TEST_F(Golden, ADifferenceNamesManifestPassAndStage) {
    ASSERT_EQ(gw({"golden", "g", "--only", "edges", "--update"}).code, 0);
    const std::string all = bytes_of(in("g/edges/1_vgx.json"));
    const std::size_t at = all.find("\"written\":");
    ASSERT_NE(at, all.npos);
    write("g/edges/1_vgx.json", all.substr(0, at) + "\"written\":9" + all.substr(at + 10));
    const Outcome outcome = gw({"golden", "g", "--only", "edges", "--recordings", "r"});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(outcome.out.find("g/edges/1_vgx.json: pass "), 0u) << outcome.out;
    EXPECT_NE(outcome.out.find("stage: "), all.npos) << outcome.out;
    EXPECT_NE(outcome.out.find("the commands are the same"), all.npos) << outcome.out;
    EXPECT_NE(outcome.out.find(": 1 differs\n"), all.npos) << outcome.out;
    EXPECT_EQ(names("r/edges"), std::vector<std::string>{"1_vgx.gwt"});
    EXPECT_EQ(gw({"golden", "g", "--only", "edges", "--update"}).code, 0);
    EXPECT_EQ(bytes_of(in("g/edges/1_vgx.json")), all);
}

TEST_F(Golden, WhatIsMissingOrLeftOverIsFound) {
    ASSERT_EQ(gw({"golden", "g", "--only", "edges", "--update"}).code, 0);
    write("g/edges/9_vgx.json", "{}");
    const Outcome outcome = gw({"golden", "g", "--only", "edges"});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(outcome.out.find("g/edges/9_vgx.json: no panel of this figure makes it\n"), 0u)
        << outcome.out;
    ASSERT_EQ(gw({"golden", "g", "--only", "edges", "--update"}).code, 0);
    EXPECT_FALSE(std::filesystem::exists(in("g/edges/9_vgx.json")));
    std::filesystem::remove(in("g/edges/1_ideal.json"));
    EXPECT_EQ(gw({"golden", "g", "--only", "edges"}).code, 1);
    expect_refused(1, {"golden", "none"}, {"none", "is no folder"});
    expect_refused(2, {"golden", "g", "--only", "fig99"}, {"--only 'fig99'"});
}

}  // namespace gw::apps
