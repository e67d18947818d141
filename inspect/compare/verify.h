// A recording against a manifest: the same passes, states, counters and planes, or the first
// difference.
// Does not read files.
#pragma once

#include "inspect/compare/compare_machines.h"
#include "inspect/manifest/manifest.h"

#include <span>

namespace gw::inspect {

struct Verification {
    std::optional<Finding> finding;  ///< nothing: as the manifest says
    bool same_commands = true;       ///< the manifest is of this very recording
    bool same_scene = true;          ///< the same meshes and maps
    /// If the finding is in a plane: all planes after its pass; the expected ones if they are
    /// known.
    std::optional<Planes> expected_planes, actual_planes;
};

/// `values`: of the file beside the manifest; empty: none. Then the expected value of a wrong pixel
/// comes from `other`, another machine, if its planes are as the manifest says. Else it is unknown.
Verification verify(const Recording& recording, const Manifest& manifest,
                    std::span<const std::uint8_t> values, const MachineMaker& make,
                    const MachineMaker& other);

/// The first difference of two manifests, in this order: profile, window, then pass by pass name,
/// parameter set, state, planes, counters. Without pixels.
std::optional<Finding> first_difference(const Manifest& expected, const Manifest& actual);

}  // namespace gw::inspect
