// The commands in README.md work as they stand there, and those in these pages of docs/: commands,
// many_machines, hiddensurfaces, step_logs, exercises, recordings, conformance, lecture.
#include "test_paths.h"
#include "tests/apps/support/examples.h"

namespace gw::apps {

using Documents = ExampleTest;

namespace {

/// tests/view runs it.
bool waits_for_a_user(const std::string& command) {
    return command.find("gw view ") != command.npos;
}

}  // namespace

TEST_F(Documents, ReadmesTourWorks) {
    auto commands = examples(bytes_of(GW_SOURCE_DIR "/README.md"));
    std::erase_if(commands, waits_for_a_user);
    EXPECT_GE(commands.size(), 5u);
    expect_to_work(commands);
}

TEST_F(Documents, CommandReferenceWorks) {
    auto commands = examples(bytes_of(GW_SOURCE_DIR "/docs/commands.md"));
    std::erase_if(commands, waits_for_a_user);
    EXPECT_GE(commands.size(), 5u);
    expect_to_work(commands);
}

TEST_F(Documents, ManyMachinesCommandsWork) {
    const auto commands = examples(bytes_of(GW_SOURCE_DIR "/docs/many_machines.md"));
    EXPECT_GE(commands.size(), 5u);
    expect_to_work(commands);
}

/// With the study stopped where a run would take longer than a thousandth of a second.
TEST_F(Documents, HiddenSurfacesCommandsWork) {
    auto commands = examples(bytes_of(GW_SOURCE_DIR "/docs/hiddensurfaces.md"));
    EXPECT_GE(commands.size(), 2u);
    for (std::string& command : commands)
        if (command.find(" study hidden ") != command.npos)
            command += " --limit 0.001 --axis polygons";
    expect_to_work(commands);
    EXPECT_FALSE(bytes_of(in("growth/growth.csv")).empty());
}

/// With the steps that the page shows, which are right.
TEST_F(Documents, StepLogsCommandsWork) {
    const std::string page = bytes_of(GW_SOURCE_DIR "/docs/step_logs.md");
    std::string steps;
    for (const std::string& step : examples(page, "{\"kind\"")) steps += step + "\n";
    write("steps.jsonl", steps);
    const auto commands = examples(page);
    EXPECT_GE(commands.size(), 5u);
    expect_to_work(commands);
}

/// With the answers that the page shows, which are right.
TEST_F(Documents, ExercisesCommandsWork) {
    const std::string page = bytes_of(GW_SOURCE_DIR "/docs/exercises.md");
    write("answers.json", examples(page, "{\"seed\"").at(0));
    const auto commands = examples(page);
    EXPECT_GE(commands.size(), 5u);
    expect_to_work(commands);
    EXPECT_NE(bytes_of(in("truth.csv")).find("\n"), std::string::npos);
}

/// But for the goldens, which test_golden.cpp verifies.
TEST_F(Documents, RecordingsCommandsWork) {
    auto commands = examples(bytes_of(GW_SOURCE_DIR "/docs/recordings.md"));
    std::erase_if(commands, [](const std::string& command) {
        return command.find(" golden ") != command.npos;
    });
    EXPECT_GE(commands.size(), 5u);
    expect_to_work(commands);
}

TEST_F(Documents, ConformanceCommandsWork) {
    const auto commands = examples(bytes_of(GW_SOURCE_DIR "/docs/conformance.md"));
    EXPECT_GE(commands.size(), 5u);
    expect_to_work(commands);
}

struct Lecture : ExampleTest {
    static std::vector<std::string> commands(const std::string& page) {
        return examples(bytes_of(std::string(GW_SOURCE_DIR "/docs/") + page), "gw ");
    }
    /// Every third command, from `first`: they are independent, and all in one test take long. They
    /// need the PATH that the page sets.
    void expect_every_third_to_work(std::size_t first) const {
        std::vector<std::string> some;
        const auto all = commands("lecture.md");
        for (std::size_t i = first; i < all.size(); i += 3)
            some.push_back("PATH=$PWD/build/release/bin:$PATH; " + all[i]);
        EXPECT_GE(some.size(), 6u);
        write("class/made", "");  // by mkdir on the page
        expect_to_work(some);
    }
};

TEST_F(Lecture, HasTheSameCommandsInBothLanguages) {
    EXPECT_EQ(commands("lecture.ja.md"), commands("lecture.md"));
}
TEST_F(Lecture, FirstThirdOfItsCommandsWorks) { expect_every_third_to_work(0); }
TEST_F(Lecture, SecondThirdOfItsCommandsWorks) { expect_every_third_to_work(1); }
TEST_F(Lecture, LastThirdOfItsCommandsWorks) { expect_every_third_to_work(2); }

}  // namespace gw::apps
