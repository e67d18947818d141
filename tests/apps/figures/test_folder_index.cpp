// Claim: a folder that commands write into has an index of its pictures, with the command that made
// each.
#include "apps/command/folder_index.h"
#include "tests/apps/scene_files.h"
#include "tests/apps/support/examples.h"

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
    EXPECT_TRUE(contains(page("steps"), "href=\"player.html\""));
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
}

TEST_F(Index, OfAQuizIsTheTeachersOnly) {
    ASSERT_EQ(gw({"quiz", "q", "--questions", "2"}).code, 0);
    EXPECT_TRUE(contains(page("q"), "src=\"handout/picture_02.svg\""));
    EXPECT_TRUE(contains(page("q"), "<a href=\"key.json\">"));
    EXPECT_FALSE(fs::exists(in("q/handout/index.html")));
}

// Letters of a plot are legible at its own width; pictures of pixels are never enlarged by a fraction.
TEST(FolderIndexes, PlotsAreWideAndPixelsWhole) {
    const std::string text = index_page({entry_of({"d/a.svg", "d/b.png"}, "d")}, {"title", "text"});
    EXPECT_NE(text.find("<figure class=\"plot\"><a href=\"a.svg\">"), text.npos);
    EXPECT_NE(text.find("<figure><a href=\"b.png\">"), text.npos);
    const std::string style = text.substr(0, text.find("</style>"));
    EXPECT_EQ(style.find("pixelated"), style.npos);
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
