// The commands that help texts and documents show, run as a user would who pastes them at the
// repository's root.
#pragma once

#include "test_paths.h"
#include "tests/apps/support/command_test.h"

namespace gw::apps {

/// A folder that looks like the repository's root after a build: scenes/, tests/golden/ and
/// build/release/bin/gw.
class ExampleTest : public CommandTest {
protected:
    ExampleTest() {
        namespace fs = std::filesystem;
        fs::create_directory_symlink(GW_SOURCE_DIR "/scenes", in("scenes"));
        fs::create_directory_symlink(GW_SOURCE_DIR "/examples", in("examples"));
        fs::create_directories(in("tests"));
        fs::create_directory_symlink(GW_SOURCE_DIR "/tests/golden", in("tests/golden"));
        fs::create_directories(in("build/release"));
        fs::create_directory_symlink(GW_BIN_DIR, in("build/release/bin"));
    }

    /// The lines of `text` that are commands of gw: indented, beginning with `command`.
    static std::vector<std::string> examples(const std::string& text,
                                             const std::string& command = "build/release/bin/gw");
    /// Each by a shell; expects exit code 0 and an empty stderr.
    void expect_to_work(const std::vector<std::string>& commands) const;
};

}  // namespace gw::apps
