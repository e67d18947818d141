// Claims: every shape of the table can be asked for by its name, with its parameters as keys and
// nothing else.
#include <gtest/gtest.h>

#include "scene/toml/shape_table.h"
#include "tests/scene/folder.h"

namespace gw::scene {
namespace {

struct TomlShapes : testing::Test {
    Folder folder;
    Scene scene(const std::string& keys) {
        return read_scene(folder.write("s.toml", "[[object]]\n" + keys + "\n")).scene;
    }
    std::string fault(const std::string& keys) {
        return folder.scene_error("s.toml", "[[object]]\n" + keys + "\n");
    }
};

}  // namespace

TEST_F(TomlShapes, AreAllThereWithTheirDefaults) {
    for (const Shape& shape : shapes()) {
        std::vector<double> values;
        std::string keys;
        for (const ShapeParameter& p : shape.parameters) {
            values.push_back(p.value);
            keys +=
                "\n" + p.name + " = " +
                (p.integer ? std::to_string(static_cast<int>(p.value)) : std::to_string(p.value));
        }
        const Scene s = scene("shape = '" + shape.name + "'");
        ASSERT_EQ(s.objects.size(), 1u);
        EXPECT_EQ(s.objects[0].name, shape.name);
        EXPECT_EQ(s.materials[0].name, "default");
        EXPECT_EQ(s.objects[0].mesh->data().positions, shape.make(values).positions) << shape.name;
        EXPECT_EQ(fault("shape = '" + shape.name + "'" + keys), "no error");
    }
}

TEST_F(TomlShapes, TakeTheirParameters) {
    const Scene s = scene(
        "shape = 'disc'\nradius = 0.5\nslices = 8\nname = 'coin'\nmaterial = {Kd = [1, 0, 0]}");
    EXPECT_EQ(s.objects[0].name, "coin");
    EXPECT_EQ(s.materials[0].Kd, vec3(1, 0, 0));
    EXPECT_EQ(bounds(s).high.x, 0.5);
    EXPECT_EQ(scene("shape = 'cone'\ncapped = false").objects[0].mesh->data().positions,
              scene("shape = 'cone'\ncapped = 0").objects[0].mesh->data().positions);
}

TEST_F(TomlShapes, HeightFieldIsTheMeshOfItsObjFile) {
    folder.write("field.obj",
                 "v -1 0.25 0\nv 0 0.5 0\nv 2 0 0\nv -1 1 0.3\nv 0 -0.1 0.3\nv 2 0.7 0.3\n"
                 "f 1 4 5 2\nf 2 5 6 3\n");
    const std::string field =
        "shape = 'height_field'\nx = [-1, 0, 2]\nz = [0, 0.3]\n"
        "heights = [[0.25, 0.5, 0], [1, -0.1, 0.7]]";
    const MeshData expected = scene("file = 'field.obj'").objects[0].mesh->data();
    const MeshData actual = scene(field).objects[0].mesh->data();
    EXPECT_TRUE(actual == expected);
    EXPECT_EQ(scene(field + "\ndivide = 2").objects[0].mesh->data().positions,
              scene("file = 'field.obj'\ndivide = 2").objects[0].mesh->data().positions);
}

TEST_F(TomlShapes, HeightFieldRefusesWhatIsNoGrid) {
    const auto of = [&](const std::string& keys) {
        return fault("shape = 'height_field'\n" + keys);
    };
    EXPECT_EQ(of("x = [0, 1]\nz = [0, 1]"),
              "s.toml:1: height_field has no heights; expected x, z and heights");
    EXPECT_EQ(of("x = [0]\nz = [0, 1]\nheights = [[0], [0]]"),
              "s.toml:3: object.x has 1 numbers; expected 2 to 4096");
    EXPECT_EQ(of("x = [0, 0]\nz = [0, 1]\nheights = [[0, 0], [0, 0]]"),
              "s.toml:3: object.x does not increase; expected each number above the last");
    EXPECT_EQ(of("x = [0, 1]\nz = [0, 'a']\nheights = [[0, 0], [0, 0]]"),
              "s.toml:4: object.z is 'a'; expected a number");
    EXPECT_EQ(of("x = [0, 1]\nz = [0, 1]\nheights = [[0, 0]]"),
              "s.toml:5: object.heights has 1 rows; expected one for each of 2 z");
    EXPECT_EQ(of("x = [0, 1]\nz = [0, 1]\nheights = [[0, 0], [0]]"),
              "s.toml:5: object.heights has 1 elements; expected an array of 2 numbers");
    EXPECT_EQ(of("x = [0, 1]\nz = [0, 1]\nheights = [[0, 0], [0, 0]]\nradius = 1"),
              "s.toml:6: unknown key 'radius' in object; the nearest known is 'parts'");
}

TEST_F(TomlShapes, RefuseWhatIsNotTheirs) {
    EXPECT_EQ(fault("shape = 'tours'"),
              "s.toml:2: unknown shape 'tours'; the nearest known is 'torus'");
    EXPECT_EQ(fault("shape = 3"), "s.toml:2: object.shape is 3; expected a string");
    EXPECT_EQ(fault("shape = 'disc'\nradus = 1"),
              "s.toml:3: unknown key 'radus' in object; the nearest known is 'radius'");
    EXPECT_EQ(fault("shape = 'disc'\nslices = 2"),
              "s.toml:3: object.slices is 2; expected a whole number from 3 to 4096");
    EXPECT_EQ(fault("shape = 'disc'\nslices = 3.5"),
              "s.toml:3: object.slices is 3.5; expected a whole number from 3 to 4096");
    EXPECT_EQ(fault("shape = 'disc'\nradius = 0"),
              "s.toml:3: object.radius is 0; expected a number from 1e-06 to 1e+06");
    EXPECT_EQ(fault("shape = 'disc'\nfile = 'a.obj'"),
              "s.toml:1: object has both file and shape; expected one of them");
    EXPECT_EQ(fault("shape = 'disc'\ncrease = 30"),
              "s.toml:3: crease beside shape; expected it beside file");
    EXPECT_EQ(fault("shape = 'disc'\nparts = 'a'"),
              "s.toml:3: parts beside shape; expected it beside file");
}

}  // namespace gw::scene
