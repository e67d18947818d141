// Corners that share vertices have the values that they had.
#include "gl/assemble/share_vertices.h"
#include "tests/gw/random.h"

#include <gtest/gtest.h>

#include <bit>
#include <set>
#include <vector>

namespace gw::gl {
namespace {

using Corner = std::vector<std::uint32_t>;

/// All bits of a vertex's values.
Corner values_of(const MeshData& m, std::size_t i) {
    Corner out;
    const auto add = [&](const auto& array, int parts, const auto& part) {
        for (int c = 0; c < parts && !array.empty(); ++c)
            out.push_back(std::bit_cast<std::uint32_t>(float(part(array.at(i), c))));
    };
    const auto component = [](const auto& v, int c) { return v[c]; };
    const auto whole = [](const auto& v, int) { return v; };
    add(m.positions, 3, component);
    add(m.normals, 3, component);
    add(m.texcoords, 2, component);
    add(m.colors, 4, component);
    add(m.w, 1, whole);
    add(m.texcoords_rq, 2, component);
    for (const UnitTexcoords& unit : m.more_texcoords) {
        add(unit.st, 2, component);
        add(unit.rq, 2, component);
    }
    add(m.edge_flags, 1, whole);
    add(m.material_indices, 1, whole);
    add(m.secondary_colors, 3, component);
    add(m.fog_coordinates, 1, whole);
    return out;
}

std::vector<Corner> corners_of(const MeshData& m) {
    std::vector<Corner> out;
    const std::size_t count = m.indices.empty() ? m.positions.size() : m.indices.size();
    for (std::size_t i = 0; i < count; ++i)
        out.push_back(values_of(m, m.indices.empty() ? i : m.indices[i]));
    return out;
}

/// Each array is there or not; few values, so that many vertices are the same. -0 is no 0.
MeshData random_mesh(test::Random& random, std::size_t count) {
    const auto below = [&](std::uint64_t n) { return std::uint32_t(random.next() % n); };
    constexpr float few[] = {0.0f, -0.0f};
    const auto value = [&] { return few[below(2)]; };
    const auto some = [&] { return below(2) == 0 ? count : 0; };
    MeshData m{.primitive = below(2) == 0 ? Primitive::Triangles : Primitive::Quads};
    for (std::size_t i = 0; i < count; ++i) m.positions.push_back({value(), 1, 2});
    for (std::size_t i = some(); i-- > 0;) m.normals.push_back({0, value(), 1});
    for (std::size_t i = some(); i-- > 0;) m.texcoords.push_back({1, value()});
    for (std::size_t i = some(); i-- > 0;) m.colors.push_back({1, 1, 1, value()});
    for (std::size_t i = some(); i-- > 0;) m.w.push_back(1 + value());
    for (std::size_t i = some(); i-- > 0;) m.texcoords_rq.push_back({value(), 1});
    for (UnitTexcoords& unit : m.more_texcoords) {
        for (std::size_t i = some(); i-- > 0;) unit.st.push_back({value(), 0});
        if (!unit.st.empty())
            for (std::size_t i = some(); i-- > 0;) unit.rq.push_back({0, value()});
    }
    for (std::size_t i = some(); i-- > 0;) m.edge_flags.push_back(std::uint8_t(below(2)));
    for (std::size_t i = some(); i-- > 0;) m.material_indices.push_back(below(2));
    for (std::size_t i = some(); i-- > 0;) m.secondary_colors.push_back({value(), 0, 0});
    for (std::size_t i = some(); i-- > 0;) m.fog_coordinates.push_back(value());
    if (below(2) == 0)
        for (std::size_t i = 0; i < count; ++i) m.indices.push_back(below(count));
    return m;
}

TEST(ShareVertices, KeepsEveryCornersValues) {
    test::Random random(11);
    int shared = 0;
    for (int i = 0; i < 400; ++i) {
        const MeshData given = random_mesh(random, 12 * (1 + random.next() % 40));
        std::set<Corner> different;
        for (std::size_t v = 0; v < given.positions.size(); ++v)
            different.insert(values_of(given, v));
        MeshData mesh = given;
        if (!share_vertices(mesh)) {
            EXPECT_GT(2 * different.size(), given.positions.size());
            EXPECT_EQ(mesh, given);
            continue;
        }
        ++shared;
        EXPECT_EQ(mesh.positions.size(), different.size());
        ASSERT_EQ(corners_of(mesh), corners_of(given));
    }
    EXPECT_GT(shared, 100);
}

TEST(ShareVertices, LeavesPointsAndLines) {
    for (const Primitive primitive : {Primitive::Points, Primitive::Lines, Primitive::LineStrip}) {
        MeshData mesh{.primitive = primitive, .positions = std::vector<vec3>(8)};
        EXPECT_FALSE(share_vertices(mesh));
        EXPECT_EQ(mesh.positions.size(), 8u);
    }
}

}  // namespace
}  // namespace gw::gl
