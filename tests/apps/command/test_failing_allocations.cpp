// Claim: whichever allocation fails, a command ends with one clear error and writes nothing.
#include "tests/apps/failing_allocations.h"

namespace gw::apps {

TEST_F(FailingAllocations, OfAPictureWithItsFiles) {
    expect_error_or_whole({"render", "lamps.toml", "-o", "a.png", "--manifest", "m.json", "--size",
                           "16x16", "--threads", "1"},
                          20, 997);
}

TEST_F(FailingAllocations, OfARecordingAndItsReplay) {
    expect_error_or_whole({"record", "lamps.toml", "-o", "t.gwt", "--size", "16x16"}, 20, 997);
    ASSERT_EQ(
        gw({"record", "lamps.toml", "-o", "t.gwt", "--manifest", "m.json", "--size", "16x16"}).code,
        0);
    expect_error_or_whole({"replay", "t.gwt", "-o", "a.png", "--machine", "both"}, 20, 997);
    expect_error_or_whole({"verify", "t.gwt", "m.json"}, 20, 997);
}

}  // namespace gw::apps
