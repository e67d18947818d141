#include "inspect/testing/golden.h"

#include "image/output/output_set.h"
#include "inspect/manifest/manifest_file.h"

#include <cstdlib>

namespace gw::testing {

inspect::Recording recording_of(CommandList list, const Profile& profile, int width, int height) {
    inspect::Recording recording;
    recording.producer = "gw::testing";
    recording.renderer = "test";
    recording.profile = profile;
    recording.width = width;
    recording.height = height;
    recording.lists = {std::move(list)};
    return recording;
}

void write_golden(const inspect::Recording& recording, const std::filesystem::path& golden) {
    const auto made =
        replayed_manifest_file(recording, inspect::maker_of("reference"), golden, true);
    image::OutputSet files;
    files.add(inspect::values_file(golden)).write(made.values);
    files.add(golden).write_text(to_json(made.manifest));
    files.commit();
}

bool updates_goldens() {
    const char* value = std::getenv("GW_UPDATE_GOLDENS");
    return value && *value && std::string_view(value) != "0";
}

}  // namespace gw::testing
