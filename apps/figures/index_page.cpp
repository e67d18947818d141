#include "apps/figures/index_page.h"

#include "study/plot/markup.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

namespace gw::apps {
namespace {

using plot::escaped;

constexpr const char* mark = "<meta name=\"generator\" content=\"gw index\">";

constexpr const char* style = R"(<style>
:root { color-scheme: light dark }
body { font-family: system-ui, sans-serif; max-width: 84em; margin: 1em auto; padding: 0 1em; line-height: 1.4 }
nav a { margin-right: 1em; white-space: nowrap }
section { margin-top: 2.5em; border-top: 1px solid #8888 }
h2 small { font-weight: normal; opacity: .75 }
.panels { display: flex; flex-wrap: wrap; gap: 1em; align-items: flex-start }
figure { margin: 0; flex: 0 1 24em }
img { width: 100%; image-rendering: pixelated; background: #fff }
code { display: block; font-size: 80%; overflow-wrap: anywhere; margin: .4em 0 }
.counts, .files { font-size: 80%; opacity: .85 }
.files a { margin-right: .8em }
@media print { section { break-inside: avoid } }
</style>
)";

/// As part of an address: what is not a name's usual character, byte by byte.
std::string address_of(const std::string& file) {
    std::string text;
    for (const char c : file) {
        const bool usual = std::isalnum(static_cast<unsigned char>(c)) ||
                           std::string_view("-_./~").find(c) != std::string_view::npos;
        text += usual ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return text;
}

std::string link(const std::string& file, const std::string& words) {
    return fmt::format("<a href=\"{}\">{}</a>", address_of(file), escaped(words));
}

std::string picture(const Shown& shown) {
    return fmt::format(
        "<figure><a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\" "
        "loading=\"lazy\"></a><figcaption>{1}</figcaption></figure>\n",
        address_of(shown.file), escaped(shown.label));
}

std::string command(const IndexedCommand& made) {
    std::string text = "<code>" + escaped(made.command) + "</code>\n";
    if (made.counts.empty()) return text;
    text += "<span class=\"counts\">" + escaped(made.counts);
    if (!made.counters.empty()) text += " (" + link(made.counters, "pass by pass") + ")";
    return text + "</span>\n";
}

std::string section(const IndexEntry& entry, const std::string& name) {
    std::string text =
        fmt::format("<section id=\"{}\"><h2>{}", escaped(name), escaped(entry.title));
    if (!entry.row.empty()) text += " <small>[" + escaped(entry.row) + "]</small>";
    text += "</h2>\n";
    if (!entry.text.empty()) text += "<p>" + escaped(entry.text) + "</p>\n";
    if (!entry.page.empty()) text += "<p>" + link(entry.page, entry.page) + "</p>\n";
    text += "<div class=\"panels\">\n";
    for (const Shown& shown : entry.pictures) text += picture(shown);
    text += "</div>\n";
    for (const IndexedCommand& made : entry.commands) text += command(made);
    if (!entry.files.empty()) text += "<p class=\"files\">";
    for (const std::string& file : entry.files) text += link(file, file) + "\n";
    if (!entry.files.empty()) text += "</p>\n";
    return text + "</section>\n";
}

}  // namespace

PageWords page_of_folder(const std::filesystem::path& folder) {
    return {folder.lexically_normal().string(),
            "Under the pictures stand the commands that made them."};
}

std::string index_page(const FolderIndex& index, const PageWords& words) {
    std::string links, sections;
    for (std::size_t i = 0; i < index.size(); ++i) {
        const std::string name =
            index[i].name.empty() ? fmt::format("entry-{}", i + 1) : index[i].name;
        links += fmt::format("<a href=\"#{}\">{}</a>\n", escaped(name), escaped(index[i].title));
        sections += section(index[i], name);
    }
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><meta charset=\"utf-8\">{}\n<meta name=\"viewport\" "
        "content=\"width=device-width\">\n<title>GW: {}</title>\n{}<h1>{}</h1>\n<p>{}</p>\n"
        "<nav>{}</nav>\n{}</html>\n",
        mark, escaped(words.title), style, escaped(words.title), escaped(words.text), links,
        sections);
}

bool is_index_page(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string begin(300, '\0');
    stream.read(begin.data(), std::ptrdiff_t(begin.size()));
    return begin.find(mark) != begin.npos;
}

}  // namespace gw::apps
