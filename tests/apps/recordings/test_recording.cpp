// gw record, replay, pixel, maps: a picture's recording gives that picture in another process.
#include "inspect/recording/recording.h"
#include "tests/apps/pictures.h"
#include "tests/apps/scene_files.h"
#include "tests/apps/support/examples.h"

#include <sys/stat.h>

#include <nlohmann/json.hpp>

namespace gw::apps {

class Recordings : public SceneTest {
protected:
    Outcome record(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "record");
        arguments.insert(arguments.end(), {"--size", "16x16"});
        return gw(std::move(arguments));
    }
};

TEST_F(Recordings, ReplayToThePictureThatRenderDraws) {
    for (const std::string profile : {"vgx", "reality", "ideal"})
        for (const std::string samples : {"1", "3"}) {
            const std::vector<std::string> how{"--profile", profile, "--samples", samples};
            std::vector<std::string> r{"lamps.toml", "-o", "a.png"}, t{"lamps.toml", "-o", "t.gwt"};
            r.insert(r.end(), how.begin(), how.end());
            t.insert(t.end(), how.begin(), how.end());
            ASSERT_EQ(render(r).code, 0);
            ASSERT_EQ(record(t).code, 0);
            for (const std::string machine : {"fast", "reference", "both"}) {
                const Outcome outcome =
                    gw({"replay", "t.gwt", "--machine", machine, "-o", "b.png"});
                EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
                EXPECT_TRUE(bytes_of(in("a.png")) == bytes_of(in("b.png")))
                    << profile << " " << machine;
            }
        }
}

TEST_F(Recordings, NeedNothingOfTheirScene) {
    ASSERT_EQ(record({"lamps.toml", "-o", "t.gwt"}).code, 0);
    std::filesystem::remove(in("lamps.toml"));
    std::filesystem::remove(in("quad.obj"));
    EXPECT_EQ(gw({"replay", "t.gwt", "-o", "a.png", "--planes", "planes"}).code, 0);
    EXPECT_EQ(read_pixels(in("a.png")).width, 16);
    EXPECT_TRUE(std::filesystem::exists(in("planes/depth.exr")));
}

TEST_F(Recordings, AreStreamedWhileTheSceneIsDrawn) {
    ASSERT_EQ(record({"lamps.toml", "-o", "t.gwt"}).code, 0);
    ASSERT_EQ(record({"lamps.toml", "-o", "s.gwt", "--stream"}).code, 0);
    EXPECT_EQ(gw({"diff", "t.gwt", "s.gwt"}).code, 0);
    for (const std::string window : {"picture", "0"}) {
        const Outcome whole = gw({"replay", "s.gwt", "--window", window, "-o", "s.png"});
        EXPECT_EQ(whole.code, 0) << whole.err;
        EXPECT_EQ(whole.err, "");
    }
    ASSERT_EQ(gw({"replay", "t.gwt", "-o", "t.png"}).code, 0);
    EXPECT_TRUE(bytes_of(in("t.png")) == bytes_of(in("s.png")));
    expect_refused(1, {"replay", "s.gwt", "--window", "other"}, {"s.gwt", "'picture' (16 x 16)"});
    expect_refused(1, {"replay", "t.gwt", "--window", "other"}, {"t.gwt", "without a name"});
    expect_refused(2, {"record", "lamps.toml", "-o", "u.gwt", "--stream", "--manifest", "u.json"},
                   {"--stream", "--manifest"});
}

