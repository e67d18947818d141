// Runs a command again and again, each time on a disk that is full after so many bytes.
#pragma once

#include "tests/apps/scene_files.h"

#include <map>
#include <set>

namespace gw::apps {

class FailingWrites : public SceneTest {
protected:
    using Files = std::map<std::string, std::string>;  ///< names from the folder to bytes

    Files files() const {
        Files all;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(in(".")))
            if (entry.is_regular_file())
                all[entry.path().lexically_relative(in(".")).string()] = bytes_of(entry.path());
        return all;
    }

    /// The sizes of the files that the command adds, and just less: so each of them fails in turn, in
    /// its first byte, in the middle and in its last.
    std::set<long> limits(const Files& before) const {
        std::set<long> sizes;
        for (const auto& [name, bytes] : files())
            if (!before.contains(name) && !bytes.empty())
                sizes.insert({0, long(bytes.size()) / 2, long(bytes.size()) - 1});
        return sizes;
    }

    void expect_nothing_written(const std::vector<std::string>& arguments, long limit,
                                const Files& before) const {
        const Outcome outcome = gw(arguments, {.largest_file = limit});
        EXPECT_EQ(outcome.code, 1) << arguments[0] << " with files of " << limit << " bytes\n"
                                   << outcome.err;
        EXPECT_EQ(files(), before) << arguments[0] << " with files of " << limit << " bytes";
    }

    /// `outputs`: what the command makes. It is run once for the sizes, then with every limit: first
    /// where nothing is, then where a file of each name is.
    void expect_whole_or_nothing(const std::vector<std::string>& arguments,
                                 const std::vector<std::string>& outputs) const {
        const Files before = files();
        ASSERT_EQ(gw(arguments).code, 0) << arguments[0];
        const std::set<long> all = limits(before);
        ASSERT_FALSE(all.empty());
        for (const long limit : all) {
            for (const std::string& output : outputs) std::filesystem::remove_all(in(output));
            expect_nothing_written(arguments, limit, before);
        }
        ASSERT_EQ(gw(arguments).code, 0) << arguments[0];
        const Files after = files();  // EXR files hold the time at which they were made
        for (const long limit : all) expect_nothing_written(arguments, limit, after);
        for (const std::string& output : outputs) std::filesystem::remove_all(in(output));
    }
};

}  // namespace gw::apps
