// EXPECT_PASSES_EQ: the passes of a command list against a golden manifest, on both machines.
//
//     TEST(MyRenderer, DrawsTheTeapotAsBefore) {
//         EXPECT_PASSES_EQ(my_renderer::list_of(teapot()), "goldens/teapot.json");
//     }
//
// Made with GW_UPDATE_GOLDENS=1, or with write_golden.
#pragma once

#include "inspect/recording/recording.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace gw::testing {

/// A list and the machine it is meant for: width x height pixels, 1 .. max_window_size each.
inspect::Recording recording_of(CommandList list, const Profile& profile, int width, int height);

/// Writes "NAME.json" and beside it "NAME.values" with the planes after every pass, by which wrong
/// pixels are found. Makes their folder. Both appear whole or not at all. Throws Error if the list is not valid or a
/// file cannot be written.
void write_golden(const inspect::Recording& recording, const std::filesystem::path& golden);

/// The environment variable GW_UPDATE_GOLDENS is set and neither empty nor 0: goldens are written
/// instead of compared. The only way in which a test changes one.
bool updates_goldens();

/// Success: after every pass all planes and counters are as the golden says, on the reference and
/// the fast machine. Failure: a message with the first differing pass, plane, pixel, both values
/// and the stage. It names the pictures of that plane: actual and, if known, expected and
/// difference (failure_files.h). Never throws: a missing or damaged golden and an invalid list are
/// failures that say so.
::testing::AssertionResult passes_eq(const inspect::Recording& recording,
                                     const std::filesystem::path& golden);

/// The profile and the window are the golden's, which has to exist.
::testing::AssertionResult passes_eq(const CommandList& list, const std::filesystem::path& golden);

}  // namespace gw::testing

/// `list`: a gw::CommandList or a gw::inspect::Recording.
#define EXPECT_PASSES_EQ(list, golden) EXPECT_TRUE(::gw::testing::passes_eq(list, golden))
#define ASSERT_PASSES_EQ(list, golden) ASSERT_TRUE(::gw::testing::passes_eq(list, golden))
