// gw figures: draws the papers' figures into a folder, with a page that shows them.
#include "apps/command/command.h"
#include "apps/command/folder_index.h"
#include "apps/command/terminal.h"
#include "apps/figures/figure_table.h"
#include "gw/error.h"
#include "gw/escape_controls.h"
#include "image/output/output_set.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace gw::apps {

namespace fs = std::filesystem;

namespace {

/// A panel as it ran.
struct RanPanel {
    const Panel* panel = nullptr;
    std::string command;   ///< to be pasted in a shell
    std::string counters;  ///< file in the figure's folder, "" for none
};

/// 1234567 as "1,234,567".
std::string grouped(std::uint64_t number) {
    std::string digits = std::to_string(number);
    for (int at = int(digits.size()) - 3; at > 0; at -= 3) digits.insert(std::size_t(at), ",");
    return digits;
}

std::string counts_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw Error(file.string() + ": cannot be read");
    const auto json = nlohmann::json::parse(stream);
    const auto passes = json["passes"].get<std::uint64_t>();
    const auto sum = [&](const char* name) {
        return grouped(json["sum"][name].get<std::uint64_t>());
    };
    return fmt::format(
        "{} {}; {} triangles and lines drawn, {} fragments, {} written, {} texels, {} bytes",
        grouped(passes), passes == 1 ? "pass" : "passes", sum("drawn"), sum("fragments"),
        sum("written"), sum("texels"), sum("bytes"));
}

/// Files are named from the folder of all figures. Reads the files of counters. Throws Error.
IndexEntry figure_entry(const Figure& figure, const std::filesystem::path& folder,
                        const std::vector<RanPanel>& panels) {
    IndexEntry entry{.name = figure.name,
                     .title = figure.title,
                     .row = figure.row,
                     .text = figure.text,
                     .pictures = {},
                     .files = {},
                     .page = figure.page.empty() ? "" : figure.name + "/" + figure.page,
                     .commands = {}};
    for (const RanPanel& ran : panels) {
        for (const Shown& shown : ran.panel->pictures)
            entry.pictures.push_back({figure.name + "/" + shown.file, shown.label});
        IndexedCommand command{ran.command, {}, {}};
        if (!ran.counters.empty()) {
            command.counters = figure.name + "/" + ran.counters;
            command.counts = counts_of(folder / command.counters);
        }
        entry.commands.push_back(std::move(command));
    }
    return entry;
}

/// Figures in the order of their table, then all other entries.
void sort_by_table(FolderIndex& index) {
    const auto place = [](const IndexEntry& entry) {
        return std::ranges::find(figures(), entry.name, &Figure::name) - figures().begin();
    };
    std::ranges::stable_sort(index, {}, place);
}

struct FiguresOptions {
    fs::path folder;
    std::vector<std::string> only;
    std::optional<Size> size;
    bool list = false, quiet = false;
};

void print_list() {
    for (const Figure& figure : figures())
        print(fmt::format("{:<14} {:<10} {}\n", figure.name, figure.row, figure.title));
}

RanPanel run_panel(const Panel& panel, const FiguresOptions& options, const Figure& figure,
                   std::size_t index) {
    const fs::path folder = options.folder / figure.name;
    std::vector<std::string> words = words_of(panel, folder);
    const Size size = options.size.value_or(figure.size.value_or(Size{}));
    if (figure.size) set_option(words, "--size", fmt::format("{}x{}", size.width, size.height));
    RanPanel ran{&panel, shell_command(words), {}};
    if (words[0] == "render") {
        ran.counters = fmt::format("counters_{}.json", index + 1);
        words.insert(words.end(), {"--counters", (folder / ran.counters).string()});
    }
    words.push_back("--quiet");
    const SilenceStdout muted;
    run_command({.words = std::move(words), .is_inner = true});
    return ran;
}

void add_to_index(const fs::path& folder, IndexEntry entry) {
    FolderIndex index = read_index(folder);
    add_entry(index, std::move(entry));
    sort_by_table(index);
    image::OutputSet output;
    output.add(folder / index_file).write_text(to_json(index));
    output.add(folder / "index.html")
        .write_text(index_page(
            index, {"The figures",
                    "GW is a graphics workstation in software. It draws by the algorithms of "
                    "three papers: multi-pass rendering (Kawabata, Watanabe, Sakai), radiosity in "
                    "pixmaps (Egashira, Satoh, Honda, Mima) and a lecture on hidden surfaces. "
                    "docs/papers.md says where each of them is, by the rows in brackets; README.md "
                    "begins with the project. Each command works from the root of the "
                    "repository."}));
    output.commit();
}

void make_figure(const Figure& figure, const FiguresOptions& options, Progress& progress,
                 const std::string& which) {
    const fs::path folder = options.folder / figure.name;
    make_folder(folder);
    std::vector<RanPanel> panels;
    for (const Panel& panel : figure.panels) {
        progress.at(fmt::format("{}, {}, {} of {}", which, figure.name, panels.size() + 1,
                                figure.panels.size()));
        panels.push_back(run_panel(panel, options, figure, panels.size()));
    }
    add_to_index(options.folder, figure_entry(figure, options.folder, panels));
}

int make_figures(const FiguresOptions& options) {
    if (options.list) {
        print_list();
        return Done;
    }
    if (options.folder.empty()) throw UsageError("DIR is missing; expected the name of a folder");
    if (!fs::exists("scenes"))
        throw Error("scenes: does not exist; expected to be run from the repository's root");
    make_folder(options.folder);
    image::check_target(options.folder / "index.html");
    read_index(options.folder);
    Progress progress("figures", options.quiet);
    const auto all = wanted_figures(options.only);
    for (std::size_t i = 0; i < all.size(); ++i)
        make_figure(*all[i], options, progress, fmt::format("figure {} of {}", i + 1, all.size()));
    print(escape_controls((options.folder / "index.html").string()) + "\n");
    return Done;
}

}  // namespace

Command add_figures(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("figures", "The figures of the papers, with a page that shows them");
    const auto options = std::make_shared<FiguresOptions>();
    command->add_option("DIR", options->folder, "The folder of the figures; created if missing")
        ->type_name("DIR");
    add_only_option(*command, options->only);
    command
        ->add_option_function<std::string>(
            "--size",
            [options](const std::string& word) { options->size = size_from("--size", word); },
            "Pixels of each picture (default: the figure's own)")
        ->type_name("WxH");
    command->add_flag("--list", options->list, "Only print names, rows and titles");
    command->add_flag("--quiet", options->quiet, "No progress");
    command->footer("Example:\n  build/release/bin/gw figures figures --only fig1");
    return {command, [options](Session&) { return make_figures(*options); }};
}

}  // namespace gw::apps
