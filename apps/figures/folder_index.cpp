#include "apps/figures/folder_index.h"

#include "apps/command/shell_command.h"
#include "apps/figures/index_page.h"
#include "gw/error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

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

/// Without the files of `other`.
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

std::string label_of(const fs::path& file) {
    std::string label = file.stem().string();
    std::ranges::replace(label, '_', ' ');
    return label;
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
                        "is of another kind; expected the index of a folder that gw wrote");
        for (const Json& entry : json.at("entries")) index.push_back(entry_from(entry));
    } catch (const Json::exception& error) {
        throw Error(file.string(), 0,
                    std::string("is not an index that gw wrote (") + error.what() +
                        "); expected none or one");
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
            entry.pictures.push_back({name, label_of(file)});
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

}  // namespace gw::apps
