#include "apps/figure_page.h"

#include "gw/error.h"
#include "plot/markup.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>

namespace gw::apps {

namespace {

constexpr const char* part_file = "figure.html";

constexpr const char* head = R"(<!DOCTYPE html>
<html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>GW: the figures</title>
<style>
body { font-family: sans-serif; max-width: 84em; margin: 1em auto; padding: 0 1em; color: #222 }
nav a { margin-right: 1em; white-space: nowrap }
section { margin-top: 2.5em; border-top: 1px solid #ccc }
h2 small { font-weight: normal; color: #666 }
.panels { display: flex; flex-wrap: wrap; gap: 1em; align-items: flex-start }
figure { margin: 0; flex: 1 1 18em; max-width: 40em }
img { width: 100%; image-rendering: pixelated; background: #fff }
code { display: block; font-size: 80%; color: #444; overflow-wrap: anywhere; margin: .4em 0 }
.counts { font-size: 80%; color: #666 }
@media print { section { break-inside: avoid } }
</style>
<h1>The figures</h1>
<p>Each command works from the root of the repository. Rows in brackets are those of docs/papers.md.</p>
)";

std::string read_text(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    if (!(text << stream.rdbuf())) throw Error(file.string() + ": cannot be read");
    return text.str();
}

/// 1234567 as "1,234,567".
std::string grouped(std::uint64_t number) {
    std::string digits = std::to_string(number);
    for (int at = int(digits.size()) - 3; at > 0; at -= 3) digits.insert(std::size_t(at), ",");
    return digits;
}

std::string counts_of(const Figure& figure, const std::filesystem::path& folder, const std::string& file) {
    const auto json = nlohmann::json::parse(read_text(folder / file));
    const auto passes = json["passes"].get<std::uint64_t>();
    const auto sum = [&](const char* name) { return grouped(json["sum"][name].get<std::uint64_t>()); };
    return fmt::format(
        "<span class=\"counts\">{} {}; {} triangles and lines drawn, {} fragments, {} written, {} "
        "texels, {} bytes "
        "(<a href=\"{}/{}\">pass by pass</a>)</span>\n",
        grouped(passes), passes == 1 ? "pass" : "passes", sum("drawn"), sum("fragments"), sum("written"),
        sum("texels"), sum("bytes"), figure.name, file);
}

std::string picture(const Figure& figure, const Shown& shown) {
    return fmt::format(
        "<figure><a href=\"{0}/{1}\"><img src=\"{0}/{1}\" "
        "alt=\"{2}\"></a><figcaption>{2}</figcaption></figure>\n",
        figure.name, shown.file, plot::escaped(shown.label));
}

}  // namespace

std::string figure_part(const Figure& figure, const std::filesystem::path& folder,
                        const std::vector<RanPanel>& panels) {
    std::string text = fmt::format(
        "<section id=\"{0}\"><h2>{1} <small>[{2}]</small></h2>\n<p>{3}</p>\n<div class=\"panels\">\n",
        figure.name, plot::escaped(figure.title), plot::escaped(figure.row), plot::escaped(figure.text));
    for (const RanPanel& ran : panels)
        for (const Shown& shown : ran.panel->pictures) text += picture(figure, shown);
    text += "</div>\n";
    for (const RanPanel& ran : panels) {
        text += "<code>" + plot::escaped(ran.command) + "</code>\n";
        if (!ran.counters.empty()) text += counts_of(figure, folder, ran.counters);
    }
    return text + "</section>\n";
}

std::string figures_page(const std::filesystem::path& folder) {
    std::string links, parts;
    for (const Figure& figure : figures()) {
        const auto file = folder / figure.name / part_file;
        if (!std::filesystem::exists(file)) continue;
        links += fmt::format("<a href=\"#{}\">{}</a>\n", figure.name, plot::escaped(figure.title));
        parts += read_text(file);
    }
    return std::string(head) + "<nav>" + links + "</nav>\n" + parts + "</html>\n";
}

}  // namespace gw::apps
