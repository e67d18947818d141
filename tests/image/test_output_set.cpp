// Files that belong together appear together.
#include "gw/error.h"
#include "image/output/output_set.h"
#include "image/output/temporaries.h"

#include "tests/image/files.h"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace gw::image {

TEST(OutputSet, ShowsNothingBeforeCommitAndAllAfter) {
    const Folder folder;
    OutputSet files;
    files.make_folder(folder / "sub");
    files.add(folder / "a.txt");
    files.add(folder / "sub/b.txt");
    EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
    EXPECT_FALSE(std::filesystem::exists(folder / "sub/b.txt"));
    files.commit();
    EXPECT_TRUE(std::filesystem::exists(folder / "a.txt"));
    EXPECT_TRUE(std::filesystem::exists(folder / "sub/b.txt"));
}

TEST(OutputSet, LeavesNeitherFilesNorFoldersWithoutCommit) {
    const Folder folder;
    {
        OutputSet files;
        files.make_folder(folder / "sub");
        files.add(folder / "sub/b.txt");
        EXPECT_THROW(files.add(folder / "missing/a.txt"), Error);
    }
    EXPECT_TRUE(folder.names().empty());
}

TEST(OutputSet, KeepsAFolderThatWasThere) {
    const Folder folder;
    std::filesystem::create_directory(folder / "sub");
    {
        OutputSet files;
        files.make_folder(folder / "sub");
    }
    EXPECT_EQ(folder.names(), std::vector<std::string>{"sub"});
}

TEST(OutputSet, SharesANewFolderWithOtherProcesses) {
    const Folder folder;
    constexpr int processes = 8, rounds = 50;
    std::vector<pid_t> children;
    for (int i = 0; i < processes; ++i) {
        children.push_back(::fork());
        if (children.back() != 0) continue;
        int failures = 0;
        for (int round = 0; round < rounds; ++round) try {
                OutputSet files;
                files.make_folder(folder / std::to_string(round));
                files.add(folder / std::to_string(round) / std::to_string(i)).write_text("whole");
                files.commit();
            } catch (const Error&) {
                ++failures;
            }
        ::_exit(failures);
    }
    for (const pid_t child : children) {
        int status = 0;
        ::waitpid(child, &status, 0);
        EXPECT_EQ(status, 0);
    }
    EXPECT_EQ(folder.names("0").size(), std::size_t(processes));
}

TEST(OutputSet, HoldsAsManyFilesAsAnimationsHavePictures) {
    const Folder folder;
    OutputSet files;
    for (int i = 0; i < 520; ++i) files.add(folder / std::to_string(i)).write_text("whole");
    EXPECT_FALSE(std::filesystem::exists(folder / "0"));
    files.commit();
    EXPECT_EQ(folder.names().size(), 520u);
}

TEST(OutputSet, RefusesAFileAsFolderAndAFolderWithoutParent) {
    const Folder folder;
    write_file(folder / "file", "");
    const auto refusal = [](const std::filesystem::path& name) -> std::string {
        OutputSet files;
        try {
            files.make_folder(name);
        } catch (const Error& error) {
            return error.what();
        }
        return "made";
    };
    EXPECT_NE(refusal(folder / "file").find("file: is not a folder; expected one"),
              std::string::npos);
    const std::string orphan = refusal(folder / "missing/sub");
    EXPECT_NE(orphan.find("missing/sub: folder cannot be made: "), std::string::npos) << orphan;
    EXPECT_NE(orphan.find("; expected a name in a folder that can be written into"),
              std::string::npos)
        << orphan;
}

TEST(OutputSet, IsRemovedByASignal) {
    const Folder folder;
    const auto die = [&] {
        remove_temporaries_on_signals();
        OutputSet files;
        files.make_folder(folder / "sub");
        files.add(folder / "sub/b.txt").write_text("half");
        files.add(folder / "a.txt").write_text("half");
        ::raise(SIGINT);
    };
    EXPECT_EXIT(die(), testing::KilledBySignal(SIGINT), "");
    EXPECT_TRUE(folder.names().empty());
}

}  // namespace gw::image
