// gw radiosity as a user runs it: what is saved survives whatever ends the program, changes,
// highlights.
#include "tests/apps/scene_files.h"

#include <sstream>

namespace gw::apps {
namespace {

class Radiosity : public CommandTest {
protected:
    Radiosity() {
        write("box.toml", R"(name = "box"
texels = 1.5
[camera]
eye = [0, 1, 5]
at = [0, 1, 0]
[material.wall]
Kd = 0.5
[material.shiny]
Kd = 0.5
Ks = 0.5
Ns = 20
[[light]]
name = "point"
position = [0, 1.8, 1]
Id = 0
Is = 1
[[object]]
shape = "room"
name = "room"
width = 2
height = 2
depth = 2
translate = [0, 1, 0]
material = "wall"
[[object]]
shape = "sphere"
name = "ball"
radius = 0.5
slices = 8
stacks = 4
translate = [0, 0.5, 0]
material = "shiny"
[[object]]
shape = "rectangle"
name = "lamp"
width = 0.5
depth = 0.5
rotate = [180, 0, 0]
translate = [0, 1.9, 0]
material = { Kd = 0 }
pixmap = { size = [2, 2], emission = 4 }
)");
    }

    Outcome solve(std::vector<std::string> more, Surroundings around = {}) const {
        std::vector<std::string> words{"radiosity",  "box.toml", "-o",     "out",
                                       "--hemicube", "16",       "--size", "48x48"};
        words.insert(words.end(), more.begin(), more.end());
        return gw(words, std::move(around));
    }
};

TEST_F(Radiosity, InterruptedLeavesTheLastCompleteSave) {
    ASSERT_EQ(solve({"--shots", "3", "--save"}).code, 0);
    const std::string saved = bytes_of(in("out/pixmaps.exr"));
    const auto before = names("out");
    const Outcome stopped = solve({"--resume", "--save", "--until", "1e-9", "--every", "1"},
                                  {.interrupt_when = "out/shot_000004.png"});
    EXPECT_EQ(stopped.code, 130);
    EXPECT_NE(stopped.err.find("out/pixmaps.exr has the first 3: --resume goes on"),
              std::string::npos)
        << stopped.err;
    EXPECT_EQ(bytes_of(in("out/pixmaps.exr")), saved);
    for (const std::string& name : names("out"))
        EXPECT_TRUE(name.find("shot_") == 0 || std::count(before.begin(), before.end(), name))
            << name;
    EXPECT_EQ(solve({"--resume", "--shots", "4"}).code, 0);
}

/// The fields of convergence.csv that do not depend on the run: all but seconds and hemicubes, which
/// are drawn again after a save.
std::vector<std::string> curve_of(const std::string& csv) {
    std::vector<std::string> rows;
    std::istringstream lines(csv);
    for (std::string row; std::getline(lines, row);) {
        std::istringstream fields(row);
        std::string kept;
        int number = 0;
        for (std::string field; std::getline(fields, field, ','); ++number)
            if (number != 1 && number != 2) kept += field + ",";
        rows.push_back(kept);
    }
    return rows;
}

TEST_F(Radiosity, ResumedGoesOnWithTheCurve) {
    ASSERT_EQ(solve({"--shots", "7"}).code, 0);
    const std::vector<std::string> whole = curve_of(bytes_of(in("out/convergence.csv")));
    EXPECT_EQ(whole.size(), 9u);  // columns, and shots 0 to 7
    ASSERT_EQ(solve({"--shots", "3", "--save"}).code, 0);
    ASSERT_EQ(solve({"--shots", "5", "--resume", "--save"}).code, 0);
    ASSERT_EQ(solve({"--shots", "7", "--resume"}).code, 0);
    EXPECT_EQ(curve_of(bytes_of(in("out/convergence.csv"))), whole);
    // The pixmaps have 5 shots.
    ASSERT_EQ(solve({"--shots", "5", "--resume"}).code, 0);
    EXPECT_EQ(curve_of(bytes_of(in("out/convergence.csv"))),
              std::vector(whole.begin(), whole.begin() + 7));
    write("out/convergence.csv", "not a curve");
    ASSERT_EQ(solve({"--shots", "6", "--resume"}).code, 0);
    EXPECT_EQ(curve_of(bytes_of(in("out/convergence.csv"))),
              (std::vector{whole[0], whole[6], whole[7]}));
}

/// Bits of a channel in a PNG.
int bits_of(const std::string& png) { return png.at(24); }

// As every picture: 8 bits stay 8, 12 and 16 become 16.
TEST_F(Radiosity, PicturesHaveTheBitsOfTheProfile) {
    for (const auto& [profile, bits] : {std::pair{"vgx", 8}, {"reality", 16}, {"ideal", 16}}) {
        ASSERT_EQ(solve({"--shots", "1", "--profile", profile, "--display", "both"}).code, 0);
        for (const char* file : {"out/picture_texture.png", "out/picture_strips.png"})
            EXPECT_EQ(bits_of(bytes_of(in(file))), bits) << profile << " " << file;
        ASSERT_EQ(solve({"--shots", "1", "--profile", profile, "--gamma", "2.2"}).code, 0);
        EXPECT_EQ(bits_of(bytes_of(in("out/picture.png"))), bits) << profile;
    }
}

TEST_F(Radiosity, AFullDiskIsSaidAndKeepsTheSave) {
    ASSERT_EQ(solve({"--shots", "2", "--save"}).code, 0);
    const std::string saved = bytes_of(in("out/pixmaps.exr"));
    const Outcome outcome = solve({"--resume", "--shots", "3", "--save"}, {.largest_file = 2000});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("cannot be written"), std::string::npos) << outcome.err;
    EXPECT_EQ(bytes_of(in("out/pixmaps.exr")), saved);
}

TEST_F(Radiosity, AChangeIsComparedWithSolvingAnew) {
    const Outcome outcome = solve({"--until", "0.3", "--change", "lamp:dim=0.5", "--change",
                                   "room:Kd=0.4,0.5,0.5", "--anew"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("changed: "), std::string::npos);
    EXPECT_NE(outcome.out.find("anew: "), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(in("out/changed.png")));
}

TEST_F(Radiosity, FormFactorsNeedNoLight) {
    std::string dark = bytes_of(in("box.toml"));
    dark.replace(dark.find(", emission = 4"), 14, "");
    write("dark.toml", dark);
    const std::vector<std::string> tail{"--form-factor", "lamp", "ball", "--hemicube", "16"};
    const auto asked = [&](const char* scene) {
        std::vector<std::string> words{"radiosity", scene};
        words.insert(words.end(), tail.begin(), tail.end());
        return gw(words);
    };
    const Outcome lit = asked("box.toml"), unlit = asked("dark.toml");
    EXPECT_EQ(unlit.code, 0) << unlit.err;
    EXPECT_NE(unlit.out.find("F(lamp -> ball) = "), std::string::npos) << unlit.out;
    EXPECT_NE(lit.out.find("F(lamp -> ball) = "), std::string::npos) << lit.out;
    expect_refused(1, {"radiosity", "dark.toml", "-o", "out"}, {"nothing emits light"});
}

TEST_F(Radiosity, HighlightsAreAdded) {
    ASSERT_EQ(solve({"--shots", "1"}).code, 0);
    const std::string dull = bytes_of(in("out/picture.png"));
    ASSERT_EQ(solve({"--shots", "1", "--specular"}).code, 0);
    EXPECT_NE(bytes_of(in("out/picture.png")), dull);
}

TEST_F(Radiosity, WhatCannotBeIsRefused) {
    const std::vector<std::string> run{"radiosity", "box.toml", "-o", "out"};
    const auto refused = [&](std::vector<std::string> more, const std::string& part) {
        std::vector<std::string> words = run;
        words.insert(words.end(), more.begin(), more.end());
        expect_refused(2, words, {part});
    };
    refused({"--change", "lamp"}, "expected NAME:emission=R,G,B");
    refused({"--change", "lamp:colour=1,2,3"}, "expected NAME:emission=R,G,B");
    refused({"--change", "lamp:Kd=1,2,3"}, "0 to 1");
    refused({"--change", "lamp:emission=nan,2,3"}, "nan");
    refused({"--change", "lamb:dim=2"}, "no object 'lamb'; expected one of ball, lamp, room");
    refused({"--change", "lamp:dim=2", "--save"}, "expected no --save");
    refused({"--anew"}, "expected --change");
    refused({"--specular", "--display", "both"}, "expected no --display");
}

}  // namespace
}  // namespace gw::apps
