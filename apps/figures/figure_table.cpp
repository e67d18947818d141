#include "apps/figures/figure_table.h"

#include "scene/toml/toml_binder.h"
#include "scene/toml/toml_value.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <sstream>

namespace gw::apps {
namespace {

using scene::key;
using scene::TomlValue;

Panel panel_from(const TomlValue& table) {
    Panel panel;
    const auto add_pictures = [&](const TomlValue& pictures) {
        for (const TomlValue& label : pictures.elements)
            panel.pictures.push_back({label.key, label.text});
    };
    scene::read_table(table, {key("command", panel.command), {"pictures", add_pictures}});
    return panel;
}

Figure figure_from(const TomlValue& table) {
    Figure figure;
    std::string size;
    const auto add_panels = [&](const TomlValue& panels) {
        for (const TomlValue& panel : panels.elements) figure.panels.push_back(panel_from(panel));
    };
    scene::read_table(table, {key("name", figure.name),
                              key("row", figure.row),
                              key("title", figure.title),
                              key("text", figure.text),
                              key("page", figure.page),
                              key("size", size),
                              {"panel", add_panels}});
    if (size == "own")
        figure.size.reset();
    else if (!size.empty())
        figure.size = size_from("size", size);
    return figure;
}

std::vector<Figure> read_figures() {
    constexpr const char* name = "figures.toml";
    const TomlValue file = scene::read_toml_text(std::string(embedded_figures(name)), name);
    std::vector<Figure> all;
    const auto add_figures = [&](const TomlValue& figures) {
        for (const TomlValue& figure : figures.elements) all.push_back(figure_from(figure));
    };
    scene::read_table(file, {{"figure", add_figures}});
    return all;
}

}  // namespace

const std::vector<Figure>& figures() {
    static const std::vector<Figure> all = read_figures();
    return all;
}

std::vector<std::string> words_of(const Panel& panel, const std::filesystem::path& folder) {
    std::vector<std::string> words;
    std::istringstream stream(panel.command);
    for (std::string word; stream >> word;)
        words.push_back(word[0] == '@' ? (folder / word.substr(1)).string() : word);
    return words;
}

const std::string* option_in(const std::vector<std::string>& words, const std::string& name) {
    const auto found = std::find(words.begin(), words.end(), name);
    return found == words.end() || found + 1 == words.end() ? nullptr : &found[1];
}

void set_option(std::vector<std::string>& words, const std::string& name,
                const std::string& value) {
    const auto found = std::find(words.begin(), words.end(), name);
    if (found == words.end())
        words.insert(words.end(), {name, value});
    else
        found[1] = value;
}

void add_only_option(CLI::App& command, std::vector<std::string>& only) {
    command
        .add_option_function<std::vector<std::string>>(
            "--only",
            [&only](const std::vector<std::string>& names) {
                std::vector<std::string> known;
                for (const Figure& figure : figures()) known.push_back(figure.name);
                for (const std::string& name : names) only.push_back(one_of("--only", name, known));
            },
            "This figure only; may be repeated")
        ->type_name("NAME")
        ->take_all()
        ->expected(1)
        ->allow_extra_args(false);
}

std::vector<const Figure*> wanted_figures(const std::vector<std::string>& only) {
    std::vector<const Figure*> found;
    for (const Figure& figure : figures())
        if (only.empty() || std::count(only.begin(), only.end(), figure.name) > 0)
            found.push_back(&figure);
    return found;
}

}  // namespace gw::apps
