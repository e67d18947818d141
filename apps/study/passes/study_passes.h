// gw study passes: one scene by passes, item buffer and rays, over sweeps [K4f]. Parses the words of
// its own options. Does not measure.
#pragma once

#include "apps/command/command.h"
#include "apps/picture/picture_options.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gw::apps {

struct PassStudyOptions {
    PictureOptions picture;
    std::filesystem::path output;
    std::filesystem::path prices;     ///< a folder of lists; empty: those built in
    std::vector<std::string> sweeps;  ///< "lights", "lights=1,4"; empty: all
    int runs = 3;
    double limit = 60;  ///< seconds of a row
};

/// Adds --sweep, --runs, --size, --depth and --profile.
void add_pass_study_options(CLI::App& command, PassStudyOptions& options);

/// Writes counts.csv, estimates.csv, times.csv, errors.csv, results.json, a page and plots after every
/// row. Prints tables.
int study_passes(const PassStudyOptions& options, Session& session);

}  // namespace gw::apps
