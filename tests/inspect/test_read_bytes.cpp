// Claim: a file that cannot be what is asked for is refused by its kind, size or beginning; nothing
// waits for a pipe, and no gigabytes are read to be refused.
#include <gtest/gtest.h>

#include "gw/error.h"
#include "inspect/manifest/manifest_file.h"
#include "inspect/recording/recording.h"
#include "tests/temporary_folder.h"

#include <sys/stat.h>

#include <chrono>

namespace gw::inspect {
namespace {

std::string refusal(const auto& read, const std::filesystem::path& file) {
    try {
        read(file);
    } catch (const Error& error) {
        const std::string text = error.what();
        return text.starts_with(file.string() + ": ") ? text.substr(file.string().size() + 2)
                                                      : text;
    }
    return "none";
}
std::string recording_refusal(const std::filesystem::path& file) {
    return refusal([](const auto& f) { read_recording_bytes(f); }, file);
}
std::string manifest_refusal(const std::filesystem::path& file) {
    return refusal([](const auto& f) { load_manifest(f); }, file);
}

}  // namespace

TEST(ReadBytes, RefusesPipesDevicesAndFolders) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    std::filesystem::create_symlink("pipe", folder / "link");
    for (const auto& refused : {recording_refusal, manifest_refusal}) {
        EXPECT_EQ(refused(folder / "pipe"), "is a pipe; expected a file");
        EXPECT_EQ(refused(folder / "link"), "is a pipe; expected a file");
        EXPECT_EQ(refused("/dev/zero"), "is a device; expected a file");
        EXPECT_EQ(refused(folder.path()), "is a folder; expected a file");
        EXPECT_EQ(refused(folder / "missing"),
                  "cannot be opened; expected a file that can be read");
    }
}

TEST(ReadBytes, RefusesBySizeAndBeginningAlone) {
    const TemporaryFolder folder;
    folder.write("large", "");
    folder.write("zeros", "");
    std::filesystem::resize_file(folder / "large", std::uintmax_t{3} << 30);
    std::filesystem::resize_file(folder / "zeros", std::uintmax_t{2000} << 20);
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(recording_refusal(folder / "large"), "has more than 2 GB; expected less");
    EXPECT_EQ(manifest_refusal(folder / "large"), "has more than 2 GB; expected less");
    EXPECT_EQ(recording_refusal(folder / "zeros"),
              "not a recording; expected a file that gw record wrote");
    EXPECT_EQ(manifest_refusal(folder / "zeros"), "is not JSON; expected a manifest that gw wrote");
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
}

}  // namespace gw::inspect
