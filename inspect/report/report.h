// A recording as a page that opens from disk. It shows, for every pass, its parameter set, its
// changes of state and planes, counters and estimated time. It has the histories of all pixels.
// docs/recordings.md. Does not choose the folder.
#pragma once

#include "inspect/report/prices.h"

#include "inspect/recording/recording.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace gw::report {

/// Places of passes, from 0, both included.
struct PassSpan {
    std::size_t first = 0, last = 0;
};

enum class Language { English, Japanese };

struct ReportOptions {
    std::string file;                ///< the recording's name, as the page shows it
    std::string command;             ///< that makes the report
    std::optional<PassSpan> passes;  ///< all, at most the first `most_passes`
    /// as many from the first as make no more than `history_fragments`
    std::optional<PassSpan> history;
    bool with_history = true;
    /// the recording's colours are identifiers, even if no state says so
    bool identifiers = false;
    std::uint64_t most_bytes = 500'000'000;
    PriceList prices;
    Language language = Language::English;  ///< which the page begins with
    std::function<void(const std::string&)> progress = [](const std::string&) {};
};

/// On one page.
inline constexpr std::size_t most_passes = 1000;
/// The number of fragments whose histories are kept by default: about 45 bytes each.
inline constexpr std::uint64_t history_fragments = 3'000'000;

/// The parts that were written.
struct ReportSummary {
    std::size_t passes = 0, passes_of_recording = 0;
    std::optional<PassSpan> history;
    std::uint64_t bytes = 0;
    bool page = false;  ///< index.html; a build without Node has none
};

/// The names that a report's folder holds.
std::vector<std::string> report_files();

/// Writes into an empty folder. Throws Error if the recording has no pass, `passes` are not of the
/// recording or more than `most_passes`, or `history` is not of the passes shown. Also if the files
/// would exceed `most_bytes`.
ReportSummary write_report(const inspect::Recording& recording, const std::filesystem::path& folder,
                           const ReportOptions& options);

}  // namespace gw::report
