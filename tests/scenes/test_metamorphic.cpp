// Claims: what a text says in another way, in another place or beside what nobody sees makes the same
// picture, by every renderer and every algorithm. Each relation holds to the bit unless its test says
// why not. Scenes are random, or those of scenes/hidden.
#include "scene/text/text_file.h"
#include "scene/toml/read_scene.h"
#include "test_paths.h"
#include "tests/scenes/counts.h"
#include "tests/scenes/pictures.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <random>
#include <sstream>

namespace gw {
namespace {

constexpr int width = 64, height = 48;

Pictures pictures_of(const std::filesystem::path& file) {
    return gw::pictures_of(scene::read_scene(file).scene, width, height);
}

struct Face {
    std::vector<dvec3> corners;
    std::string group, material;
};

/// How a model is written.
struct Writing {
    std::function<std::string(double)> number = [](double v) {
        std::ostringstream text;
        text.precision(17);
        text << v;
        return text.str();
    };
    std::string prefix;  ///< of all names
    std::string more;    ///< statements that nothing uses
    double scale = 1;
    dvec3 move{0};
};

struct Model {
    std::vector<Face> faces;
    dvec3 eye{0, 0, 16}, at{0, 0, 0};
};

/// Faces in slabs one behind the other: no two of them tie. Coordinates are multiples of 1/64, so
/// that moved ones round nowhere.
Model random_model(std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto coordinate = [&](int reach) {
        return (int(random() % (128u * unsigned(reach))) - 64 * reach) / 64.0;
    };
    Model model;
    for (int i = 0; i < 24; ++i) {
        const double z = -i / 4.0, x = coordinate(4), y = coordinate(3);
        const double w = 1 + double(random() % 128) / 64, h = 1 + double(random() % 128) / 64;
        const std::string group = "g" + std::to_string(i % 5),
                          material = "m" + std::to_string(i % 3);
        model.faces.push_back(
            {{{x, y, z}, {x + w, y, z}, {x + w, y + h, z}, {x, y + h, z}}, group, material});
    }
    return model;
}

/// The model's files; returns the scene's.
std::filesystem::path write(const TemporaryFolder& folder, const std::string& name,
                            const Model& model, const Writing& w = {}) {
    std::string mtl, obj = "mtllib " + name + ".mtl\n" + w.more, state;
    for (int i = 0; i < 3; ++i)
        mtl += "newmtl " + w.prefix + "m" + std::to_string(i) + "\nKa " + w.number(0.25) + "\nKd " +
               w.number(0.25 * (i + 1)) + " " + w.number(0.5) + " " + w.number(1 - 0.25 * i) +
               "\nKs 0.5\nNs 8\n";
    const auto point = [&](const dvec3& p) {
        const dvec3 q = p * w.scale + w.move;
        return w.number(q.x) + " " + w.number(q.y) + " " + w.number(q.z);
    };
    for (const Face& face : model.faces) {
        const std::string now =
            "g " + w.prefix + face.group + "\nusemtl " + w.prefix + face.material + "\n";
        if (now != state) obj += state = now;
        for (const dvec3& p : face.corners) obj += "v " + point(p) + "\n";
        obj += "vn 0 0 1\nf";
        for (int k = -int(face.corners.size()); k < 0; ++k) obj += " " + std::to_string(k) + "//-1";
        obj += "\n";
    }
    const auto place = [&](const dvec3& p) {
        std::string text = point(p);
        std::replace(text.begin(), text.end(), ' ', ',');
        return "[" + text + "]";
    };
    folder.write(name + ".mtl", mtl);
    folder.write(name + ".obj", obj);
    return folder.write(name + ".toml",
                        "[camera]\neye = " + place(model.eye) + "\nat = " + place(model.at) +
                            "\n[[light]]\ndirection = [0.5, -1, -2]\n[[object]]\nfile = \"" + name +
                            ".obj\"\n");
}

AllCounts counts_of(const std::filesystem::path& file) {
    return gw::counts_of(scene::read_scene(file).scene, width, height);
}

/// Texts that say the same, or the same in another unit or place.
std::map<std::string, Writing> writings() {
    std::map<std::string, Writing> all;
    all["renamed"].prefix = "some name ";
    all["with what nothing uses"].more =
        "# nothing\nv 900 900 900\nvt 3 3\nvn nan nan nan\ng none\nusemtl none\nlod 3\ng\nusemtl\n";
    all["in exponents"].number = [](double v) {
        std::ostringstream text;
        text.precision(17);
        text << std::scientific << v;
        return text.str();
    };
    all["with signs and zeros"].number = [](double v) {
        std::ostringstream text;
        text.precision(20);
        text << std::fixed << std::showpos << v;
        return text.str();
    };
    all["1024 times as large"].scale = 1024;
    all["in thousandths"].scale = 1.0 / 1024;
    all["moved"].move = {-2, 5, 3};
    all["in map coordinates"].move = {431000, 5411000, 0};
    return all;
}

class Metamorphic : public testing::TestWithParam<int> {
protected:
    TemporaryFolder folder;
    Model model = random_model(std::uint32_t(GetParam()));
    std::filesystem::path file = write(folder, "a", model);
    Pictures before = pictures_of(file);

