#include "inspect/manifest/manifest.h"

#include "inspect/recording/check_lists.h"
#include "inspect/recording/content.h"
#include "inspect/replay/forwarding_machine.h"
#include "inspect/replay/shown_maps.h"

#include <fmt/format.h>

#include <array>
#include <map>

namespace gw::inspect {
namespace {

/// Only the machine's input: the same drawing has the same digest under any name, from any build of
/// its program.
Digest commands_content(const Recording& recording) {
    return digest_of_bytes(encode({.profile = recording.profile,
                                   .width = recording.width,
                                   .height = recording.height,
                                   .lists = recording.lists}));
}

/// The parameter set of a pass; "" if unknown.
std::string set_of(const Recording& recording, const std::string& pass) {
    for (const ParameterSet& s : recording.sets)
        if (s.pass == pass) return s.set;
    return "";
}

bool makes_fragments(const Command& command) {
    return std::holds_alternative<Draw>(command) || std::holds_alternative<WriteSpans>(command) ||
           std::holds_alternative<WritePixels>(command) ||
           std::holds_alternative<DrawPixels>(command);
}

/// The state of each pass: that of its first command that makes fragments; if it has none, its last
/// one.
std::vector<State> states_of(const Recording& recording, const std::vector<PassRange>& ranges) {
    std::vector<State> states(ranges.size());
    State state;
    std::size_t index = 0, pass = 0;
    bool chosen = false;
    for (const CommandList& list : recording.lists)
        for (const Command& command : list.commands) {
            for (; pass < ranges.size() && index >= ranges[pass].end; ++pass) chosen = false;
            if (const auto* set = std::get_if<SetState>(&command)) state = set->state;
            if (pass < ranges.size() && !chosen) states[pass] = state;
            chosen = chosen || makes_fragments(command);
            ++index;
        }
    return states;
}

struct PassRuns {
    ManifestPass first;
    std::array<std::vector<std::uint8_t>, every_plane.size()> digests;  ///< of all runs, as bytes
    int count = 0;
};

void add_bytes(std::vector<std::uint8_t>& bytes, const Digest& digest) {
    for (const std::uint64_t half : {digest.high, digest.low})
        for (int shift = 56; shift >= 0; shift -= 8) bytes.push_back(std::uint8_t(half >> shift));
}

void add(PassRuns& runs, const ManifestPass& pass) {
    if (runs.count++ == 0)
        runs.first = pass;
    else
        runs.first.report.counters += pass.report.counters;
    for (std::size_t i = 0; i < every_plane.size(); ++i)
        add_bytes(runs.digests[i], pass.report.digests[i]);
}

ManifestPass merged(const PassRuns& runs) {
    ManifestPass pass = runs.first;
    if (runs.count == 1) return pass;
    pass.shown.reset();
    pass.report.name += fmt::format(", {} runs", runs.count);
    for (const Plane plane : every_plane)
        if (const auto i = std::size_t(plane); pass.report.digested & mask_of(plane))
            pass.report.digests[i] = digest_of_bytes(runs.digests[i]);
    return pass;
}

void add_color_maps(Manifest& manifest, const ShownMaps& maps) {
    const ColorMap none;
    const ColorMap* before = &none;
    for (std::size_t i = 0; i < manifest.passes.size(); ++i) {
        const ColorMap* now = maps.of_pass(i);
        if (now == nullptr) now = &none;
        if (*now != *before) manifest.passes[i].color_map = *now;
        before = now;
    }
}

}  // namespace

Manifest manifest_of(const Recording& recording, const std::vector<PassReport>& reports,
                     const std::vector<std::optional<Digest>>& shown) {
    Manifest manifest{.producer = recording.producer,
                      .scene = recording.scene,
                      .scene_hash = scene_content(recording),
                      .commands_hash = commands_content(recording),
                      .renderer = recording.renderer,
                      .profile = recording.profile,
                      .width = recording.width,
                      .height = recording.height};
    const std::vector<PassRange> ranges = pass_ranges(recording);
    const std::vector<State> states = states_of(recording, ranges);
    State before;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        manifest.passes.push_back(
            {set_of(recording, ranges[i].name), changed_fields(before, states[i]), reports.at(i)});
        before = states[i];
        if (i < shown.size()) manifest.passes.back().shown = shown[i];
    }
    add_color_maps(manifest, ShownMaps(recording));
    return manifest;
}

const ColorMap* map_of_pass(const Manifest& manifest, std::size_t pass) {
    for (std::size_t i = pass + 1; i-- > 0;)
        if (const auto& map = manifest.passes.at(i).color_map)
            return map->bits != 0 ? &*map : nullptr;
    return nullptr;
}

Manifest replayed_manifest(const Recording& recording, const MachineMaker& make,
                           ValuesWriter* values) {
    validate_lists(recording);
    const auto machine = make(recording);
    DigestingMachine digesting(*machine);
    ShownDigests shown(recording);
    play_by_pass(recording, digesting, [&](std::size_t) {
        if (values) values->add(machine->planes());
        shown.add(*machine);
    });
    return manifest_of(recording, machine->passes(), shown.all());
}

Manifest merge_runs(const Manifest& manifest) {
    std::map<std::string, std::size_t> places;
    std::vector<PassRuns> all;
    for (const ManifestPass& pass : manifest.passes) {
        const auto [place, is_new] = places.try_emplace(pass.report.name, all.size());
        if (is_new) all.emplace_back();
        add(all[place->second], pass);
    }
    Manifest result = manifest;
    result.passes.clear();
    for (const PassRuns& runs : all) result.passes.push_back(merged(runs));
    return result;
}

}  // namespace gw::inspect