TEST_F(Recordings, AStreamThatIsCutShortIsUsedWithAWarning) {
    ASSERT_EQ(record({"lamps.toml", "-o", "s.gwt", "--stream", "--samples", "3"}).code, 0);
    const std::string bytes = bytes_of(in("s.gwt"));
    write("cut.gwt", bytes.substr(0, bytes.size() - 1));
    const Outcome cut = gw({"replay", "cut.gwt"});
    EXPECT_EQ(cut.code, 0) << cut.err;
    EXPECT_NE(cut.err.find("cut.gwt: cut short after part "), std::string::npos) << cut.err;
    EXPECT_EQ(cut.out, gw({"replay", "s.gwt"}).out);
    std::string damaged = bytes;
    damaged[bytes.size() / 2] = static_cast<char>(damaged[bytes.size() / 2] ^ 1);
    write("damaged.gwt", damaged);
    expect_refused(1, {"replay", "damaged.gwt"}, {"damaged.gwt", "part ", " is damaged"});
}

// Index 258 has 2 in R and 1 in G.
TEST_F(Recordings, OfIndicesReplayThroughTheirMap) {
    inspect::Recording r;
    r.width = 2;
    r.height = 1;
    r.lists.resize(1);
    r.lists[0].add(BeginPass{"frame 0"});
    r.lists[0].add(WritePixels{.rect = {0, 0, 2, 1}, .colors = {{37, 0, 0, 255}, {2, 1, 0, 255}}});
    inspect::ColorMap map{.bits = 12, .entries = std::vector<std::uint32_t>(4096)};
    map.entries[37] = 200 | 100 << 8 | 50 << 16;
    map.entries[258] = 1 | 2 << 8 | 3 << 16;
    r.color_maps = {map};
    const auto bytes = inspect::encode(r);
    write("i.gwt", {bytes.begin(), bytes.end()});
    const auto shown = [&](std::vector<std::string> more, int x) {
        more.insert(more.begin(), {"replay", "i.gwt", "-o", "i.png"});
        EXPECT_EQ(gw(more).code, 0);
        std::vector<int> bytes_of_pixel;
        for (const float value : read_pixels(in("i.png")).at(x, 0))
            bytes_of_pixel.push_back(int(value * 255 + 0.5f));
        return bytes_of_pixel;
    };
    EXPECT_EQ(shown({}, 0), (std::vector<int>{200, 100, 50}));
    EXPECT_EQ(shown({}, 1), (std::vector<int>{1, 2, 3}));
    EXPECT_EQ(shown({"--indices"}, 0), (std::vector<int>{37, 0, 0}));
    EXPECT_EQ(shown({"--indices"}, 1), (std::vector<int>{2, 1, 0}));
    EXPECT_NE(
        gw({"pixel", "i.gwt", "1", "0"}).out.find("index 0 > 258 through map entry 258 (1 2 3)"),
        std::string::npos);
    ASSERT_EQ(gw({"inspect", "i.gwt", "-o", "page"}).code, 0);
    ASSERT_EQ(gw({"replay", "i.gwt", "-o", "i.png"}).code, 0);
    EXPECT_EQ(read_pixels(in("page/pictures/0000_color.png")).at(1, 0),
              read_pixels(in("i.png")).at(1, 0));
}

TEST_F(Recordings, HoldHiddenSurfaceAlgorithms) {
    for (const std::string name : {"newell", "z-buffer", "scan-line"}) {
        ASSERT_EQ(record({"lamps.toml", "-o", "t.gwt", "--algorithm", name}).code, 0);
        EXPECT_EQ(gw({"replay", "t.gwt", "--machine", "both"}).code, 0);
    }
    EXPECT_EQ(record({"lamps.toml", "-o", "t.gwt", "--algorithm", "sorting"}).code, 2);
}

TEST_F(Recordings, APixelOfAHiddenSurfaceAlgorithmNamesItsPolygon) {
    const auto shown_by = [&](const std::string& name) {
        EXPECT_EQ(record({"lamps.toml", "-o", "t.gwt", "--algorithm", name}).code, 0);
        const Outcome outcome = gw({"pixel", "t.gwt", "8", "8", "--json"});
        const auto last = nlohmann::json::parse(outcome.out)["events"].back();
        EXPECT_EQ(last["color"][0], last["polygon"]) << last;
        return last["polygon"].get<int>();
    };
    EXPECT_GT(shown_by("newell"), 0);
    EXPECT_EQ(shown_by("newell"), shown_by("z-buffer"));
    EXPECT_EQ(shown_by("scan-line"), shown_by("z-buffer"));
}

