// gw hidden and gw styles: what they write, print and refuse.
#include "apps/hidden_captions.h"
#include "command_test.h"
#include "pictures.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace gw::apps {

struct Hidden : CommandTest {
    const std::string cycle = GW_SOURCE_DIR "/scenes/hidden/cycle.toml";
    Outcome hidden(std::vector<std::string> words) const {
        words.insert(words.begin(), {"hidden", cycle, "--size", "48x36"});
        return gw(words);
    }
};

TEST_F(Hidden, TellsWhichAlgorithmsAreWrongAboutACycle) {
    const Outcome outcome = hidden({"--json"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    for (const auto& run : nlohmann::json::parse(outcome.out)) {
        const std::string name = run["algorithm"];
        const bool sorts = name.find("painter") == 0;
        if (name != "back-face") {
            EXPECT_EQ(run["counts"]["wrong"] > 0, sorts) << name;
        }
    }
}

TEST_F(Hidden, PrintsTheSameCountsAsCsv) {
    const Outcome outcome = hidden({"--csv", "--algorithm", "newell"});
    std::istringstream lines(outcome.out);
    std::string header, counts, rest;
    std::getline(lines, header);
    std::getline(lines, counts);
    EXPECT_EQ(header.substr(0, 18), "algorithm,polygons");
    EXPECT_EQ(counts.substr(0, 9), "newell,3,");
    EXPECT_EQ(std::count(header.begin(), header.end(), ','), std::count(counts.begin(), counts.end(), ','));
    EXPECT_FALSE(std::getline(lines, rest));
}

TEST_F(Hidden, WritesStepsThatEndWithThePicture) {
    const Outcome outcome = hidden({"--algorithm", "newell", "--steps", "s", "--pictures", "3"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(names("s"), (std::vector<std::string>{"difference.png", "picture.png", "pieces.svg",
                                                    "step_0001.png", "step_0002.png", "step_0003.png",
                                                    "steps.gif", "steps.jsonl", "writes.png"}));
    EXPECT_EQ(bytes_of(in("s/steps.gif")).substr(0, 6), "GIF89a");
    EXPECT_NE(bytes_of(in("s/pieces.svg")).find("<polygon"), std::string::npos);
    std::istringstream log(bytes_of(in("s/steps.jsonl")));
    int lines = 0;
    for (std::string line; std::getline(log, line); ++lines) EXPECT_TRUE(nlohmann::json::accept(line));
    EXPECT_GT(lines, 4);
}

TEST_F(Hidden, WritesAComparisonOfAll) {
    const Outcome outcome = hidden({"--compare", "c"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const auto found = names("c");
    for (const char* name : {"sheet.png", "complexity.png", "counts.csv", "counts.json", "index.html",
                             "bsp.png", "bsp_difference.png", "bsp_writes.png"})
        EXPECT_EQ(std::count(found.begin(), found.end(), name), 1) << name;
    const Pixels sheet = read_pixels(in("c/sheet.png"));
    EXPECT_EQ(sheet.width, 3 * (6 * 48 + 4) - 4);  // enlarged, so that captions can be read
}

TEST_F(Hidden, WritesOverEachPictureWhatItShows) {
    hiddensurface::Replay replay(
        {{.action = hiddensurface::Action::Compare, .polygons = {7, 8}, .test = "x", .result = "yes"}}, 4, 4);
    replay.go_to(1);
    const auto lines = caption_of_step("newell", replay);
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(lines[0][0].text, "newell");
    EXPECT_EQ(lines[0][1].text, "1 of 1");
    EXPECT_EQ(lines[1][1].text, "7");
    EXPECT_EQ(lines[1][2].text, "8");
    EXPECT_EQ(lines[2][1].text, "yes");
    const auto cells = captions_of("bsp", {.snapped = 5, .wrong = 3});
    EXPECT_EQ(cells[0][0][0].text, "bsp");
    EXPECT_EQ(cells[1][0][0].text, "3 wrong");
    EXPECT_EQ(cells[1][1][2].text, "5 snapped");
}

// The scene's name is the scene's file's.
TEST_F(Hidden, EscapesTheScenesName) {
    const std::string hostile = "<script>alert(1)</script> & 'a' \"b\"";
    write("quad.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n");
    write("scene.toml", "name = '''" + hostile + "'''\n[[object]]\nfile = \"quad.obj\"\n");
    const Outcome outcome = gw({"hidden", "scene.toml", "--size", "16x12", "--compare", "c"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const std::string page = bytes_of(in("c/index.html"));
    EXPECT_EQ(page.find("<script>"), page.npos);
    EXPECT_NE(page.find("&lt;script&gt;alert(1)&lt;/script&gt; &amp; &#39;a&#39; &quot;b&quot;"), page.npos);
}

// A scene that takes long is not even read.
TEST_F(Hidden, FindsOutFirstThatItCannotWrite) {
    write("file", "");
    expect_refused(1, {"hidden", "none.toml", "--compare", "no/such"}, {"no/such"});
    expect_refused(1, {"hidden", "none.toml", "--algorithm", "bsp", "--steps", "file"},
                   {"file", "not a folder"});
}

TEST_F(Hidden, RefusesWhatMakesNoSense) {
    expect_refused(2, {"hidden", cycle, "--algorithm", "quicksort"},
                   {"--algorithm 'quicksort'", "newell", "bsp"});
    expect_refused(2, {"hidden", cycle, "--steps", "s"}, {"--steps", "--algorithm NAME"});
    expect_refused(2, {"hidden", cycle, "--algorithm", "bsp", "--compare", "c"}, {"--compare"});
    expect_refused(2, {"hidden", cycle, "--level", "atom"}, {"--level 'atom'", "polygon"});
    expect_refused(2, {"hidden", cycle, "--pictures", "0"}, {"--pictures '0'"});
    expect_refused(1, {"hidden", "none.toml"}, {"none.toml"});
    expect_refused(1, {"hidden", cycle, "--size", "16x12", "--compare", "no/such"}, {"no/such"});
}

TEST_F(Hidden, StylesAreSixPicturesInOneFigure) {
    const Outcome outcome = gw({"styles", cycle, "-o", "styles.png", "--size", "40x30"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const Pixels figure = read_pixels(in("styles.png"));
    EXPECT_EQ(figure.width, 3 * 44 - 4);
    EXPECT_EQ(figure.height, 2 * 34 - 4);
    expect_refused(2, {"styles", cycle, "-o", "styles.xyz"}, {"styles.xyz"});
}

}  // namespace gw::apps
