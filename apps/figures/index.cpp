// gw index: one page for all pictures and plots below a folder, with the commands that made them.
#include "apps/command/command.h"
#include "apps/command/terminal.h"
#include "apps/figures/folder_index.h"
#include "apps/figures/index_page.h"
#include "gw/error.h"
#include "image/output/origin.h"
#include "study/plot/plot.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

namespace gw::apps {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_files = 100'000;

/// Files below a folder by their names from there, in order. Hidden ones are left out.
std::vector<fs::path> files_below(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (auto at = fs::recursive_directory_iterator(folder, error); !error && at != fs::end(at);
         at.increment(error)) {
        if (at->path().filename().string().starts_with(".")) {
            if (at->is_directory()) at.disable_recursion_pending();
        } else if (at->is_regular_file()) {
            files.push_back(at->path().lexically_relative(folder));
        }
        if (files.size() > most_files)
            throw Error(
                folder.string(), 0,
                fmt::format("has more than {} files; expected a folder of pictures", most_files));
    }
    if (error) throw Error(folder.string(), 0, "cannot be read: " + error.message());
    std::ranges::sort(files);
    return files;
}

/// The command on the page of a report, which gw inspect wrote into `data`; "" where it is none.
std::string command_of_report(const fs::path& data) {
    std::ifstream stream(data, std::ios::binary);
    constexpr std::string_view begin = "gw_report(";
    std::string text(begin.size(), '\0');
    stream.read(text.data(), std::ptrdiff_t(text.size()));
    if (text != begin) return "";
    std::string rest(std::istreambuf_iterator<char>(stream), {});
    rest.resize(std::min(rest.size(), rest.rfind(')')));
    const auto json = nlohmann::json::parse(rest, nullptr, false);
    return json.is_object() ? json.value("command", "") : "";
}

/// Another folder's entries as those of this one.
FolderIndex moved(FolderIndex index, const fs::path& below) {
    const auto move = [&](std::string& name) {
        if (!name.empty()) name = (below / name).lexically_normal().generic_string();
    };
    for (IndexEntry& entry : index) {
        if (!below.empty() && !entry.name.empty())
            entry.name = below.generic_string() + "/" + entry.name;
        for (Shown& shown : entry.pictures) move(shown.file);
        for (std::string& file : entry.files) move(file);
        for (IndexedCommand& command : entry.commands) move(command.counters);
        move(entry.page);
    }
    return index;
}

bool is_inside(const fs::path& file, const std::vector<fs::path>& folders) {
    return std::ranges::any_of(folders, [&](const fs::path& folder) {
        const fs::path from = file.lexically_relative(folder);
        return !from.empty() && *from.begin() != "..";
    });
}

bool is_known(const FolderIndex& index, const std::string& file) {
    return std::ranges::any_of(index, [&](const IndexEntry& entry) {
        return std::ranges::find(entry.files, file) != entry.files.end() ||
               std::ranges::find(entry.pictures, file, &Shown::file) != entry.pictures.end();
    });
}

/// The command that a picture or plot says it was made by; "" where it does not.
std::string command_of(const fs::path& file) {
    std::string command;
    if (file.extension() == ".svg") {
        std::string beginning(1 << 16, '\0');
        std::ifstream stream(file, std::ios::binary);
        stream.read(beginning.data(), std::ptrdiff_t(beginning.size()));
        command = plot::command_of(beginning.substr(0, std::size_t(stream.gcount())));
    }
    return command.empty() ? image::origin_of(file) : command;
}

/// Pictures and plots that no folder's index has, by the commands that they name, and last those
/// that name none. Not those of reports, which show them themselves.
void add_single(FolderIndex& index, const fs::path& folder, const std::vector<fs::path>& files,
                const std::vector<fs::path>& reports) {
    std::vector<fs::path> single;
    for (const fs::path& file : files)
        if (!is_inside(file, reports) && !is_known(index, file.generic_string()))
            single.push_back(file);
    IndexEntry others{.title = "Others", .text = "Which command made these was not noted."};
    const std::size_t before = index.size();
    for (Shown& shown : entry_of(single, "").pictures) {
        IndexEntry entry;
        const std::string command = command_of(folder / shown.file);
        if (!command.empty()) caption(entry, command);
        const auto same =
            std::find_if(index.begin() + std::ptrdiff_t(before), index.end(),
                         [&](const IndexEntry& other) { return other.commands == entry.commands; });
        IndexEntry& into = command.empty()       ? others
                           : same == index.end() ? index.emplace_back(entry)
                                                 : *same;
        into.pictures.push_back(std::move(shown));
    }
    if (!others.pictures.empty()) index.push_back(std::move(others));
}

FolderIndex index_of(const fs::path& folder) {
    const std::vector<fs::path> files = files_below(folder);
    FolderIndex index;
    std::vector<fs::path> reports;
    for (const fs::path& file : files) {
        const fs::path below = file.parent_path();
        if (file.filename() == index_file)
            for (IndexEntry& entry : moved(read_index(folder / below), below))
                index.push_back(std::move(entry));
        if (file.filename() != "data.js") continue;
        const std::string command = command_of_report(folder / file);
        if (command.empty()) continue;
        reports.push_back(below);
        index.push_back({.title = "gw inspect: a recording as a page",
                         .page = (below / "index.html").generic_string(),
                         .commands = {{command, "", ""}}});
    }
    add_single(index, folder, files, reports);
    return index;
}

int make_index(const fs::path& folder) {
    if (folder.empty()) throw UsageError("DIR is empty; expected the name of a folder");
    if (!fs::is_directory(folder))
        throw Error(folder.string(), 0, "is not a folder; expected one with pictures");
    const fs::path page = folder / "index.html";
    image::check_target(page);
    if (fs::exists(page) && !is_index_page(page))
        throw Error(page.string(), 0,
                    "is not a page of gw index; expected none, or one to replace");
    const FolderIndex index = index_of(folder);
    if (index.empty()) throw Error(folder.string(), 0, "has no pictures or plots; expected some");
    image::write_file(page, index_page(index, page_of_folder(folder)));
    print(page.string() + "\n");
    return done;
}

}  // namespace

Command add_index(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "index",
        "One page for all pictures and plots below a folder, with the commands that made them");
    const auto folder = std::make_shared<fs::path>();
    command->add_option("DIR", *folder, "The folder; its index.html is written")
        ->required()
        ->type_name("DIR");
    command->footer(
        "Example:\n  build/release/bin/gw figures figures --only fig1 --size 64x48 && build/release/bin/gw "
        "index "
        "figures");
    return {command, [folder] { return make_index(*folder); }};
}

}  // namespace gw::apps
