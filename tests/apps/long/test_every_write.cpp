// Claim: wherever a disk is full, in whichever file of whichever command, the command says so with
// code 1, and what was there before is as it was.
#include "tests/apps/failing_writes.h"

namespace gw::apps {

TEST_F(FailingWrites, OfPicturesInEveryKindOfFormat) {
    for (const std::string name : {"a.png", "a.exr", "a.tif", "a.ppm", "a.jpg", "a.tga"})
        expect_whole_or_nothing({"render", "lamps.toml", "-o", name, "--size", "32x32"}, {name});
}

TEST_F(FailingWrites, OfFoldersThatAreNewOrKept) {
    expect_whole_or_nothing({"render", "lamps.toml", "-o", "a.png", "--size", "16x16", "--planes",
                             "planes", "--components", "parts"},
                            {"a.png", "planes", "parts"});
    expect_whole_or_nothing(
        {"hidden", "lamps.toml", "--algorithm", "newell", "--steps", "steps", "--size", "16x16"},
        {"steps"});
    expect_whole_or_nothing({"quiz", "quiz", "--questions", "1"}, {"quiz"});
}

}  // namespace gw::apps