class RadiosityRecordings : public ExampleTest {};

TEST_F(RadiosityRecordings, OfHemicubesAndOfPicturesReplay) {
    ASSERT_EQ(gw({"radiosity", "scenes/radiosity/cornell.toml", "-o", "box", "--shots", "1",
                  "--hemicube", "16", "--size", "32x24", "--profile", "vgx", "--record"})
                  .code,
              0);
    const Outcome hemicubes = gw({"replay", "box/hemicubes.gwt", "--machine", "both"});
    EXPECT_EQ(hemicubes.code, 0) << hemicubes.out << hemicubes.err;
    EXPECT_NE(hemicubes.out.find("16 x 16 pixels on profile identifiers"), std::string::npos)
        << hemicubes.out;
    const Outcome pictures =
        gw({"replay", "box/pictures.gwt", "--machine", "both", "-o", "again.png"});
    EXPECT_EQ(pictures.code, 0) << pictures.out << pictures.err;
    EXPECT_TRUE(bytes_of(in("again.png")) == bytes_of(in("box/picture.png")));
    expect_refused(2,
                   {"radiosity", "scenes/radiosity/cornell.toml", "--form-factor", "lamp", "floor",
                    "--record"},
                   {"--form-factor"});
}

TEST_F(Recordings, APixelsHistoryIsInPictureCoordinates) {
    ASSERT_EQ(record({"lamps.toml", "-o", "t.gwt"}).code, 0);
    const Outcome outside = gw({"pixel", "t.gwt", "0", "0", "--json"}),
                  inside = gw({"pixel", "t.gwt", "4", "11", "--json"});
    ASSERT_EQ(outside.code, 0) << outside.err;
    // Of the scene: the pass that counts pixels draws the whole window.
    const auto fragments = [](const Outcome& outcome) {
        const auto json = nlohmann::json::parse(outcome.out);
        int count = 0;
        for (const auto& event : json["events"])
            count += event["command_name"] == "Draw" && event["pass_name"] != "count pixels";
        return count;
    };
    EXPECT_EQ(fragments(outside), 0);
    EXPECT_GT(fragments(inside), 3);
    EXPECT_NE(gw({"pixel", "t.gwt", "4", "11"}).out.find("written"), std::string::npos);
    expect_refused(1, {"pixel", "t.gwt", "16", "0"}, {"pixel 16 0", "0..15"});
    expect_refused(2, {"pixel", "t.gwt", "x", "0"}, {"X 'x'"});
}

TEST_F(Recordings, MapsShowWhereFragmentsWereMade) {
    ASSERT_EQ(record({"lamps.toml", "-o", "t.gwt"}).code, 0);
    ASSERT_EQ(gw({"maps", "t.gwt", "-o", "maps"}).code, 0);
    EXPECT_EQ(names("maps"),
              (std::vector<std::string>{"depth_complexity.png", "fragments.exr", "index.html",
                                        "index.json", "overdraw.png", "why_killed.png"}));
    ASSERT_EQ(gw({"maps", "t.gwt", "-o", "depth", "--pass", "depth"}).code, 0);
    const Pixels why = read_pixels(in("depth/why_killed.png"));
    EXPECT_EQ(why.at(0, 0), (std::vector<float>{0, 0, 0}));
    EXPECT_EQ(why.at(8, 8), (std::vector<float>{1, 1, 1}));
    expect_refused(1, {"maps", "t.gwt", "-o", "x", "--pass", "none"}, {"--pass 'none'"});
}

