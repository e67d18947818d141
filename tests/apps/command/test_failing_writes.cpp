// Claim: wherever a disk is full, in whichever file of whichever command, the command says so with
// code 1, and what was there before is as it was.
#include "tests/apps/failing_writes.h"

namespace gw::apps {

TEST_F(FailingWrites, OfEveryFileBesideAPicture) {
    expect_whole_or_nothing({"render", "lamps.toml", "-o", "a.png", "--size", "16x16", "--manifest",
                             "m.json", "--counters", "c.json"},
                            {"a.png", "m.json", "c.json"});
    expect_whole_or_nothing({"cast", "lamps.toml", "-o", "a.png", "--tests", "t.png"},
                            {"a.png", "t.png"});
    expect_whole_or_nothing({"styles", "lamps.toml", "-o", "a.png", "--size", "16x16"}, {"a.png"});
}

TEST_F(FailingWrites, OfRecordingsAndManifests) {
    expect_whole_or_nothing(
        {"record", "lamps.toml", "-o", "t.gwt", "--manifest", "m.json", "--size", "16x16"},
        {"t.gwt", "m.json", "m.values"});
    ASSERT_EQ(gw({"record", "lamps.toml", "-o", "t.gwt", "--size", "16x16"}).code, 0);
    expect_whole_or_nothing({"replay", "t.gwt", "-o", "a.png"}, {"a.png"});
    expect_whole_or_nothing({"inspect", "t.gwt", "-o", "report"}, {"report"});
    write("other.toml", bytes_of(in("lamps.toml")) + "[[light]]\ndirection = [0, 0, -1]\nId = 1\n");
    ASSERT_EQ(gw({"verify", "t.gwt", "m.json", "--update"}).code, 0);
}

}  // namespace gw::apps
