// The expected results of a recording, pass by pass: JSON that people read and `gw verify` checks.
// The schema is in docs/recordings.md. Names neither the machine nor its threads: they make no
// difference.
#pragma once

#include "gw/counters.h"
#include "inspect/manifest/values.h"
#include "inspect/recording/recording.h"
#include "inspect/replay/player.h"
#include "inspect/shown/color_map.h"
#include "inspect/text/state_fields.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gw::inspect {

struct ManifestPass {
    std::string set;  ///< the paper's parameter set; "" if the driver added the pass
    /// the fields that differ from the pass before (of the first: from GL's initial state)
    std::vector<Field> state;
    PassReport report;  ///< with digests of all planes
    /// if it is another than that of the pass before; of 0 bits: colours are colours again
    std::optional<ColorMap> color_map;
    std::optional<Digest> shown;  ///< of the shown picture, if colours are indices
    bool operator==(const ManifestPass&) const = default;
};

struct Manifest {
    std::string producer;
    std::string scene;     ///< the name of the scene's file
    Digest scene_hash;     ///< of its meshes and maps
    Digest commands_hash;  ///< of everything that entered the machine
    std::string renderer;
    Profile profile;
    int width = 0, height = 0;
    std::vector<ManifestPass> passes;
    std::string values;  ///< the name of the file of planes beside it; "": none
    bool operator==(const Manifest&) const = default;
};

inline constexpr int manifest_version = 1;

/// `reports`: of all of its passes, with digests of all planes. `shown`: of ShownDigests.
Manifest manifest_of(const Recording& recording, const std::vector<PassReport>& reports,
                     const std::vector<std::optional<Digest>>& shown = {});
/// At the end of a pass; null: colours are not indices.
const ColorMap* map_of_pass(const Manifest& manifest, std::size_t pass);

/// Replays a recording and describes the result. `values`: receives the planes after every pass;
/// may be null.
Manifest replayed_manifest(const Recording& recording, const MachineMaker& make,
                           ValuesWriter* values);

/// For lists of thousands of passes with a few names, as superposed pictures have. The result has a
/// pass for each name, in the order of their first runs. "diffuse lamp, 16 runs" has the first
/// run's state and parameter set and the sums of the counters. Its digests are those of the runs'
/// digests. A single run stays as it is.
Manifest merge_runs(const Manifest& manifest);

/// A line for each pass, so that files compare line by line.
std::string to_json(const Manifest& manifest);
/// Throws Error naming the member that is missing or wrong. Unknown members are refused.
Manifest manifest_from_json(std::string_view text);

}  // namespace gw::inspect
