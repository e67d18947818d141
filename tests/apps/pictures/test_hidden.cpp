// gw hidden and gw styles: what they write, print and refuse.
#include "apps/hidden/page.h"
#include "apps/hidden/pictures.h"
#include "test_paths.h"
#include "tests/apps/pictures.h"
#include "tests/apps/support/command_test.h"

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

// A material may have its colour in Ka, Ke or Ks alone.
TEST_F(Hidden, PaintsAMaterialWithoutKdInItsOtherColours) {
    write("cards.mtl",
          "newmtl a\nKa 1 0 0\nKd 0 0 0\nnewmtl e\nKe 0 1 0\nKd 0 0 0\nnewmtl none\nKd 0 0 0\n");
    write("cards.obj",
          "mtllib cards.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nv 3 0 0\n"
          "v 3 1 0\nusemtl a\nf 1 2 3 4\nusemtl e\nf 2 5 6 3\nusemtl none\nf 5 7 8 6\n");
    ASSERT_EQ(gw({"hidden", "cards.obj", "--eye", "1.5,0.5,9", "--at", "1.5,0.5,0", "--fov", "20",
                  "--size", "60x20", "--algorithm", "z-buffer", "--steps", "s"})
                  .code,
              0);
    const Pixels picture = read_pixels(in("s/picture.png"));
    const std::vector<float> ambient = picture.at(22, 10), emissive = picture.at(30, 10),
                             without = picture.at(38, 10);
    EXPECT_GT(ambient[0], 0.5f);
    EXPECT_EQ(ambient[1], 0);
    EXPECT_GT(emissive[1], 0.5f);
    EXPECT_EQ(emissive[0], 0);
    EXPECT_GT(without[0], 0.1f);
    EXPECT_EQ(without[0], without[2]);
}

// What is quadratic by nature says so before it begins.
TEST_F(Hidden, SaysBeforehandWhatWouldTakeLong) {
    write("ball.toml", "[[object]]\nshape = \"sphere\"\nslices = 128\nstacks = 64\n");
    const std::vector<std::string> all{"hidden", "ball.toml", "--size", "48x36",
                                       "--csv",  "--limit",   "0.00001"};
    std::vector<std::string> one = all;
    one.insert(one.end(), {"--algorithm", "newell"});
    expect_refused(1, one, {"newell: ", " polygons would take about ", "; --limit 0 to try"});
    const Outcome outcome = gw(all);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("gw: warning: left out: newell: "), std::string::npos)
        << outcome.err;
    EXPECT_EQ(outcome.out.find("newell"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("z-buffer"), std::string::npos) << outcome.out;
}

TEST_F(Hidden, PrintsTheSameCountsAsCsv) {
    const Outcome outcome = hidden({"--csv", "--algorithm", "newell"});
    std::istringstream lines(outcome.out);
    std::string header, counts, rest;
    std::getline(lines, header);
    std::getline(lines, counts);
    EXPECT_EQ(header.substr(0, 18), "algorithm,polygons");
    EXPECT_EQ(counts.substr(0, 9), "newell,3,");
    EXPECT_EQ(std::count(header.begin(), header.end(), ','),
              std::count(counts.begin(), counts.end(), ','));
    EXPECT_FALSE(std::getline(lines, rest));
}

/// Without the player, which the folder has if the build has it.
std::vector<std::string> without_player(std::vector<std::string> names) {
    const auto found = std::erase(names, "player.html");
    EXPECT_EQ(found, embedded_page("player.html").empty() ? 0u : 1u);
    return names;
}

TEST_F(Hidden, PagesHoldTheirData) {
    for (const std::string name : {"player.html", "compare.html"}) {
        const std::string bare(embedded_page(name));
        if (bare.empty()) {  // a build without npm has no pages
            EXPECT_EQ(page_with(name, {"first\n"}), "");
            continue;
        }
        const std::string page = page_with(name, {"first\n", "second\n"});
        EXPECT_NE(bare.find("<html"), std::string::npos);
        const std::string mark = "<script class=\"data\" type=\"text/plain\">";
        EXPECT_EQ(bare.find(mark), std::string::npos);
        const std::size_t first = page.find(mark), second = page.find(mark, first + 1);
        ASSERT_NE(second, std::string::npos);
        EXPECT_EQ(page.find(mark, second + 1), std::string::npos);
        EXPECT_EQ(page.substr(first + mark.size(), 4), "H4sI");  // gzip, deflated
    }
}

