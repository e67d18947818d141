// gw inspect: a report is there whole or not at all, of every kind of recording; and what is wrong
// is one line. What the page does is tested by web/tests/browser.
#include "inspect/report/embedded.h"

#include "tests/apps/scene_files.h"
#include "tests/apps/support/examples.h"

#include <nlohmann/json.hpp>

namespace gw::apps {

namespace fs = std::filesystem;

class Inspect : public SceneTest {
protected:
    Inspect() { EXPECT_EQ(record("t.gwt"), 0); }

    int record(const std::string& file, std::vector<std::string> more = {}) const {
        std::vector<std::string> words{"record", "lamps.toml", "-o", file, "--size", "16x16"};
        words.insert(words.end(), more.begin(), more.end());
        return gw(words).code;
    }
    Outcome inspect(std::vector<std::string> arguments, Surroundings surroundings = {}) const {
        arguments.insert(arguments.begin(), "inspect");
        return gw(std::move(arguments), std::move(surroundings));
    }
    nlohmann::json report(const std::string& folder) const {
        const std::string text = bytes_of(in(folder + "/data.js")), begin = "gw_report(";
        return nlohmann::json::parse(text.substr(begin.size(), text.rfind(')') - begin.size()));
    }
};

TEST_F(Inspect, MakesAFolderWithAPageAndSaysWhatIsInIt) {
    const Outcome outcome = inspect({"t.gwt", "-o", "r"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const bool page = !report::embedded("report.html").empty();  // a build without npm has none
    EXPECT_TRUE(outcome.out.starts_with(page ? "r/index.html\n" : "r/data.js\n")) << outcome.out;
    EXPECT_NE(outcome.out.find(" MB, pixel histories of passes 0-"), std::string::npos)
        << outcome.out;
    auto files = names("r");
    EXPECT_EQ(std::erase(files, "index.html"), page ? 1u : 0u);
    EXPECT_EQ(files, (std::vector<std::string>{"data.js", "history", "pictures"}));
    EXPECT_EQ(names("r/history"), std::vector<std::string>{"0_0.js"});
}

TEST_F(Inspect, CountersAreThoseOfGwPasses) {
    ASSERT_EQ(inspect({"t.gwt", "-o", "r"}).code, 0);
    const auto passes =
        nlohmann::json::parse(gw({"passes", "lamps.toml", "--size", "16x16", "--json"}).out);
    const auto shown = report("r");
    ASSERT_EQ(shown["passes"].size(), passes["passes"].size());
    for (std::size_t i = 0; i < shown["passes"].size(); ++i)
        for (const char* name : {"name", "set", "counters", "estimated_seconds"})
            EXPECT_EQ(shown["passes"][i][name], passes["passes"][i][name]) << i << " " << name;
}

TEST_F(Inspect, TheCommandOnThePageMakesThePageAgain) {
    ASSERT_EQ(
        inspect({"t.gwt", "-o", "r", "--passes", "1-3", "--history", "2-2", "--lang", "ja"}).code,
        0);
    const auto shown = report("r");
    EXPECT_EQ(shown["command"],
              "build/release/bin/gw inspect t.gwt -o r --passes 1-3 --history 2-2 --lang ja");
    EXPECT_EQ(shown["language"], "ja");
    EXPECT_EQ(shown["passes"].size(), 3u);
    EXPECT_EQ(shown["history"], (nlohmann::json{{"first", 2}, {"last", 2}}));
}

TEST_F(Inspect, HiddenSurfaceRunsToo) {
    for (const std::string name : {"painter-centroid", "newell", "z-buffer", "scan-line"}) {
        ASSERT_EQ(record("h.gwt", {"--algorithm", name}), 0);
        EXPECT_EQ(inspect({"h.gwt", "-o", "h"}).code, 0) << name;
        EXPECT_EQ(report("h")["renderer"], name);
    }
}

TEST_F(Inspect, AHiddenSurfaceRunHasAPassForEachThingDrawn) {
    const auto names_by = [&](const std::string& algorithm) {
        EXPECT_EQ(record("h.gwt", {"--algorithm", algorithm}), 0);
        EXPECT_EQ(inspect({"h.gwt", "-o", "h"}).code, 0);
        const nlohmann::json shown = report("h");
        std::vector<std::string> names;
        for (const auto& pass : shown["passes"]) names.push_back(pass["name"]);
        return names;
    };
    const auto painted = names_by("painter-centroid");
    EXPECT_EQ(painted.front(), "painter's, centroid");
    ASSERT_GT(painted.size(), 1u);
    for (std::size_t i = 1; i < painted.size(); ++i)
        EXPECT_NE(painted[i].find("polygon "), std::string::npos) << painted[i];
    const auto scanned = names_by("scan-line");
    ASSERT_GT(scanned.size(), 3u);
    for (std::size_t i = 1; i < scanned.size(); ++i)
        EXPECT_TRUE(scanned[i].starts_with("row ")) << scanned[i];
    EXPECT_EQ(names_by("z-buffer"), std::vector<std::string>{"Z-buffer"});
}

TEST_F(Inspect, AnEarlierReportIsReplacedAndNothingElse) {
    ASSERT_EQ(inspect({"t.gwt", "-o", "r"}).code, 0);
    ASSERT_EQ(inspect({"t.gwt", "-o", "r", "--history", "none"}).code, 0);
    EXPECT_FALSE(fs::exists(in("r/history")));
    fs::create_directory(in("empty"));
    EXPECT_EQ(inspect({"t.gwt", "-o", "empty/"}).code, 0);
    write("r/thesis.txt", "mine");
    expect_refused(1, {"inspect", "t.gwt", "-o", "r"},
                   {"r: holds thesis.txt", "expected a new name"});
    EXPECT_EQ(bytes_of(in("r/thesis.txt")), "mine");
    expect_refused(1, {"inspect", "t.gwt", "-o", "t.gwt"}, {"t.gwt: is not a folder"});
    expect_refused(1, {"inspect", "t.gwt", "-o", "missing/r"}, {"missing does not exist"});
    expect_refused(2, {"inspect", "t.gwt", "-o", ""}, {"--output"});
}

TEST_F(Inspect, BadRecordingsAndOptionsAreRefusedWithOneLine) {
    write("short.gwt", bytes_of(in("t.gwt")).substr(0, 2000));
    write("empty.gwt", "");
    expect_refused(1, {"inspect", "missing.gwt", "-o", "r"}, {"missing.gwt", "cannot be opened"});
    expect_refused(1, {"inspect", "short.gwt", "-o", "r"}, {"short.gwt", "cut short or damaged"});
    expect_refused(1, {"inspect", "empty.gwt", "-o", "r"}, {"empty.gwt", "not a recording"});
    expect_refused(1, {"inspect", "t.gwt", "-o", "r", "--passes", "0-99"},
                   {"0-99", "expected passes of 0-"});
    expect_refused(2, {"inspect", "t.gwt", "-o", "r", "--passes", "0-1000"},
                   {"--passes 0-1000", "at most 1000"});
    expect_refused(2, {"inspect", "t.gwt", "-o", "r", "--passes", "3-1"},
                   {"--passes '3-1'", "A-B"});
    expect_refused(2, {"inspect", "t.gwt", "-o", "r", "--history", "some"}, {"--history 'some'"});
    expect_refused(2, {"inspect", "t.gwt", "-o", "r", "--passes", "1-2", "--history", "0-1"},
                   {"0-1"});
    expect_refused(2, {"inspect", "t.gwt", "-o", "r", "--lang", "de"}, {"--lang 'de'", "en, ja"});
    expect_refused(2, {"inspect", "t.gwt", "-o", "r", "--limit", "0"}, {"--limit '0'"});
    write("p.toml", "machine = \"m\"\n");
    expect_refused(1, {"inspect", "t.gwt", "-o", "r", "--prices", "p.toml"},
                   {"p.toml", "no prices"});
}

TEST_F(Inspect, WhatCannotBeWrittenLeavesNothing) {
    ASSERT_EQ(inspect({"t.gwt", "-o", "old"}).code, 0);
    const std::string before = bytes_of(in("old/data.js"));
    expect_refused(1, {"inspect", "t.gwt", "-o", "old"}, {"old/", "cannot be written"},
                   {.largest_file = 2000});
    EXPECT_EQ(bytes_of(in("old/data.js")), before);
    ASSERT_EQ(gw({"record", "lamps.toml", "-o", "big.gwt", "--size", "400x400"}).code, 0);
    expect_refused(1, {"inspect", "big.gwt", "-o", "r", "--limit", "1"},
                   {"the report needs more than 1 MB", "--passes A-B", "--limit"});
}

TEST_F(Inspect, InterruptedLeavesNothing) {
    // Far more work than half a second, so that the signal arrives while files are written.
    ASSERT_EQ(
        gw({"record", "lamps.toml", "-o", "long.gwt", "--size", "512x512", "--samples", "64"}).code,
        0);
    const auto before = names();
    const Outcome outcome = inspect({"long.gwt", "-o", "r"}, {.interrupt_after_ms = 700});
    EXPECT_EQ(outcome.code, 130);
    EXPECT_EQ(names(), before);
}

class InspectRadiosity : public ExampleTest {};

TEST_F(InspectRadiosity, RunsToo) {
    ASSERT_EQ(gw({"radiosity", "scenes/radiosity/cornell.toml", "-o", "box", "--shots", "1",
                  "--hemicube", "16", "--size", "32x24", "--record"})
                  .code,
              0);
    for (const std::string name : {"hemicubes", "pictures"}) {
        const Outcome outcome = gw({"inspect", "box/" + name + ".gwt", "-o", name});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_TRUE(fs::exists(in(name + "/pictures/0000_color.png"))) << name;
    }
}

}  // namespace gw::apps
