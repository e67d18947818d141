#include "apps/figures/figure_table.h"

#include "scene/toml/toml_binder.h"
#include "scene/toml/toml_value.h"

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

}  // namespace gw::apps
