// A file is there whole or as it was before.
#include "gw/error.h"
#include "image/output/output_file.h"
#include "image/output/output_folder.h"
#include "image/output/temporaries.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "tests/image/files.h"

namespace gw::image {
namespace {

std::string failure(const std::filesystem::path& target) {
    try {
        write_file(target, "new");
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST(OutputFile, ReplacesTheTargetAtCommitOnly) {
    const Folder folder;
    write_file(folder / "a.txt", "old");
    OutputFile file(folder / "a.txt");
    file.write(std::vector<std::uint8_t>{'n', 'e', 'w'});
    EXPECT_EQ(bytes_of(folder / "a.txt"), "old");
    file.commit();
    EXPECT_EQ(bytes_of(folder / "a.txt"), "new");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.txt"});
}

TEST(OutputFile, LeavesNothingWithoutCommit) {
    const Folder folder;
    {
        OutputFile file(folder / "a.txt");
        file.write(std::vector<std::uint8_t>(1000, 7));
        EXPECT_EQ(folder.names().size(), 1u);
    }
    EXPECT_TRUE(folder.names().empty());
}

TEST(OutputFile, FollowsALink) {
    const Folder folder;
    write_file(folder / "real.txt", "old");
    std::filesystem::create_symlink("real.txt", folder / "link.txt");
    write_file(folder / "link.txt", "new");
    EXPECT_EQ(bytes_of(folder / "real.txt"), "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
}

TEST(OutputFile, FollowsALinkToAFileThatIsNotThereYet) {
    const Folder folder;
    std::filesystem::create_directory(folder / "sub");
    std::filesystem::create_symlink("sub/real.txt", folder / "first");
    std::filesystem::create_symlink("first", folder / "second");
    write_file(folder / "second", "new");
    EXPECT_EQ(bytes_of(folder / "sub/real.txt"), "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "second"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "first"));
}

TEST(OutputFile, RefusesALinkThatLeadsNowhere) {
    const Folder folder;
    std::filesystem::create_symlink("missing/a.txt", folder / "link");
    EXPECT_TRUE(contains(failure(folder / "link"), "missing does not exist"));
    std::filesystem::create_symlink("b", folder / "a");
    std::filesystem::create_symlink("a", folder / "b");
    EXPECT_TRUE(contains(failure(folder / "a"), "too many links"));
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a", "b", "link"}));
}

TEST(OutputFile, KeepsTheModeOfWhatItReplaces) {
    using std::filesystem::perms;
    const Folder folder;
    for (const auto mode : {perms(0600), perms(0640), perms(0755), perms(0666)}) {
        write_file(folder / "a.txt", "old");
        std::filesystem::permissions(folder / "a.txt", mode);
        write_file(folder / "a.txt", "new");
        EXPECT_EQ(std::filesystem::status(folder / "a.txt").permissions(), mode);
    }
}

TEST(OutputFile, IsReadableByItsOwnerAloneWhileItReplacesOneThatIs) {
    using std::filesystem::perms;
    const Folder folder;
    write_file(folder / "a.txt", "secret");
    std::filesystem::permissions(folder / "a.txt", perms(0600));
    const OutputFile file(folder / "a.txt");
    EXPECT_EQ(std::filesystem::status(file.temporary()).permissions(), perms(0600));
}

TEST(OutputFile, RemovesWhatAKilledProcessLeftBeside) {
    const Folder folder;
    const pid_t child = ::fork();
    if (child == 0) {
        OutputFile file(folder / "a.txt");
        file.write_text("half");
        OutputFolder tree(folder / "tree", {"index.html"});
        write_file(tree.temporary() / "index.html", "half");
        ::kill(::getpid(), SIGKILL);
    }
    ::waitpid(child, nullptr, 0);
    ASSERT_EQ(folder.names().size(), 2u);
    write_file(folder / ".gw-mine.tmp", "mine");
    write_file(folder / "b.txt", "whole");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{".gw-mine.tmp", "b.txt"}));
}

TEST(OutputFile, LeavesWhatLivingProcessesWrite) {
    const Folder folder;
    OutputFile ours(folder / "a.txt");
    const pid_t child = ::fork();
    if (child == 0) {
        remove_stale_temporaries(folder.path() / "././.");
        ::_exit(0);
    }
    ::waitpid(child, nullptr, 0);
    EXPECT_TRUE(std::filesystem::exists(ours.temporary()));
    // A process of another container, whose number means nothing here, holds a lock.
    const std::filesystem::path foreign = folder / ".gw-999999999-0.tmp";
    write_file(foreign, "half");
    const int lock = ::open(foreign.c_str(), O_RDONLY);
    ::flock(lock, LOCK_EX);
    remove_stale_temporaries(folder.path() / ".");
    EXPECT_TRUE(std::filesystem::exists(foreign));
    ::close(lock);
    remove_stale_temporaries(folder.path() / "./.");
    EXPECT_FALSE(std::filesystem::exists(foreign));
}

TEST(OutputFile, ReportsAFullDevice) {
    const Folder folder;
    std::filesystem::create_symlink("/dev/full", folder / "full.png");
    EXPECT_EQ(failure(folder / "full.png"),
              (folder / "full.png").string() + ": cannot be written: No space left on device");
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
    EXPECT_EQ(folder.names(), std::vector<std::string>{"full.png"});
}

TEST(OutputFile, TakesANameAsLongAsNamesCanBe) {
    const Folder folder;
    const std::string name(255, 'n');
    EXPECT_EQ(failure(folder / name), "");
    EXPECT_EQ(folder.names(), std::vector<std::string>{name});
}

TEST(OutputFile, SaysWhatIsInTheWay) {
    const Folder folder;
    std::filesystem::create_directory(folder / "sub");
    write_file(folder / "file", "old");
    EXPECT_TRUE(contains(failure(folder / "missing/a.txt"), "missing does not exist"));
    EXPECT_TRUE(contains(failure(folder / "sub"), "it is a folder"));
    EXPECT_TRUE(contains(failure(folder / "sub/"), "it names a folder"));
    EXPECT_TRUE(contains(failure(folder / "file/a.txt"), "file is not a folder"));
    EXPECT_TRUE(contains(failure(folder / std::string(256, 'n')), "File name too long"));
}

}  // namespace gw::image
