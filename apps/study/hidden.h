// gw study hidden: growth and cost of the hidden-surface algorithms. Does not parse options.
#pragma once

#include "apps/command/command.h"

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
    std::string command;  ///< the command line, for the plots
};

/// Writes growth.csv, laws.csv, costs.csv, a plot for every counter and axis, and index.html. Prints
/// exponents and rankings.
int study_hidden(const HiddenStudyOptions& options, const Session& session);

}  // namespace gw::apps
