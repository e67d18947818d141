#include "apps/command/folder_index.h"

#include "apps/command/page_style.h"
#include "gw/error.h"
#include "image/plot/markup.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace gw::apps {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;
constexpr const char* format_name = "gw index";

Json json_of(const IndexEntry& entry) {
    Json pictures = Json::array(), commands = Json::array();
    for (const Shown& shown : entry.pictures)
        pictures.push_back({{"file", shown.file}, {"label", shown.label}});
    for (const IndexedCommand& c : entry.commands)
        commands.push_back(
            {{"command", c.command}, {"counts", c.counts}, {"counters", c.counters}});
    return {{"name", entry.name}, {"title", entry.title}, {"row", entry.row},
            {"text", entry.text}, {"pictures", pictures}, {"files", entry.files},
            {"page", entry.page}, {"commands", commands}};
}

IndexEntry entry_from(const Json& json) {
    IndexEntry entry{.name = json.at("name"),
                     .title = json.at("title"),
                     .row = json.at("row"),
                     .text = json.at("text"),
                     .pictures = {},
                     .files = json.at("files"),
                     .page = json.at("page"),
                     .commands = {}};
    for (const Json& shown : json.at("pictures"))
        entry.pictures.push_back({shown.at("file"), shown.at("label")});
    for (const Json& c : json.at("commands"))
        entry.commands.push_back({c.at("command"), c.at("counts"), c.at("counters")});
    return entry;
}

std::vector<std::string> commands_of(const IndexEntry& entry) {
    std::vector<std::string> commands;
    for (const IndexedCommand& c : entry.commands) commands.push_back(c.command);
    return commands;
}

bool has(const IndexEntry& entry, const std::string& file) {
    return std::ranges::find(entry.files, file) != entry.files.end() ||
           std::ranges::find(entry.pictures, file, &Shown::file) != entry.pictures.end();
}

/// Removes the files of `other` from the entry.
void take_away(IndexEntry& entry, const IndexEntry& other) {
    std::erase_if(entry.pictures, [&](const Shown& shown) { return has(other, shown.file); });
    std::erase_if(entry.files, [&](const std::string& file) { return has(other, file); });
    if (entry.page == other.page) entry.page.clear();
}

bool can_be_looked_at(const fs::path& file) {
    static const std::vector<std::string> extensions{".png",  ".svg",  ".gif", ".jpg",
                                                     ".jpeg", ".webp", ".bmp"};
    return std::ranges::find(extensions, file.extension().string()) != extensions.end();
}

/// "newell/picture.png" is "newell picture".
std::string label_of(fs::path file) {
    std::string label = file.replace_extension().generic_string();
    for (const char c : {'_', '/'}) std::ranges::replace(label, c, ' ');
    return label;
}

using plot::escaped;

constexpr const char* mark = "<meta name=\"generator\" content=\"gw index\">";

constexpr const char* style = R"(<style>
nav a { margin-right: 1em; display: inline-block }
.panels { display: flex; flex-wrap: wrap; gap: 1em; align-items: flex-start }
figure { margin: 0; flex: 0 1 24em; min-width: 0; max-width: 100% }
figure.plot { flex-basis: 45em; overflow-x: auto }
figure.plot img { width: 45em; max-width: none }
img { width: 100% }
code { display: block; font-size: 80%; margin: .4em 0 }
.counts, .files { font-size: 80%; color: var(--faint) }
.files a { margin-right: .8em }
@media print { section { break-inside: avoid } }
</style>
<script id="whole-pixels">
// A small picture is enlarged by a whole factor, each pixel a square; a large one is reduced smoothly.
addEventListener('load', ({ target: i }) => {
    if (!(i instanceof HTMLImageElement) || i.closest('.plot')) return
    const times = Math.floor(i.clientWidth / i.naturalWidth)
    if (times >= 1) Object.assign(i.style, { width: times * i.naturalWidth + 'px', imageRendering: 'pixelated' })
}, true)
</script>
)";

/// The file's name as part of an address: unusual characters become %XX, byte by byte.
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

