// Runs the real binary in a folder of its own, as a user would. Does not look into it.
#pragma once

#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace gw::apps {

struct Outcome {
    int code = -1;  ///< as a shell sees it: 128 + n for signal n
    std::string out, err;
};

/// How the process runs besides its arguments.
struct Surroundings {
    std::filesystem::path folder;  ///< working directory
    long largest_file = -1;        ///< bytes; as `ulimit -f`
    std::string stdout_file;       ///< instead of Outcome::out
    int interrupt_after_ms = -1;   ///< SIGINT then
    std::string interrupt_when;    ///< SIGINT when this file is in the folder
};

Outcome run_process(const std::vector<std::string>& words, const Surroundings& surroundings);

std::string bytes_of(const std::filesystem::path& file);

/// A test with a folder that goes away with it.
class CommandTest : public testing::Test {
protected:
    std::filesystem::path in(const std::string& name) const { return folder_ / name; }
    void write(const std::string& name, const std::string& text) const {
        folder_.write(name, text);
    }
    /// Names in the folder, sorted.
    std::vector<std::string> names(const std::string& folder = ".") const {
        return folder_.names(folder);
    }

    /// Runs gw in the folder.
    Outcome gw(std::vector<std::string> arguments, Surroundings surroundings = {}) const;

    /// Runs gw and expects: this exit code, nothing on stdout, one line on stderr that contains
    /// every one of `parts`, and the folder as it was.
    void expect_refused(int code, const std::vector<std::string>& arguments,
                        const std::vector<std::string>& parts,
                        Surroundings surroundings = {}) const;

private:
    TemporaryFolder folder_;
};

}  // namespace gw::apps
