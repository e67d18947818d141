// Claims: files are read whole without their byte order mark, and names in files are found as
// people meant them.
#include "scene/text/text_file.h"

#include <gtest/gtest.h>

#include "tests/scene/folder.h"

#include <sys/stat.h>

namespace gw::scene {

TEST(ReadText, DropsTheByteOrderMark) {
    Folder folder;
    EXPECT_EQ(read_text(folder.write("a", "\xef\xbb\xbfv 1\n")), "v 1\n");
    EXPECT_EQ(read_text(folder.write("b", "")), "");
    const std::string long_text(200'001, 'x');
    EXPECT_EQ(read_text(folder.write("c", long_text)), long_text);
}

TEST(ReadText, ReadsLinesThatEndInCarriageReturns) {
    Folder folder;
    EXPECT_EQ(read_text(folder.write("a", "v 1\rv 2\r")), "v 1\nv 2\n");
    EXPECT_EQ(read_text(folder.write("b", "v 1\r\nv 2\r")), "v 1\r\nv 2\r");
}

TEST(ReadText, SaysWhyItCannot) {
    Folder folder;
    EXPECT_EQ(folder.error([&] { read_text(folder.path() / "no"); }),
              "no: cannot be opened: No such file or directory; expected a readable file");
    std::filesystem::create_directory(folder.path() / "d");
    EXPECT_EQ(folder.error([&] { read_text(folder.path() / "d"); }),
              "d: is a directory; expected a file");
    const auto utf16 = folder.write("u", std::string("\xff\xfev\0", 4));
    EXPECT_EQ(folder.error([&] { read_text(utf16); }), "u:1: is UTF-16; expected UTF-8 text");
}

TEST(ReadText, RefusesWhatHasNoEnd) {
    Folder folder;
    EXPECT_EQ(folder.error([&] { read_text("/dev/zero"); }),
              "/dev/zero: is a device or a pipe; expected a file");
    const std::filesystem::path pipe = folder.path() / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(folder.error([&] { read_text(pipe); }),
              "pipe: is a device or a pipe; expected a file");
    std::filesystem::create_symlink("/dev/zero", folder.path() / "link.mtl");
    EXPECT_EQ(folder.error([&] { read_text(folder.path() / "link.mtl"); }),
              "link.mtl: is a device or a pipe; expected a file");
}

TEST(ReadText, RefusesMoreThanItHolds) {
    Folder folder;
    const auto file = folder.write("large.obj", "");
    std::filesystem::resize_file(file, most_text + 1);  // a hole: takes no room on the disk
    EXPECT_EQ(folder.error([&] { read_text(file); }),
              "large.obj: has more than 2048 MB; expected less");
}

TEST(FindFile, TakesBackslashesQuotesAndBlanks) {
    Folder folder;
    const auto file = folder.write("my maps/red wood.png", "");
    EXPECT_EQ(find_file(folder.path(), "my maps\\red wood.png"), file);
    EXPECT_EQ(find_file(folder.path(), "\"my maps/red wood.png\""), file);
    EXPECT_EQ(find_file(folder.path() / "my maps", "..\\my maps\\.\\red wood.png"), file);
    EXPECT_EQ(find_file("elsewhere", file.string()), file);
}

TEST(FindFile, DisregardsCaseOnlyWhereItMust) {
    Folder folder;
    const auto lower = folder.write("maps/a.png", ""), upper = folder.write("maps/A.PNG", "");
    EXPECT_EQ(find_file(folder.path(), "maps/a.png"), lower);
    EXPECT_EQ(find_file(folder.path(), "MAPS/A.PNG"), upper);
    EXPECT_EQ(find_file(folder.path(), "Maps/A.png"), upper);  // the first in byte order
}

TEST(FindFile, FallsBackToTheLastPart) {
    Folder folder;
    const auto file = folder.write("wood.png", "");
    EXPECT_EQ(find_file(folder.path(), "C:\\Users\\me\\wood.png"), file);
    EXPECT_EQ(find_file(folder.path(), "/nowhere/Wood.PNG"), file);
    EXPECT_EQ(existing_file(folder.path(), "/nowhere/wood.png"), std::nullopt);
    EXPECT_EQ(find_file(folder.path(), "no\\such.png"), folder.path() / "no/such.png");
}

TEST(FindFile, TakesNoNameForItsBeginBeforeANul) {
    Folder folder;
    folder.write("a.obj", "");
    const std::string name("a.obj\0b", 7);
    EXPECT_FALSE(existing_file(folder.path(), name));
    EXPECT_EQ(file_fault(folder.path() / name), "does not exist");
}

}  // namespace gw::scene
