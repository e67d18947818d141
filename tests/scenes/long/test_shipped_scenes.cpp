// Claims: each scene of scenes/ has the same picture by every renderer in another unit, in another
// place, in another order, under other names, beside what nobody sees, and in another notation.
#include "gw/base/arithmetic.h"
#include "image/textures.h"
#include "scene/geometry/transform.h"
#include "scene/maps/finish.h"
#include "scene/text/text_file.h"
#include "scene/toml/read_scene.h"
#include "test_paths.h"
#include "tests/scenes/pictures.h"
#include "tests/temporary_folder.h"

#include <cctype>
#include <cmath>
#include <numeric>
#include <regex>
#include <set>

namespace gw {
namespace {

const std::filesystem::path folder = std::filesystem::path(GW_SOURCE_DIR) / "scenes";

constexpr int columns = 32, rows = 24;
/// Of pixels, at outlines.
constexpr int few = columns * rows / 50;

scene::Scene ready(const std::filesystem::path& file) {
    scene::Scene scene = scene::read_scene(file).scene;
    image::load_textures(scene);
    scene::Warnings warnings;
    scene::finish(scene, warnings);
    scene::add_defaults(scene, columns, rows);
    return scene;
}

/// Every length times a power of two.
void scale(scene::Scene& s) {
    constexpr double by = 1024;
    constexpr float single = 1024;
    for (scene::Object& object : s.objects) {
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 3; ++row) object.world_from_object[column][row] *= by;
        object.move *= by;
        if (object.glare) object.glare->radius *= by;
    }
    for (scene::Light& light : s.lights) {
        light.position *= single;
        light.linear_attenuation /= single;
        light.quadratic_attenuation /= single * single;
        if (light.kind != scene::LightKind::Directional) {
            light.area.u *= single;
            light.area.v *= single;
        }
    }
    scene::Camera& c = *s.camera;
    c.eye *= by;
    c.at *= by;
    for (double* length : {&c.near_plane, &c.far_plane, &c.ortho_height, &c.aperture, &c.focus})
        *length *= by;
    if (s.fog) {
        s.fog->start *= single;
        s.fog->end *= single;
        s.fog->density /= single;
    }
}

void move(scene::Scene& s) {
    const dvec3 by(-2, 5, 3);
    for (scene::Object& object : s.objects) object.world_from_object[3] += dvec4(by, 0);
    for (scene::Light& light : s.lights) light.position += vec3(by);
    s.camera->eye += by;
    s.camera->at += by;
}

/// Other names, and a material that nothing uses.
void rename(scene::Scene& s) {
    for (scene::Object& object : s.objects) object.name = "x " + object.name;
    for (scene::Material& material : s.materials) material.name = "x " + material.name;
    for (scene::Light& light : s.lights) {
        std::set<std::string> only;
        for (const std::string& name : light.only) only.insert("x " + name);
        light.only = only;
    }
    s.materials.insert(s.materials.begin(), scene::Material{.name = "unused"});
    for (scene::Object& object : s.objects) ++object.material;
}

/// Straight ahead, too far to be seen.
void add_far_triangle(scene::Scene& s) {
    const dvec3 ahead = s.camera->at - s.camera->eye;
    s.materials.push_back({.name = "far"});
    const auto side = static_cast<float>(std::sqrt(dot3(ahead, ahead)) / 1024);
    MeshData data{.primitive = Primitive::Triangles,
                  .positions = {{0, 0, 0}, {side, 0, 0}, {0, side, 0}}};
    data.normals.assign(3, {0, 0, 1});
    s.objects.push_back({.name = "far",
                         .mesh = make_mesh(std::move(data)),
                         .material = s.materials.size() - 1,
                         .world_from_object = scene::translation(s.camera->eye + ahead * 1000.0),
                         .casts_shadow = false});
}

/// The last object and the last face of each mesh first.
void reverse(scene::Scene& s) {
    std::ranges::reverse(s.objects);
    for (scene::Object& object : s.objects) {
        MeshData data = object.mesh->data();
        const std::size_t sides = data.primitive == Primitive::Triangles ? 3
                                  : data.primitive == Primitive::Quads   ? 4
                                                                         : 0;
        const bool is_list = data.primitive == Primitive::Polygons && !data.polygon_sizes.empty();
        if (sides == 0 && !is_list) continue;
        std::vector<std::uint32_t> corners = data.indices, reversed;
        if (corners.empty()) {
            corners.resize(data.positions.size());
            std::iota(corners.begin(), corners.end(), 0u);
        }
        std::size_t end = corners.size();
        for (std::size_t face = object.mesh->polygon_count(); face-- > 0;) {
            const std::size_t count = is_list ? data.polygon_sizes[face] : sides;
            end -= count;
            const auto from = corners.begin() + std::ptrdiff_t(end);
            reversed.insert(reversed.end(), from, from + std::ptrdiff_t(count));
        }
        data.indices = reversed;
        std::ranges::reverse(data.polygon_sizes);
        object.mesh = make_mesh(std::move(data));
    }
}

/// 0.25 as 25e-2, with line ends of Windows. Strings and comments stay.
std::string in_other_notation(const std::string& text) {
    static const std::regex pieces(R"("[^"\n]*"|#[^\n]*|(\d+)\.(\d+)(?![\deE])|\n)");
    std::string out;
    std::size_t done = 0;
    for (std::sregex_iterator it(text.begin(), text.end(), pieces), end; it != end; ++it) {
        out += text.substr(done, std::size_t(it->position()) - done);
        done = std::size_t(it->position() + it->length());
        if (it->str() == "\n")
            out += "\r\n";
        else if ((*it)[2].matched)
            out += std::to_string(std::stoll((*it)[1].str() + (*it)[2].str())) + "e-" +
                   std::to_string((*it)[2].length());
        else
            out += it->str();
    }
    return out + text.substr(done);
}

/// The scene's file in other words, beside links to the files that it names.
scene::Scene read_in_other_words(const std::filesystem::path& name) {
    const TemporaryFolder copy;
    const std::filesystem::path inner = copy.path() / name.parent_path();
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().filename() != name.parent_path())
            std::filesystem::create_symlink(entry.path(), copy.path() / entry.path().filename());
    std::filesystem::create_directories(inner);
    if (!name.parent_path().empty())
        for (const auto& entry : std::filesystem::directory_iterator(folder / name.parent_path()))
            std::filesystem::create_symlink(entry.path(), inner / entry.path().filename());
    std::filesystem::remove(copy.path() / name);
    copy.write(name.string(), in_other_notation(scene::read_text(folder / name)));
    return ready(copy.path() / name);
}

std::vector<std::string> files() {
    std::vector<std::string> names;
    for (const char* inner : {"", "hidden", "radiosity"})
        for (const auto& entry : std::filesystem::directory_iterator(folder / inner))
            if (const auto type = entry.path().extension(); type == ".toml" || type == ".gltf")
                names.push_back((inner / entry.path().filename()).string());
    std::ranges::sort(names);
    return names;
}

class ShippedScene : public testing::TestWithParam<std::string> {};

TEST_P(ShippedScene, IsTheSame) {
    const scene::Scene scene = ready(folder / GetParam());
    const auto pictures = [](const scene::Scene& s) { return pictures_of(s, columns, rows); };
    const Pictures before = pictures(scene);
    const auto after = [&](void (*change)(scene::Scene&)) {
        scene::Scene other = scene;
        change(other);
        return pictures(other);
    };
    expect_alike(before, after([](scene::Scene& s) {
                     scale(s);
                     rename(s);
                 }),
                 "1024 times as large, under other names");
    // Places are rounded anew where they are no multiples of a power of two.
    expect_alike(before, after(move), "moved", {few, 1});
    expect_alike(before, after(add_far_triangle), "with a triangle far away", {few, 1});
    // Where depths tie, as at a silhouette, the first face is seen.
    expect_alike(before, after(reverse), "in another order", {few});
    if (!GetParam().ends_with(".gltf"))
        expect_alike(before, pictures(read_in_other_words(GetParam())), "in another notation");
}

INSTANTIATE_TEST_SUITE_P(All, ShippedScene, testing::ValuesIn(files()), [](const auto& test) {
    std::string name = test.param;
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
});

}  // namespace
}  // namespace gw
