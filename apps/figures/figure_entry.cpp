#include "apps/figures/figure_entry.h"

#include "gw/error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

namespace gw::apps {
namespace {

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

}  // namespace

IndexEntry figure_entry(const Figure& figure, const std::filesystem::path& folder,
                        const std::vector<RanPanel>& panels) {
    IndexEntry entry{.name = figure.name,
                     .title = figure.title,
                     .row = figure.row,
                     .text = figure.text,
                     .pictures = {},
                     .files = {},
                     .page = {},
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

void sort_by_table(FolderIndex& index) {
    const auto place = [](const IndexEntry& entry) {
        return std::ranges::find(figures(), entry.name, &Figure::name) - figures().begin();
    };
    std::ranges::stable_sort(index, {}, place);
}

}  // namespace gw::apps
