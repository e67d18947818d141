// A figure as an entry of its folder's index: pictures, commands, what these counted. Does not
// draw.
#pragma once

#include "apps/figures/figure_table.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gw::apps {

/// A panel as it ran.
struct RanPanel {
    const Panel* panel = nullptr;
    std::string command;   ///< to be pasted in a shell
    std::string counters;  ///< file in the figure's folder, "" for none
};

/// Files are named from the folder of all figures. Reads the files of counters. Throws Error.
IndexEntry figure_entry(const Figure& figure, const std::filesystem::path& folder,
                        const std::vector<RanPanel>& panels);

/// Figures in the order of their table, then all other entries.
void sort_by_table(FolderIndex& index);

}  // namespace gw::apps
