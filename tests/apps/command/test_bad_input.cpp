// Every wrong file and option: one line that says what, where and what was expected; the exit code;
// no file left.
#include "tests/apps/scene_files.h"

namespace gw::apps {

using BadInput = SceneTest;
using BadOption = SceneTest;

TEST_F(BadInput, MissingFileOrDirectory) {
    std::filesystem::create_directory(in("folder"));
    expect_refused(1, {"render", "missing.obj", "-o", "a.png"}, {"missing.obj: ", "expected"});
    expect_refused(1, {"render", "missing.toml", "-o", "a.png"}, {"missing.toml: ", "expected"});
    expect_refused(1, {"render", "folder", "-o", "a.png"}, {"folder: is a directory", "expected"});
    expect_refused(1, {"passes", "missing.obj"}, {"missing.obj: ", "expected"});
    expect_refused(1, {"render", "quad.txt", "-o", "a.png"}, {"quad.txt", "expected"});
}

TEST_F(BadInput, ObjWithFileAndLine) {
    const std::vector<std::pair<std::string, std::string>> cases{
        {"v 0 0 0\nv abc 1 2\n", "bad.obj:2: "},
        {"v nan 0 0\n", "bad.obj:1: "},
        {"v inf 0 0\n", "bad.obj:1: "},
        {"\n\nv 1 2\n", "bad.obj:3: "},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "bad.obj:4: "},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", "bad.obj:4: "},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", "bad.obj:4: "},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", "bad.obj:4: "},
    };
    for (const auto& [text, where] : cases) {
        write("bad.obj", text);
        expect_refused(1, {"render", "bad.obj", "-o", "a.png"}, {where, "expected"});
    }
}

TEST_F(BadInput, EmptyMesh) {
    write("empty.obj", "");
    expect_refused(1, {"render", "empty.obj", "-o", "a.png"}, {"empty.obj: ", "expected"});
    write("points.obj", "v 0 0 0\nv 1 1 1\n");
    expect_refused(1, {"render", "points.obj", "-o", "a.png"}, {"points.obj: ", "expected"});
}

TEST_F(BadInput, MtlWithFileAndLine) {
    write("bad.obj", "mtllib bad.mtl\nusemtl red\n" + bytes_of(in("quad.obj")));
    write("bad.mtl", "newmtl red\nKd 1 x 0\n");
    expect_refused(1, {"render", "bad.obj", "-o", "a.png"}, {"bad.mtl:2: ", "expected"});
}

TEST_F(BadInput, MaterialsAndPicturesThatNoFileHasAreWarnedOf) {
    const auto err_of_drawing = [&] {
        const Outcome drawn = gw({"render", "bad.obj", "--size", "8x8", "-o", "a.png"});
        EXPECT_EQ(drawn.code, 0) << drawn.err;
        return drawn.err;
    };
    write("bad.obj", "mtllib bad.mtl\nusemtl red\n" + bytes_of(in("quad.obj")));
    write("bad.mtl", "newmtl rde\n");
    EXPECT_NE(err_of_drawing().find("gw: warning: bad.obj:2: unknown material 'red'; the nearest "
                                    "known is 'rde'; the default one stands in"),
              std::string::npos);
    write("bad.obj", "mtllib missing.mtl\nusemtl red\n" + bytes_of(in("quad.obj")));
    EXPECT_NE(err_of_drawing().find("line 1: mtllib 'missing.mtl' does not exist"),
              std::string::npos);
    write("bad.obj", "mtllib bad.mtl\nusemtl red\n" + bytes_of(in("quad.obj")));
    write("bad.mtl", "newmtl red\nmap_Kd missing.png\n");
    EXPECT_NE(err_of_drawing().find("missing.png"), std::string::npos);
}

TEST_F(BadInput, TextureNamesTheLineThatAsks) {
    write("bad.obj", "mtllib bad.mtl\nusemtl red\n" + bytes_of(in("quad.obj")));
    write("bad.mtl", "newmtl red\nKd 1 0 0\nmap_Kd broken.png\n");
    write("broken.png", "no picture");
    expect_refused(1, {"render", "bad.obj", "-o", "a.png"},
                   {"bad.mtl:3: map_Kd broken.png: ", "expected a picture file"});
    write("bad.toml",
          "[[object]]\nfile = \"quad.obj\"\n[object.material]\nmap_Ks = \"nowhere.png\"\n");
    expect_refused(1, {"render", "bad.toml", "-o", "a.png"},
                   {"bad.toml:4: map_Ks nowhere.png: ", "expected"});
}

