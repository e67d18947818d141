// Folders that commands write into have an index of their pictures, with the command that made
// each; gw index makes one page of many folders.
#include "apps/describe/shell_words.h"
#include "apps/figures/folder_index.h"
#include "apps/figures/index_page.h"
#include "tests/apps/scene_files.h"
#include "tests/apps/support/examples.h"

#include "gw/error.h"
#include "study/plot/plot.h"

namespace gw::apps {

namespace fs = std::filesystem;

class Index : public SceneTest {
protected:
    Index() { EXPECT_EQ(gw({"record", "lamps.toml", "-o", "t.gwt", "--size", "16x16"}).code, 0); }

    std::string page(const std::string& folder) const {
        return bytes_of(in(folder + "/index.html"));
    }
    static bool contains(const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    }
};

TEST_F(Index, ShowsEveryPictureWithTheCommandThatMakesItAgain) {
    ASSERT_EQ(gw({"maps", "t.gwt", "-o", "maps", "--pass", "0"}).code, 0);
    const std::string text = page("maps");
    for (const char* name : {"depth_complexity.png", "overdraw.png", "why_killed.png"})
        EXPECT_TRUE(contains(text, std::string("<img src=\"") + name + "\"")) << name;
    EXPECT_TRUE(contains(text, "<a href=\"fragments.exr\">"));
    EXPECT_TRUE(contains(text, "<code>build/release/bin/gw maps t.gwt -o maps --pass 0</code>"));
    EXPECT_FALSE(contains(text, "http"));
}

TEST_F(Index, OfSeveralCommandsInOneFolderHasEachPictureOnce) {
    ASSERT_EQ(gw({"maps", "t.gwt", "-o", "out"}).code, 0);
    ASSERT_EQ(gw({"replay", "t.gwt", "--planes", "out"}).code, 0);
    EXPECT_TRUE(contains(page("out"), "gw maps t.gwt -o out<"));
    EXPECT_TRUE(contains(page("out"), "gw replay t.gwt --planes out<"));
    ASSERT_EQ(gw({"maps", "t.gwt", "-o", "out", "--pass", "1"}).code, 0);
    const std::string text = page("out");
    EXPECT_FALSE(contains(text, "gw maps t.gwt -o out<"));
    EXPECT_TRUE(contains(text, "gw maps t.gwt -o out --pass 1<"));
    EXPECT_EQ(text.find("src=\"overdraw.png\""), text.rfind("src=\"overdraw.png\""));
    const std::string once = bytes_of(in("out/index.json"));
    ASSERT_EQ(gw({"maps", "t.gwt", "-o", "out", "--pass", "1"}).code, 0);
    EXPECT_EQ(bytes_of(in("out/index.json")), once);
}

TEST_F(Index, ComponentsPlanesAndStepsHaveOneEach) {
    ASSERT_EQ(
        render({"lamps.toml", "-o", "a.png", "--components", "parts", "--planes", "planes"}).code,
        0);
    EXPECT_TRUE(contains(page("parts"), "src=\"sum.png\""));
    EXPECT_FALSE(contains(page("parts"), "a.png\""));
    EXPECT_TRUE(contains(page("planes"), "src=\"depth.png\""));
    ASSERT_EQ(
        gw({"hidden", "lamps.toml", "--algorithm", "newell", "--steps", "steps", "--size", "16x16"})
            .code,
        0);
    EXPECT_TRUE(contains(page("steps"), "src=\"steps.gif\""));
    EXPECT_FALSE(fs::exists(in("index.html")));
}

TEST_F(Index, LeavesPagesOfOthersAlone) {
    fs::create_directory(in("mine"));
    write("mine/index.html", "my own page");
    ASSERT_EQ(gw({"maps", "t.gwt", "-o", "mine"}).code, 0);
    EXPECT_EQ(page("mine"), "my own page");
    EXPECT_TRUE(fs::exists(in("mine/index.json")));
    write("mine/index.json", "[1, 2]");
    ASSERT_EQ(gw({"maps", "t.gwt", "-o", "mine"}).code, 0);
    EXPECT_EQ(bytes_of(in("mine/index.json")), "[1, 2]");
    EXPECT_TRUE(fs::exists(in("mine/overdraw.png")));
    expect_refused(1, {"index", "mine"}, {"mine/index.html", "not a page of gw index"});
}

TEST_F(Index, OfAFolderOfFoldersIsOnePage) {
    fs::create_directory(in("all"));
    ASSERT_EQ(gw({"maps", "t.gwt", "-o", "all/maps"}).code, 0);
    ASSERT_EQ(gw({"inspect", "t.gwt", "-o", "all/a report"}).code, 0);
    ASSERT_EQ(gw({"hidden", "lamps.toml", "--compare", "all/hidden", "--size", "16x16"}).code, 0);
    ASSERT_EQ(render({"lamps.toml", "-o", "all/alone.png"}).code, 0);
    const Outcome outcome = gw({"index", "all"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "all/index.html\n");
    const std::string text = page("all");
    EXPECT_TRUE(contains(text, "src=\"maps/overdraw.png\""));
    EXPECT_TRUE(contains(text, "href=\"hidden/index.html\""));
    EXPECT_TRUE(contains(text, "src=\"hidden/sheet.png\""));
    EXPECT_TRUE(contains(text, "href=\"a%20report/index.html\""));
    EXPECT_TRUE(contains(text, "gw inspect t.gwt -o &#39;all/a report&#39;<"));
    EXPECT_FALSE(contains(text, "pictures/0000"));
    EXPECT_TRUE(contains(text, "src=\"alone.png\""));
    ASSERT_EQ(gw({"index", "all"}).code, 0);
    EXPECT_EQ(page("all"), text);
}

TEST_F(Index, HasSinglePicturesByTheCommandsThatTheyName) {
    fs::create_directories(in("all/deep"));
    ASSERT_EQ(render({"lamps.toml", "-o", "all/a.png"}).code, 0);
    ASSERT_EQ(render({"lamps.toml", "-o", "all/deep/t.png", "--turntable", "2"}).code, 0);
    ASSERT_EQ(gw({"cast", "lamps.toml", "-o", "all/deep/cast.png", "--size", "16x16"}).code, 0);
    if (!TemporaryFolder().keeps_attributes())
        GTEST_SKIP() << "no extended attributes in " << in("all");
    EXPECT_FALSE(fs::exists(in("all/index.json")));
    EXPECT_FALSE(fs::exists(in("all/deep/index.html")));
    write("all/mine.png", "from elsewhere");
    ASSERT_EQ(gw({"index", "all"}).code, 0);
    const std::string text = page("all");
    const auto has = [&](const std::string& part) {
        EXPECT_TRUE(contains(text, part)) << part << "\n" << text;
    };
    has("<h2>gw render lamps.toml</h2>");
    has("src=\"a.png\"");
    has("<code>build/release/bin/gw render lamps.toml -o all/a.png");
    has("gw cast lamps.toml -o all/deep/cast.png --size 16x16</code>");
    EXPECT_LT(text.find("t_001.png"), text.find("t_002.png"));
    EXPECT_EQ(text.find("--turntable 2"), text.rfind("--turntable 2"));
    EXPECT_LT(text.find("<h2>Others"), text.find("src=\"mine.png\""));
    EXPECT_EQ(text.find("src", text.find("src=\"mine.png\"") + 1), text.npos)
        << "others name their command";
}

TEST_F(Index, HasPlotsOfOtherProgramsByTheirCommands) {
    fs::create_directory(in("all"));
    const plot::Plot plot{.title = "a plot",
                          .caption = "",
                          .command = "build/release/bin/bench_growth 'a b'",
                          .x = {"x"},
                          .y = {"y"},
                          .series = {{"s", {{1, 2}}}}};
    write("all/plot.svg", plot::svg(plot));
    ASSERT_EQ(gw({"index", "all"}).code, 0);
    EXPECT_TRUE(contains(page("all"), "<h2>bench_growth a b</h2>"));
    EXPECT_TRUE(contains(page("all"), "<code>build/release/bin/bench_growth &#39;a b&#39;</code>"));
    EXPECT_TRUE(contains(page("all"), "src=\"plot.svg\""));
}

TEST_F(Index, OfAQuizIsTheTeachersOnly) {
    ASSERT_EQ(gw({"hidden", "--quiz", "q", "--questions", "2"}).code, 0);
    EXPECT_TRUE(contains(page("q"), "src=\"handout/picture_02.png\""));
    EXPECT_TRUE(contains(page("q"), "<a href=\"key.json\">"));
    EXPECT_FALSE(fs::exists(in("q/handout/index.html")));
}

TEST_F(Index, RefusesWhatIsNoFolderOfPictures) {
    expect_refused(1, {"index", "missing"}, {"missing", "is not a folder"});
    expect_refused(1, {"index", "t.gwt"}, {"t.gwt", "is not a folder"});
    expect_refused(2, {"index", ""}, {"DIR"});
    fs::create_directory(in("empty"));
    expect_refused(1, {"index", "empty"}, {"empty", "no pictures"});
    write("empty/index.json", "{\"format\": \"gw index\", \"version\": 1}");
    expect_refused(1, {"index", "empty"}, {"index.json", "entries"});
    write("empty/index.json", "{\"format\": \"a list\", \"version\": 1, \"entries\": []}");
    expect_refused(1, {"index", "empty"}, {"index.json", "of another kind"});
}

TEST(ShellWords, AreThoseOfTheCommand) {
    const std::vector<std::string> words{"hidden", "a b.toml", "it's", "",
                                         "--eye",  "1,2,3",    "\\",   "x'' y"};
    std::vector<std::string> expected{"build/release/bin/gw"};
    expected.insert(expected.end(), words.begin(), words.end());
    EXPECT_EQ(shell_words(shell_command(words)), expected);
    EXPECT_TRUE(shell_words("").empty());
}

TEST(FolderIndexes, CannotBeBrokenByNames) {
    IndexEntry entry = entry_of({"d/<b>&\"'.png", "d/a b#?.svg", "elsewhere/c.png"}, "d");
    ASSERT_EQ(entry.pictures.size(), 2u);
    entry.title = "<script>";
    entry.commands = {{"gw '<x>' && y", "", ""}};
    const std::string text = index_page({entry}, {"<t>", "&"});
    EXPECT_EQ(text.find("<script>"), text.npos);
    EXPECT_EQ(text.find("<b>"), text.npos);
    EXPECT_EQ(text.find("<t>"), text.npos);
    EXPECT_NE(text.find("src=\"a%20b%23%3F.svg\""), text.npos);
    EXPECT_NE(text.find("&amp;&amp; y"), text.npos);
}

}  // namespace gw::apps
