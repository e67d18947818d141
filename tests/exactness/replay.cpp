// gw-replay: replays recordings of another process, compiler or processor. Plays each T.gwt on both
// machines and compares every plane and counter of every pass with T.json, as gw verify does.
// scripts/exactness makes the files. Prints "recordings AGREE OF", counting each machine. Exit 3
// if one differs, 1 for an error, 2 for usage.
#include "gw/error.h"
#include "inspect/compare/verify.h"
#include "inspect/manifest/manifest_file.h"
#include "inspect/recording/recording.h"

#include <fmt/format.h>

namespace gw::exactness {
namespace {

/// Whether the machine of this name agrees with the manifest.
bool replays(const std::filesystem::path& file, const std::string& machine) {
    const inspect::Recording recording = inspect::decode(inspect::read_recording_bytes(file));
    const inspect::ManifestFile expected =
        inspect::load_manifest(std::filesystem::path(file).replace_extension(".json"));
    const auto make = inspect::maker_of(machine, 1);
    const auto result = inspect::verify(recording, expected.manifest, expected.values, make, make);
    if (result.finding)
        fmt::print(stderr, "{}, {}: {}", file.string(), machine,
                   text(*result.finding, recording.height));
    return !result.finding;
}

int run(int argc, char** argv) {
    if (argc < 2) {
        fmt::print(stderr, "usage: gw-replay T.gwt...\n");
        return 2;
    }
    int agree = 0, of = 0;
    for (int i = 1; i < argc; ++i)
        for (const char* machine : {"reference", "fast"}) {
            agree += replays(argv[i], machine) ? 1 : 0;
            ++of;
        }
    fmt::print("recordings {} {}\n", agree, of);
    return agree == of ? 0 : 3;
}

}  // namespace
}  // namespace gw::exactness

int main(int argc, char** argv) {
    try {
        return gw::exactness::run(argc, argv);
    } catch (const gw::Error& e) {
        fmt::print(stderr, "gw-replay: {}\n", e.what());
        return 1;
    }
}