TEST_F(BadInput, TomlWithFileAndLine) {
    write("bad.toml", "[camera]\neye = [0, 0\n");
    expect_refused(1, {"render", "bad.toml", "-o", "a.png"}, {"bad.toml:"});
    write("bad.toml", "[camera]\neye = [0, 0, 5]\nfovv = 40\n");
    expect_refused(1, {"render", "bad.toml", "-o", "a.png"}, {"bad.toml:3: ", "'fovv'", "'fov'"});
    write("bad.toml", "[camera]\nfov = \"wide\"\n");
    expect_refused(1, {"render", "bad.toml", "-o", "a.png"}, {"bad.toml:2: ", "expected a number"});
    write("bad.toml", "[camera]\nfov = 40\n");
    expect_refused(1, {"render", "bad.toml", "-o", "a.png"},
                   {"bad.toml: ", "expected an [[object]]"});
}

TEST_F(BadInput, ProfileWithFileAndLine) {
    expect_refused(1, {"render", "quad.obj", "-o", "a.png", "--profile", "none.toml"},
                   {"none.toml: "});
    write("p.toml", "color_bits = 8\ndepht_bits = 24\n");
    expect_refused(1, {"render", "quad.obj", "-o", "a.png", "--profile", "p.toml"},
                   {"p.toml:2: ", "'depth_bits'"});
    write("p.toml", "color_bits = 8\ndepth_bits = 40\n");
    expect_refused(1, {"render", "quad.obj", "-o", "a.png", "--profile", "p.toml"},
                   {"p.toml:2: ", "expected 16 to 32"});
    write("p.toml", "base = \"ideal\"\ncolor_bits = 8\n");
    expect_refused(1, {"render", "quad.obj", "-o", "a.png", "--profile", "p.toml"},
                   {"p.toml", "lit_bits", "expected 4 to 8"});
    write("p.toml", "base = \"vgy\"\n");
    expect_refused(1, {"render", "quad.obj", "-o", "a.png", "--profile", "p.toml"},
                   {"p.toml:1: ", "vgx"});
}

TEST_F(BadInput, MoreLightsThanEquationOneHasInOnePass) {
    std::string text = bytes_of(in("lamps.toml"));
    for (int i = 0; i < 7; ++i) text += "[[light]]\ndirection = [0, 0, -1]\n";
    write("many.toml", text);
    expect_refused(1, {"render", "many.toml", "-o", "a.png", "--renderer", "hardware"},
                   {"8", "multipass"});
    EXPECT_EQ(render({"many.toml", "-o", "a.png"}).code, 0);
}

TEST_F(BadOption, Size) {
    for (const char* size : {"0x0", "0x5", "1000000x1000000", "4097x1", "-4x4", "huge", "640",
                             "640x", "x480", "6x4x3", "1e3x4", "99999999999x1", ""}) {
        expect_refused(2, {"render", "quad.obj", "-o", "a.png", "--size", size},
                       {"--size", "1..4096", "640x480"});
    }
}

