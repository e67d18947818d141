// A manifest as a file, and the file of values beside it. Reads; whoever writes files writes what
// is here.
#pragma once

#include "inspect/compare/verify.h"

#include <filesystem>
#include <vector>

namespace gw::inspect {

/// A manifest, and the bytes of the file of values that it names; none where that file is not
/// there.
struct ManifestFile {
    Manifest manifest;
    std::vector<std::uint8_t> values;
};

/// Throws Error "M.json: what is wrong".
ManifestFile load_manifest(const std::filesystem::path& file);

/// "M.values" for "M.json": the values are found beside their manifest.
std::filesystem::path values_file(const std::filesystem::path& manifest_file);

/// Replays a recording: what came out, as it will stand in `file`, which is not written here.
ManifestFile replayed_manifest_file(const Recording& recording, const MachineMaker& make,
                                    const std::filesystem::path& file, bool with_values);

}  // namespace gw::inspect
