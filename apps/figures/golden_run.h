// The figures' panels, small and on each profile, run for what enters the machine. Does not
// compare.
#pragma once

#include "apps/figures/figure_table.h"
#include "gw/profile.h"
#include "inspect/recording/recording.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gw::apps {

/// A recording, and the name of its manifest in the folder of goldens: "fig1/3_vgx.json".
struct GoldenRecording {
    std::filesystem::path file;
    inspect::Recording recording;
};

/// Panel `index` from 0, on these profiles. 96 x 72 pixels; radiosity: two shots of small
/// hemicubes. A panel that superposes does it at most twice where the scene does not ask for more.
/// What does not depend on the profile asked for (a study's machines, hemicubes) comes with the
/// first of all profiles.
std::vector<GoldenRecording> run_golden_panel(const Figure& figure, std::size_t index,
                                              const std::vector<Profile>& profiles);

}  // namespace gw::apps
