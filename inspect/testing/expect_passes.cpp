#include "inspect/testing/expect_passes.h"

#include "gw/error.h"
#include "image/output/output_set.h"
#include "inspect/compare/verify.h"
#include "inspect/manifest/manifest_file.h"
#include "inspect/testing/failure_files.h"

#include <cstdlib>

namespace gw::testing {
namespace {

using ::testing::AssertionFailure;
using ::testing::AssertionResult;
using ::testing::AssertionSuccess;

AssertionResult failure_of(const inspect::Verification& v, const inspect::Recording& recording,
                           const std::filesystem::path& golden) {
    AssertionResult failure = AssertionFailure();
    failure << golden.string() << ": " << text(*v.finding, recording.height);
    if (!v.same_commands) failure << "the golden is of another command list\n";
    failure << write_failure_recording(golden.stem().string(), recording, golden, *v.finding);
    if (!v.actual_planes) return failure;
    const std::string name = golden.stem().string() + "-pass" + std::to_string(*v.finding->pass);
    return failure << write_failure_pictures(name, v.expected_planes, *v.actual_planes,
                                             recording.profile);
}

AssertionResult compared(const inspect::Recording& recording, const std::filesystem::path& golden) {
    const inspect::ManifestFile expected = inspect::load_manifest(golden);
    const auto fast = inspect::maker_of("fast"), reference = inspect::maker_of("reference");
    const auto v = verify(recording, expected.manifest, expected.values, reference, fast);
    if (v.finding) return failure_of(v, recording, golden);
    if (const auto finding = compare_machines(recording, reference, fast))
        return AssertionFailure() << "the two machines differ: "
                                  << text(*finding, recording.height);
    return AssertionSuccess();
}

AssertionResult compared_or_updated(const inspect::Recording& recording,
                                    const std::filesystem::path& golden) {
    if (!updates_goldens()) {
        if (!std::filesystem::exists(golden))
            return AssertionFailure() << golden.string()
                                      << ": there is no golden; GW_UPDATE_GOLDENS=1 in the "
                                         "environment writes it";
        return compared(recording, golden);
    }
    write_golden(recording, golden);
    return AssertionSuccess() << golden.string() << ": written, because GW_UPDATE_GOLDENS is set";
}

}  // namespace

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
    std::error_code failed;
    const std::filesystem::path folder = golden.parent_path();
    if (!folder.empty()) std::filesystem::create_directories(folder, failed);
    if (failed) throw Error(folder.string(), 0, "cannot be made: " + failed.message());
    image::OutputSet files;
    files.add(inspect::values_file(golden)).write(made.values);
    files.add(golden).write_text(to_json(made.manifest));
    files.commit();
}

bool updates_goldens() {
    const char* value = std::getenv("GW_UPDATE_GOLDENS");
    return value && *value && std::string_view(value) != "0";
}

AssertionResult passes_eq(const inspect::Recording& recording,
                          const std::filesystem::path& golden) {
    try {
        return compared_or_updated(recording, golden);
    } catch (const Error& error) {
        return AssertionFailure() << error.what();
    }
}

AssertionResult passes_eq(const CommandList& list, const std::filesystem::path& golden) {
    try {
        const inspect::Manifest manifest = inspect::load_manifest(golden).manifest;
        return passes_eq(recording_of(list, manifest.profile, manifest.width, manifest.height),
                         golden);
    } catch (const Error& error) {
        return AssertionFailure()
               << error.what()
               << "\nA list takes its profile and window from the golden. The first one is written "
                  "with GW_UPDATE_GOLDENS=1 for recording_of(list, profile, width, height), or by "
                  "gw::testing::write_golden";
    }
}

}  // namespace gw::testing
