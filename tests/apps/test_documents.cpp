// The commands in README.md and docs/commands.md work as they stand there.
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

}  // namespace gw::apps
