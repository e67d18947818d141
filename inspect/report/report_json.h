// The contents of a report's page, as JSON. docs/recordings.md, "The files", has its members.
#pragma once

#include "inspect/manifest/manifest.h"
#include "inspect/report/report.h"

#include <nlohmann/json_fwd.hpp>

namespace gw::report {

struct ReportFacts {
    const inspect::Recording& recording;
    const inspect::Manifest& manifest;
    PassSpan shown;
    std::optional<PassSpan> history;
    const nlohmann::ordered_json& pictures;  ///< of every pass that is shown
    /// of every pass of the recording: writes them for colours
    const std::vector<bool>& identifiers;
    bool with_small = false;  ///< pictures have small ones beside them
    const ReportOptions& options;
};

std::string report_json(const ReportFacts& facts);

}  // namespace gw::report
