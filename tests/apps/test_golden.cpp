// The golden suite: every pass of every figure, small, on each profile, is as the manifests in tests/golden
// say. They change only by `gw golden tests/golden --update`.
#include "apps/figure_table.h"
#include "examples.h"

#include <set>

namespace gw::apps {

class Golden : public ExampleTest, public testing::WithParamInterface<std::string> {};

std::vector<std::string> golden_figures() {
    std::vector<std::string> names;
    for (const Figure& figure : figures()) names.push_back(figure.name);
    return names;
}

/// On vgx here; on the other profiles in tests/apps/long.
bool takes_long(const std::string& figure) {
    static const std::set<std::string> all{"fig5", "focus", "glare", "lamps", "shadows", "soft"};
    return all.contains(figure);
}

TEST_P(Golden, EveryPassIsAsItWas) {
    std::vector<std::string> words{"golden", GW_SOURCE_DIR "/tests/golden", "--only", GetParam()};
    if (takes_long(GetParam())) words.insert(words.end(), {"--profile", "vgx"});
    const Outcome outcome = gw(words);
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    EXPECT_NE(outcome.out.find(": all as they were\n"), std::string::npos) << outcome.out;
}

INSTANTIATE_TEST_SUITE_P(All, Golden, testing::ValuesIn(golden_figures()),
                         [](const auto& test) { return test.param; });

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
    EXPECT_NE(outcome.out.find(": 1 differ\n"), all.npos) << outcome.out;
    EXPECT_EQ(names("r/edges"), std::vector<std::string>{"1_vgx.gwt"});
    EXPECT_EQ(gw({"golden", "g", "--only", "edges", "--update"}).code, 0);
    EXPECT_EQ(bytes_of(in("g/edges/1_vgx.json")), all);
}

TEST_F(Golden, WhatIsMissingOrLeftOverIsFound) {
    ASSERT_EQ(gw({"golden", "g", "--only", "edges", "--update"}).code, 0);
    write("g/edges/9_vgx.json", "{}");
    const Outcome outcome = gw({"golden", "g", "--only", "edges"});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(outcome.out.find("g/edges/9_vgx.json: no panel of this figure makes it\n"), 0u) << outcome.out;
    ASSERT_EQ(gw({"golden", "g", "--only", "edges", "--update"}).code, 0);
    EXPECT_FALSE(std::filesystem::exists(in("g/edges/9_vgx.json")));
    std::filesystem::remove(in("g/edges/1_ideal.json"));
    EXPECT_EQ(gw({"golden", "g", "--only", "edges"}).code, 1);
    expect_refused(1, {"golden", "none"}, {"none", "is no folder"});
    expect_refused(2, {"golden", "g", "--only", "fig99"}, {"--only 'fig99'"});
}

}  // namespace gw::apps
