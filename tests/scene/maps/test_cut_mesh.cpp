// Claims: cutting keeps every point of a mesh in one piece, whose level is that of its opacity; pieces
// fit together without gaps or T-junctions, also across triangles; positions, texture coordinates and
// orientation are those of the mesh. Areas are closed forms.
#include "scene/maps/cut_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

namespace gw::scene {
namespace {

double area_of(const MeshData& mesh) {
    double sum = 0;
    for (std::size_t i = 0; i + 2 < mesh.positions.size(); i += 3) {
        const dvec3 a(mesh.positions[i]), b(mesh.positions[i + 1]), c(mesh.positions[i + 2]);
        sum += length(cross3(b - a, c - a)) / 2;
    }
    return sum;
}

double area_of(const std::vector<MeshData>& meshes) {
    double sum = 0;
    for (const MeshData& mesh : meshes) sum += area_of(mesh);
    return sum;
}

/// (0, 0), (1, 0), (0, 1), with these alphas.
MeshRef triangle(float a, float b, float c) {
    return make_mesh({.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                      .normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}},
                      .colors = {{1, 1, 1, a}, {1, 1, 1, b}, {1, 1, 1, c}}});
}

/// A map whose alphas these are, row by row from below.
Map map_of(int width, int height, const std::vector<double>& alpha, Wrap wrap = Wrap::Repeat) {
    std::vector<std::uint16_t> rgba;
    for (const double a : alpha)
        rgba.insert(rgba.end(), {0xFFFF, 0xFFFF, 0xFFFF, std::uint16_t(std::lround(a * 65535))});
    return {.wrap_s = wrap, .wrap_t = wrap, .texture = make_texture("alpha", width, height, rgba)};
}

/// The unit square in the plane z = 0 as n x n squares of two triangles, s = x and t = y times `repeats`.
MeshRef square(int n, float repeats = 1) {
    MeshData mesh;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            mesh.positions.emplace_back(float(i) / float(n), float(j) / float(n), 0);
            mesh.texcoords.emplace_back(vec2(mesh.positions.back()) * repeats);
        }
    const auto row = std::uint32_t(n + 1);
    for (std::uint32_t j = 0; j + 1 < row; ++j)
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
            const std::uint32_t a = j * row + i;
            for (const std::uint32_t k : {a, a + 1, a + row + 1, a, a + row + 1, a + row})
                mesh.indices.push_back(k);
        }
    return make_mesh(std::move(mesh));
}

std::vector<MeshData> cut(const MeshRef& mesh, const Map* map, const OpacityLevels& levels) {
    CutBudget budget;
    return cut_by_opacity(*mesh, map, ColorUse::Opacity, levels, budget).value();
}

using Edge = std::array<float, 6>;
/// Sides that no other triangle of any mesh runs along in the other direction.
std::vector<Edge> border(const std::vector<MeshData>& meshes) {
    std::map<Edge, int> count;
    for (const MeshData& mesh : meshes)
        for (std::size_t i = 0; i + 2 < mesh.positions.size(); i += 3)
            for (std::size_t k = 0; k < 3; ++k) {
                const vec3 &a = mesh.positions[i + k], &b = mesh.positions[i + (k + 1) % 3];
                ++count[{a.x, a.y, a.z, b.x, b.y, b.z}];
                --count[{b.x, b.y, b.z, a.x, a.y, a.z}];
            }
    std::vector<Edge> alone;
    for (const auto& [edge, n] : count)
        if (n > 0) alone.push_back(edge);
    return alone;
}

bool is_on_unit_square(const Edge& e) {
    const auto on = [&](std::size_t axis, float at) { return e[axis] == at && e[axis + 3] == at; };
    return on(0, 0) || on(0, 1) || on(1, 0) || on(1, 1);
}

/// Alphas from 0.25 to 1, so that every piece is drawn.
std::vector<double> noise(int count, unsigned seed, double low) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> alpha(low, 1);
    std::vector<double> list;
    for (int i = 0; i < count; ++i) list.push_back(alpha(random));
    return list;
}

}  // namespace

