// Claim: what stands in a file cannot make a terminal do anything, nor hide or flood a message.
#include "apps/command/terminal.h"
#include "tests/apps/scene_files.h"

namespace gw::apps {

TEST(Text, ShowsControlCharactersAndKeepsTheRest) {
    EXPECT_EQ(without_controls("a\tb\nc"), "a\tb\nc");
    EXPECT_EQ(without_controls("\x1b[31mred\x07\x7f\r"), "\\x1b[31mred\\x07\\x7f\\x0d");
    EXPECT_EQ(without_controls(std::string_view("a\0b", 3)), "a\\x00b");
    EXPECT_EQ(without_controls("größe 輪 🂡"), "größe 輪 🂡");
}

TEST(Text, ShowsBytesThatAreNoUtf8AndC1Controls) {
    EXPECT_EQ(without_controls("\x9b"
                               "31m"),
              "\\x9b31m");
    EXPECT_EQ(without_controls("\xc2\x9b"
                               "31m"),
              "\\xc2\\x9b31m");
    EXPECT_EQ(without_controls("\xc0\x9b"), "\\xc0\\x9b");
    EXPECT_EQ(without_controls("a\xe8\xbc"), "a\\xe8\\xbc");
    EXPECT_EQ(without_controls("\xff\xfe"), "\\xff\\xfe");
}

TEST(Text, OfALineHasNoNewlinesAndLosesItsMiddleWhereItIsLong) {
    EXPECT_EQ(as_one_line("a\nb\n\n"), "a b");
    const std::string flood(1 << 20, 'x');
    const std::string line = as_one_line("begin " + flood + " end");
    EXPECT_LT(line.size(), 2000u);
    EXPECT_TRUE(line.starts_with("begin xxx"));
    EXPECT_TRUE(line.ends_with("xxx end"));
    EXPECT_NE(line.find(" [...] "), std::string::npos);
    std::string wheels;
    for (int i = 0; i < 1000; ++i) wheels += "輪";
    EXPECT_EQ(as_one_line(wheels).find('\\'), std::string::npos) << "characters stay whole";
}

class UntrustedText : public SceneTest {
protected:
    static void expect_harmless(const std::string& text) {
        EXPECT_EQ(text.find('\x1b'), std::string::npos) << text;
        EXPECT_EQ(text.find('\0'), std::string::npos) << text;
    }
};

TEST_F(UntrustedText, OfErrorsAndWarningsIsShown) {
    write("a.toml", "name = \"x\"\n\"\\u001b[2J\" = 1\n");
    const Outcome key = gw({"render", "a.toml", "-o", "a.png"});
    EXPECT_EQ(key.code, 1);
    expect_harmless(key.err);
    write("b.obj", bytes_of(in("quad.obj")) + "usemtl \x1b]0;title\x07\n");
    const Outcome material = gw({"render", "b.obj", "-o", "b.png"});
    expect_harmless(material.err);
    const Outcome file = gw({"render", "\x1b[2J.obj", "-o", "b.png"});
    EXPECT_EQ(file.code, 1);
    EXPECT_NE(file.err.find("\\x1b[2J.obj: "), std::string::npos) << file.err;
}

TEST_F(UntrustedText, OfNamesInTablesIsShown) {
    write("names.toml", "[[light]]\nname = \"\\u001b[2J\"\ndirection = [0, 0, -1]\nId = 1\n" +
                            bytes_of(in("lamps.toml")));
    const Outcome passes = gw({"passes", "names.toml", "--size", "16x16"});
    ASSERT_EQ(passes.code, 0) << passes.err;
    expect_harmless(passes.out);
    EXPECT_NE(passes.out.find("\\x1b[2J"), std::string::npos);
    ASSERT_EQ(gw({"record", "names.toml", "-o", "t.gwt", "--size", "16x16"}).code, 0);
    expect_harmless(gw({"pixel", "t.gwt", "8", "8"}).out);
}

TEST_F(UntrustedText, WithANulIsNotCutThere) {
    write("nul.toml", "[[object]]\nfile = \"a\\u0000b.obj\"\n");
    const Outcome outcome = gw({"render", "nul.toml", "-o", "a.png"});
    EXPECT_EQ(outcome.code, 1);
    expect_harmless(outcome.err);
    EXPECT_EQ(outcome.err.back(), '\n');
    EXPECT_NE(outcome.err.find("expected"), std::string::npos) << outcome.err;
}

}  // namespace gw::apps
