// Claim: no option takes an empty word, as an unset variable of a shell gives it, for an option that
// was not given, nor '-' for a file of that name. The options are those of each command's help.
#include "tests/apps/support/command_test.h"

#include <regex>
#include <sstream>

namespace gw::apps {
namespace {

struct HelpLines {
    std::vector<std::string> commands, positionals, options;
};

HelpLines lines_of(const std::string& help) {
    HelpLines found;
    std::vector<std::string>* part = nullptr;
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);) {
        if (line == "Positionals:")
            part = &found.positionals;
        else if (line == "Subcommands:")
            part = &found.commands;
        else if (line == "Options:")
            part = &found.options;
        else if (line.substr(0, 2) != "  ")
            part = nullptr;
        else if (part != nullptr && line[2] != ' ')
            part->push_back(line);
    }
    return found;
}

std::string first_word(const std::string& line) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    return word;
}

bool is_required(const std::string& line) { return line.find(" REQUIRED") != line.npos; }

/// "--planes" of "  --planes DIR  ...", "" of an option without a value.
std::string option_with_value(const std::string& line) {
    static const std::regex pattern("^  (?:-\\w,)?(--?[\\w-]+) (?!Excludes:|Needs:)\\S.*");
    std::smatch found;
    return std::regex_match(line, found, pattern) ? found[1].str() : "";
}

/// What a positional argument takes.
std::string word_for(const std::string& name) {
    if (name == "STUDY") return "precision";
    return name == "X" || name == "Y" ? "1" : "file";
}

class EmptyValues : public CommandTest {
protected:
    /// Returns the number of options tried.
    int expect_all_refused(const std::vector<std::string>& command) {
        std::vector<std::string> words = command;
        words.push_back("--help");
        const HelpLines help = lines_of(gw(words).out);
        int tried = 0;
        for (const std::string& line : help.options) {
            const std::string option = option_with_value(line);
            if (option.empty()) continue;
            // Blanks are one rule for all options: a command's first stands for the others.
            std::vector<std::string> values{"", "-"};
            if (tried == 0) values.insert(values.end(), {" ", "\t "});
            for (const std::string& value : values) {
                words = command;
                for (const std::string& other : help.positionals)
                    if (is_required(other)) words.push_back(word_for(first_word(other)));
                for (const std::string& other : help.options)
                    if (is_required(other) && option_with_value(other) != option)
                        words.insert(words.end(), {option_with_value(other), "x.png"});
                words.insert(words.end(), {option, value});
                SCOPED_TRACE(testing::PrintToString(words));
                expect_refused(2, words, {option});
            }
            ++tried;
        }
        for (const std::string& line : help.commands) {
            std::vector<std::string> inner = command;
            inner.push_back(first_word(line));
            tried += expect_all_refused(inner);
        }
        return tried;
    }
};

TEST_F(EmptyValues, AreUsageErrorsOfEveryOptionOfEveryCommand) {
    EXPECT_GT(expect_all_refused({}), 100);
}

TEST_F(EmptyValues, AreLeftToTheProgramThatIsRun) {
    EXPECT_EQ(gw({"gl", "--", "test", "", "=", ""}).code, 0);
    EXPECT_EQ(gw({"gl", "--", "test", "-", "!=", ""}).code, 0);
    expect_refused(2, {"gl", "--", ""}, {"PROGRAM"});
}

}  // namespace
}  // namespace gw::apps
