// The golden suite: every pass of every figure, small, on each profile, is as the manifests and the
// table of digests in tests/golden say. They change only by `gw golden tests/golden --update`.
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

/// Puts another word in the place of one of the words of the line that has `part`.
std::string with_word(const std::string& text, const std::string& part, std::size_t index,
                      const std::string& word) {
    std::size_t begin = text.rfind('\n', text.find(part)) + 1;
    begin = text.find_first_not_of(' ', begin);
    for (; index > 0; --index) begin = text.find(' ', begin) + 1;
    return text.substr(0, begin) + word + text.substr(text.find(' ', begin));
}

TEST_F(Golden, ADifferenceInTheTableNamesProfilePassAndColumnAndHowToSeeIt) {
    ASSERT_EQ(gw({"golden", "g", "--only", "edges", "--update"}).code, 0);
    const std::string all = bytes_of(in("g/digests.txt"));
    const std::string other(32, '7');
    const std::vector<std::pair<std::size_t, std::string>> columns{
        {0, "state"},       {1, "counters"},    {2, "plane stencil"},
        {3, "plane depth"}, {4, "plane color"}, {6, "plane accum"}};
    for (const auto& [column, name] : columns) {
        write("g/digests.txt", with_word(all, " depth\n", column, other));
        const Outcome outcome = gw({"golden", "g", "--only", "edges", "--recordings", "r"});
        EXPECT_EQ(outcome.code, 3);
        EXPECT_EQ(outcome.out.find("g/digests.txt: edges/1_ideal, pass 0 'depth', " + name +
                                   ": expected " + other + ", got "),
                  0u)
            << outcome.out;
        EXPECT_NE(outcome.out.find("gw golden g --only edges --profile ideal --recordings DIR2, "
                                   "then gw diff of the two DIR2/edges/1_ideal.gwt\n"),
                  all.npos)
            << outcome.out;
        EXPECT_NE(outcome.out.find("the commands are the same"), all.npos) << outcome.out;
        EXPECT_TRUE(std::filesystem::exists(in("r/edges/1_ideal.gwt")));
    }
    write("g/digests.txt", with_word(all, "edges/1_ideal ", 1, other));
    EXPECT_EQ(gw({"golden", "g", "--only", "edges", "--update"}).code, 0);
    EXPECT_EQ(bytes_of(in("g/digests.txt")), all);
}

TEST_F(Golden, TheTablesHeadAndCommandsAreCompared) {
    ASSERT_EQ(gw({"golden", "g", "--only", "edges", "--update"}).code, 0);
    const std::string all = bytes_of(in("g/digests.txt"));
    const std::size_t panel = all.find("edges/1_ideal ");
    std::string changed = all;
    changed[panel + 14] = changed[panel + 14] == '0' ? '1' : '0';
    write("g/digests.txt", changed);
    EXPECT_NE(gw({"golden", "g", "--only", "edges"}).out.find("edges/1_ideal, profile or window"),
              all.npos);
    const std::size_t commands = panel + 14 + 33;
    changed[commands] = changed[commands] == '0' ? '1' : '0';
    write("g/digests.txt", changed);
    EXPECT_NE(gw({"golden", "g", "--only", "edges"}).out.find("the commands differ: "), all.npos);
}

TEST_F(Golden, AnUpdateOfOneProfileKeepsTheOthersAndTheOtherFigures) {
    ASSERT_EQ(gw({"golden", "g", "--only", "edges", "--only", "strips", "--update"}).code, 0);
    const std::string all = bytes_of(in("g/digests.txt"));
    for (const char* panel : {"edges/1_ideal ", "edges/1_reality ", "strips/1_reality "})
        EXPECT_NE(all.find(panel), all.npos) << panel;
    EXPECT_EQ(gw({"golden", "g", "--only", "edges", "--profile", "ideal", "--update"}).code, 0);
    EXPECT_EQ(bytes_of(in("g/digests.txt")), all);
    EXPECT_EQ(all.find("vgx"), all.npos);
}

TEST_F(Golden, ABrokenTableIsRefusedWithItsLine) {
    ASSERT_EQ(gw({"golden", "g", "--only", "edges", "--update"}).code, 0);
    const std::string all = bytes_of(in("g/digests.txt"));
    for (const char* line :
         {"edges/1_ideal 12\n", "  = = = = = = = hardware\n", "rubbish\n", "  hardware\n"}) {
        write("g/digests.txt", line + all);
        expect_refused(1, {"golden", "g", "--only", "edges"}, {"g/digests.txt:1: expected"});
    }
}

TEST_F(Golden, WhatIsMissingOrLeftOverInTheTableIsFound) {
    ASSERT_EQ(gw({"golden", "g", "--only", "edges", "--update"}).code, 0);
    const std::string all = bytes_of(in("g/digests.txt"));
    const std::string digest(32, '7');
    write("g/digests.txt", all + "edges/9_ideal " + digest + " " + digest + "\n");
    write("g/edges/1_ideal.json", "{}");
    const Outcome outcome = gw({"golden", "g", "--only", "edges"});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(outcome.out.find("g/edges/1_ideal.json: no panel of this figure makes it\n"
                               "g/digests.txt: edges/9_ideal: no panel of this figure makes it\n"),
              0u)
        << outcome.out;
    ASSERT_EQ(gw({"golden", "g", "--only", "edges", "--update"}).code, 0);
    EXPECT_EQ(bytes_of(in("g/digests.txt")), all);
    EXPECT_FALSE(std::filesystem::exists(in("g/edges/1_ideal.json")));
    write("g/digests.txt", "");
    expect_refused(1, {"golden", "g", "--only", "edges", "--profile", "ideal"},
                   {"g/digests.txt", "edges/1_ideal", "--update"});
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
    std::filesystem::remove(in("g/edges/1_vgx.json"));
    EXPECT_EQ(gw({"golden", "g", "--only", "edges"}).code, 1);
    expect_refused(1, {"golden", "none"}, {"none", "is no folder"});
    expect_refused(2, {"golden", "g", "--only", "fig99"}, {"--only 'fig99'"});
}

}  // namespace gw::apps
