// Attribute mapping [K3.1]: a map of its own for each component of one object, from MTL and from
// TOML, each component's image being the map times what the light sends.
#include "multipass/frame/driver.h"
#include "scene/toml/read_scene.h"
#include "tests/multipass/scenes.h"

#include <gtest/gtest.h>
#include "tests/temporary_folder.h"

namespace gw::multipass {
namespace {

constexpr int size = 16;
constexpr std::size_t middle = size / 2 * size + size / 2;

/// A square whose material comes from `material` (TOML) over m.mtl.
class ComponentMaps : public testing::Test {
protected:
    ComponentMaps() {
        write(
            "q.obj",
            "mtllib m.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n"
            "usemtl m\nf 1/1/1 2/2/1 3/3/1 4/4/1\n");
        write(
            "m.mtl",
            "newmtl m\nKa 1 1 1\nKd 1 1 1\nKs 1 1 1\nKe 1 1 1\nNs 0\n"
            "map_Ka a.png\nmap_Kd d.png\nmap_Kd d2.png\nmap_Ks s.png\nmap_Ke e.png\nrefl r.png\n");
    }
    void write(const std::string& name, const std::string& text) const {
        folder_.write(name, text);
    }

    /// The colours of the square in each component's image.
    std::vector<std::pair<std::string, Rgba>> images(const std::string& material) const {
        write(
            "s.toml",
            "[camera]\northo = 4\n[[light]]\nname = 'l'\ndirection = [0, 0, -1]\nIa = 1\nId = 1\nIs = 1\n"
            "[[object]]\nfile = 'q.obj'\n" +
                material);
        scene::Scene s = scene::read_scene(folder_ / "s.toml").scene;
        scene::Material& m = s.materials.at(0);
        for (auto* maps : {&m.map_Ka, &m.map_Kd, &m.map_Ks, &m.map_Ke, &m.refl, &m.refraction})
            for (scene::Map& map : *maps) map.texture = texture(map.file.filename().string());
        const auto machine = make_reference(vgx(), size, size);
        std::vector<std::pair<std::string, Rgba>> result;
        for (const ComponentImage& image :
             render_components(*machine, s, scene::make_view(s, size, size), {}))
            result.emplace_back(image.name, image.color[middle]);
        return result;
    }

    /// Each file name is a colour.
    static TextureRef texture(const std::string& file) {
        const std::uint8_t by_name[][3] = {{10, 0, 0},  {0, 20, 0},  {0, 7, 0},  {0, 0, 30},
                                           {40, 40, 0}, {0, 50, 50}, {60, 0, 60}};
        const std::string names[] = {"a.png", "d.png", "d2.png", "s.png",
                                     "e.png", "r.png", "t.png"};
        for (std::size_t i = 0; i < 7; ++i)
            if (names[i] == file)
                return plain_map(by_name[i][0], by_name[i][1], by_name[i][2]).texture;
        ADD_FAILURE() << file;
        return nullptr;
    }

private:
    TemporaryFolder folder_;
};

using Images = std::vector<std::pair<std::string, Rgba>>;

const Images all{{"ambient", {10, 0, 0, 255}},   {"diffuse", {0, 27, 0, 255}},
                 {"specular", {0, 0, 30, 255}},  {"reflection", {0, 50, 50, 255}},
                 {"refraction", {0, 0, 0, 255}}, {"emission", {40, 40, 0, 255}}};

TEST_F(ComponentMaps, OfMtlBelongToTheirComponents) { EXPECT_EQ(images(""), all); }

TEST_F(ComponentMaps, OfTomlBelongToTheirComponents) {
    write("m.mtl", "newmtl m\n");
    EXPECT_EQ(
        images(
            "material = {Ka = 1, Kd = 1, Ks = 1, Ke = 1, Ns = 0, map_Ka = 'a.png', map_Kd = ['d.png', "
            "'d2.png'], map_Ks = {file = 's.png'}, map_Ke = 'e.png', refl = 'r.png'}\n"),
        all);
}

TEST_F(ComponentMaps, OfTomlReplaceThoseOfMtlOneByOne) {
    Images expected = all;
    expected[1].second = {40, 40, 0, 255};
    expected[4].second = {60, 0, 60, 255};
    EXPECT_EQ(images("material = {map_Kd = 'e.png', refraction = 't.png'}\n"), expected);
}

}  // namespace
}  // namespace gw::multipass
