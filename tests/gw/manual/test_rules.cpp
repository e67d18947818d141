// The rules of docs/manual.md and the tests that cite them: "[R6.12]" in a comment or a name.
#include "test_paths.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace gw {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    std::ifstream in(file);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
}

std::vector<fs::path> files_below(const char* folder, const std::set<std::string>& extensions) {
    std::vector<fs::path> out;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(GW_SOURCE_DIR) / folder))
        if (extensions.contains(entry.path().extension().string())) out.push_back(entry.path());
    std::sort(out.begin(), out.end());
    return out;
}

std::vector<fs::path> pages() {
    std::vector<fs::path> out = files_below("docs/manual", {".md"});
    out.push_back(fs::path(GW_SOURCE_DIR) / "docs/recordings.md");
    out.push_back(fs::path(GW_SOURCE_DIR) / "docs/manual.md");
    return out;
}

std::vector<std::string> all_matches(const std::string& text, const char* pattern) {
    std::vector<std::string> out;
    const std::regex expression(pattern, std::regex::ECMAScript | std::regex::multiline);
    for (auto i = std::sregex_iterator(text.begin(), text.end(), expression);
         i != std::sregex_iterator(); ++i)
        out.push_back((*i)[1]);
    return out;
}

/// How often each rule is declared: "**[R6.12]**" at the start of a line.
std::map<std::string, int> declared() {
    std::map<std::string, int> out;
    for (const fs::path& page : pages()) {
        if (page.filename() == "manual.md") continue;
        for (const std::string& rule : all_matches(text_of(page), R"(^\*\*\[(R\d+\.\d+)\]\*\*)"))
            out[rule] += 1;
    }
    return out;
}

/// Rules that a test cites, with the files that do.
std::map<std::string, std::set<std::string>> cited() {
    std::map<std::string, std::set<std::string>> out;
    for (const fs::path& file : files_below("tests", {".cpp", ".h"}))
        for (const std::string& rule : all_matches(text_of(file), R"(\[(R\d+\.\d+)\])"))
            if (file.filename() != "test_rules.cpp") out[rule].insert(file.filename());
    return out;
}

// Definitions that every test of arithmetic uses, and that no single test can check.
const std::set<std::string> uncited{
    "R1.1",  // the definition of a machine
    "R2.2",  // notation: the order of operations
    "R2.3",  // notation: float32
    "R2.4",  // notation: integers
    "R2.9",  // a table of formats: each is checked with the stage that makes it
};

TEST(Manual, EveryRuleIsDeclaredOnce) {
    const auto rules = declared();
    EXPECT_GE(rules.size(), 150u);
    for (const auto& [rule, times] : rules) EXPECT_EQ(times, 1) << rule;
}

TEST(Manual, RulesOfAPageAreNumberedFromOne) {
    const auto rules = declared();
    std::map<int, std::set<int>> chapters;
    for (const auto& [rule, times] : rules) {
        const std::size_t dot = rule.find('.');
        chapters[std::stoi(rule.substr(1, dot - 1))].insert(std::stoi(rule.substr(dot + 1)));
    }
    for (const auto& [chapter, numbers] : chapters)
        EXPECT_EQ(*numbers.rbegin(), int(numbers.size())) << "chapter " << chapter;
}

TEST(Manual, TheTableOfChaptersHasEverySection) {
    const std::string table = text_of(fs::path(GW_SOURCE_DIR) / "docs/manual.md");
    for (const auto& entry : fs::directory_iterator(fs::path(GW_SOURCE_DIR) / "docs/manual"))
        for (const std::string& section : all_matches(text_of(entry.path()), R"(\n## ([^\n]+))"))
            EXPECT_NE(table.find("[" + section + "](manual/" + entry.path().filename().string()),
                      table.npos)
                << entry.path().filename() << ": " << section;
}

TEST(Manual, PagesNameRulesThatExist) {
    const auto rules = declared();
    for (const fs::path& page : pages())
        for (const std::string& rule : all_matches(text_of(page), R"(\b(R\d+\.\d+)\b)"))
            EXPECT_TRUE(rules.contains(rule)) << page.filename() << ": " << rule;
}

TEST(Manual, SourcesNameRulesThatExist) {
    const auto rules = declared();
    for (const char* folder : {"gw", "inspect", "conformance", "tests"})
        for (const fs::path& file : files_below(folder, {".cpp", ".h"}))
            for (const std::string& rule : all_matches(text_of(file), R"(\[(R\d+\.\d+)\])"))
                EXPECT_TRUE(rules.contains(rule) || file.filename() == "test_rules.cpp")
                    << file << ": " << rule;
}

TEST(Manual, EveryRuleIsCitedByATest) {
    const auto citations = cited();
    for (const auto& [rule, times] : declared())
        EXPECT_TRUE(citations.contains(rule) || uncited.contains(rule))
            << rule << ": no test cites it";
    for (const std::string& rule : uncited) {
        EXPECT_TRUE(declared().contains(rule)) << rule << " is no rule";
        EXPECT_FALSE(citations.contains(rule)) << rule << " is cited: take it off the list";
    }
}

}  // namespace
}  // namespace gw