TEST_F(Hidden, WritesStepsThatEndWithThePicture) {
    const Outcome outcome = hidden({"--algorithm", "newell", "--steps", "s"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(without_player(names("s")),
              (std::vector<std::string>{"difference.png", "index.html", "index.json", "picture.png",
                                        "pieces.svg", "steps.jsonl", "writes.png"}));
    EXPECT_NE(bytes_of(in("s/pieces.svg")).find("<path"), std::string::npos);
    std::istringstream log(bytes_of(in("s/steps.jsonl")));
    int lines = 0;
    for (std::string line; std::getline(log, line); ++lines)
        EXPECT_TRUE(nlohmann::json::accept(line));
    EXPECT_GT(lines, 4);
}

TEST_F(Hidden, WritesTwoAlgorithmsIntoOnePlayer) {
    for (const std::vector<std::string>& two :
         {std::vector<std::string>{"newell", "z-buffer"}, {"roberts", "appel"}}) {
        const std::string list = two[0] + "," + two[1], folder = two[0];
        const Outcome outcome = hidden({"--algorithm", list, "--steps", folder, "--csv"});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_NE(outcome.out.find("\n" + two[0] + ","), std::string::npos) << outcome.out;
        EXPECT_NE(outcome.out.find("\n" + two[1] + ","), std::string::npos) << outcome.out;
        std::string logs;
        for (const std::string& name : two)
            logs += bytes_of(in(folder + "/" + name + "/steps.jsonl")).substr(0, 60);
        EXPECT_NE(logs.find("\"algorithm\":\"" + two[0]), std::string::npos) << logs;
        EXPECT_NE(logs.find("\"algorithm\":\"" + two[1]), std::string::npos) << logs;
        if (embedded_page("player.html").empty()) continue;
        const std::string page = bytes_of(in(folder + "/player.html")), mark = "class=\"data\"";
        const std::size_t first = page.find(mark);
        ASSERT_NE(first, page.npos);
        EXPECT_NE(page.find(mark, first + 1), page.npos);
    }
}

TEST_F(Hidden, WarnsIfAnAlgorithmHasNoStepsSoFine) {
    const Outcome coarse = hidden({"--algorithm", "newell", "--level", "pixel", "--steps", "n"});
    EXPECT_EQ(coarse.code, 0);
    EXPECT_EQ(coarse.err,
              "gw: warning: --level pixel: newell has no finer steps than of a polygon\n");
    EXPECT_EQ(hidden({"--algorithm", "z-buffer", "--level", "pixel", "--steps", "z"}).err, "");
}

TEST_F(Hidden, WritesAComparisonOfAll) {
    const Outcome outcome = hidden({"--compare", "c"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const auto found = names("c");
    for (const char* name : {"sheet.png", "complexity.png", "counts.csv", "counts.json",
                             "index.html", "bsp.png", "bsp_difference.png", "bsp_writes.png"})
        EXPECT_EQ(std::count(found.begin(), found.end(), name), 1) << name;
    const Pixels sheet = read_pixels(in("c/sheet.png"));
    const int one = 6 * 48 + 4;  // enlarged, so that captions can be read
    EXPECT_EQ((sheet.width + 4) % one, 0);
    EXPECT_LE(sheet.width, 1920);
    EXPECT_LE(sheet.height, sheet.width);
}

// A line for each algorithm, three times or so: as many counters abreast as a terminal is wide.
TEST_F(Hidden, PrintsATableThatATerminalHolds) {
    const Outcome outcome = hidden({});
    std::istringstream lines(outcome.out);
    std::size_t words = 0, rows = 0;
    for (std::string line, word; std::getline(lines, line);) {
        EXPECT_LE(line.size(), 120u);
        for (std::istringstream in_line(line); in_line >> word; ++words)
            rows += word == "quake" ? 1 : 0;
    }
    const std::size_t algorithms = hiddensurface::algorithms().size(),
                      counters = hiddensurface::count_names().size();
    EXPECT_EQ(words, rows * algorithms + counters * (algorithms + 1));
    EXPECT_GT(rows, 1u);
    EXPECT_LE(rows, 3u);
}

TEST_F(Hidden, WritesOverEachPictureWhatItShows) {
    const auto cells = captions_of("bsp", {.splits = 2, .snapped = 5, .wrong = 3});
    EXPECT_EQ(cells[0][0][0].text, "bsp");
    ASSERT_EQ(cells[0][1].size(), 1u);  // what is 0 is left out
    EXPECT_EQ(cells[0][1][0].text, "2 splits");
    EXPECT_EQ(cells[1][0][0].text, "3 wrong");
    ASSERT_EQ(cells[1][1].size(), 1u);
    EXPECT_EQ(cells[1][1][0].text, "5 snapped");
}

// The scene's name is the scene's file's: no page holds it as markup.
TEST_F(Hidden, EscapesTheScenesName) {
    write("quad.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n");
    write("scene.toml",
          "name = '''<script>alert(1)</script>'''\n[[object]]\nfile = \"quad.obj\"\n");
    const Outcome outcome = gw({"hidden", "scene.toml", "--size", "16x12", "--compare", "c"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const std::string page = bytes_of(in("c/index.html"));
    EXPECT_NE(page.find("<html"), page.npos);
    EXPECT_EQ(page.find("alert(1)"), page.npos);
}

// A scene that takes long is not even read.
TEST_F(Hidden, FindsOutFirstThatItCannotWrite) {
    write("file", "");
    expect_refused(1, {"hidden", cycle, "--compare", "no/such"}, {"no/such"});
    expect_refused(1, {"hidden", cycle, "--algorithm", "bsp", "--steps", "file"},
                   {"file", "not a folder"});
}

TEST_F(Hidden, RefusesWhatMakesNoSense) {
    expect_refused(2, {"hidden", cycle, "--algorithm", "quicksort"},
                   {"--algorithm 'quicksort'", "newell", "bsp"});
    expect_refused(2, {"hidden", cycle, "--steps", "s"}, {"--steps", "--algorithm NAME"});
    expect_refused(2, {"hidden", cycle, "--algorithm", "bsp,"}, {"--algorithm ''"});
    expect_refused(2, {"hidden", cycle, "--algorithm", "bsp,quake,newell"}, {"3 names"});
    expect_refused(2, {"hidden", cycle, "--algorithm", "bsp,bsp"}, {"one name twice"});
    expect_refused(2, {"hidden", cycle, "--algorithm", "bsp,appel"}, {"two of a kind"});
    expect_refused(2, {"hidden", cycle, "--algorithm", "bsp", "--compare", "c"}, {"--compare"});
    expect_refused(2, {"hidden", cycle, "--algorithm", "bsp", "--steps", "s", "--level", "atom"},
                   {"--level 'atom'", "polygon"});
    expect_refused(2, {"hidden", cycle, "--level", "pixel"}, {"--level", "--steps"});
    expect_refused(1, {"hidden", "none.toml"}, {"none.toml"});
    expect_refused(1, {"hidden", cycle, "--size", "16x12", "--compare", "no/such"}, {"no/such"});
}

TEST_F(Hidden, DrawsHiddenLinesWithStepsAndCounts) {
    for (const std::string name : {"roberts", "appel"}) {
        const Outcome outcome = hidden({"--algorithm", name, "--steps", name});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_NE(outcome.out.find(name), std::string::npos);
        EXPECT_NE(outcome.out.find("\nlines "), std::string::npos);
        EXPECT_EQ(without_player(names(name)),
                  (std::vector<std::string>{"difference.png", "index.html", "index.json",
                                            "lines.svg", "picture.png", "steps.jsonl"}));
        std::istringstream log(bytes_of(in(name + "/steps.jsonl")));
        int lines = 0;
        for (std::string line; std::getline(log, line); ++lines)
            EXPECT_TRUE(nlohmann::json::accept(line));
        EXPECT_EQ(lines, 11);  // header, the sides of three triangles, end
    }
    const Outcome json = hidden({"--algorithm", "appel", "--json"});
    EXPECT_EQ(nlohmann::json::parse(json.out)[0]["counts"]["lines"], 9);
    expect_refused(1, {"hidden", cycle, "--algorithm", "floating-horizon"},
                   {"expected a height field"});
}

TEST_F(Hidden, GradesAFragmentList) {
    const auto fragments = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"fragments", cycle, "--size", "48x36"});
        return gw(words);
    };
    EXPECT_EQ(fragments({"--truth", "truth.csv"}).code, 0);
    const Outcome right = fragments({"truth.csv"});
    EXPECT_EQ(right.code, 0) << right.err;
    EXPECT_NE(right.out.find("missing 0\ndoubled 0\nmisplaced 0\nwrong 0\n"), std::string::npos);
    EXPECT_EQ(right.out.find("--size"), std::string::npos);
    write("mine.csv", "x,y,polygon\n0,0,1\n");
    const std::string bad = fragments({"mine.csv"}).out;
    EXPECT_NE(bad.find("was the list made with --size"), std::string::npos) << bad;
    const Outcome mine = fragments({"mine.csv", "--marked", "marked.png", "--json"});
    EXPECT_EQ(mine.code, 3);
    const auto grade = nlohmann::json::parse(mine.out);
    EXPECT_EQ(grade["misplaced"], 1);
    EXPECT_EQ(grade["missing"], grade["expected"]);
    EXPECT_EQ(read_pixels(in("marked.png")).width, 48);
    write("bad.csv", "0,0,1\n0,0\n");
    expect_refused(1, {"fragments", cycle, "bad.csv", "--size", "48x36"},
                   {"bad.csv:2: ", "expected x,y,polygon"});
    expect_refused(1, {"fragments", cycle, "none.csv"}, {"none.csv"});
    expect_refused(1, {"fragments", "none.toml", "--truth", "no/such.csv"}, {"no/such.csv"});
    expect_refused(2, {"fragments", cycle}, {"LIST.csv", "--truth"});
    expect_refused(2, {"fragments", cycle, "--truth", "t.csv", "--marked", "m.png"},
                   {"--marked", "LIST.csv"});
    expect_refused(2, {"fragments", cycle, "f.csv", "--marked", "m.xyz"}, {"m.xyz"});
    expect_refused(2, {"fragments", cycle, "f.csv", "--algorithm", "bsp"}, {"--algorithm"});
}

TEST_F(Hidden, PlayWritesPolygonsAndNeedsSomethingToDo) {
    EXPECT_EQ(gw({"play", cycle, "--polygons", "p.json"}).code, 0);
    EXPECT_EQ(nlohmann::json::parse(bytes_of(in("p.json")))["log"], "gw hidden polygons");
    expect_refused(2, {"play", cycle}, {"STEPS.jsonl", "--polygons"});
    expect_refused(1, {"play", cycle, "none.jsonl"}, {"none.jsonl"});
    expect_refused(1, {"play", cycle, "--polygons", "no/such.json"}, {"no/such.json"});
    expect_refused(2, {"play", cycle, "s.jsonl", "--compare", "c"}, {"--compare"});
}

TEST_F(Hidden, QuizRefusesWrongValues) {
    expect_refused(2, {"hidden"}, {"SCENE is required"});
    expect_refused(2, {"quiz"}, {"DIR is required"});
    expect_refused(2, {"grade", "q/key.json"}, {"ANSWERS is required"});
    expect_refused(2, {"quiz", "q", cycle}, {"unexpected word"});
    expect_refused(2, {"quiz", "q", "--kind", "riddle"}, {"--kind 'riddle'", "order"});
    expect_refused(2, {"quiz", "q", "--questions", "0"}, {"--questions '0'"});
    expect_refused(2, {"quiz", "q", "--seed", "-1"}, {"--seed '-1'"});
    expect_refused(2, {"quiz", "q", "--algorithm", "bsp"}, {"--algorithm"});
    expect_refused(1, {"quiz", "no/such"}, {"no/such"});
}

TEST_F(Hidden, NamesTheCommandsOfOtherTasks) {
    const std::pair<std::vector<std::string>, std::string> moved[] = {
        {{"--quiz", "q", "--seed", "7"}, "gw quiz DIR"},
        {{"--seed", "7"}, "gw quiz DIR --seed N"},
        {{"--questions", "7"}, "gw quiz DIR --questions N"},
        {{"--kind", "order"}, "gw quiz DIR --kind NAME"},
        {{"--students", "3"}, "gw quiz DIR --students N"},
        {{"--grade", "key.json", "answers.json"}, "gw grade KEY.json ANSWERS.json"},
        {{cycle, "--fragments", "f.csv"}, "gw fragments SCENE LIST.csv"},
        {{cycle, "--marked", "m.png"}, "gw fragments SCENE LIST.csv --marked IMAGE"},
        {{cycle, "--truth", "t.csv"}, "gw fragments SCENE --truth FILE.csv"},
        {{cycle, "--play", "s.jsonl"}, "gw play SCENE STEPS.jsonl"},
        {{cycle, "--polygons", "p.json"}, "gw play SCENE --polygons FILE.json"},
    };
    for (auto [words, command] : moved) {
        words.insert(words.begin(), "hidden");
        expect_refused(2, words, {"no such option; expected " + command + "\n"});
    }
    EXPECT_EQ(gw({"hidden", "--help"}).out.find("--quiz"), std::string::npos);
    EXPECT_EQ(gw({"describe", "bash"}).out.find("--grade"), std::string::npos);
    expect_refused(2, {"new-algorithm", "mine"}, {"unknown command"});
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
