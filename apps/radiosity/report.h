// How a solution converges: the unshot share against shots and seconds [F1c], as CSV and plots.
#pragma once

#include "image/output/output_set.h"
#include "radiosity/solver/solver.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gw::apps {

/// After a shot. Shares are of what is emitted.
struct Step {
    std::uint64_t shots = 0;
    double seconds = 0, unshot = 0, absorbed = 0, escaped = 0, imbalance = 0;
    int hemicubes = 0;
};

Step step_of(const radiosity::Solver& solver, double seconds, int hemicubes);

/// convergence.csv, convergence.svg and convergence_seconds.svg in a folder.
void put_report(const std::vector<Step>& steps, const std::filesystem::path& folder,
                image::OutputSet& files);

}  // namespace gw::apps
