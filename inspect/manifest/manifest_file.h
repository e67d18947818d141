// A manifest as a file, and the file of values beside it. Reads files; does not write them.
#pragma once

#include "inspect/manifest/manifest.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace gw::inspect {

/// A manifest, and the bytes of the file of values that it names; none if that file is missing.
struct ManifestFile {
    Manifest manifest;
    std::vector<std::uint8_t> values;
};

/// Whether a file that begins so may be a manifest: JSON's first character.
bool is_manifest(std::string_view bytes);

/// Throws Error "M.json: REASON".
ManifestFile load_manifest(const std::filesystem::path& file);

/// "M.values" for "M.json": the values are found beside their manifest.
std::filesystem::path values_file(const std::filesystem::path& manifest_file);

/// Replays a recording and returns the result as it will stand in `file`, which is not written
/// here.
ManifestFile replayed_manifest_file(const Recording& recording, const MachineMaker& make,
                                    const std::filesystem::path& file, bool with_values);

}  // namespace gw::inspect
