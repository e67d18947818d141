// --translucency, --shadow and --counters of gw render.
#include "tests/apps/scene_files.h"

#include <nlohmann/json.hpp>

namespace gw::apps {

/// A lamp over a white floor, two panes of glass that cross each other, and a box that casts a
/// shadow.
class EffectOptions : public SceneTest {
protected:
    EffectOptions() {
        write("panes.toml", R"([camera]
eye = [0, 3, 5]
[[light]]
name = "lamp"
position = [1, 6, 2]
Ia = 0.2
shadow = "volume"
[[light]]
name = "sky"
direction = [0, -1, 0]
[[object]]
shape = "rectangle"
width = 6
depth = 6
[[object]]
shape = "box"
translate = [-1, 0.5, 0]
[[object]]
shape = "rectangle"
rotate = [80, 30, 0]
translate = [1, 0.6, 0]
material = {Kd = [1, 0, 0], d = 0.5}
[[object]]
shape = "rectangle"
rotate = [80, -50, 0]
translate = [1, 0.6, 0]
material = {Kd = [0, 0, 1], d = 0.5}
)");
    }
    std::string picture(std::vector<std::string> options) const {
        options.insert(options.begin(), {"render", "panes.toml", "-o", "a.png", "--size", "64x48"});
        const Outcome outcome = gw(options);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return bytes_of(in("a.png"));
    }
};

TEST_F(EffectOptions, TranslucencyChangesWherePanesCross) {
    const std::string sorted = picture({"--translucency", "sorted"}),
                      layers = picture({"--translucency", "layers"});
    EXPECT_EQ(picture({}), sorted);
    EXPECT_NE(layers, sorted);
    EXPECT_NE(picture({"--translucency", "unsorted"}), layers);
}

TEST_F(EffectOptions, ShadowReplacesTheKindOfLightsThatCastOne) {
    const auto ran = [&](const std::string& kind, const std::string& pass) {
        picture({"--shadow", kind, "--counters", "c.json"});
        const auto json = nlohmann::json::parse(bytes_of(in("c.json")));
        for (const auto& total : json["by_name"])
            if (total["name"] == pass) return true;
        return false;
    };
    EXPECT_TRUE(ran("volume", "shadow lamp"));
    EXPECT_FALSE(ran("volume", "light Z"));
    EXPECT_TRUE(ran("map", "light Z"));
    EXPECT_FALSE(ran("none", "shadow lamp"));
    EXPECT_FALSE(ran("map", "shadow sky"));
}

TEST_F(EffectOptions, CountersAddUp) {
    picture({"--samples", "4", "--counters", "c.json"});
    const auto json = nlohmann::json::parse(bytes_of(in("c.json")));
    int runs = 0;
    std::uint64_t written = 0;
    for (const auto& total : json["by_name"]) {
        runs += total["runs"].get<int>();
        written += total["counters"]["written"].get<std::uint64_t>();
        if (total["name"] == "diffuse sky") {
            EXPECT_EQ(total["runs"], 4);
        }
    }
    EXPECT_EQ(json["passes"], runs);
    EXPECT_EQ(json["sum"]["written"], written);
    EXPECT_GT(written, 0u);
}

TEST_F(EffectOptions, AreCheckedBeforeAnythingIsDrawn) {
    expect_refused(2, {"render", "panes.toml", "-o", "a.png", "--translucency", "glass"},
                   {"--translucency 'glass'", "sorted, unsorted, layers"});
    expect_refused(2, {"render", "panes.toml", "-o", "a.png", "--shadow", "soft"},
                   {"--shadow 'soft'", "none, volume, map"});
    expect_refused(2, {"render", "panes.toml", "-o", "a.png", "--counters", "a.png"},
                   {"--counters and --output are the same file"});
    expect_refused(1, {"render", "panes.toml", "-o", "a.png", "--counters", "missing/c.json"},
                   {"missing does not exist"});
    expect_refused(2, {"hidden", "panes.toml", "--shadow", "map"}, {"unknown option '--shadow'"});
}

}  // namespace gw::apps
