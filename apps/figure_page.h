// A folder of figures as one page: plain HTML that needs no network. Every figure leaves its part of the page
// in its own folder, so that figures made one at a time make the same page. Does not draw.
#pragma once

#include "apps/figure_table.h"

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

/// The figure's part of the page. Reads the files of counters. Throws Error.
std::string figure_part(const Figure& figure, const std::filesystem::path& folder,
                        const std::vector<RanPanel>& panels);

/// The page of all figures whose part lies in the folder, in the table's order.
std::string figures_page(const std::filesystem::path& folder);

}  // namespace gw::apps
