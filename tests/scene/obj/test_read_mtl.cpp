// Claims: MTL statements become materials in the papers' words; statements that are not honoured
// are reported once; faults are errors with their line.
#include "scene/obj/read_mtl.h"

#include <gtest/gtest.h>

#include "tests/scene/folder.h"

namespace gw::scene {
namespace {

struct Mtl : testing::Test {
    Folder folder;
    Warnings list;

    MaterialLibrary library(const std::string& text) {
        list = Warnings();
        return read_mtl(folder.write("m.mtl", text), list);
    }
    std::vector<Material> read(const std::string& text) { return library(text).materials; }
    Material one(const std::string& statements) {
        return read("newmtl m\n" + statements + "\n").at(0);
    }
    std::string fault(const std::string& text) {
        return folder.error([&] {
            const MaterialLibrary found = library(text);
            const MaterialNames names(found);
            for (const Material& material : found.materials) names.find(material.name);
        });
    }
    std::string fault_of(const std::string& statement) {
        return fault("newmtl m\n" + statement + "\n");
    }
    Strings warned() const {
        Strings lines;
        for (const std::string& line : list.lines()) lines.push_back(folder.relative(line));
        return lines;
    }
};

}  // namespace

TEST_F(Mtl, ReadsEveryParameter) {
    const Material m = one(
        "Ka 0.1 0.2 0.3\nKd 0.4 0.5 0.6\nKs .7 .8 .9\nKe 1 2 3\nNs 96.078431\nNi 1.5\nd 0.25\nTf 0 1 "
        "0\nillum 7");
    EXPECT_EQ(m.name, "m");
    EXPECT_EQ(m.Ka, vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(m.Kd, vec3(0.4f, 0.5f, 0.6f));
    EXPECT_EQ(m.Ks, vec3(0.7f, 0.8f, 0.9f));
    EXPECT_EQ(m.Ke, vec3(1, 2, 3));
    EXPECT_EQ(m.Ns, 96.078431f);
    EXPECT_EQ(m.Ni, 1.5f);
    EXPECT_EQ(m.d, 0.25f);
    EXPECT_EQ(m.Tf, vec3(0, 1, 0));
    EXPECT_EQ(m.illum, 7);
    EXPECT_EQ(warned(), Strings());
}

TEST_F(Mtl, StartsWithTheInitialValues) {
    const Material m = one("");
    EXPECT_EQ(m.Ka, vec3(0.2f));
    EXPECT_EQ(m.Kd, vec3(0.8f));
    EXPECT_EQ(m.Ks, vec3(0));
    EXPECT_EQ(m.d, 1);
}

TEST_F(Mtl, TakesOneNumberForAGrey) { EXPECT_EQ(one("Kd 0.5").Kd, vec3(0.5f)); }

TEST_F(Mtl, TakesKeywordsInAnyCase) {
    folder.write("a.png", "");
    const Material m = one("KD 1 0 0\nmap_kd a.png\nMap_Ks a.png\nNEWMTL second");
    EXPECT_EQ(m.Kd, vec3(1, 0, 0));
    EXPECT_EQ(m.map_Kd.size(), 1u);
    EXPECT_EQ(m.map_Ks.size(), 1u);
}

TEST_F(Mtl, KeepsNamesWithBlanks) {
    const std::vector<Material> materials = read("newmtl  dark red #2 \r\nnewmtl b\r\n");
    EXPECT_EQ(materials[0].name, "dark red #2");
    EXPECT_EQ(materials[1].name, "b");
}

TEST_F(Mtl, ReadsTrAsOneMinusDAndPrefersD) {
    EXPECT_EQ(one("Tr 0.25").d, 0.75f);
    EXPECT_EQ(one("d 0.25\nTr 0.75").d, 0.25f);
    EXPECT_EQ(warned(), Strings());
    EXPECT_EQ(one("d 1\nTr 1").d, 1);
    EXPECT_EQ(warned(), (Strings{"m.mtl:3: d and Tr disagree (Tr should be 1 - d); d counts"}));
    EXPECT_EQ(one("Tr 1\nd 1").d, 1);
    EXPECT_EQ(warned(), (Strings{"m.mtl:3: d and Tr disagree (Tr should be 1 - d); d counts"}));
    EXPECT_EQ(one("d -halo 0.5").d, 0.5f);
    EXPECT_EQ(warned(), (Strings{"m.mtl:2: d -halo is read as d"}));
}

TEST_F(Mtl, AsksForDAndTrOfEachMaterialAnew) {
    folder.write("m.mtl", "newmtl a\nd 0.5\nnewmtl b\nTr 0.25\nnewmtl c\nd 0.125\n");
    const auto materials = read_mtl(folder.path() / "m.mtl", folder.warnings_list()).materials;
    ASSERT_EQ(materials.size(), 3u);
    EXPECT_EQ(materials[0].d, 0.5f);
    EXPECT_EQ(materials[1].d, 0.75f);
    EXPECT_EQ(materials[2].d, 0.125f);
    EXPECT_EQ(folder.warnings(), Strings());
}

TEST_F(Mtl, LimitsWhatIsOutOfRange) {
    EXPECT_EQ(one("Ns 20000").Ns, 10000);
    EXPECT_EQ(warned(), (Strings{"m.mtl:2: Ns is out of range and limited to Ns 0 .. 10000"}));
    EXPECT_EQ(one("Ns -1.96").Ns, 0);
    EXPECT_EQ(one("Kd -1 0.5 0").Kd, vec3(0, 0.5f, 0));
    EXPECT_EQ(warned(), (Strings{"m.mtl:2: Kd is out of range and limited to Kd r g b from 0"}));
    EXPECT_EQ(one("Ni 0").Ni, 1);
}

TEST_F(Mtl, ReadsMapsWithTheirOrigin) {
    const auto file = folder.write("maps/red wood.png", "");
    const Material m =
        one("map_Ka -s 2 3 maps\\red wood.png\nmap_Kd maps/red wood.png\nmap_Ks maps/red wood.png\n"
            "map_Ke maps/red wood.png\nrefl -type sphere -clamp on maps/red wood.png");
    EXPECT_EQ(m.map_Ka.at(0).file, file);
    EXPECT_EQ(m.map_Ka[0].scale, vec2(2, 3));
    EXPECT_EQ(m.map_Ka[0].origin.line, 2);
    EXPECT_EQ(folder.relative(m.map_Ka[0].origin.file), "m.mtl");
    EXPECT_EQ(m.map_Kd.at(0).wrap_t, Wrap::Repeat);
    EXPECT_EQ(m.map_Ks.size() + m.map_Ke.size(), 2u);
    EXPECT_EQ(m.refl.at(0).wrap_t, Wrap::Clamp);
    EXPECT_EQ(m.refl[0].origin.line, 6);
    EXPECT_EQ(m.refl[0].texture, nullptr);
}

TEST_F(Mtl, KeepsSeveralMapsOfOneComponentButNoneTwice) {
    EXPECT_EQ(one("map_Kd a.png\nmap_Kd b.png\nmap_Kd -s 2 2 a.png").map_Kd.size(), 3u);
    EXPECT_EQ(one("map_Kd a.png\nmap_Kd a.png").map_Kd.size(), 1u);
    EXPECT_EQ(warned(), (Strings{"m.mtl:3: map_Kd again with the same map; it counts once"}));
}

TEST_F(Mtl, ReadsAMapOfOpacity) {
    const auto file = folder.write("leaf.png", "");
    const Material m = one("map_D -clamp on -s 2 3 -o 0.5 leaf.png\nd 0.5");
    ASSERT_EQ(m.map_d.size(), 1u);
    EXPECT_EQ(m.map_d[0].file, file);
    EXPECT_EQ(m.map_d[0].origin.line, 2);
    EXPECT_EQ(m.map_d[0].wrap_s, Wrap::Clamp);
    EXPECT_EQ(m.map_d[0].scale, vec2(2, 3));
    EXPECT_EQ(m.map_d[0].offset, vec2(0.5f, 0));
    EXPECT_EQ(m.d, 0.5f);
    EXPECT_FALSE(m.vertex_d || m.d_cutoff);
    EXPECT_EQ(warned(), Strings());
}

TEST_F(Mtl, TakesTheAlphaOfThePictureThatMapKdNames) {
    const auto channel = [&](const std::string& statements) {
        return one(statements).map_d.at(0).channel;
    };
    EXPECT_EQ(channel("map_d a.png"), OpacityChannel::AlphaOrLuminance);
    EXPECT_EQ(channel("map_Kd b.png\nmap_d a.png"), OpacityChannel::AlphaOrLuminance);
    EXPECT_EQ(channel("map_Kd a.png\nmap_d a.png"), OpacityChannel::Alpha);
    EXPECT_EQ(channel("map_d a.png\nmap_Kd b.png\nmap_Kd a.png"), OpacityChannel::Alpha);
    EXPECT_EQ(channel("map_Kd a.png\nmap_d -imfchan l a.png"), OpacityChannel::Luminance);
}

TEST_F(Mtl, CountsTheFirstMapOfOpacity) {
    folder.write("a.png", "");
    const Material m = one("map_d a.png\nmap_d a.png\nmap_d b.png");
    ASSERT_EQ(m.map_d.size(), 1u);
    EXPECT_EQ(folder.relative(m.map_d[0].file.string()), "a.png");
    EXPECT_EQ(warned(), (Strings{"m.mtl:3: map_d again with the same map; it counts once",
                                 "m.mtl:4: map_d again with another map; the first one counts"}));
}

TEST_F(Mtl, CountsTheFirstOfEqualNames) {
    const std::vector<Material> materials =
        read("newmtl a\nKd 1 0 0\nnewmtl b\nnewmtl a\nKd 0 0 1\n");
    ASSERT_EQ(materials.size(), 2u);
    EXPECT_EQ(materials[0].Kd, vec3(1, 0, 0));
    EXPECT_EQ(warned(), (Strings{"m.mtl:4: material 'a' again; the first one counts"}));
}

TEST_F(Mtl, WarnsOfWhatItDoesNotHonour) {
    one("map_Bump -bm 0.5 b.png\nmap_Ns m.png\nPr 0.5\nmap_Bump c.png");
    EXPECT_EQ(warned(),
              (Strings{"m.mtl:2: map_Bump is not honoured", "m.mtl:3: map_Ns is not honoured",
                       "m.mtl:4: Pr is not honoured"}));
}

TEST_F(Mtl, RefusesWhatIsWrong) {
    EXPECT_EQ(fault("Kd 1 1 1\n"), "m.mtl:1: 'Kd' before any material; expected newmtl NAME");
    EXPECT_EQ(fault("newmtl\n"), "m.mtl:1: newmtl has no name; expected newmtl NAME");
    EXPECT_EQ(fault_of("Kd 1 0"), "m.mtl:2: Kd has 2 numbers; expected Kd r g b");
    EXPECT_EQ(fault_of("Kd"), "m.mtl:2: Kd has 0 numbers; expected Kd r g b");
    EXPECT_EQ(fault_of("Kd red"), "m.mtl:2: 'red' is not a number; expected Kd r g b");
    EXPECT_EQ(fault_of("Ks 1 nan 1"), "m.mtl:2: 'nan' is not finite; expected Ks r g b");
    EXPECT_EQ(fault_of("Ns"), "m.mtl:2: Ns has 0 numbers; expected Ns 0 .. 10000");
    EXPECT_EQ(fault_of("Ns 1 2"), "m.mtl:2: Ns has 2 numbers; expected Ns 0 .. 10000");
    EXPECT_EQ(fault_of("illum 1.5"), "m.mtl:2: illum is '1.5'; expected a whole number 0 .. 10");
    EXPECT_EQ(fault_of("d -halo"), "m.mtl:2: d has 0 numbers; expected d 0 .. 1");
    EXPECT_EQ(fault_of("Kx 1 1 1"), "m.mtl:2: unknown statement 'Kx'; the nearest known is 'Ka'");
}

TEST_F(Mtl, LeavesOutAMapWithoutAName) {
    const Material m = one("map_Kd\nmap_Ks -clamp on\nKd 0.5");
    EXPECT_TRUE(m.map_Kd.empty() && m.map_Ks.empty());
    EXPECT_EQ(m.Kd, vec3(0.5f));
    EXPECT_EQ(warned(), (Strings{"m.mtl:2: map_Kd names no file: left out",
                                 "m.mtl:3: map_Ks names no file: left out"}));
}

TEST_F(Mtl, HasNoHighlightsBelowIllum2) {
    EXPECT_EQ(one("Ks 1\nillum 1").Ks, vec3(0));
    EXPECT_EQ(warned(), Strings{"m.mtl:3: material 'm': illum 1 has no highlights: Ks is not used; "
                                "expected illum 2 for highlights"});
    EXPECT_EQ(one("illum 1\nKs 1").Ks, vec3(0)) << "in either order";
    EXPECT_EQ(one("illum 0\nKs 1").Ks, vec3(0));
    EXPECT_EQ(warned().at(0),
              "m.mtl:2: material 'm': illum 0 (constant colour) is read as 1 (lit, without "
              "highlights)");
    EXPECT_EQ(one("Ks 1\nillum 1\nrefl a.png").Ks, vec3(1)) << "Ks weighs the reflection";
    EXPECT_EQ(one("Ks 1\nillum 2").Ks, vec3(1));
    EXPECT_EQ(one("Ks 1").Ks, vec3(1));
    one("Ks 0\nillum 1");
    EXPECT_EQ(warned(), Strings());
}

TEST_F(Mtl, RefusesOtherColourSystemsAndCubeMaps) {
    EXPECT_EQ(fault_of("Kd spectral a.rfl 1"),
              "m.mtl:2: Kd spectral is not supported; expected Kd r g b");
    EXPECT_EQ(fault_of("Ka xyz 1 1 1"), "m.mtl:2: Ka xyz is not supported; expected Ka r g b");
    EXPECT_EQ(fault_of("refl -type cube_top a.png"),
              "m.mtl:2: refl -type cube_top is not supported; expected refl -type sphere");
}

TEST_F(Mtl, NamesItsOwnFileInErrorsOfAnObj) {
    folder.write("m.mtl", "newmtl a\nKd 1 0\n");
    const std::string error = "m.mtl:2: Kd has 2 numbers; expected Kd r g b",
                      face = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
    EXPECT_EQ(folder.scene_error("s.obj", face), error);
    EXPECT_EQ(folder.obj_error(face), "no error") << "a scene may bring another material a";
    folder.write("m.mtl", "Kd 1 0\n");
    EXPECT_EQ(folder.obj_error(face), "m.mtl:1: 'Kd' before any material; expected newmtl NAME");
}

/// Exporters write all materials of a program, of which a model uses some.
TEST_F(Mtl, AFaultInAMaterialThatNothingUsesIsAWarning) {
    const std::string text =
        "newmtl sky\nrefl -type cube_top sky.png\nNs x\nnewmtl a\nKd 1 0 0\nnewmtl sky\nKd 0 0 1\n";
    const MaterialLibrary found = library(text);
    EXPECT_EQ(MaterialNames(found).find("a")->Kd, vec3(1, 0, 0));
    EXPECT_EQ(warned(),
              (Strings{"m.mtl:2: refl -type cube_top is not supported; expected refl -type sphere; "
                       "nothing uses material 'sky', so it is left out",
                       "m.mtl:6: material 'sky' again; the first one counts"}));
    EXPECT_EQ(fault(text),
              "m.mtl:2: refl -type cube_top is not supported; expected refl -type sphere");
}

TEST_F(Mtl, TheFirstLibraryThatHasAMaterialDecidesWhetherItHasAFault) {
    for (const bool good_first : {false, true}) {
        MaterialLibrary all = library(good_first ? "newmtl a\nKd 1 0 0\n" : "newmtl a\nKd 1 0\n");
        all.add(library(good_first ? "newmtl a\nKd 1 0\n" : "newmtl a\nKd 1 0 0\n"));
        const MaterialNames names(all);
        if (good_first)
            EXPECT_EQ(names.find("a")->Kd, vec3(1, 0, 0));
        else
            EXPECT_THROW(names.find("a"), Error);
    }
}

}  // namespace gw::scene