TEST(CutMesh, AMaskKeepsWhereVertexAlphasReachTheCutoff) {
    const auto meshes = cut(triangle(0, 1, 0), nullptr, mask_levels(0.25));  // alpha is x
    EXPECT_EQ(area_of(meshes[0]), 0);
    EXPECT_NEAR(area_of(meshes[1]), 0.75 * 0.75 / 2, 1e-6);
    for (const vec3& p : meshes[1].positions) EXPECT_GE(p.x, 0.25f);
}

TEST(CutMesh, ABlendHasTheAreaOfEachSixteenth) {
    const OpacityLevels levels = blend_levels();
    const auto meshes = cut(triangle(0, 1, 0), nullptr, levels);
    const auto beyond = [](double x) { return x >= 1 ? 0 : (1 - x) * (1 - x) / 2; };
    EXPECT_EQ(area_of(meshes[0]), 0);
    for (int k = 1; k <= 16; ++k)
        EXPECT_NEAR(area_of(meshes[std::size_t(k)]),
                    beyond((k - 0.5) / 16) - beyond((k + 0.5) / 16), 1e-6)
            << k;
}

TEST(CutMesh, ColoursThatAreNoOpacityStayWithTheirPoints) {
    MeshData data = square(1)->data();
    for (const vec3& p : data.positions) data.colors.emplace_back(p.x, p.y, 0.25f, p.x * p.y);
    const Map map = map_of(4, 1, {0.25, 0.5, 0.75, 1}, Wrap::Clamp);
    CutBudget budget;
    const auto meshes =
        cut_by_opacity(*make_mesh(std::move(data)), &map, ColorUse::Color, blend_levels(), budget)
            .value();
    EXPECT_NEAR(area_of(meshes), 1, 1e-6);
    for (const MeshData& mesh : meshes) {
        ASSERT_EQ(mesh.colors.size(), mesh.positions.size());
        for (std::size_t i = 0; i < mesh.colors.size(); ++i) {
            EXPECT_NEAR(mesh.colors[i].x, mesh.positions[i].x, 1e-6);
            EXPECT_NEAR(mesh.colors[i].y, mesh.positions[i].y, 1e-6);
            EXPECT_NEAR(mesh.colors[i].z, 0.25f, 1e-6);
        }
    }
}

TEST(CutMesh, AStepOfTexelsIsCutInTheMiddle) {
    const Map map = map_of(4, 1, {0, 0, 1, 1}, Wrap::Clamp);
    const auto meshes = cut(square(1), &map, mask_levels(0.5));
    EXPECT_NEAR(area_of(meshes[1]), 0.5, 1e-7);
    for (std::size_t i = 0; i < meshes[1].positions.size(); ++i) {
        EXPECT_GE(meshes[1].positions[i].x, 0.5f);
        EXPECT_EQ(meshes[1].texcoords[i], vec2(meshes[1].positions[i]));
    }
}

TEST(CutMesh, OneTexelIsAStarOfFourQuads) {
    // Alpha falls from 1 to 0 along the cell's sides, and to the mean of 1/4 in its middle: it is 1/2 at
    // (1/2, 0), (1/3, 1/3) and (0, 1/2), so a quad of 1/6 of a cell in each of four cells.
    std::vector<double> alpha(64, 0);
    alpha[8 * 3 + 3] = 1;
    const Map map = map_of(8, 8, alpha);
    EXPECT_NEAR(area_of(cut(square(1), &map, mask_levels(0.5))[1]), 4.0 / 6 / 64, 1e-7);
}

TEST(CutMesh, WrapsDecideBeyondTheFirstImage) {
    const auto area = [](Wrap wrap) {
        const Map map = map_of(4, 1, {0, 0, 1, 1}, wrap);
        return area_of(cut(square(1, 4), &map, mask_levels(0.5))[1]);
    };
    EXPECT_NEAR(area(Wrap::Repeat), 0.5, 1e-6);
    EXPECT_NEAR(area(Wrap::MirroredRepeat), 0.5, 1e-6);
    EXPECT_NEAR(area(Wrap::Clamp), 1 - 0.5 / 4, 1e-6);
    const Map mirrored = map_of(4, 1, {0, 0, 1, 1}, Wrap::MirroredRepeat);
    // s = 1 lies in an opaque part from 0.5 to 1.5, where repetition has 0.5 to 1.
    const auto meshes = cut(square(1, 2), &mirrored, mask_levels(0.5));
    for (const vec2& st : meshes[1].texcoords) EXPECT_TRUE(st.x >= 0.5f && st.x <= 1.5f);
}

