#include "gw/mesh.h"
#include "scene/toml/shape_table.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace gw::scene {
namespace {

const Shape& shape(const std::string& name) {
    const auto found = std::ranges::find(shapes(), name, &Shape::name);
    if (found == shapes().end()) throw std::runtime_error(name);
    return *found;
}

std::vector<double> defaults(const Shape& s) {
    std::vector<double> values;
    for (const ShapeParameter& p : s.parameters) values.push_back(p.value);
    return values;
}

MeshRef make(const std::string& name) { return make_mesh(shape(name).make(defaults(shape(name)))); }
MeshRef make(const std::string& name, const std::vector<double>& values) {
    return make_mesh(shape(name).make(values));
}

using Point = std::array<float, 3>;
Point point(const vec3& p) { return {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}; }  // -0 is 0

// Sides between bit-equal positions, with how often each is walked that way.
std::map<std::pair<Point, Point>, int> sides(const Mesh& mesh) {
    std::map<std::pair<Point, Point>, int> count;
    for (const Triangle& t : mesh.triangles())
        for (std::size_t k = 0; k < 3; ++k)
            ++count[{point(mesh.data().positions[t.vertex[k]]),
                     point(mesh.data().positions[t.vertex[(k + 1) % 3]])}];
    return count;
}

// Every side is walked once each way: no hole, no crack, all triangles turned alike.
bool is_closed(const Mesh& mesh) {
    const auto count = sides(mesh);
    return std::ranges::all_of(count, [&](const auto& side) {
        const auto back = count.find({side.first.second, side.first.first});
        return side.second == 1 && back != count.end() && back->second == 1;
    });
}

// Vertices - sides + triangles: 2 for a sphere, 0 for a torus.
int euler_characteristic(const Mesh& mesh) {
    std::set<Point> points;
    for (const Triangle& t : mesh.triangles())
        for (const std::uint32_t v : t.vertex) points.insert(point(mesh.data().positions[v]));
    return static_cast<int>(points.size()) - static_cast<int>(sides(mesh).size()) / 2 +
           static_cast<int>(mesh.triangles().size());
}

struct Corners {
    std::array<dvec3, 3> position, normal;
    std::array<dvec2, 3> texcoord;
    dvec3 area() const {
        return glm::cross(position[1] - position[0], position[2] - position[0]) / 2.0;
    }
    double texture_area() const {
        const dvec2 a = texcoord[1] - texcoord[0], b = texcoord[2] - texcoord[0];
        return (a.x * b.y - a.y * b.x) / 2;
    }
};

std::vector<Corners> triangles(const Mesh& mesh) {
    std::vector<Corners> all;
    for (const Triangle& t : mesh.triangles()) {
        Corners c;
        for (std::size_t k = 0; k < 3; ++k) {
            c.position[k] = mesh.data().positions[t.vertex[k]];
            c.normal[k] = mesh.data().normals[t.vertex[k]];
            c.texcoord[k] = mesh.data().texcoords[t.vertex[k]];
        }
        all.push_back(c);
    }
    return all;
}

double volume(const Mesh& mesh) {
    double sum = 0;
    for (const Corners& c : triangles(mesh)) sum += glm::dot(c.position[0], c.area()) / 3;
    return sum;
}

class EveryShape : public testing::TestWithParam<std::string> {};

TEST_P(EveryShape, HasNormalsOfLengthOneOnTheSideOfItsTriangles) {
    const MeshRef mesh = make(GetParam());
    EXPECT_GT(mesh->triangles().size(), 0u);
    for (const vec3& n : mesh->data().normals) ASSERT_NEAR(glm::length(n), 1.0f, 1e-6f);
    for (const Corners& c : triangles(*mesh))
        for (const dvec3& n : c.normal)
            ASSERT_GT(glm::dot(n, c.area()), 0) << c.position[0].x << " " << c.position[0].y;
}

TEST_P(EveryShape, IsMappedWithoutMirroringInsideTheUnitSquare) {
    for (const Corners& c : triangles(*make(GetParam()))) {
        ASSERT_GT(c.texture_area(), 0)
            << c.position[0].x << " " << c.position[0].y << " " << c.position[0].z;
        for (const dvec2& p : c.texcoord) {
            ASSERT_GE(std::min(p.x, p.y), 0);
            ASSERT_LE(p.x, GetParam() == "icosphere" ? 1.5 : 1);
            ASSERT_LE(p.y, 1);
        }
    }
}

TEST_P(EveryShape, WorksWithTheSmallestCounts) {
    const Shape& s = shape(GetParam());
    std::vector<double> values = defaults(s);
    for (std::size_t i = 0; i < values.size(); ++i)
        if (s.parameters[i].integer) values[i] = s.parameters[i].low;
    for (const Corners& c : triangles(*make(GetParam(), values)))
        ASSERT_GT(glm::length(c.area()), 0);
}

TEST_P(EveryShape, HasDefaultsInRangeAndADistinctName) {
    EXPECT_EQ(std::ranges::count(shapes(), GetParam(), &Shape::name), 1);
    for (const ShapeParameter& p : shape(GetParam()).parameters) {
        EXPECT_GE(p.value, p.low);
        EXPECT_LE(p.value, p.high);
    }
}

std::vector<std::string> all_names() {
    std::vector<std::string> names;
    for (const Shape& s : shapes()) names.push_back(s.name);
    return names;
}
INSTANTIATE_TEST_SUITE_P(Shapes, EveryShape, testing::ValuesIn(all_names()),
                         [](const auto& test) { return test.param; });

TEST(Shapes, AreInAlphabeticalOrder) {
    const auto names = all_names();
    EXPECT_TRUE(std::ranges::is_sorted(names));
}

TEST(Shapes, SolidOnesAreClosedWithoutACrack) {
    for (const char* name : {"bottle", "bowl", "box", "cone", "cylinder", "goblet", "icosphere",
                             "pedestal", "room", "sphere", "torus", "torus_knot", "vase"}) {
        const MeshRef mesh = make(name);
        EXPECT_TRUE(is_closed(*mesh)) << name;
        const bool ring = std::string(name).starts_with("torus");
        EXPECT_EQ(euler_characteristic(*mesh), ring ? 0 : 2) << name;
        EXPECT_EQ(volume(*mesh) > 0, std::string(name) != "room") << name;
    }
}

TEST(Shapes, SegmentsOfABoxMeetAtItsEdges) {
    const MeshRef box = make("box", {0.3, 0.7, 1.1, 7});
    EXPECT_EQ(box->polygon_count(), 6u * 49);
    EXPECT_TRUE(is_closed(*box));
    EXPECT_NEAR(volume(*box), 0.3 * 0.7 * 1.1, 1e-7);
}

TEST(Shapes, TriangleCounts) {
    EXPECT_EQ(make("torus", {1, 0.25, 10, 7})->triangles().size(), 140u);
    EXPECT_EQ(make("torus_knot", {2, 3, 1, 0.2, 50, 6})->triangles().size(), 600u);
    EXPECT_EQ(make("sphere", {1, 12, 6})->triangles().size(), 2u * 12 * 5);
    EXPECT_EQ(make("icosphere", {1, 3})->triangles().size(), 20u * 64);
    EXPECT_EQ(make("cylinder", {1, 2, 9, 4, 1})->triangles().size(), 2u * 9 * 4 + 18);
    EXPECT_EQ(make("cone", {1, 2, 9, 4, 0})->triangles().size(), 9u * 7);
    EXPECT_EQ(make("disc", {1, 9, 3})->triangles().size(), 9u * 5);
    EXPECT_EQ(make("rectangle", {1, 1, 5, 3})->polygon_count(), 15u);
    for (const int n : {2, 3, 12})
        EXPECT_EQ(make("teapot", {n * 1.0})->triangles().size(), 64u * n * n - 8u * n);
}

TEST(Shapes, SpheresAreRound) {
    for (const char* name : {"sphere", "icosphere"}) {
        const MeshRef mesh = make(name);
        for (const vec3& p : mesh->data().positions) ASSERT_NEAR(glm::length(dvec3(p)), 1, 1e-7);
    }
    EXPECT_NEAR(volume(*make("icosphere", {1, 6})), 4.18879, 0.002);
}

TEST(Shapes, TheTorusHasItsVolume) {
    EXPECT_NEAR(volume(*make("torus", {1, 0.25, 400, 200})), 2 * 9.8696 * 0.0625, 0.001);
}

TEST(Teapot, HasTheSizeOfThePublishedOne) {
    const MeshRef pot = make("teapot");
    vec3 low(9), high(-9);
    for (const vec3& p : pot->data().positions) low = glm::min(low, p), high = glm::max(high, p);
    EXPECT_EQ(low.x, -3.0f);
    EXPECT_NEAR(high.x, 3.434, 0.001);
    EXPECT_EQ(low.y, 0.0f);
    EXPECT_EQ(high.y, 3.15f);
    EXPECT_EQ(low.z, -high.z);
    EXPECT_EQ(high.z, 2.0f);
}

TEST(Teapot, TheNormalsAtThePolesAreVertical) {
    const MeshRef pot = make("teapot", {5});
    int poles = 0;
    for (std::size_t i = 0; i < pot->data().positions.size(); ++i) {
        const vec3 p = pot->data().positions[i];
        if (p.x != 0 || p.z != 0) continue;
        ++poles;
        EXPECT_EQ(pot->data().normals[i], vec3(0, p.y > 0 ? 1 : -1, 0));
    }
    EXPECT_EQ(poles, 8 * 6);
}

// Patches that meet along a smooth border agree on position exactly and on the normal nearly.
TEST(Teapot, PatchesSideBySideShareTheirNormals) {
    const MeshRef pot = make("teapot", {6});
    const std::size_t patch = 7 * 7;
    const MeshData& d = pot->data();
    // last column of one, first of the other
    const auto border = [&](std::size_t left, std::size_t right) {
        for (std::size_t row = 0; row < 7; ++row) {
            const std::size_t a = left * patch + row * 7 + 6, b = right * patch + row * 7;
            EXPECT_EQ(d.positions[a], d.positions[b]);
            EXPECT_GT(glm::dot(d.normals[a], d.normals[b]), 0.9999f)
                << left << " " << right << " " << row;
        }
    };
    for (const auto& [first, count] : {std::pair<std::size_t, std::size_t>{0, 4},
                                       {4, 4},
                                       {8, 4},
                                       {12, 2},
                                       {14, 2},
                                       {16, 2},
                                       {18, 2},
                                       {20, 4},
                                       {24, 4},
                                       {28, 4}})
        for (std::size_t i = 0; i < count; ++i) border(first + i, first + (i + 1) % count);
}

// Borders of one triangle only: where the published surface ends (lid, rim inside, ends of spout
// and handle, bottom).
TEST(Teapot, NoSideIsWalkedTwiceTheSameWay) {
    const auto count = sides(*make("teapot", {6}));
    for (const auto& [side, n] : count) ASSERT_EQ(n, 1);
}

}  // namespace
}  // namespace gw::scene
