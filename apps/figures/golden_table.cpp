#include "apps/figures/golden_table.h"

#include "gw/error.h"
#include "gw/names.h"
#include "inspect/recording/content.h"
#include "inspect/replay/plane_values.h"
#include "scene/text/text_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace gw::apps {
namespace {

constexpr const char* table_head =
    "# Digests (XXH3-128) of each pass, for gw golden: docs/recordings.md, \"The golden suite\".\n"
    "# A panel with its profile: digest of profile and window, digest of the commands. Then its\n"
    "# passes: ";

std::string digest_of(const std::string& text) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
    return to_string(inspect::digest_of_bytes({bytes, text.size()}));
}

/// The parts of a manifest that say what was drawn, without its passes.
std::string head_of(const inspect::Manifest& manifest) {
    return to_json(inspect::Manifest{
        .profile = manifest.profile, .width = manifest.width, .height = manifest.height});
}

std::string state_text(const inspect::ManifestPass& pass) {
    std::string text = pass.set + "\n";
    for (const inspect::Field& field : pass.state) text += field.name + " " + field.value + "\n";
    return text;
}

std::string counters_text(const Counters& counters) {
    std::string text;
    for (const auto& [name, count] : counter_names())
        if (counters.*count) text += fmt::format("{} {}\n", name, counters.*count);
    return text;
}

PassDigests digests_of(const inspect::ManifestPass& pass) {
    PassDigests row{pass.report.name,
                    {digest_of(state_text(pass)), digest_of(counters_text(pass.report.counters))}};
    for (const Plane plane : inspect::planes_in_order)
        row.digests.push_back(pass.report.digested & mask_of(plane)
                                  ? to_string(pass.report.digests[std::size_t(plane)])
                                  : "-");
    return row;
}

/// A wrong plane says more than a wrong count.
std::optional<inspect::Finding> pass_difference(const PassDigests& expected,
                                                const PassDigests& actual, std::size_t pass) {
    inspect::Finding finding{.pass = pass, .pass_name = expected.name};
    if (expected.name != actual.name) {
        finding.what = "name";
        finding.expected = expected.name;
        finding.actual = actual.name;
        return finding;
    }
    const std::size_t columns = digest_columns().size();
    for (std::size_t i = 0; i < columns; ++i) {
        const std::size_t column = i == 0 ? 0 : i + 1 < columns ? i + 1 : 1;  // the counters last
        if (expected.digests[column] == actual.digests[column]) continue;
        finding.what = (column < 2 ? "" : "plane ") + digest_columns()[column];
        finding.expected = expected.digests[column];
        finding.actual = actual.digests[column];
        if (column >= 2) finding.stage = inspect::stage_of(inspect::planes_in_order[column - 2]);
        return finding;
    }
    return {};
}

[[noreturn]] void fail(const std::filesystem::path& file, int line, const std::string& what) {
    throw Error(file.string(), line, what);
}

bool is_digest(const std::string& word) {
    return word == "-" || (word.size() == 32 && std::ranges::all_of(word, [](unsigned char c) {
                               return std::isdigit(c) || (c >= 'a' && c <= 'f');
                           }));
}

/// A line of a pass: its digests, "=" replaced by the one above, then the name.
std::optional<PassDigests> pass_from(std::istringstream& words, const GoldenDigests& panel) {
    PassDigests row;
    for (std::size_t column = 0; column < digest_columns().size(); ++column) {
        std::string word;
        words >> word;
        if (word == "=" && !panel.passes.empty()) word = panel.passes.back().digests[column];
        if (!is_digest(word)) return {};
        row.digests.push_back(word);
    }
    words.get();
    std::getline(words, row.name);
    return row;
}

}  // namespace

const std::vector<std::string>& digest_columns() {
    static const std::vector<std::string> columns = [] {
        std::vector<std::string> names{"state", "counters"};
        for (const Plane plane : inspect::planes_in_order) names.emplace_back(name_of(plane));
        return names;
    }();
    return columns;
}

GoldenDigests digests_of(const inspect::Manifest& manifest) {
    GoldenDigests panel{digest_of(head_of(manifest)), to_string(manifest.commands_hash), {}};
    for (const inspect::ManifestPass& pass : manifest.passes)
        panel.passes.push_back(digests_of(pass));
    return panel;
}

std::optional<inspect::Finding> first_difference(const GoldenDigests& expected,
                                                 const GoldenDigests& actual) {
    if (expected.head != actual.head)
        return inspect::Finding{
            .what = "profile or window", .expected = expected.head, .actual = actual.head};
    const std::size_t shorter = std::min(expected.passes.size(), actual.passes.size());
    for (std::size_t i = 0; i < shorter; ++i)
        if (auto finding = pass_difference(expected.passes[i], actual.passes[i], i)) return finding;
    if (expected.passes.size() == actual.passes.size()) return {};
    return inspect::Finding{.what = "number of passes",
                            .expected = std::to_string(expected.passes.size()),
                            .actual = std::to_string(actual.passes.size())};
}

GoldenTable read_golden_table(const std::filesystem::path& file) {
    GoldenTable table;
    if (!std::filesystem::exists(file)) return table;
    std::istringstream lines(scene::read_text(file));
    GoldenDigests* panel = nullptr;
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (line.starts_with("#")) continue;
        std::istringstream words(line);
        if (!line.starts_with("  ")) {
            std::string name, head, commands;
            words >> name >> head >> commands;
            if (!is_digest(head) || !is_digest(commands))
                fail(file, number, "expected a panel and two digests of 32 hexadecimal digits");
            panel = &table[name];
            *panel = {head, commands, {}};
            continue;
        }
        const auto pass = panel ? pass_from(words, *panel) : std::nullopt;
        if (!pass)
            fail(file, number,
                 fmt::format("expected digests of a pass: {}, and its name below a panel's line",
                             fmt::join(digest_columns(), ", ")));
        panel->passes.push_back(*pass);
    }
    return table;
}

std::string text_of(const GoldenTable& table) {
    std::string text = fmt::format("{}{}, name. =: as in the pass before; -: no such plane.\n",
                                   table_head, fmt::join(digest_columns(), ", "));
    for (const auto& [name, panel] : table) {
        text += fmt::format("{} {} {}\n", name, panel.head, panel.commands);
        const PassDigests* before = nullptr;
        for (const PassDigests& pass : panel.passes) {
            text += " ";
            for (std::size_t i = 0; i < pass.digests.size(); ++i)
                text +=
                    " " + (before && before->digests[i] == pass.digests[i] ? "=" : pass.digests[i]);
            text += " " + pass.name + "\n";
            before = &pass;
        }
    }
    return text;
}

}  // namespace gw::apps
