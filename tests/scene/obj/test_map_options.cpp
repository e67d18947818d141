// Claims: map options are told from the file name behind them, and honoured or warned about.
#include "scene/obj/map_options.h"

#include <gtest/gtest.h>

#include "tests/scene/folder.h"

namespace gw::scene {
namespace {

struct MapOptions : testing::Test {
    Folder folder;
    Warnings list;

    MapStatement read(const std::string& rest, const std::string& keyword = "map_Kd") {
        list = Warnings();
        const std::string text = keyword + " " + rest + "\n";
        Statements in("m.mtl", text);
        in.next();
        return read_map(in, folder.path(), list);
    }
    std::string file(const std::string& rest) {
        return folder.relative(read(rest).map.file.string());
    }
    std::string fault(const std::string& rest, const std::string& keyword = "map_Kd") {
        return folder.error([&] { read(rest, keyword); });
    }
};

}  // namespace

TEST_F(MapOptions, LeaveFileNamesWithBlanksWhole) {
    EXPECT_EQ(file("my wood.png"), "my wood.png");
    EXPECT_EQ(file("-s 2 2 2 my wood.png"), "my wood.png");
    EXPECT_EQ(file("-s 2 -o 1 1 -clamp on -bm 1 my  wood.png"), "my  wood.png");
    EXPECT_EQ(file("-mm 0 1 -blendu on -blendv on -cc off -type sphere a.png"), "a.png");
    EXPECT_EQ(file("-t 0 0 0 -boost 0 wood -s.png"), "wood -s.png");
    EXPECT_EQ(file("-"), "-");
}

TEST_F(MapOptions, TakeANumberAtTheEndForTheFile) {
    EXPECT_EQ(file("-s 2 3 4"), "4");
    EXPECT_EQ(read("-s 2 3 4").map.scale, vec2(2, 3));
    EXPECT_EQ(file("-s 2 7"), "7");
    EXPECT_EQ(file("-o 1 2 3 4 5.png"), "4 5.png");
}

TEST_F(MapOptions, AreHonoured) {
    const MapStatement statement = read("-o 0.5 -s 2 4 -clamp on -type sphere a.png");
    EXPECT_EQ(statement.map.offset, vec2(0.5f, 0));
    EXPECT_EQ(statement.map.scale, vec2(2, 4));
    EXPECT_EQ(statement.map.wrap_t, Wrap::Clamp);
    EXPECT_EQ(statement.type, "sphere");
    EXPECT_EQ(read("-s 3 a.png").map.scale, vec2(3, 1));
    EXPECT_TRUE(list.lines().empty());
}

TEST_F(MapOptions, AreWarnedAboutWhereTheyWouldChangeThePicture) {
    EXPECT_TRUE((read("-blendu on -mm 0 1 -bm 1 a.png"), list.lines().empty()));
    read("-blendu off -mm 0.5 2 -texres 256 -imfchan r -t 1 1 1 a.png");
    EXPECT_EQ(list.lines(), (Strings{"m.mtl:1: map option -blendu is not honoured",
                                     "m.mtl:1: map option -mm is not honoured",
                                     "m.mtl:1: map option -texres is not honoured",
                                     "m.mtl:1: map option -imfchan is not honoured",
                                     "m.mtl:1: map option -t is not honoured"}));
}

TEST_F(MapOptions, ChooseTheChannelOfAMapOfOpacity) {
    const auto channel = [&](const std::string& rest) { return read(rest, "map_d").map.channel; };
    EXPECT_EQ(channel("a.png"), OpacityChannel::AlphaOrLuminance);
    EXPECT_EQ(channel("-imfchan r a.png"), OpacityChannel::Red);
    EXPECT_EQ(channel("-imfchan g a.png"), OpacityChannel::Green);
    EXPECT_EQ(channel("-clamp on -imfchan b a.png"), OpacityChannel::Blue);
    EXPECT_EQ(channel("-imfchan m a.png"), OpacityChannel::Alpha);
    EXPECT_EQ(channel("-imfchan l a.png"), OpacityChannel::Luminance);
    EXPECT_TRUE(list.lines().empty());
    EXPECT_EQ(channel("-imfchan z a.png"), OpacityChannel::AlphaOrLuminance);
    EXPECT_EQ(list.lines(), (Strings{"m.mtl:1: map option -imfchan is not honoured"}));
    EXPECT_EQ(fault("-imfchan a a.png", "map_d"),
              "m.mtl:1: -imfchan has 'a'; expected r, g, b, m, l or z");
    EXPECT_EQ(fault("-imfchan", "map_d"), "m.mtl:1: -imfchan has ''; expected r, g, b, m, l or z");
    EXPECT_EQ(fault("-imfchan"), "m.mtl:1: -imfchan has ''; expected a word");
}

TEST_F(MapOptions, AreCheckedOneByOne) {
    EXPECT_EQ(fault("-clmap on a.png"),
              "m.mtl:1: unknown option '-clmap'; the nearest known is '-clamp'");
    EXPECT_EQ(fault("-clamp a.png"), "m.mtl:1: -clamp has 'a.png'; expected on or off");
    EXPECT_EQ(fault("-s a.png"), "m.mtl:1: -s has 'a.png'; expected a number");
    EXPECT_EQ(fault("-mm 1 a.png"), "m.mtl:1: -mm has 'a.png'; expected a number");
    EXPECT_EQ(fault("-s nan a.png"), "m.mtl:1: -s has 'nan'; expected a number");
    EXPECT_EQ(fault("-s 1 1 1"), "no error");
    EXPECT_EQ(fault("-clamp on"), "no error");
    EXPECT_EQ(fault("-type"), "m.mtl:1: -type has ''; expected a word");
}

}  // namespace gw::scene
