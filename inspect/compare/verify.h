// A recording against a manifest: the same passes, states, counters and planes, or the first
// difference.
// Does not read files.
#pragma once

#include "inspect/compare/compare_machines.h"
#include "inspect/manifest/manifest.h"
#include "inspect/manifest/values.h"

#include <span>

namespace gw::inspect {

/// Replays a recording and says what came out. `values`: may be null; is given the planes after
/// every pass.
Manifest replayed_manifest(const Recording& recording, const MachineMaker& make,
                           ValuesWriter* values);

struct Verification {
    std::optional<Finding> finding;  ///< nothing: as the manifest says
    bool same_commands = true;       ///< the manifest is of this very recording
    bool same_scene = true;          ///< the same meshes and maps
    /// Where the finding is in a plane: all planes after its pass; the expected ones where they are
    /// known.
    std::optional<Planes> expected_planes, actual_planes;
};

/// `values`: of the file beside the manifest; empty: none. Then the expected value of a wrong pixel
/// is taken from `other`, another machine, where its planes are as the manifest says; else it is
/// not known.
Verification verify(const Recording& recording, const Manifest& manifest,
                    std::span<const std::uint8_t> values, const MachineMaker& make,
                    const MachineMaker& other);

/// The first difference of two manifests, in this order: profile, window, then pass by pass name,
/// parameter set, state, planes, counters. Without pixels.
std::optional<Finding> first_difference(const Manifest& expected, const Manifest& actual);

}  // namespace gw::inspect
