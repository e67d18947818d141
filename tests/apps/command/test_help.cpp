// gw --help and the help of every command: it has an example, and the example works.
#include "tests/apps/support/examples.h"

#include <sstream>

namespace gw::apps {

using Help = ExampleTest;

namespace {

/// The first words of the lines after "Subcommands:".
std::vector<std::string> commands_of(const std::string& help) {
    std::vector<std::string> commands;
    std::istringstream lines(help.substr(help.find("Subcommands:")));
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line) && line.substr(0, 2) == "  ") {
        std::istringstream words(line);
        std::string word;
        words >> word;
        commands.push_back(word);
    }
    return commands;
}

}  // namespace

TEST_F(Help, OfEveryCommandHasAnExampleThatWorks) {
    const Outcome all = gw({"--help"});
    EXPECT_EQ(all.code, 0);
    expect_to_work(examples(all.out));
    const std::vector<std::string> commands = commands_of(all.out);
    EXPECT_GE(commands.size(), 3u);
    for (const std::string& command : commands) {
        const Outcome help = gw({command, "--help"});
        EXPECT_EQ(help.code, 0);
        EXPECT_EQ(examples(help.out).size(), 1u) << command;
        if (command == "view") continue;  // waits for a user: tests/view
        expect_to_work(examples(help.out));
    }
}

TEST_F(Help, NamesEveryExitCode) {
    EXPECT_NE(gw({"--help"}).out.find("0 done, 1 "), std::string::npos);
}

TEST_F(Help, VersionIsOneLine) {
    const Outcome outcome = gw({"--version"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.out.substr(0, 3), "gw ");
    EXPECT_EQ(outcome.out.find('\n'), outcome.out.size() - 1);
}

}  // namespace gw::apps
