// Claim: no command replaces a file that it reads, whichever of its outputs is named so.
#include "tests/apps/pictures.h"
#include "tests/apps/scene_files.h"

namespace gw::apps {
namespace {

const std::vector<std::string> reads_it{"this command reads it"};

}  // namespace

class Inputs : public SceneTest {
protected:
    Inputs() {
        write("textured.mtl", "newmtl red\nKd 1 0 0\nmap_Kd map.png\n");
        write_pixel(in("map.png"), {255, 0, 0});
        write("textured.obj", "mtllib textured.mtl\nusemtl red\n" + bytes_of(in("quad.obj")));
        write("mine.toml", bytes_of(in("lamps.toml")) +
                               "[[object]]\nfile = \"textured.obj\"\ntranslate = [0, 0, 1]\n");
        std::filesystem::create_symlink("map.png", in("link.png"));
    }

    void expect_kept(const std::vector<std::string>& arguments, const std::string& input,
                     int code = 1) const {
        const std::string before = bytes_of(in(input));
        expect_refused(code, arguments, code == 1 ? reads_it : std::vector<std::string>{});
        EXPECT_EQ(bytes_of(in(input)), before) << input;
    }
};

TEST_F(Inputs, OfASceneStayAsTheyAre) {
    for (const std::string input :
         {"mine.toml", "textured.obj", "textured.mtl", "quad.obj", "map.png", "./map.png"}) {
        expect_kept({"record", "mine.toml", "-o", input}, input);
        expect_kept({"record", "mine.toml", "-o", "t.gwt", "--manifest", input}, input);
        expect_kept({"render", "mine.toml", "-o", "a.png", "--manifest", input}, input);
        expect_kept({"render", "mine.toml", "-o", "a.png", "--counters", input}, input);
    }
    expect_kept({"render", "mine.toml", "-o", "map.png"}, "map.png");
    expect_kept({"render", "mine.toml", "-o", "link.png"}, "map.png");
    expect_kept({"cast", "mine.toml", "--quiet", "-o", "map.png"}, "map.png");
    expect_kept({"cast", "mine.toml", "--quiet", "-o", "a.png", "--tests", "map.png"}, "map.png");
    expect_kept({"styles", "mine.toml", "-o", "map.png"}, "map.png");
    expect_kept({"fragments", "mine.toml", "--truth", "quad.obj"}, "quad.obj");
}

TEST_F(Inputs, OfATurntableAreNotOneOfItsPictures) {
    write("a_002.png", bytes_of(in("map.png")));
    write("textured.mtl", "newmtl red\nmap_Kd a_002.png\n");
    expect_kept({"render", "mine.toml", "-o", "a.png", "--turntable", "3"}, "a_002.png");
}

TEST_F(Inputs, InFoldersOfOutputsStayAsTheyAre) {
    std::filesystem::create_directory(in("parts"));
    write("parts/sum.png", bytes_of(in("map.png")));
    write("textured.mtl", "newmtl red\nmap_Kd parts/sum.png\n");
    expect_kept({"render", "mine.toml", "-o", "a.png", "--components", "parts", "--size", "16x16"},
                "parts/sum.png");
    EXPECT_EQ(names("parts"), std::vector<std::string>{"sum.png"});
}

TEST_F(Inputs, ProfilesAndRecordingsStayAsTheyAre) {
    ASSERT_EQ(gw({"record", "mine.toml", "-o", "t.gwt", "--size", "16x16"}).code, 0);
    std::filesystem::create_symlink("t.gwt", in("t.png"));
    expect_kept({"replay", "t.gwt", "-o", "t.png"}, "t.gwt");
    expect_kept({"diff", "t.gwt", "t.gwt", "-o", "t.png"}, "t.gwt");
    expect_kept({"verify", "t.gwt", "t.gwt", "--update"}, "t.gwt");
}

TEST_F(Inputs, TwoOutputsAreTwoFiles) {
    expect_refused(2, {"render", "mine.toml", "-o", "a.png", "--manifest", "a.png"},
                   {"are the same file"});
    expect_refused(1, {"render", "mine.toml", "-o", "a.png", "--manifest", "./a.png"},
                   {"another output"});
    expect_refused(1, {"record", "mine.toml", "-o", "a.values", "--manifest", "a.json"},
                   {"another output"});
}

TEST_F(Inputs, AManifestToADeviceHasNoValues) {
    std::filesystem::create_symlink("/dev/null", in("nowhere.json"));
    const auto before = names();
    ASSERT_EQ(
        gw({"record", "mine.toml", "-o", "t.gwt", "--size", "16x16", "--manifest", "nowhere.json"})
            .code,
        0);
    std::filesystem::remove(in("t.gwt"));
    EXPECT_EQ(names(), before);
}

}  // namespace gw::apps
