// Claims: each wrong TOML scene is one message with its line; unknown keys name the nearest known
// one.
#include <gtest/gtest.h>

#include "tests/scene/folder.h"

namespace gw::scene {
namespace {

struct TomlError : testing::Test {
    Folder folder;
    TomlError() {
        folder.write("t.mtl", "newmtl red\n");
        folder.write("t.obj", "mtllib t.mtl\n" + triangle + "o tri\nusemtl red\nf 1 2 3\n");
    }
    std::string fault(const std::string& text) { return folder.scene_error("s.toml", text); }
    std::string object(const std::string& key) {
        return fault("[[object]]\nfile = 't.obj'\n" + key + "\n");
    }
    std::string camera(const std::string& key) { return fault("[camera]\n" + key + "\n"); }
    std::string light(const std::string& keys) {
        return fault("[[object]]\nfile = 't.obj'\n[[light]]\n" + keys + "\n");
    }
    std::string material(const std::string& key) { return fault("[material.m]\n" + key + "\n"); }
};

}  // namespace

TEST_F(TomlError, Syntax) {
    EXPECT_EQ(fault("[camera\n").substr(0, 9), "s.toml:1:");
    EXPECT_EQ(fault("\n\na = \n").substr(0, 9), "s.toml:3:");
    EXPECT_EQ(fault("[fog]\n[fog]\n").substr(0, 9), "s.toml:2:");
    EXPECT_EQ(fault("name = '\xff'\n").substr(0, 9), "s.toml:1:");
    EXPECT_EQ(fault("\nname = '\xff'\n"), "s.toml:2: is not UTF-8; expected UTF-8 text");
    EXPECT_EQ(fault("name = \"\x95\x5c\"\n"), "s.toml:1: is not UTF-8; expected UTF-8 text");
    EXPECT_EQ(fault("texels = .5\n"),
              "s.toml:1: a number begins with its point; expected a digit before it: 0.1, not .1");
    EXPECT_EQ(fault("[camera]\neye = [1, -.5, 2]\n"),
              "s.toml:2: a number begins with its point; expected a digit before it: 0.1, not .1");
    EXPECT_EQ(fault("[camera]\neye = [1, 5., 2]\n"),
              "s.toml:2: a number ends with its point; expected a digit after it: 1.0, not 1.");
    // Texts that toml++ asserts to be impossible.
    EXPECT_EQ(fault("[=]\n").substr(0, 9), "s.toml:1:");
    EXPECT_EQ(fault(std::string("\n[\0[light]]\n", 12)).substr(0, 9), "s.toml:2:");
}

TEST_F(TomlError, UnknownKeys) {
    EXPECT_EQ(fault("\n[camrea]\n"),
              "s.toml:2: unknown key 'camrea'; the nearest known is 'camera'");
    EXPECT_EQ(camera("fvo = 3"),
              "s.toml:2: unknown key 'fvo' in camera; the nearest known is 'fov'");
    EXPECT_EQ(camera("\n'fo v' = 3"),
              "s.toml:3: unknown key 'fo v' in camera; the nearest known is 'fov'");
    EXPECT_EQ(light("postion = [0, 0, 0]\ndirection = [0, 1, 0]"),
              "s.toml:4: unknown key 'postion' in light; the nearest known is 'position'");
    EXPECT_EQ(object("transalte = [0, 0, 0]"),
              "s.toml:3: unknown key 'transalte' in object; the nearest known is 'translate'");
    EXPECT_EQ(object("radius = 3"),
              "s.toml:3: unknown key 'radius' in object; the nearest known is 'parts'");
    EXPECT_EQ(material("kd = 1"),
              "s.toml:2: unknown key 'kd' in material.m; the nearest known is 'Kd'");
    EXPECT_EQ(material("map_Kd = {fiel = 'x'}"),
              "s.toml:2: unknown key 'fiel' in material.m.map_Kd; the nearest known is 'file'");
    EXPECT_EQ(fault("fog = {colour = 1}\n"),
              "s.toml:1: unknown key 'colour' in fog; the nearest known is 'color'");
    EXPECT_EQ(light("position = [0, 0, 0]\narea = {shape = 'disc', w = 1}"),
              "s.toml:5: unknown key 'w' in light.area; the nearest known is 'u'");
}

TEST_F(TomlError, WrongTypes) {
    EXPECT_EQ(camera("eye = 1"), "s.toml:2: camera.eye is 1; expected an array of 3 numbers");
    EXPECT_EQ(camera("eye = [1, 2]"),
              "s.toml:2: camera.eye has 2 elements; expected an array of 3 numbers");
    EXPECT_EQ(camera("eye = [1,\n 2,\n 'x']"), "s.toml:4: camera.eye is 'x'; expected a number");
    EXPECT_EQ(camera("fov = 'wide'"),
              "s.toml:2: camera.fov is 'wide'; expected a number from 0.1 to 179");
    EXPECT_EQ(camera("fov = true"),
              "s.toml:2: camera.fov is true; expected a number from 0.1 to 179");
    EXPECT_EQ(camera("fov = 1979-05-27"),
              "s.toml:2: camera.fov is a date; expected a number from 0.1 to 179");
    EXPECT_EQ(camera("fov = {}"),
              "s.toml:2: camera.fov is a table; expected a number from 0.1 to 179");
    EXPECT_EQ(fault("camera = 3\n"), "s.toml:1: camera is 3; expected a table");
    EXPECT_EQ(fault("name = 3\n"), "s.toml:1: name is 3; expected a string");
    EXPECT_EQ(fault("light = 3\n"), "s.toml:1: light is 3; expected [[light]]");
    EXPECT_EQ(fault("object = [3]\n"), "s.toml:1: object is 3; expected a table");
    EXPECT_EQ(fault("material = 3\n"), "s.toml:1: material is 3; expected [material.NAME]");
    EXPECT_EQ(fault("mtllib = 3\n"),
              "s.toml:1: mtllib is 3; expected a string or an array of strings");
    EXPECT_EQ(object("visible = 1"), "s.toml:3: object.visible is 1; expected true or false");
    EXPECT_EQ(object("material = 1"), "s.toml:3: object.material is 1; expected a name or a table");
    EXPECT_EQ(material("Kd = '1 0 0'"),
              "s.toml:2: material.m.Kd is '1 0 0'; expected a number or an array of 3 numbers");
    EXPECT_EQ(material("illum = 2.5"),
              "s.toml:2: material.m.illum is 2.5; expected a whole number from 0 to 10");
}

TEST_F(TomlError, NumbersOutOfRange) {
    EXPECT_EQ(camera("fov = 180"),
              "s.toml:2: camera.fov is 180; expected a number from 0.1 to 179");
    EXPECT_EQ(camera("near = -1"),
              "s.toml:2: camera.near is -1; expected a number from 0 to 1e+18");
    EXPECT_EQ(camera("eye = [0, nan, 0]"), "s.toml:2: camera.eye is nan; expected a number");
    EXPECT_EQ(camera("eye = [0, inf, 0]"), "s.toml:2: camera.eye is inf; expected a number");
    EXPECT_EQ(material("Kd = [0, -0.5, 0]"),
              "s.toml:2: material.m.Kd is -0.5; expected a number from 0");
    EXPECT_EQ(material("Ke = 1e39"),
              "s.toml:2: material.m.Ke is 1e39; expected a number that a float32 holds");
    EXPECT_EQ(material("d = 1.5"), "s.toml:2: material.m.d is 1.5; expected a number from 0 to 1");
    EXPECT_EQ(material("Ns = 10001"),
              "s.toml:2: material.m.Ns is 10001; expected a number from 0 to 10000");
    EXPECT_EQ(material("illum = 11"),
              "s.toml:2: material.m.illum is 11; expected a whole number from 0 to 10");
    EXPECT_EQ(object("crease = 181"),
              "s.toml:3: object.crease is 181; expected a number from 0 to 180");
    EXPECT_EQ(light("position = [0, 0, 0]\nexponent = 129"),
              "s.toml:5: light.exponent is 129; expected a number from 0 to 128");
}

TEST_F(TomlError, WordsThatAreNone) {
    EXPECT_EQ(light("kind = 'sun'"),
              "s.toml:4: light.kind is 'sun'; expected 'directional', 'point' or 'spot'");
    EXPECT_EQ(light("position = [0, 0, 0]\nshadow = true"),
              "s.toml:5: light.shadow is true; expected 'none', 'volume' or 'map'");
    EXPECT_EQ(fault("fog = {mode = 'EXP'}\n"),
              "s.toml:1: fog.mode is 'EXP'; expected 'linear', 'exp' or 'exp2'");
}

TEST_F(TomlError, Cameras) {
    EXPECT_EQ(camera("eye = [0, 0, 0]"), "s.toml:1: camera.at is the eye; expected another point");
    EXPECT_EQ(camera("up = [0, 0, 2]"),
              "s.toml:2: camera.up is along the view; expected another direction");
    EXPECT_EQ(camera("near = 1e300"),
              "s.toml:2: camera.near is 1e300; expected a number from 0 to 1e+18");
    EXPECT_EQ(camera("near = 2\nfar = 1"),
              "s.toml:3: camera.far is not beyond near; expected near < far");
}

TEST_F(TomlError, PlacesBeyondAnyScene) {
    EXPECT_EQ(camera("eye = [1e39, 0, 0]"),
              "s.toml:2: camera.eye is 1e39; expected a number from -1e+18 to 1e+18");
    EXPECT_EQ(camera("at = [0, -1e19, 0]"),
              "s.toml:2: camera.at is -1e19; expected a number from -1e+18 to 1e+18");
    EXPECT_EQ(light("position = [0, 1e20, 0]"),
              "s.toml:4: light.position is 1e20; expected a number from -1e+18 to 1e+18");
}

TEST_F(TomlError, FogThatEndsBeforeItStarts) {
    EXPECT_EQ(fault("fog = {start = 5, end = 2}\n"),
              "s.toml:1: fog.end is not beyond start; expected start < end");
    EXPECT_EQ(fault("fog = {start = 5}\n"),
              "s.toml:1: fog.end is not beyond start; expected start < end");
}

TEST_F(TomlError, EmptyListsOfNames) {
    EXPECT_EQ(light("position = [0, 0, 0]\nonly = []"),
              "s.toml:5: light.only is empty; expected at least one string");
    EXPECT_EQ(object("parts = []"),
              "s.toml:3: object.parts is empty; expected at least one string");
}

TEST_F(TomlError, Lights) {
    EXPECT_EQ(light("Id = 1"),
              "s.toml:3: light has neither position nor direction; expected one of them, or both");
    EXPECT_EQ(light("kind = 'point'\ndirection = [0, 1, 0]"),
              "s.toml:3: light has no position; expected one");
    EXPECT_EQ(light("direction = [0, 0, 0]"),
              "s.toml:4: light.direction is 0; expected a direction that is not 0");
    EXPECT_EQ(light("position = [0, 0, 0]\nonly = ['trio']"),
              "s.toml:5: unknown object 'trio'; the nearest known is 'tri'");
    EXPECT_EQ(light("position = [0, 0, 0]\nattenuation = [0, 0, 0]"),
              "s.toml:5: light.attenuation is 0 everywhere; expected a factor above 0");
    EXPECT_EQ(light("position = [0, 0, 0]\narea = {u = [1, 0, 0]}"),
              "s.toml:5: light.area has no shape; expected 'disc', 'rectangle' or 'line'");
    EXPECT_EQ(light("position = [0, 0, 0]\narea = {shape = 'disc', u = [1, 0, 0]}"),
              "s.toml:5: light.area.v is 0; expected a half axis in world units");
    EXPECT_EQ(light("position = [0, 0, 0]\narea = {shape = 'line', u = [1, 0, 0], samples = 0}"),
              "s.toml:5: light.area.samples is 0; expected a whole number from 1 to 4096");
}

TEST_F(TomlError, Objects) {
    EXPECT_EQ(fault(""), "s.toml: has nothing to draw; expected an [[object]] that is visible");
    EXPECT_EQ(object("visible = false"),
              "s.toml:1: has nothing to draw; expected an [[object]] that is visible");
    EXPECT_EQ(fault("\n[[object]]\nname = 'x'\n"),
              "s.toml:2: object has neither file nor shape; expected one of them");
    EXPECT_EQ(fault("[[object]]\nfile = 'no.obj'\n"),
              "s.toml:2: file 'no.obj' does not exist; expected an OBJ or glTF file");
    std::filesystem::create_directory(folder.path() / "d");
    EXPECT_EQ(fault("[[object]]\nfile = 'd'\n"),
              "s.toml:2: file 'd' is a directory; expected an OBJ or glTF file");
    folder.write("other.STL", "solid x\n");
    EXPECT_EQ(fault("[[object]]\nfile = 'other.STL'\n"),
              "s.toml:2: file 'other.STL' has the extension '.stl'; expected an OBJ or glTF file");
    EXPECT_EQ(fault("[[object]]\nfile = 's.toml'\n"),
              "s.toml:2: file 's.toml' has the extension '.toml'; expected an OBJ or glTF file");
    EXPECT_EQ(fault("\nmtllib = ['d']\n[[object]]\nshape = 'box'\n"),
              "s.toml:2: mtllib 'd' is a directory; expected an MTL file");
    EXPECT_EQ(fault("[[object]]\nfile = '/dev/null'\n"),
              "s.toml:2: file '/dev/null' is a device or a pipe; expected an OBJ or glTF file");
    EXPECT_EQ(object("parts = ['tri', 'quad']"),
              "s.toml:3: unknown part 'quad'; the nearest known is 'tri'");
    EXPECT_EQ(fault("[[object]]\nshape = 'no shape'\n").substr(0, 34),
              "s.toml:2: unknown shape 'no shape'");
}

TEST_F(TomlError, Placements) {
    EXPECT_EQ(object("scale = 0"), "s.toml:3: object.scale is 0; expected numbers other than 0");
    EXPECT_EQ(object("scale = [1, 0, 1]"),
              "s.toml:3: object.scale is 0; expected numbers other than 0");
    EXPECT_EQ(
        object("rotate = 90"),
        "s.toml:3: object.rotate is 90; expected {axis, degrees} or degrees about x, y and z");
    EXPECT_EQ(object("rotate = {degrees = 90}"),
              "s.toml:3: object.rotate.axis is missing or 0; expected a direction");
    EXPECT_EQ(object("rotate = {axis = [0, 1, 0]}"),
              "s.toml:3: object.rotate.degrees is missing; expected an angle");
    EXPECT_EQ(object("rotate = [1e30, 0, 0]"),
              "s.toml:3: object.rotate is 1e30; expected a number from -36000 to 36000");
    EXPECT_EQ(object("rotate = [90, 0]"),
              "s.toml:3: object.rotate has 2 elements; expected an array of 3 numbers");
    EXPECT_EQ(object("translate = [1e300, 0, 0]"),
              "s.toml:3: object.translate is 1e300; expected a number from -1e+18 to 1e+18");
    const std::string rows = "1, 0, 0, 0, 0, 1, 0, 0, ";
    EXPECT_EQ(object("matrix = [" + rows + "0, 0, 1, 0, 0, 0, 1, 1]"),
              "s.toml:3: object.matrix is not affine; expected 0, 0, 0, 1 as its last row");
    EXPECT_EQ(object("matrix = [" + rows + "1, 0, 0, 0, 0, 0, 0, 1]"),
              "s.toml:3: object.matrix is singular; expected one that can be inverted");
    EXPECT_EQ(object("matrix = [" + rows + "0, 0, 1, 0, 0, 0, 0, 1]\nscale = 2"),
              "s.toml:3: matrix beside translate, rotate or scale; expected it alone");
}

TEST_F(TomlError, Materials) {
    EXPECT_EQ(object("material = 'rad'"),
              "s.toml:3: unknown material 'rad'; the nearest known is 'red'");
    EXPECT_EQ(object("material = 'glas'\n[material.glass]\n[material.gold]"),
              "s.toml:3: unknown material 'glas'; the nearest known is 'glass'");
    EXPECT_EQ(material("d = 1\nTr = 0"),
              "s.toml:3: Tr beside d; expected one of them (Tr = 1 - d)");
    EXPECT_EQ(material("map_Kd = ''"),
              "s.toml:2: material.m.map_Kd names no file; expected a texture's file name");
    EXPECT_EQ(
        material("map_Kd = 1"),
        "s.toml:2: material.m.map_Kd is 1; expected a file name, a table with one, or an array of these");
    EXPECT_EQ(fault("mtllib = 'no.mtl'\n"),
              "s.toml:1: mtllib 'no.mtl' does not exist; expected an MTL file");
}

TEST_F(TomlError, ErrorsInItsFilesNameThem) {
    folder.write("bad.obj", "v 1 2\n");
    EXPECT_EQ(fault("[[object]]\nfile = 'bad.obj'\n").substr(0, 29),
              "bad.obj:1: v has 2 numbers; e");
    EXPECT_EQ(folder.error([&] { read_scene(folder.path() / "no.toml"); }),
              "no.toml: cannot be opened: No such file or directory; expected a readable file");
}

}  // namespace gw::scene
