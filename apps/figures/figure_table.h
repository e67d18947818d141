// The papers' figures as data: figures.toml, which is built into the program, and its commands as
// words of the command line. Does not run them.
#pragma once

#include "apps/command/command.h"
#include "apps/command/folder_index.h"
#include "apps/command/option_values.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gw::apps {

/// One command, as typed after "gw", and its pictures on the page. "@" stands for the figure's
/// folder: "-o @a.png" becomes "-o DIR/fig1/a.png". The command render also gets the size and a
/// file of counters.
struct Panel {
    std::string command;
    std::vector<Shown> pictures;
};

struct Figure {
    std::string name;  ///< of its folder, and for --only
    std::string row;   ///< of docs/papers.md
    std::string title;
    std::string text;  ///< tells the reader where to look; HTML's <, > and & are not special
    std::vector<Panel> panels;
    std::string page;  ///< a page that a command makes, in the figure's folder; "": none
    std::optional<Size> size = Size{};  ///< none: the commands name their own
};

/// All figures, in the order of the page.
const std::vector<Figure>& figures();

/// The text of the file "figures.toml" when the program was built.
std::string_view embedded_figures(std::string_view name);

/// The panel's words after "gw", with the folder in place of "@".
std::vector<std::string> words_of(const Panel& panel, const std::filesystem::path& folder);

/// The value of an option among words; null if the option is absent.
const std::string* option_in(const std::vector<std::string>& words, const std::string& name);
/// Gives the option this value; adds the option if it is absent.
void set_option(std::vector<std::string>& words, const std::string& name, const std::string& value);

/// Adds --only NAME, which may be repeated.
void add_only_option(CLI::App& command, std::vector<std::string>& only);
/// The figures of these names, in the table's order; all figures if there are no names.
std::vector<const Figure*> wanted_figures(const std::vector<std::string>& only);

}  // namespace gw::apps
