// gw info, and words that gw does not know.
#include "tests/apps/support/command_test.h"

#include "gw/profile.h"

#include <nlohmann/json.hpp>

namespace gw::apps {

using Info = CommandTest;
using Usage = CommandTest;

TEST_F(Info, NamesEveryProfile) {
    const Outcome outcome = gw({"info"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "");
    for (const Profile& profile : profiles())
        EXPECT_NE(outcome.out.find(profile.name), std::string::npos);
}

TEST_F(Info, AsJsonHasTheProfilesBits) {
    const Outcome outcome = gw({"info", "--json"});
    EXPECT_EQ(outcome.code, 0);
    const auto json = nlohmann::json::parse(outcome.out);
    ASSERT_EQ(json["profiles"].size(), 4u);
    EXPECT_EQ(json["profiles"][0]["name"], "vgx");
    EXPECT_EQ(json["profiles"][1]["color_bits"], 12);
    EXPECT_EQ(json["profiles"][2]["subpixel_bits"], 8);
    EXPECT_EQ(json["profiles"][1]["extensions"]["shadow_texture"], true);
}

TEST_F(Info, ReportsAFullDiskBehindStandardOutput) {
    expect_refused(1, {"info"}, {"standard output: cannot be written: No space left on device"},
                   {.stdout_file = "/dev/full"});
}

TEST_F(Usage, SuggestsTheNearestCommandAndOption) {
    expect_refused(2, {"inof"}, {"unknown command 'inof'", "'info'"});
    expect_refused(2, {"rendr", "a.obj", "-o", "a.png"}, {"unknown command 'rendr'", "'render'"});
    expect_refused(2, {"info", "--jsn"}, {"unknown option '--jsn'", "'--json'"});
    expect_refused(2, {"info", "--jsn=1"}, {"unknown option '--jsn'", "'--json'"});
    expect_refused(2, {"--verison"}, {"unknown option '--verison'", "'--version'"});
    expect_refused(2, {"info", "word"}, {"unexpected word 'word'", "gw info --help"});
    expect_refused(2, {}, {"no command", "gw --help"});
}

}  // namespace gw::apps
