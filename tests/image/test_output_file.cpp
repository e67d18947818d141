// A file is there whole or as it was before.
#include "gw/error.h"
#include "image/output/output_file.h"

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