/// A plot is as wide as its letters need.
std::string picture(const Shown& shown) {
    return fmt::format(
        "<figure{2}><a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\" "
        "loading=\"lazy\"></a><figcaption>{1}</figcaption></figure>\n",
        address_of(shown.file), escaped(shown.label),
        shown.file.ends_with(".svg") ? " class=\"plot\"" : "");
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

void make_folder(const std::filesystem::path& folder) {
    image::OutputSet output;
    output.make_folder(folder);
    output.commit();
}

FolderIndex read_index(const fs::path& folder) {
    const fs::path file = folder / index_file;
    FolderIndex index;
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return index;
    try {
        const Json json = Json::parse(std::ifstream(file, std::ios::binary));
        if (json.at("format") != format_name || json.at("version") != 1)
            throw Error(file.string(), 0,
                        "has another format; expected the index of a folder that gw wrote");
        for (const Json& entry : json.at("entries")) index.push_back(entry_from(entry));
    } catch (const Json::exception&) {
        throw Error(file.string(), 0, "is not an index that gw wrote; expected none or one");
    }
    return index;
}

std::string to_json(const FolderIndex& index) {
    Json entries = Json::array();
    for (const IndexEntry& entry : index) entries.push_back(json_of(entry));
    return Json{{"format", format_name}, {"version", 1}, {"entries", entries}}.dump(
               1, ' ', false, Json::error_handler_t::replace) +
           "\n";
}

void add_entry(FolderIndex& index, IndexEntry entry) {
    for (IndexEntry& old : index) take_away(old, entry);
    const auto same = std::ranges::find(index, commands_of(entry), commands_of);
    if (same != index.end()) {
        entry.pictures.insert(entry.pictures.begin(), same->pictures.begin(), same->pictures.end());
        entry.files.insert(entry.files.begin(), same->files.begin(), same->files.end());
        *same = std::move(entry);
    } else {
        index.push_back(std::move(entry));
    }
    std::erase_if(index, [](const IndexEntry& e) {
        return e.pictures.empty() && e.files.empty() && e.page.empty();
    });
}

IndexEntry entry_of(const std::vector<fs::path>& files, const fs::path& folder) {
    IndexEntry entry;
    for (const fs::path& file : files) {
        const fs::path relative =
            file.lexically_normal().lexically_relative(folder.lexically_normal());
        const std::string name = relative.generic_string();
        if (relative.empty() || name.starts_with("..")) continue;
        if (name == "index.html")
            entry.page = name;
        else if (can_be_looked_at(file))
            entry.pictures.push_back({name, label_of(relative)});
        else
            entry.files.push_back(name);
    }
    return entry;
}

void caption(IndexEntry& entry, const std::vector<std::string>& words) {
    entry.title = "gw";
    for (std::size_t i = 0;
         i < std::min<std::size_t>(words.size(), 2) && !words[i].starts_with("-"); ++i)
        entry.title += " " + words[i];
    entry.commands = {{shell_command(words), "", ""}};
}

void put_index(image::OutputSet& output, const fs::path& folder, const Session& session) {
    if (session.is_inner) return;
    IndexEntry entry = entry_of(output.targets(), folder);
    caption(entry, session.words);
    const fs::path page = folder / "index.html";
    const bool page_is_ours = entry.page.empty() && (!fs::exists(page) || is_index_page(page));
    FolderIndex index;
    try {
        index = read_index(folder);
    } catch (const Error&) {
        return;
    }
    add_entry(index, std::move(entry));
    output.add(folder / index_file).write_text(to_json(index));
    if (page_is_ours) output.add(page).write_text(index_page(index, page_of_folder(folder)));
}

PageWords page_of_folder(const std::filesystem::path& folder) {
    return {folder.lexically_normal().string(),
            "The commands that made the pictures stand below them."};
}

std::string index_page(const FolderIndex& index, const PageWords& words) {
    std::string links, sections;
    for (std::size_t i = 0; i < index.size(); ++i) {
        const std::string name =
            index[i].name.empty() ? fmt::format("entry-{}", i + 1) : index[i].name;
        links += fmt::format("<a href=\"#{}\">{}</a>\n", escaped(name), escaped(index[i].title));
        sections += section(index[i], name);
    }
    return page_begin("GW: " + words.title, mark) + style +
           fmt::format("<p>{}</p>\n<nav aria-label=\"Pictures\">{}</nav>\n{}", escaped(words.text),
                       links, sections) +
           std::string(page_end);
}

bool is_index_page(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string begin(300, '\0');
    stream.read(begin.data(), std::ptrdiff_t(begin.size()));
    return begin.find(mark) != begin.npos;
}

}  // namespace gw::apps
