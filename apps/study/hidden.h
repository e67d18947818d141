// gw study hidden: how the hidden-surface algorithms grow, and what they cost. Does not parse
// options.
#pragma once

#include "apps/command/session.h"

#include <filesystem>
#include <string>

namespace gw::apps {

struct HiddenStudyOptions {
    std::filesystem::path output;
    /// a folder: recipes.toml, and price lists
    std::filesystem::path prices = "scenes/hidden/prices";
    double limit = 0.5;  ///< seconds of one run
    std::string axis;    ///< empty: all
    int threads = 1;
    bool quiet = false;
    std::string command;  ///< as it was called, for the plots
};

/// growth.csv, laws.csv, costs.csv, a plot for every counter and axis, index.html; prints exponents
/// and rankings.
int study_hidden(const HiddenStudyOptions& options, const Session& session);

}  // namespace gw::apps
