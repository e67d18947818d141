// A folder is there whole or as it was before; and pictures made smaller keep their mean.
#include "gw/error.h"
#include "image/output/output_file.h"
#include "image/output/output_folder.h"
#include "image/picture.h"

#include "tests/image/files.h"

#include <sys/wait.h>
#include <unistd.h>

namespace gw::image {

namespace fs = std::filesystem;

namespace {

std::string refusal_of(const fs::path& target) {
    try {
        OutputFolder(target, {"a.txt", "index.html"});
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

void fill(const fs::path& target, const std::string& text) {
    OutputFolder output(target, {"a.txt"});
    write_file(output.temporary() / "a.txt", text);
    output.commit();
}

}  // namespace

TEST(OutputFolder, AppearsAtCommitOnly) {
    const Folder folder;
    OutputFolder output(folder / "out", {"a.txt"});
    write_file(output.temporary() / "a.txt", "new");
    EXPECT_FALSE(fs::exists(folder / "out"));
    output.commit();
    EXPECT_EQ(bytes_of(folder / "out" / "a.txt"), "new");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"out"});
}

TEST(OutputFolder, LeavesNothingWithoutCommit) {
    const Folder folder;
    fill(folder / "out", "old");
    {
        OutputFolder output(folder / "out", {"a.txt"});
        fs::create_directory(output.temporary() / "deep");
        write_file(output.temporary() / "deep" / "b.txt", "new");
    }
    EXPECT_EQ(folder.names(), std::vector<std::string>{"out"});
    EXPECT_EQ(bytes_of(folder / "out" / "a.txt"), "old");
}

TEST(OutputFolder, ReplacesItsOwnKindAndEmptyFoldersAndLinksToThem) {
    const Folder folder;
    fill(folder / "out", "old");
    fill(folder / "out/", "new");
    EXPECT_EQ(bytes_of(folder / "out" / "a.txt"), "new");
    fs::create_directory(folder / "empty");
    fs::create_directory_symlink("empty", folder / "link");
    fill(folder / "link", "linked");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(bytes_of(folder / "empty" / "a.txt"), "linked");
}

TEST(OutputFolder, IsWholeWhicheverProcessIsLast) {
    const Folder folder;
    std::vector<pid_t> children;
    for (int i = 0; i < 8; ++i) {
        children.push_back(::fork());
        if (children.back() != 0) continue;
        try {
            for (int round = 0; round < 20; ++round) fill(folder / "out", std::to_string(i));
        } catch (const Error&) {
            ::_exit(1);
        }
        ::_exit(0);
    }
    for (const pid_t child : children) {
        int status = 0;
        ::waitpid(child, &status, 0);
        EXPECT_EQ(status, 0);
    }
    EXPECT_EQ(folder.names(), std::vector<std::string>{"out"});
    EXPECT_EQ(bytes_of(folder / "out" / "a.txt").size(), 1u);
}

TEST(OutputFolder, RefusesWhatItMayNotReplace) {
    const Folder folder;
    fs::create_directory(folder / "mine");
    write_file(folder / "mine" / "thesis.txt", "mine");
    write_file(folder / "file", "mine");
    fs::create_directory(folder / "site");
    write_file(folder / "site" / "index.html", "mine");
    EXPECT_NE(refusal_of(folder / "site").find("has no a.txt"), std::string::npos);
    EXPECT_NE(refusal_of(folder / "mine").find("holds thesis.txt"), std::string::npos);
    EXPECT_NE(refusal_of(folder / "file").find("is not a folder"), std::string::npos);
    EXPECT_NE(refusal_of(folder / "missing" / "out").find("does not exist"), std::string::npos);
    EXPECT_EQ(refusal_of(folder / "out"), "");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"file", "mine", "site"}));
}

TEST(Reduced, SquaresBecomeTheirMeanToNearest) {
    const Picture small =
        downscaled({.width = 3, .height = 2, .channels = 1, .values = {0, 1, 7, 2, 4, 8}}, 2);
    EXPECT_EQ(small.width, 2);
    EXPECT_EQ(small.height, 1);
    EXPECT_EQ(small.values, (std::vector<std::uint16_t>{2, 8}));  // 7/4 and 15/2
}

}  // namespace gw::image
