// Claim: whichever of all allocations fails, a command ends with one clear error and writes nothing.
#include "tests/apps/failing_allocations.h"

namespace gw::apps {

TEST_F(FailingAllocations, OfAPictureEachInTurn) {
    expect_error_or_whole({"render", "lamps.toml", "-o", "a.png", "--size", "16x16"}, 1, 1);
}

TEST_F(FailingAllocations, OfAReplayEachInTurn) {
    ASSERT_EQ(gw({"record", "lamps.toml", "-o", "t.gwt", "--size", "16x16"}).code, 0);
    expect_error_or_whole({"replay", "t.gwt", "-o", "a.png"}, 1, 1);
}

TEST_F(FailingAllocations, OfARecordingAndAProofOneInAHundred) {
    expect_error_or_whole({"record", "lamps.toml", "-o", "t.gwt", "--size", "16x16"}, 50, 97);
    ASSERT_EQ(
        gw({"record", "lamps.toml", "-o", "t.gwt", "--manifest", "m.json", "--size", "16x16"}).code,
        0);
    expect_error_or_whole({"verify", "t.gwt", "m.json"}, 50, 97);
}

}  // namespace gw::apps
