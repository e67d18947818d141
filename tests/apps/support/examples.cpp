#include "tests/apps/support/examples.h"

#include <sstream>

namespace gw::apps {

std::vector<std::string> ExampleTest::examples(const std::string& text,
                                               const std::string& command) {
    std::vector<std::string> found;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t first = line.find_first_not_of(' ');
        if (first != line.npos && first > 0 && line.substr(first, command.size()) == command) {
            found.push_back(line.substr(first));
        }
    }
    return found;
}

void ExampleTest::expect_to_work(const std::vector<std::string>& commands) const {
    for (const std::string& command : commands) {
        const Outcome outcome = run_process({"/bin/sh", "-c", command}, {.folder = in(".")});
        EXPECT_EQ(outcome.code, 0) << command << "\n" << outcome.err;
        EXPECT_EQ(outcome.err, "") << command;
    }
}

}  // namespace gw::apps
