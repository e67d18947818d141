// gw verify and diff: what is not as it should be is named.
#include "tests/apps/scene_files.h"

namespace gw::apps {

class ComparedRecordings : public SceneTest {
protected:
    Outcome record(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "record");
        arguments.insert(arguments.end(), {"--size", "16x16"});
        return gw(std::move(arguments));
    }
};

TEST_F(ComparedRecordings, VerifyAgainstTheirManifestsAndNoOther) {
    ASSERT_EQ(record({"lamps.toml", "-o", "t.gwt", "--manifest", "m.json"}).code, 0);
    for (const std::string machine : {"fast", "reference", "both"})
        EXPECT_EQ(gw({"verify", "t.gwt", "m.json", "--machine", machine}).code, 0);
    ASSERT_EQ(render({"lamps.toml", "-o", "a.png", "--manifest", "r.json"}).code, 0);
    EXPECT_EQ(gw({"verify", "t.gwt", "r.json"}).code, 0);
    ASSERT_EQ(record({"lamps.toml", "-o", "other.gwt", "--eye", "1,0,5"}).code, 0);
    const Outcome outcome = gw({"verify", "other.gwt", "m.json"});
    EXPECT_EQ(outcome.code, 3);
    for (const char* part :
         {"pass 0 'depth', plane ", ", pixel ", ": expected ", ", got ", "; stage: "})
        EXPECT_NE(outcome.out.find(part), std::string::npos) << part << " in " << outcome.out;
    EXPECT_EQ(gw({"verify", "other.gwt", "m.json", "--update"}).code, 0);
    EXPECT_EQ(gw({"verify", "other.gwt", "m.json"}).code, 0);
}

TEST_F(ComparedRecordings, DiffNamesCommandPixelAndFragment) {
    ASSERT_EQ(record({"lamps.toml", "-o", "a.gwt", "--manifest", "a.json"}).code, 0);
    write("lamps.toml",
          bytes_of(in("lamps.toml")) + "[[light]]\ndirection = [0, 0, -1]\nId = 0.1\n");
    ASSERT_EQ(record({"lamps.toml", "-o", "b.gwt", "--manifest", "b.json"}).code, 0);
    EXPECT_EQ(gw({"diff", "a.gwt", "a.gwt"}).code, 0);
    EXPECT_EQ(gw({"diff", "a.json", "a.json"}).code, 0);
    EXPECT_EQ(gw({"diff", "a.json", "b.json"}).code, 3);
    const Outcome outcome = gw({"diff", "a.gwt", "b.gwt", "-o", "d.png"});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_NE(outcome.out.find("commands: "), std::string::npos) << outcome.out;
    expect_refused(1, {"diff", "a.gwt", "a.json"}, {"a.gwt", "two of a kind"});
}

/// Sixteen rows and eight: the commands differ in nothing else that could be compared.
TEST_F(ComparedRecordings, OfOtherHeightAreNotReplayedAgainstEachOther) {
    ASSERT_EQ(gw({"record", "lamps.toml", "-o", "a.gwt", "--size", "16x16"}).code, 0);
    ASSERT_EQ(gw({"record", "lamps.toml", "-o", "b.gwt", "--size", "16x8"}).code, 0);
    const Outcome outcome = gw({"diff", "a.gwt", "b.gwt"});
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    EXPECT_EQ(outcome.out, "commands: height: expected 16, got 8\n");
    EXPECT_EQ(outcome.err, "");
}

TEST_F(ComparedRecordings, WithOtherCommandsAndTheSamePlanesVerifyAndSaySo) {
    ASSERT_EQ(record({"lamps.toml", "-o", "a.gwt", "--manifest", "a.json"}).code, 0);
    EXPECT_EQ(gw({"verify", "a.gwt", "a.json"}).out.find("its commands are not"),
              std::string::npos);
    // A material that is nowhere seen: the ambient colour under a lamp without ambient light.
    write("lamps.toml", bytes_of(in("lamps.toml")) +
                            "[[object]]\nfile = \"quad.obj\"\ntranslate = [0, 0, -1]\n"
                            "material = {Ka = 1}\n");
    ASSERT_EQ(record({"lamps.toml", "-o", "b.gwt", "--manifest", "b.json"}).code, 0);
    // The manifest of the one with the commands of the other.
    std::string mixed = bytes_of(in("a.json"));
    const std::string other = bytes_of(in("b.json"));
    const auto hash = [](const std::string& text) {
        return text.substr(text.find("\"commands\": "), 47);
    };
    mixed.replace(mixed.find(hash(mixed)), 47, hash(other));
    write("mixed.json", mixed);
    const Outcome outcome = gw({"verify", "a.gwt", "mixed.json"});
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    EXPECT_NE(outcome.out.find("a.gwt: its commands are not those of mixed.json"),
              std::string::npos)
        << outcome.out;
}

}  // namespace gw::apps