TEST(CutMesh, TheMapsScaleAndOffsetCount) {
    Map map = map_of(4, 1, {0, 0, 1, 1}, Wrap::Clamp);
    map.scale = vec2(0.5f, 1);
    map.offset = vec2(0.25f, 0);
    const auto meshes = cut(square(1), &map, mask_levels(0.5));
    for (const vec3& p : meshes[1].positions) EXPECT_GE(p.x, 0.5f);
}

TEST(CutMesh, PiecesFitTogether) {
    for (const int n : {1, 3, 7})
        for (const float repeats : {0.3f, 1.0f, 2.7f}) {
            const Map map = map_of(16, 8, noise(128, unsigned(n), 0.25));
            const auto meshes = cut(square(n, repeats), &map, blend_levels());
            EXPECT_NEAR(area_of(meshes), 1, 1e-6);
            for (const Edge& edge : border(meshes)) EXPECT_TRUE(is_on_unit_square(edge));
        }
}

TEST(CutMesh, PiecesFitWholeTrianglesBesideThem) {
    std::vector<double> alpha(64 * 64, 1);
    for (int y = 20; y < 30; ++y)
        for (int x = 20; x < 30; ++x) alpha[std::size_t(64 * y + x)] = 0.3;
    const Map map = map_of(64, 64, alpha);
    const auto meshes = cut(square(5), &map, blend_levels());
    std::size_t triangles = 0;
    for (const MeshData& mesh : meshes) triangles += mesh.positions.size() / 3;
    EXPECT_LT(triangles, 4000u);  // of 8,192 halves of cells
    for (const Edge& edge : border(meshes)) EXPECT_TRUE(is_on_unit_square(edge));
}

TEST(CutMesh, PartsOfOneLevelAreLarge) {
    std::vector<double> alpha(512 * 512, 1);
    alpha[512 * 100 + 100] = 0;  // a hole of one texel
    const Map map = map_of(512, 512, alpha);
    EXPECT_LT(cut(square(1), &map, mask_levels(0.5))[1].positions.size() / 3, 1000u);
}

TEST(CutMesh, PiecesAreTurnedAsTheirTriangle) {
    const Map map = map_of(16, 8, noise(128, 5, 0));
    for (const float sign : {1.0f, -1.0f})
        for (const MeshData& mesh : cut(square(2, sign), &map, blend_levels()))
            for (std::size_t i = 0; i + 2 < mesh.positions.size(); i += 3) {
                const dvec3 a(mesh.positions[i]), b(mesh.positions[i + 1]),
                    c(mesh.positions[i + 2]);
                EXPECT_GE(cross3(b - a, c - a).z, 0);
            }
}

TEST(CutMesh, VertexAlphasMultiplyTheMap) {
    MeshData data = square(1)->data();
    for (const vec3& p : data.positions) data.colors.emplace_back(1, 1, 1, p.x);
    const Map map = map_of(2, 2, {0.5, 0.5, 0.5, 0.5});
    const auto meshes = cut(make_mesh(data), &map, mask_levels(0.25));  // 0.5 x >= 0.25
    EXPECT_NEAR(area_of(meshes[1]), 0.5, 1e-5);                         // an alpha has 16 bits
}

TEST(CutMesh, ABudgetIsKept) {
    const Map map = map_of(64, 64, noise(64 * 64, 1, 0));
    CutBudget few{.triangles = 1000};
    EXPECT_FALSE(cut_by_opacity(*square(1), &map, ColorUse::Opacity, blend_levels(), few));
    CutBudget cells{.cells = 4000};
    EXPECT_FALSE(cut_by_opacity(*square(1), &map, ColorUse::Opacity, blend_levels(), cells));
    CutBudget far;
    EXPECT_FALSE(cut_by_opacity(*square(1, 1e30f), &map, ColorUse::Opacity, blend_levels(), far));
}

}  // namespace gw::scene
