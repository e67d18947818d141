// Claims: each scene of scenes/ has the same picture by every renderer in another unit, in another
// place, in another order, under other names, beside what nobody sees, cut along diagonals, and in
// another notation. Hidden-surface algorithms count the same in another unit and notation.
#include "gw/base/arithmetic.h"
#include "image/textures.h"
#include "scene/geometry/transform.h"
#include "scene/maps/finish.h"
#include "scene/text/text_file.h"
#include "scene/toml/read_scene.h"
#include "test_paths.h"
#include "tests/scenes/counts.h"
#include "tests/scenes/pictures.h"
#include "tests/temporary_folder.h"

#include <array>
#include <cctype>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>
#include <regex>
#include <set>

namespace gw {
namespace {

const std::filesystem::path folder = std::filesystem::path(GW_SOURCE_DIR) / "scenes";

constexpr int columns = 32, rows = 24;
/// Of pixels, at outlines.
constexpr int few = columns * rows / 50, many = 2 * few;

scene::Scene ready(const std::filesystem::path& file) {
    scene::Scene scene = scene::read_scene(file).scene;
    image::load_textures(scene);
    scene::Warnings warnings;
    scene::finish(scene, warnings);
    if (file.parent_path().filename() == "radiosity")  // their light is no renderer's
        scene.lights.push_back({.kind = scene::LightKind::Directional, .direction = {-1, -2, -3}});
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

/// Three points in the world.
using Corners = std::array<dvec3, 3>;

Corners corners_of(const scene::Object& object, const Triangle& triangle) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k)
        corners[k] = dvec3(object.world_from_object *
                           dvec4(dvec3(object.mesh->data().positions[triangle.vertex[k]]), 1));
    return corners;
}

/// How large the front of a triangle looks from the eye.
double seen(const Corners& c, const scene::Camera& camera) {
    const dvec3 normal = cross3(c[1] - c[0], c[2] - c[0]), to_eye = camera.eye - c[0];
    const double distance2 = dot3(to_eye, to_eye);
    return dot3(normal, to_eye) / (distance2 * std::sqrt(distance2));
}

/// The opaque triangle whose front looks largest.
Corners largest_front(const scene::Scene& s) {
    Corners largest{};
    double most = 0;
    for (const scene::Object& object : s.objects) {
        if (!object.mesh || s.materials[object.material].d < 1 ||
            object.mesh->kind() != MeshKind::Triangles)
            continue;
        for (const Triangle& triangle : object.mesh->triangles()) {
            const Corners c = corners_of(object, triangle);
            if (const double now = seen(c, *s.camera); now > most) {
                most = now;
                largest = c;
            }
        }
    }
    return largest;
}

/// Behind the middle of that one. Mirrors and lights do not see it.
void add_hidden_triangle(scene::Scene& s) {
    const Corners front = largest_front(s);
    const dvec3 middle = (front[0] + front[1] + front[2]) / 3.0, eye = s.camera->eye;
    const dvec3 ahead = s.camera->at - eye;
    MeshData data{.primitive = Primitive::Triangles};
    for (const dvec3& corner : front) {
        const dvec3 before = middle + (corner - middle) / 8.0;
        const dvec3 along = s.camera->ortho_height > 0 ? ahead : before - eye;
        data.positions.emplace_back(before + along / 64.0 - middle);
    }
    s.materials.push_back({.name = "hidden", .Ka = vec3(0), .Kd = vec3(0)});
    s.objects.push_back({.name = "hidden",
                         .mesh = make_mesh(std::move(data)),
                         .material = s.materials.size() - 1,
                         .world_from_object = scene::translation(middle),
                         .casts_shadow = false});
}

/// Quads and polygons as triangles.
void cut(scene::Scene& s) {
    for (scene::Object& object : s.objects) {
        MeshData data = object.mesh->data();
        if (data.primitive != Primitive::Quads && data.primitive != Primitive::Polygons) continue;
        data.primitive = Primitive::Triangles;
        data.indices.clear();
        for (const Triangle& triangle : object.mesh->triangles())
            data.indices.insert(data.indices.end(), triangle.vertex.begin(), triangle.vertex.end());
        data.polygon_sizes.clear();
        data.polygon_ids.clear();
        data.edge_flags.clear();
        object.mesh = make_mesh(std::move(data));
    }
}

/// Objects, and the faces of each mesh, in the order that `change` makes of 0, 1, 2, ...
void reorder(scene::Scene& s, const std::function<void(std::vector<std::size_t>&)>& change) {
    const auto order_of = [&](std::size_t count) {
        std::vector<std::size_t> order(count);
        std::iota(order.begin(), order.end(), std::size_t{0});
        change(order);
        return order;
    };
    std::vector<scene::Object> objects;
    for (const std::size_t i : order_of(s.objects.size())) objects.push_back(s.objects[i]);
    s.objects = objects;
    for (scene::Object& object : s.objects) {
        MeshData data = object.mesh->data();
        const std::size_t sides = data.primitive == Primitive::Triangles ? 3
                                  : data.primitive == Primitive::Quads   ? 4
                                                                         : 0;
        const bool is_list = data.primitive == Primitive::Polygons && !data.polygon_sizes.empty();
        if (sides == 0 && !is_list) continue;
        std::vector<std::uint32_t> corners = data.indices, sizes;
        if (corners.empty()) {
            corners.resize(data.positions.size());
            std::iota(corners.begin(), corners.end(), 0u);
        }
        const std::size_t faces = object.mesh->polygon_count();
        std::vector<std::size_t> starts{0};
        for (std::size_t face = 0; face < faces; ++face)
            starts.push_back(starts.back() + (is_list ? data.polygon_sizes[face] : sides));
        data.indices.clear();
        for (const std::size_t face : order_of(faces)) {
            const auto from = corners.begin();
            data.indices.insert(data.indices.end(), from + std::ptrdiff_t(starts[face]),
                                from + std::ptrdiff_t(starts[face + 1]));
            sizes.push_back(std::uint32_t(starts[face + 1] - starts[face]));
        }
        if (is_list) data.polygon_sizes = sizes;
        object.mesh = make_mesh(std::move(data));
    }
}

/// The last object and the last face of each mesh first.
void reverse(scene::Scene& s) {
    reorder(s, [](std::vector<std::size_t>& order) { std::ranges::reverse(order); });
}

void shuffle(scene::Scene& s) {
    std::mt19937 random(7);
    reorder(s, [&](std::vector<std::size_t>& order) { std::ranges::shuffle(order, random); });
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
    constexpr int all = columns * rows;  // needles are seen in a few pixels
    const auto expect_same = [&](const Pictures& now, const std::string& what, Bound bound = {}) {
        bound.one_in = all;
        expect_alike(before, now, what, bound);
    };
    expect_same(after([](scene::Scene& s) {
                    scale(s);
                    rename(s);
                }),
                "1024 times as large, under other names");
    // Places are rounded anew where they are no multiples of a power of two.
    expect_same(after(move), "moved", {few, 1});
    expect_same(after(add_far_triangle), "with a triangle far away", {few, 1});
    // Shadow volumes and glare reach to the bounds of all objects, so their outlines round anew.
    expect_same(after(add_hidden_triangle), "with a hidden triangle", {many});
    // Two renderers send rays where polygons meet, and now more of them do.
    Pictures cut_ones = after(cut);
    for (const char* name : {"adaptive", "multipass"}) {
        EXPECT_LE(differing(before.at(name), cut_ones.at(name)), many) << "cut, " << name;
        cut_ones[name] = before.at(name);
    }
    expect_same(cut_ones, "cut along diagonals");
    // Where depths tie, as at a silhouette, the first face is seen.
    expect_same(after(reverse), "in reverse order", {few});
    expect_same(after(shuffle), "in another order", {few});
    if (!GetParam().ends_with(".gltf"))
        expect_same(pictures(read_in_other_words(GetParam())), "in another notation");
}

/// Of scenes that even the slowest algorithms draw in a moment.
TEST_P(ShippedScene, IsTheSameWork) {
    const scene::Scene scene = ready(folder / GetParam());
    std::size_t faces = 0;
    for (const scene::Object& object : scene.objects) faces += object.mesh->polygon_count();
    if (faces > 500) GTEST_SKIP() << faces << " faces";
    const AllCounts before = counts_of(scene, columns, rows);
    scene::Scene other = scene;
    scale(other);
    rename(other);
    expect_same_counts(before, counts_of(other, columns, rows), "1024 times as large, renamed");
    if (!GetParam().ends_with(".gltf"))
        expect_same_counts(before, counts_of(read_in_other_words(GetParam()), columns, rows),
                           "in another notation");
}

INSTANTIATE_TEST_SUITE_P(All, ShippedScene, testing::ValuesIn(files()), [](const auto& test) {
    std::string name = test.param;
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
});

}  // namespace
}  // namespace gw
