#include "inspect/manifest/manifest_file.h"

#include "gw/error.h"
#include "inspect/recording/read_bytes.h"

namespace gw::inspect {

namespace fs = std::filesystem;

namespace {

const Beginning manifest_beginning{is_manifest, "is not JSON; expected a manifest that gw wrote"};
const Beginning values_beginning{
    [](std::string_view bytes) { return has_identifier(bytes, "GWV1"); },
    "is not a file of values; expected one that gw wrote, or none"};

}  // namespace

bool is_manifest(std::string_view bytes) {
    const auto first = bytes.find_first_not_of(" \t\r\n");
    return first != bytes.npos && bytes[first] == '{';
}

ManifestFile load_manifest(const fs::path& file) {
    const std::vector<std::uint8_t> bytes = read_bytes(file, manifest_beginning);
    ManifestFile result;
    try {
        result.manifest =
            manifest_from_json({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    } catch (const Error& error) {
        throw Error(file.string(), 0, error.what());
    }
    const std::string& name = result.manifest.values;
    if (name != fs::path(name).filename())
        throw Error(file.string(), 0, "'values' does not name a file beside it");
    if (!name.empty() && fs::exists(file.parent_path() / name))
        result.values = read_bytes(file.parent_path() / name, values_beginning);
    return result;
}

fs::path values_file(const fs::path& manifest_file) {
    return fs::path(manifest_file).replace_extension(".values");
}

ManifestFile replayed_manifest_file(const Recording& recording, const MachineMaker& make,
                                    const fs::path& file, bool with_values) {
    if (!with_values) return {replayed_manifest(recording, make, nullptr), {}};
    ValuesWriter values(recording.width, recording.height, recording.profile.color_planes);
    ManifestFile result{replayed_manifest(recording, make, &values), {}};
    result.manifest.values = values_file(file).filename().string();
    result.values = values.finish();
    return result;
}

}  // namespace gw::inspect
