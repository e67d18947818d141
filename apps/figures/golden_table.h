// The goldens of the profiles beside the papers' own: digests.txt, a table of digests by pass.
// A digest says that a state or a plane differs, not how: the recording of the panel shows that.
#pragma once

#include "inspect/compare/finding.h"
#include "inspect/manifest/manifest.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gw::apps {

/// What a manifest says of a pass, in the order of `digest_columns`: digests of its state with its
/// parameter set, of its counters, of its planes. "-": the machine has no such plane.
struct PassDigests {
    std::string name;
    std::vector<std::string> digests;
    bool operator==(const PassDigests&) const = default;
};

/// A panel's recording on one profile.
struct GoldenDigests {
    std::string head;      ///< of profile and window
    std::string commands;  ///< of all that entered the machine
    std::vector<PassDigests> passes;
    bool operator==(const GoldenDigests&) const = default;
};

/// "state", "counters" and the planes' names.
const std::vector<std::string>& digest_columns();

GoldenDigests digests_of(const inspect::Manifest& manifest);

/// The first difference: profile or window, then pass by pass name, state, planes, counters.
std::optional<inspect::Finding> first_difference(const GoldenDigests& expected,
                                                 const GoldenDigests& actual);

/// By the panel and its profile, "fig1/3_reality".
using GoldenTable = std::map<std::string, GoldenDigests>;

/// Throws Error with the line that is wrong; a file that does not exist is an empty table.
GoldenTable read_golden_table(const std::filesystem::path& file);
/// "=" stands for the digest of the pass before.
std::string text_of(const GoldenTable& table);

}  // namespace gw::apps
