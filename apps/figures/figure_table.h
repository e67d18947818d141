// The figures of the papers that this program makes: those of figures.toml, which is built in. Does
// not draw: figures.cpp runs the commands.
#pragma once

#include "apps/command/option_values.h"
#include "apps/figures/folder_index.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gw::apps {

/// One command, as typed after "gw", and the pictures of it that are shown, in the figure's folder.
/// "@" stands for the figure's folder, so that "-o @a.png" becomes "-o DIR/fig1/a.png". For the
/// command render, the size and a file of counters are added.
struct Panel {
    std::string command;
    std::vector<Shown> pictures;
};

struct Figure {
    std::string name;  ///< of its folder, and for --only
    std::string row;   ///< of docs/papers.md
    std::string title;
    std::string text;  ///< what to look at; HTML's <, > and & are not special
    std::vector<Panel> panels;
    std::optional<Size> size = Size{};  ///< none: the commands say theirs themselves
};

/// All of them, in the order of the page.
const std::vector<Figure>& figures();

/// "figures.toml", as it was when the program was built.
std::string_view embedded_figures(std::string_view name);

}  // namespace gw::apps