TEST_F(Recordings, HistoriesAndMapsSayThatSurfacesAreLeftOut) {
    ASSERT_EQ(gw({"conformance", "suite", "--only", "surfaces"}).code, 0);
    const std::string drawn = "suite/surfaces_01.gwt";
    for (const auto& result : {gw({"maps", drawn, "-o", "maps"}), gw({"pixel", drawn, "0", "0"})}) {
        EXPECT_EQ(result.code, 0);
        EXPECT_NE(result.err.find("it draws to surfaces beside the window"), std::string::npos);
        EXPECT_NE(result.err.find("--surface N"), std::string::npos);
    }
}

TEST_F(Recordings, HistoriesAndMapsShowASurface) {
    ASSERT_EQ(gw({"conformance", "suite", "--only", "surface-rules"}).code, 0);
    const std::string drawn = "suite/surface-rules_01.gwt";
    const auto result = gw({"pixel", drawn, "3", "2", "--surface", "1", "--json"});
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.err, "");
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["surface"], 1);
    EXPECT_EQ(json["events"][0]["command_name"], "Draw");
    EXPECT_EQ(json["events"].back()["command_name"], "Blit");
    const std::string window = gw({"pixel", drawn, "3", "2"}).out;
    EXPECT_NE(window.find("of surface 1: "), std::string::npos);  // a comparison with its depth
    EXPECT_EQ(gw({"maps", drawn, "-o", "maps", "--surface", "1"}).err, "");
    expect_refused(1, {"pixel", drawn, "0", "0", "--surface", "2"},
                   {"--surface 2", "0 (16x16), 1 (16x16)"});
    expect_refused(2, {"maps", drawn, "-o", "x", "--surface", "-1"}, {"--surface '-1'"});
}

TEST_F(Recordings, BadFilesAreRefusedWithAReason) {
    ASSERT_EQ(record({"lamps.toml", "-o", "t.gwt", "--manifest", "m.json"}).code, 0);
    const std::string bytes = bytes_of(in("t.gwt"));
    write("short.gwt", bytes.substr(0, bytes.size() / 2));
    write("empty.gwt", "");
    write("text.gwt", "hello, hello, hello");
    expect_refused(1, {"replay", "missing.gwt"}, {"missing.gwt", "cannot be opened"});
    expect_refused(1, {"replay", "."}, {".", "is a folder"});
    ASSERT_EQ(::mkfifo(in("pipe").c_str(), 0600), 0);
    expect_refused(1, {"replay", "pipe"}, {"pipe", "is a pipe; expected a file"});
    expect_refused(1, {"diff", "pipe", "pipe"}, {"pipe", "is a pipe; expected a file"});
    expect_refused(1, {"verify", "t.gwt", "pipe"}, {"pipe", "is a pipe; expected a file"});
    write("large.gwt", "");
    std::filesystem::resize_file(in("large.gwt"), std::uintmax_t{3} << 30);
    expect_refused(1, {"replay", "large.gwt"}, {"large.gwt", "has more than 2 GB"});
    expect_refused(1, {"replay", "short.gwt"}, {"short.gwt", "cut short or damaged"});
    expect_refused(1, {"replay", "empty.gwt"}, {"empty.gwt", "not a recording"});
    expect_refused(1, {"verify", "text.gwt", "m.json"}, {"text.gwt", "not a recording"});
    expect_refused(1, {"verify", "t.gwt", "t.gwt"}, {"t.gwt", "is not JSON"});
    expect_refused(1, {"replay", "t.gwt", "-o", "missing/a.png"}, {"missing"});
    expect_refused(2, {"replay", "t.gwt", "-o", "a.xyz"}, {"a.xyz"});
    expect_refused(2, {"replay", "t.gwt", "--machine", "both?"}, {"both?"});
    expect_refused(2, {"record", "lamps.toml", "-o", "x.gwt", "--manifest", "x.gwt"},
                   {"the same file"});
    expect_refused(1, {"record", "lamps.toml", "-o", "missing/x.gwt"}, {"missing"});
}

}  // namespace gw::apps
