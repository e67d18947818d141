// GW_SCREENSHOT's file is replaced whole, keeps its mode and is found through links.
#include "gl/record/whole_file.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace gw::gl {

namespace {

namespace fs = std::filesystem;

class WholeFile : public testing::Test {
protected:
    static std::string text_of(const fs::path& file) {
        std::ifstream in(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    std::ptrdiff_t count() const {
        return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
    }
    const TemporaryFolder temporary;
    const fs::path folder = temporary.path();
    const std::string file = (folder / "picture.ppm").string();
};

}  // namespace

TEST_F(WholeFile, IsReplacedAndKeepsItsMode) {
    EXPECT_EQ(write_whole_file(file, "one"), "");
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(write_whole_file(file, "two"), "");
    EXPECT_EQ(text_of(file), "two");
    EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(count(), 1);
}

TEST_F(WholeFile, IsFoundThroughLinks) {
    const std::string link = (folder / "link").string(), second = (folder / "second").string();
    fs::create_symlink("picture.ppm", link);
    fs::create_symlink("link", second);
    EXPECT_EQ(write_whole_file(second, "new"), "");
    EXPECT_EQ(write_whole_file(link, "newer"), "");
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_TRUE(fs::is_symlink(second));
    EXPECT_EQ(text_of(file), "newer");
    EXPECT_EQ(count(), 3);
}

TEST_F(WholeFile, StaysWhatItIsIfItIsNoRegularFile) {
    EXPECT_EQ(write_whole_file("/dev/null", "picture"), "");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    EXPECT_FALSE(write_whole_file(folder.string(), "picture").empty());
    EXPECT_TRUE(fs::is_directory(folder));
}

TEST_F(WholeFile, StaysAsItWasIfItCannotBeWritten) {
    EXPECT_EQ(write_whole_file(file, "one"), "");
    EXPECT_EQ(write_whole_file((folder / "none" / "picture").string(), "two"),
              "No such file or directory");
    EXPECT_EQ(write_whole_file("/dev/full", std::string(100000, 'x')), "No space left on device");
    EXPECT_EQ(count(), 1);
}

}  // namespace gw::gl
