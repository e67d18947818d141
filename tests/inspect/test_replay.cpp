// Claims: a recording replays to the same planes on both machines, however it is cut; a machine
// with a fault is found, with pass, plane, pixel and both values.
#include <gtest/gtest.h>

#include "inspect/compare/compare_machines.h"
#include "inspect/replay/forwarding_machine.h"
#include "inspect/replay/player.h"
#include "tests/inspect/same.h"
#include "tests/inspect/three_passes.h"
#include "tests/inspect/wrong_machine.h"

namespace gw::inspect {

TEST(Replay, GivesTheSamePlanesOnBothMachines) {
    for (const fuzz::Suite& suite : fuzz::suites())
        for (std::uint64_t i = 0; i < 8; ++i) {
            const Recording recording = decode(encode(recording_of(fuzz::make_case(suite, i))));
            const auto finding =
                compare_machines(recording, maker_of("reference"), maker_of("fast", 2));
            ASSERT_FALSE(finding) << suite.name << " " << i << ": "
                                  << text(*finding, recording.height);
        }
}

TEST(Replay, StepByStepIsTheSameAsWhole) {
    const Recording recording = three_passes();
    const auto whole = maker_of("fast")(recording), steps = maker_of("fast")(recording);
    Player(recording, *whole).play();
    Player player(recording, *steps);
    for (std::size_t end = 0; end <= command_count(recording); ++end) player.play_to(end);
    EXPECT_EQ(whole->planes(), steps->planes());
    EXPECT_EQ(whole->passes(), steps->passes());
}

TEST(Replay, KnowsItsPasses) {
    const auto passes = pass_ranges(three_passes());
    ASSERT_EQ(passes.size(), 3u);
    EXPECT_EQ(passes[1].name, "first");
    EXPECT_EQ(passes[1].first, 2u);
    EXPECT_EQ(passes[1].end, 4u);
    EXPECT_EQ(passes[2].end, 7u);
    Recording unnamed;
    unnamed.lists = {{{SetState{}, Clear{}, BeginPass{.name = "a"}}}};
    EXPECT_EQ(pass_ranges(unnamed).front().name, "");
    unnamed.lists = {{{SetState{}, BeginPass{.name = "a"}}}};
    EXPECT_EQ(pass_ranges(unnamed).front().name, "a");
}

TEST(Replay, RecorderKeepsWhatWasExecuted) {
    const Recording recording = three_passes();
    const auto machine = maker_of("fast")(recording);
    std::vector<CommandList> lists;
    Recorder recorder(*machine, lists);
    Player(recording, recorder).play();
    ASSERT_EQ(lists.size(), 2u);
    EXPECT_TRUE(same(lists[1], recording.lists[1]));
}

TEST(Replay, AWrongMachineIsFoundOut) {
    const Recording recording = three_passes();
    const auto finding = compare_machines(recording, maker_of("reference"), wrong(too_green));
    ASSERT_TRUE(finding);
    EXPECT_EQ(
        text(*finding, recording.height),
        "pass 1 'first', plane color, pixel 3 3: expected 100 100 100 255, got 100 101 100 255; stage: "
        "shading, texture, fog, blending or the colour mask\n"
        "  after command 3 of the recording (WritePixels), the first whose planes differ\n");
}

TEST(Replay, ADifferenceInCountsAloneIsFoundToo) {
    const Recording recording = three_passes();
    const auto finding =
        compare_machines(recording, maker_of("reference"), wrong([](Command& command) {
                             if (auto* clear = std::get_if<Clear>(&command))
                                 clear->planes &= ~mask_of(Plane::Stencil);
                         }));
    ASSERT_TRUE(finding);
    EXPECT_EQ(finding->what, "counter pixels");
    EXPECT_EQ(finding->stage, "pixel commands");
}

}  // namespace gw::inspect
