// The commands in README.md, docs/commands.md and docs/lecture.md work as they stand there.
#include "examples.h"

namespace gw::apps {

using Documents = ExampleTest;

TEST_F(Documents, ReadmesTourWorks) {
    const auto commands = examples(bytes_of(GW_SOURCE_DIR "/README.md"));
    EXPECT_GE(commands.size(), 5u);
    expect_to_work(commands);
}

TEST_F(Documents, CommandReferenceWorks) {
    const auto commands = examples(bytes_of(GW_SOURCE_DIR "/docs/commands.md"));
    EXPECT_GE(commands.size(), 5u);
    expect_to_work(commands);
}

// They need the PATH that the page sets.
TEST_F(Documents, LectureWorksAndIsTheSameInBothLanguages) {
    auto commands = examples(bytes_of(GW_SOURCE_DIR "/docs/lecture.md"), "gw ");
    EXPECT_EQ(examples(bytes_of(GW_SOURCE_DIR "/docs/lecture.ja.md"), "gw "), commands);
    EXPECT_GE(commands.size(), 15u);
    for (std::string& command : commands) command = "PATH=$PWD/build/release/bin:$PATH; " + command;
    expect_to_work(commands);
}

}  // namespace gw::apps
