// EXPECT_PASSES_EQ: the passes of a command list against a golden manifest, on both machines.
//
//     TEST(MyRenderer, DrawsTheTeapotAsBefore) {
//         EXPECT_PASSES_EQ(my_renderer::list_of(teapot()), "goldens/teapot.json");
//     }
//
// Made with GW_UPDATE_GOLDENS=1, or with write_golden.
#pragma once

#include "inspect/testing/golden.h"

#include <gtest/gtest.h>

namespace gw::testing {

/// Success: after every pass all planes and counters are as the golden says, on the reference and
/// the fast machine. Failure: a message with the first differing pass, plane, pixel, both values
/// and the stage, and where the pictures of that plane are: actual and, where known, expected and
/// difference (failure_files.h). Never throws: a golden that is missing or damaged and a list
/// that is not valid are failures that say so.
::testing::AssertionResult passes_eq(const inspect::Recording& recording,
                                     const std::filesystem::path& golden);

/// The profile and the window are the golden's, which has to exist.
::testing::AssertionResult passes_eq(const CommandList& list, const std::filesystem::path& golden);

}  // namespace gw::testing

/// `list`: a gw::CommandList or a gw::inspect::Recording.
#define EXPECT_PASSES_EQ(list, golden) EXPECT_TRUE(::gw::testing::passes_eq(list, golden))
#define ASSERT_PASSES_EQ(list, golden) ASSERT_TRUE(::gw::testing::passes_eq(list, golden))
