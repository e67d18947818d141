// What a failed comparison leaves to look at. Does not compare.
#pragma once

#include "gw/planes.h"
#include "gw/profile.h"
#include "inspect/compare/finding.h"
#include "inspect/recording/recording.h"

#include <filesystem>
#include <optional>
#include <string>

namespace gw::testing {

/// Where pictures of failures go: the environment variable GW_TESTING_OUTPUT, or "gw-testing" in
/// the current folder.
std::filesystem::path output_folder();

/// Of the first plane in a fragment's order that differs, PNG files
/// "SUITE.TEST-NAME-PLANE-actual.png", -expected and -difference (black where equal, white where
/// worst); without `expected` of the colours, and only the actual ones. Returns a line for each
/// file; where it cannot be written, the line says why.
std::string write_failure_pictures(const std::string& name, const std::optional<Planes>& expected,
                                   const Planes& actual, const Profile& profile);

/// What a golden was compared with, as "SUITE.TEST-NAME.gwt" for gw pixel and gw inspect, and its
/// manifest and values for gw diff. Returns a line for each command that shows the difference.
std::string write_failure_recording(const std::string& name, const inspect::Recording& actual,
                                    const std::filesystem::path& golden,
                                    const inspect::Finding& finding);

}  // namespace gw::testing
