// Manifests of recordings.
#include "inspect/manifest/manifest.h"

#include "inspect/recording/content.h"
#include "inspect/replay/player.h"

namespace gw::inspect {
namespace {

/// Only what the machine sees: the same drawing has the same commands, whatever it is called.
Digest commands_content(Recording recording) {
    recording.producer = recording.scene = recording.renderer = "";
    recording.sets.clear();
    return digest_of_bytes(encode(recording));
}

bool makes_fragments(const Command& command) {
    return std::holds_alternative<Draw>(command) || std::holds_alternative<WriteSpans>(command) ||
           std::holds_alternative<WritePixels>(command);
}

/// The state of each pass: that of its first command that makes fragments; where it has none, its
/// last one.
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

}  // namespace

Manifest manifest_of(const Recording& recording, const std::vector<PassReport>& reports) {
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
    }
    return manifest;
}

}  // namespace gw::inspect
