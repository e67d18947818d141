// gw conformance: files that gw verify takes, on the fast machine too; small, and for every rule.
#include "conformance/suite.h"
#include "inspect/compare/verify.h"
#include "test_paths.h"
#include "tests/apps/support/command_test.h"

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

namespace gw::apps {

using Conformance = CommandTest;

TEST_F(Conformance, FilesVerifyOnBothMachines) {
    ASSERT_EQ(gw({"conformance", "some", "--only", "blocks", "--only", "fog", "--values"}).code, 0);
    for (const char* name : {"some/blocks_01", "some/fog_01"}) {
        const std::string file = name;
        const Outcome outcome = gw({"verify", file + ".gwt", file + ".json", "--machine", "both"});
        EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    }
    EXPECT_TRUE(std::filesystem::exists(in("some/fog_02.values")));
    EXPECT_FALSE(std::filesystem::exists(in("some/clip_01.gwt")));
}

TEST_F(Conformance, RefusesWhatItDoesNotKnow) {
    expect_refused(2, {"conformance", "some", "--only", "nothing"}, {"--only nothing", "--list"});
    expect_refused(2, {"conformance"}, {"DIR is missing"});
    EXPECT_FALSE(std::filesystem::exists(in("some")));
}

TEST_F(Conformance, ListsItsGroups) {
    const Outcome outcome = gw({"conformance", "--list"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_NE(outcome.out.find("polygons"), std::string::npos);
    EXPECT_NE(outcome.out.find("R7.1-R7.9"), std::string::npos);
}

TEST_F(Conformance, TheSuiteIsSmallerThan16MB) {
    ASSERT_EQ(gw({"conformance", "all"}).code, 0);
    std::uintmax_t bytes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(in("all")))
        bytes += entry.file_size();
    EXPECT_LT(bytes, 16u * 1024 * 1024);
}

TEST(ConformanceSuite, TheFastMachineAgreesWithTheReferenceMachine) {
    for (const conformance::Group& group : conformance::groups())
        for (const conformance::Member& member : conformance::members(group)) {
            const auto finding = compare_machines(member.recording, inspect::maker_of("reference"),
                                                  inspect::maker_of("fast"));
            ASSERT_FALSE(finding) << member.name << ": " << text(*finding, member.recording.height);
        }
}

/// Rules that no recording can show, with the reason.
const std::set<std::string> without_recording{
    "R1.1",  "R1.2",           // what a machine is; its caller's modes
    "R1.4",  "R1.7", "R1.11",  // refusals
    "R5.7",  "R5.8",           // refusals
    "R10.7",                   // recordings hold no images that are resampled
    "R18.7",                   // they have one machine
};

TEST(ConformanceSuite, ReachesEveryRule) {
    std::set<std::string> reached = without_recording, declared;
    for (const conformance::Group& group : conformance::groups())
        for (const std::string& rule : rules_of(group)) reached.insert(rule);
    std::vector<std::filesystem::path> pages{GW_SOURCE_DIR "/docs/recordings.md"};
    for (const auto& entry : std::filesystem::directory_iterator(GW_SOURCE_DIR "/docs/manual"))
        pages.push_back(entry.path());
    const std::regex declaration(R"(\*\*\[(R\d+\.\d+)\]\*\*.*)");
    for (const auto& page : pages) {
        std::ifstream in(page);
        std::smatch match;
        for (std::string line; std::getline(in, line);)
            if (std::regex_match(line, match, declaration)) declared.insert(match[1]);
    }
    EXPECT_EQ(reached, declared);
}

}  // namespace gw::apps
