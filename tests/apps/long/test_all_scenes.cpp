// Every scene on every profile: what is recorded replays in another process to the same bits, on
// both machines.
#include "test_paths.h"
#include "tests/apps/support/command_test.h"

#include <algorithm>

namespace gw::apps {

class AllScenes : public CommandTest, public testing::WithParamInterface<std::string> {};

/// Without the price lists, which are no scenes.
std::vector<std::string> all_scenes() {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(GW_SOURCE_DIR "/scenes"))
        if (entry.path().extension() == ".toml" &&
            entry.path().parent_path().filename() != "prices")
            found.push_back(entry.path().string());
    std::sort(found.begin(), found.end());
    return found;
}

TEST_P(AllScenes, ReplayInAnotherProcessOnBothMachines) {
    for (const std::string profile : {"vgx", "reality", "ideal"}) {
        const Outcome recorded =
            gw({"record", GetParam(), "-o", "t.gwt", "--size", "32x24", "--profile", profile,
                "--manifest", "t.json", "--no-values", "--quiet"});
        ASSERT_EQ(recorded.code, 0) << recorded.err;
        const Outcome verified = gw({"verify", "t.gwt", "t.json", "--machine", "both"});
        EXPECT_EQ(verified.code, 0) << verified.out << verified.err;
        EXPECT_NE(verified.out.find("on reference and fast"), std::string::npos) << verified.out;
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, AllScenes, testing::ValuesIn(all_scenes()), [](const auto& test) {
    std::string name = std::filesystem::path(test.param).stem().string();
    if (test.param.find("/radiosity/") != std::string::npos) name = "radiosity_" + name;
    return name;
});

}  // namespace gw::apps
