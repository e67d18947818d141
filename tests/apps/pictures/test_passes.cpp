// gw passes: the parameter sets as the paper writes them.
#include "tests/apps/pictures.h"
#include "tests/apps/scene_files.h"

#include <nlohmann/json.hpp>

namespace gw::apps {

using Passes = SceneTest;

namespace {

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_F(Passes, AreWrittenAsThePaperWritesThem) {
    const Outcome outcome = gw({"passes", "lamps.toml", "--size", "16x16"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(
        contains(outcome.out,
                 "\nambient     (Ka=object, Kd=0, Ks=0, Ke=0, Map=ambient map); lights each; "));
    EXPECT_TRUE(
        contains(outcome.out,
                 "\ndiffuse     (Ka=0, Kd=object, Ks=0, Ke=0, Map=diffuse map); lights each; "));
    EXPECT_TRUE(
        contains(outcome.out,
                 "\nspecular    (Ka=0, Kd=0, Ks=object, Ke=0, Map=specular map); lights each; "));
}

TEST_F(Passes, ThatRanAreCountedLightByLight) {
    const std::string out = gw({"passes", "lamps.toml", "--size", "16x16"}).out;
    std::size_t at = 0;
    for (const char* name : {"\nran ", "\ndepth ", "\nambient lamp 1 ", "\ndiffuse lamp 1 ",
                             "\nspecular lamp 1 ", "\ndiffuse lamp 2 ", "\nspecular lamp 2 "}) {
        at = out.find(name, at);
        ASSERT_NE(at, std::string::npos) << name << out;
    }
    EXPECT_FALSE(contains(out, "ambient lamp 2"));  // its Ia is 0
}

TEST_F(Passes, OfTheHardwareRendererAreOne) {
    const Outcome outcome =
        gw({"passes", "lamps.toml", "--renderer", "hardware", "--json", "--size", "16x16"});
    const auto json = nlohmann::json::parse(outcome.out);
    ASSERT_EQ(json["passes"].size(), 1u);
    EXPECT_EQ(json["passes"][0]["set"],
              "(Ka=object, Kd=object, Ks=object, Ke=object, Map=object map)");
    EXPECT_EQ(json["passes"][0]["counters"]["written"], 64);
}

TEST_F(Passes, AsJsonAddUp) {
    const auto json =
        nlohmann::json::parse(gw({"passes", "lamps.toml", "--json", "--size", "16x16"}).out);
    std::uint64_t written = 0;
    for (const auto& pass : json["passes"])
        written += pass["counters"]["written"].get<std::uint64_t>();
    EXPECT_EQ(json["sum"]["written"], written);
    EXPECT_GT(written, 6 * 64u);
    EXPECT_EQ(json["list"].size(), 8u);
}

TEST_F(Passes, AsCsvHaveOneLineEach) {
    const Outcome csv = gw({"passes", "lamps.toml", "--csv", "--size", "16x16"});
    const auto json =
        nlohmann::json::parse(gw({"passes", "lamps.toml", "--json", "--size", "16x16"}).out);
    EXPECT_EQ(csv.out.substr(0, 27), "name,set,draws,vertices,pri");
    EXPECT_EQ(std::size_t(std::count(csv.out.begin(), csv.out.end(), '\n')),
              json["passes"].size() + 1);
    EXPECT_TRUE(contains(
        csv.out, "\"ambient lamp 1\",\"(Ka=object, Kd=0, Ks=0, Ke=0, Map=ambient map)\",1,4,"));
}

TEST_F(Passes, AsTomlAreAListThatDrawsTheSamePicture) {
    const Outcome toml = gw({"passes", "lamps.toml", "--toml"});
    EXPECT_EQ(toml.code, 0) << toml.err;
    write("own.toml", bytes_of(in("lamps.toml")) + toml.out);
    EXPECT_EQ(render({"lamps.toml", "-o", "a.png"}).code, 0);
    EXPECT_EQ(render({"own.toml", "-o", "b.png"}).err, "");
    EXPECT_EQ(bytes_of(in("a.png")), bytes_of(in("b.png")));
    EXPECT_EQ(gw({"passes", "own.toml", "--toml"}).out, toml.out);
}

TEST_F(Passes, OfTheSceneReplaceThoseOfMultipassOnly) {
    const std::string own =
        "[[pass]]\nname = 'flat'\nclear = ['color', 'depth', 'stencil']\nKe = [0, 1, 0]\n";
    write("own.toml", bytes_of(in("lamps.toml")) + own);
    EXPECT_TRUE(contains(gw({"passes", "own.toml", "--size", "16x16"}).out, "\nflat "));
    EXPECT_FALSE(contains(
        gw({"passes", "own.toml", "--size", "16x16", "--renderer", "hardware"}).out, "flat"));
    EXPECT_EQ(render({"own.toml", "-o", "own.png"}).code, 0);
    EXPECT_EQ(read_pixels(in("own.png")).at(8, 8), (std::vector<float>{0, 1, 0}));
}

TEST_F(Passes, ThatAreWrongAreOneLine) {
    write("bad.toml", bytes_of(in("lamps.toml")) + "[[pass]]\nname = 'a'\nlihgts = 'each'\n");
    expect_refused(1, {"render", "bad.toml", "-o", "bad.png"},
                   {"bad.toml:18: unknown key 'lihgts' in pass; the nearest known is 'lights'"});
}

TEST_F(Passes, InTwoFormsAtOnceAreRefused) {
    expect_refused(2, {"passes", "lamps.toml", "--csv", "--json"}, {"--csv", "--json"});
    expect_refused(2, {"passes", "lamps.toml", "--csv", "--toml"}, {"--csv", "--toml"});
}

}  // namespace gw::apps
