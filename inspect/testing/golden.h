// Golden manifests: what the passes of a list must leave in every plane, bit for bit, as a file of
// the test.
// Does not know GoogleTest: expect_passes.h does.
#pragma once

#include "inspect/recording/recording.h"

#include <filesystem>

namespace gw::testing {

/// A list and the machine it is meant for: width x height pixels, 1 .. max_window_size each.
inspect::Recording recording_of(CommandList list, const Profile& profile, int width, int height);

/// Writes "NAME.json" and beside it "NAME.values" with the planes after every pass, by which wrong
/// pixels are found. Both appear whole or not at all. Throws Error where the list is not valid or a
/// file cannot be written.
void write_golden(const inspect::Recording& recording, const std::filesystem::path& golden);

/// The environment variable GW_UPDATE_GOLDENS is set and neither empty nor 0: goldens are written
/// instead of compared. The only way in which a test changes one.
bool updates_goldens();

}  // namespace gw::testing