TEST_F(BadOption, Numbers) {
    for (const char* samples : {"-3", "0", "x", "1.5", "32769", ""}) {
        expect_refused(2, {"render", "quad.obj", "-o", "a.png", "--samples", samples},
                       {"--samples", "expected"});
    }
    expect_refused(2, {"render", "quad.obj", "-o", "a.png", "--samples", "16385"},
                   {"--samples", "vgx", "1..16384"});
    expect_refused(2, {"render", "quad.obj", "-o", "a.png", "--threads", "-1"},
                   {"--threads", "expected"});
    expect_refused(2, {"render", "quad.obj", "-o", "a.png", "--turntable", "0"},
                   {"--turntable", "expected"});
    for (const char* frames : {"0-2", "2-1", "1-4", "4", "-1", "1-", "a-b", "1-2-3"})
        expect_refused(
            2, {"render", "quad.obj", "-o", "a.png", "--turntable", "3", "--frames", frames},
            {"--frames", "A-B", "1..3"});
    expect_refused(2, {"render", "quad.obj", "-o", "a.png", "--frames", "1-2"},
                   {"--frames", "--turntable"});
    expect_refused(2, {"render", "quad.obj", "-o", "a.png", "--fov", "180"}, {"--fov", "expected"});
    expect_refused(2, {"render", "quad.obj", "-o", "a.png", "--fov", "nan"}, {"--fov", "expected"});
    expect_refused(2, {"render", "quad.obj", "-o", "a.png", "--gamma", "0"},
                   {"--gamma", "expected"});
    expect_refused(2, {"render", "quad.obj", "-o", "a.png", "--exposure", "much"},
                   {"--exposure", "expected"});
    for (const char* point : {"1,2", "1,2,3,4", "a,b,c", "1,2,inf", "1 2 3", ""}) {
        expect_refused(2, {"render", "quad.obj", "-o", "a.png", "--eye", point},
                       {"--eye", "expected X,Y,Z"});
    }
    expect_refused(2, {"render", "quad.obj", "-o", "a.png", "--eye", "1,2,3", "--at", "1,2,3"},
                   {"--at is the eye; expected another point"});
    expect_refused(2, {"render", "quad.obj", "-o", "a.png", "--up", "0,0,0"},
                   {"--up is 0; expected a direction that is not 0"});
    expect_refused(2,
                   {"render", "quad.obj", "-o", "a.png", "--eye", "0.1,0.7,0.3", "--at", "0,0,0",
                    "--up", "-0.3,-2.1,-0.9"},
                   {"--up is along the view; expected another direction"});
    expect_refused(2, {"render", "quad.obj", "-o", "a.png", "--eye", "1e19,0,0"},
                   {"--eye", "expected X,Y,Z from -1e+18 to 1e+18"});
}

TEST_F(BadOption, Names) {
    expect_refused(2, {"render", "quad.obj", "-o", "a.png", "--profile", "vgy"},
                   {"--profile", "vgx, reality, ideal, opengl"});
    expect_refused(2, {"render", "quad.obj", "-o", "a.png", "--renderer", "fast"},
                   {"--renderer", "hardware, multipass"});
    expect_refused(2, {"render", "quad.obj", "-o", "a.png", "--machine", "slow"},
                   {"--machine", "reference"});
    expect_refused(2, {"render", "quad.obj", "-o", "a.png", "--sice", "1x1"},
                   {"'--sice'", "'--size'"});
    expect_refused(2, {"render", "--sice", "1x1", "quad.obj", "-o", "a.png"},
                   {"'--sice'", "'--size'"});
}

TEST_F(BadOption, MissingOrTooManyWords) {
    expect_refused(2, {"render"}, {"required"});
    expect_refused(2, {"render", "quad.obj"}, {"--output"});
    expect_refused(2, {"render", "quad.obj", "-o"}, {"--output"});
    expect_refused(2, {"render", "-o", "a.png"}, {"SCENE"});
    expect_refused(2, {"render", "", "-o", "a.png"}, {"SCENE is empty"});
    expect_refused(2, {"render", "quad.obj", "-o", ""}, {"--output is empty"});
    expect_refused(2, {"render", "quad.obj", "quad.obj", "-o", "a.png"}, {"'quad.obj'"});
    expect_refused(
        2, {"render", "quad.obj", "-o", "a.png", "--turntable", "2", "--manifest", "m.json"},
        {"--turntable"});
}

TEST_F(BadInput, SavedViewWithFileAndLine) {
    const auto refuse = [&](const std::string& text, const std::vector<std::string>& parts) {
        write("view.toml", "base = 'lamps.toml'\n[picture]\n" + text);
        expect_refused(1, {"render", "view.toml", "-o", "a.png"}, parts);
    };
    refuse("renderer = 'radar'\n", {"view.toml:3: ", "radar", "multipass"});
    refuse("samples = 0\n", {"view.toml:3: ", "--samples", "1..32768"});
    refuse("size = [3, 4]\n", {"view.toml:3: ", "expected a word or a number"});
    refuse("output = 'b.png'\n", {"view.toml:3: ", "unknown key 'output'"});
    write("view.toml", "base = 'lamps.toml'\npicture = 3\n");
    expect_refused(1, {"render", "view.toml", "-o", "a.png"}, {"view.toml:2: ", "[picture]"});
}

}  // namespace gw::apps