    void expect_same(const Model& other, const std::string& what, const Bound& bound = {}) {
        expect_alike(before, pictures_of(write(folder, "b", other)), what, bound);
    }
};

TEST_P(Metamorphic, AnotherWritingIsTheSamePictureAndWork) {
    const AllCounts counts = counts_of(file);
    for (const auto& [what, writing] : writings()) {
        const auto other = write(folder, "b", model, writing);
        const bool moves = writing.move != dvec3(0);
        expect_alike(before, pictures_of(other), what, {.ray_units = moves});
        if (!moves) expect_same_counts(counts, counts_of(other), what);
    }
}

TEST_P(Metamorphic, AnotherOrderIsTheSamePicture) {
    Model other = model;
    std::reverse(other.faces.begin(), other.faces.end());
    expect_same(other, "reversed");
    std::mt19937 random(7);
    std::shuffle(other.faces.begin(), other.faces.end(), random);
    expect_same(other, "shuffled");
}

TEST_P(Metamorphic, ATriangleFarAwayChangesNothingElse) {
    for (const double far_away : {1e3, 2e5, 5e5}) {
        Model other = model;
        other.faces.push_back(
            {{{0, 0, -far_away}, {1, 0, -far_away}, {0, 1, -far_away}}, "far", "m0"});
        expect_same(other, "with a triangle " + std::to_string(far_away) + " away",
                    {.ray_units = 1});
    }
}

TEST_P(Metamorphic, AHiddenTriangleChangesNothing) {
    Model other = model;
    const Face front = other.faces.front();
    const dvec3 middle = (front.corners[0] + front.corners[2]) / 2.0;
    Face behind{{}, "hidden", "m2"};
    for (std::size_t k = 0; k < 3; ++k)
        behind.corners.push_back((front.corners[k] + middle) / 2.0 - dvec3(0, 0, 1.0 / 64));
    other.faces.push_back(behind);
    expect_same(other, "with a hidden triangle");
}

TEST_P(Metamorphic, AQuadCutAlongItsDiagonalIsTheSame) {
    Model other = model;
    other.faces.clear();
    for (const Face& f : model.faces) {
        other.faces.push_back({{f.corners[0], f.corners[1], f.corners[2]}, f.group, f.material});
        other.faces.push_back({{f.corners[0], f.corners[2], f.corners[3]}, f.group, f.material});
    }
    expect_same(other, "cut");
}

/// Quarters have corners of their own, which the machine snaps to sixteenths of a pixel: pixels on
/// outlines may change.
TEST_P(Metamorphic, AQuadDividedInFourIsTheSameButForOutlines) {
    Model other = model;
    other.faces.clear();
    for (const Face& f : model.faces) {
        const auto at = [&](double u, double v) {
            return f.corners[0] + (f.corners[1] - f.corners[0]) * u +
                   (f.corners[3] - f.corners[0]) * v;
        };
        for (const double u : {0.0, 0.5})
            for (const double v : {0.0, 0.5})
                other.faces.push_back(
                    {{at(u, v), at(u + 0.5, v), at(u + 0.5, v + 0.5), at(u, v + 0.5)},
                     f.group,
                     f.material});
    }
    expect_same(other, "divided", {width * height / 50, 1});
}

INSTANTIATE_TEST_SUITE_P(Random, Metamorphic, testing::Range(1, 4));

/// Shipped models: only their text changes.
class Shipped : public testing::TestWithParam<const char*> {};

/// The file with every v changed.
std::string with_positions(const std::string& text,
                           const std::function<std::string(const dvec3&)>& change) {
    std::istringstream lines(text);
    std::string out;
    for (std::string line; std::getline(lines, line);) {
        dvec3 p(0);
        std::istringstream words(line);
        std::string keyword;
        if (words >> keyword >> p.x >> p.y >> p.z && keyword == "v")
            out += "V " + change(p) + "\n";
        else
            out += line + "\n";
    }
    return out;
}

TEST_P(Shipped, AnotherWritingIsTheSamePicture) {
    const std::filesystem::path models = std::filesystem::path(GW_SOURCE_DIR) / "scenes/hidden";
    const TemporaryFolder folder;
    folder.write("colors.mtl", scene::read_text(models / "colors.mtl"));
    const std::string text = scene::read_text(models / GetParam());
    const Pictures before = pictures_of(folder.write("a.obj", text));
    const auto write_point = [](const dvec3& p) {
        std::ostringstream words;
        words.precision(17);
        words << std::scientific << p.x << ' ' << p.y << ' ' << p.z;
        return words.str();
    };
    expect_alike(before, pictures_of(folder.write("b.obj", with_positions(text, write_point))),
                 "in exponents");
    const auto large = [&](const dvec3& p) { return write_point(p * 1024.0); };
    expect_alike(before, pictures_of(folder.write("b.obj", with_positions(text, large))),
                 "1024 times as large");
    // Positions that are no multiples of a power of two round anew, so outlines may change.
    const auto moved = [&](const dvec3& p) { return write_point(p + dvec3(431000, 5411000, 12)); };
    expect_alike(before, pictures_of(folder.write("b.obj", with_positions(text, moved))),
                 "in map coordinates", {width * height / 50, 1});
}

INSTANTIATE_TEST_SUITE_P(All, Shipped,
                         testing::Values("cycle.obj", "five.obj", "pierce.obj", "pinwheel.obj",
                                         "ten.obj", "three_bars.obj"),
                         [](const auto& test) {
                             const std::string name = test.param;
                             return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace gw
