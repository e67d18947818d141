// Claim: what stands in a file cannot make a terminal do anything, nor hide or flood a message.
#include "apps/command/terminal.h"
#include "tests/apps/scene_files.h"

#include <algorithm>

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
    EXPECT_EQ(as_one_line("a\nb\tc\n\n"), "a\\x0ab\\x09c");
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
    /// The line ends where the command ends it, and is read from left to right.
    static void expect_one_line(const std::string& text) {
        EXPECT_EQ(std::ranges::count(text, '\n'), 1) << text;
        EXPECT_NE(text.find("\\x0a"), std::string::npos) << text;
        for (const char* mark : {"\t", "\r", "\u202e", "\u2028", "\u0085"})
            EXPECT_EQ(text.find(mark), std::string::npos) << text;
    }
    static constexpr const char* forged = "a\ngw: done\t\u202e\u2028\u0085";
    static constexpr const char* forged_in_toml = R"("a\ngw: done\t\u202e\u2028\u0085")";
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

TEST_F(UntrustedText, CannotAddALineToAnError) {
    write("object.toml", std::string("[[object]]\nfile = ") + forged_in_toml + "\n");
    write("renderer.toml", std::string(forged_in_toml) + " = 1\n");
    write("profile.toml", std::string("name = ") + forged_in_toml + "\nlights = 0\n");
    const std::string name(forged), lamps = in("lamps.toml").string();
    write("glow.toml", "[[object]]\nshape = \"rectangle\"\npixmap = { emission = 4 }\n");
    write(name + ".gwt", "no recording");
    for (const auto& words : std::vector<std::vector<std::string>>{
             {"render", "object.toml", "-o", "a.png"},
             {"render", "renderer.toml", "-o", "a.png"},
             {"render", name + ".obj", "-o", "a.png"},
             {"render", name, "-o", "a.png"},
             {"replay", name + ".gwt"},
             {"verify", name + ".gwt", "a.json"},
             {"render", lamps, "-o", name + "/a.png"},
             {"render", lamps, "-o", "a.png", "--profile", name},
             {"render", lamps, "-o", "a.png", "--renderer", name},
             {"hidden", lamps, "--algorithm", name},
             {"radiosity", "glow.toml", "--form-factor", name, name}}) {
        const Outcome outcome = gw(words);
        EXPECT_NE(outcome.code, 0) << words[0];
        expect_one_line(outcome.err);
    }
}

TEST_F(UntrustedText, CannotAddALineToATable) {
    write("names.toml", std::string("[[light]]\nname = ") + forged_in_toml +
                            "\ndirection = [0, 0, -1]\nId = 1\n" + bytes_of(in("lamps.toml")));
    const Outcome passes = gw({"passes", "names.toml", "--size", "16x16"});
    ASSERT_EQ(passes.code, 0) << passes.err;
    EXPECT_NE(passes.out.find("a\\x0agw: done"), std::string::npos) << passes.out;
    EXPECT_EQ(passes.out.find("\ngw: done"), std::string::npos) << passes.out;
    const Outcome json = gw({"passes", "names.toml", "--size", "16x16", "--json"});
    EXPECT_NE(json.out.find(R"(a\ngw: done\t\u202e\u2028\u0085)"), std::string::npos) << json.out;
    ASSERT_EQ(gw({"record", "names.toml", "-o", "t.gwt", "--size", "16x16"}).code, 0);
    EXPECT_EQ(gw({"pixel", "t.gwt", "8", "8"}).out.find("\ngw: done"), std::string::npos);
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
