// Runs a command again and again, each time with another allocation that fails.
#pragma once

#include "test_paths.h"
#include "tests/apps/scene_files.h"

#include <algorithm>
#include <map>

namespace gw::apps {

class FailingAllocations : public SceneTest {
protected:
    /// One in `step` of the command's allocations fails, and each of the first `all`. Then the
    /// command says so in one line, with code 1, and the folder is as it was; or it can do without
    /// that memory, and does what it always does.
    void expect_error_or_whole(const std::vector<std::string>& arguments, long all,
                               long step) const {
        const Files before = files();
        const Outcome counted = failing(0, arguments);
        ASSERT_EQ(counted.code, 0) << counted.err;
        const Files after = files();
        const long allocations = std::stol(counted.err);
        ASSERT_GT(allocations, all);
        long errors = 0, of_memory = 0, runs = 0;
        for (long k = 1; k <= allocations; k += k < all ? 1 : step) {
            restore(before);
            const Outcome outcome = failing(k, arguments);
            ++runs;
            errors += outcome.code == 1;
            if (outcome.code == 0) {
                ASSERT_EQ(files(), after) << arguments[0] << ", allocation " << k;
                continue;
            }
            ASSERT_EQ(outcome.code, 1) << arguments[0] << ", allocation " << k << outcome.err;
            ASSERT_EQ(files(), before) << arguments[0] << ", allocation " << k;
            ASSERT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
            ASSERT_EQ(outcome.err.substr(0, 4), "gw: ") << outcome.err;
            of_memory += outcome.err.find("memory") != std::string::npos;
        }
        EXPECT_GT(errors, runs / 2) << "of " << runs;
        EXPECT_GT(of_memory, errors * 95 / 100) << "streams take missing memory for a wrong number";
        restore(before);
    }

private:
    using Files = std::map<std::string, std::string>;  ///< names from the folder to bytes

    Files files() const {
        Files all;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(in(".")))
            all[entry.path().lexically_relative(in(".")).string()] =
                entry.is_regular_file() ? bytes_of(entry.path()) : "";
        return all;
    }
    void restore(const Files& wanted) const {
        for (const auto& [name, bytes] : files())
            if (!wanted.contains(name)) std::filesystem::remove_all(in(name));
    }
    Outcome failing(long k, std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(),
                         {GW_BIN_DIR "/gw-failing-allocation", std::to_string(k)});
        return run_process(arguments, {.folder = in(".")});
    }
};

}  // namespace gw::apps
