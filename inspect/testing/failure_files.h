// Files that a failed comparison leaves for inspection. Does not compare.
#pragma once

#include "gw/planes.h"
#include "gw/profile.h"
#include "inspect/compare/finding.h"
#include "inspect/recording/recording.h"

#include <filesystem>
#include <optional>
#include <string>

namespace gw::testing {

/// The folder for pictures of failures: the environment variable GW_TESTING_OUTPUT, or "gw-testing"
/// in the current folder.
std::filesystem::path output_folder();

/// Writes PNG files of the first plane, in a fragment's order, that differs:
/// "SUITE.TEST-NAME-PLANE-actual.png", -expected and -difference (equal pixels black, the worst
/// white). Without `expected`, writes only the actual colours. Returns a line for each file; if it
/// cannot be written, the line says why.
std::string write_failure_pictures(const std::string& name, const std::optional<Planes>& expected,
                                   const Planes& actual, const Profile& profile);

/// Writes the recording that was compared with a golden, as "SUITE.TEST-NAME.gwt" for gw pixel and
/// gw inspect, and its manifest and values for gw diff. Returns a line for each command that shows
/// the difference.
std::string write_failure_recording(const std::string& name, const inspect::Recording& actual,
                                    const std::filesystem::path& golden,
                                    const inspect::Finding& finding);

}  // namespace gw::testing
