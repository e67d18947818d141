// Lists the mesh vertices that primitives use, by the side that they show.
#include "gw/fast/vertices/geometry.h"
#include "gw/fast/vertices/geometry_scratch.h"

#include <bit>

namespace gw::fast {
namespace {

/// Calls visit(vertex of the mesh, shows the front) for each vertex that a part's primitives use,
/// once or more.
template <class Visit>
void for_each_used(const GeometrySet& set, std::size_t ordinal, const Visit& visit) {
    const GeometryPart& part = set.parts[ordinal];
    const std::uint32_t vertices = part.mesh->vertex_count();
    const std::size_t end = set.end_of(ordinal, &GeometryPart::primitive, set.primitives.size());
    for (std::size_t i = part.primitive; i < end; ++i) {
        const SetupPrimitive& p = set.primitives[i];
        for (const std::uint32_t at : {p.vertex[0], p.vertex[1], p.vertex[2], p.provoking}) {
            const std::uint32_t v = at - part.vertex;
            if (v < vertices) visit(v, p.front != 0);
        }
    }
}

/// Appends the places of the bits that are set.
void append_bits(std::vector<std::uint32_t>& list, std::uint64_t bits) {
    std::size_t i = list.size();
    list.resize(i + std::size_t(std::popcount(bits)));
    for (; bits != 0; bits &= bits - 1) list[i++] = std::uint32_t(std::countr_zero(bits));
}

/// Of a mesh of at most 64 vertices.
void list_few_used(GeometrySet& set, std::size_t ordinal) {
    std::uint64_t front = 0, back = 0;
    for_each_used(set, ordinal, [&](std::uint32_t v, bool shows_front) {
        (shows_front ? front : back) |= std::uint64_t{1} << v;
    });
    append_bits(set.used, front | back);
    append_bits(set.used_front, front);
    append_bits(set.used_back, back);
}

void list_many_used(GeometrySet& set, std::size_t ordinal, std::vector<std::uint8_t>& sides) {
    sides.assign(set.parts[ordinal].mesh->vertex_count(), 0);
    for_each_used(set, ordinal, [&](std::uint32_t v, bool shows_front) {
        sides[v] = std::uint8_t(sides[v] | (shows_front ? 1 : 2));
    });
    for (std::uint32_t v = 0; v < sides.size(); ++v) {
        if (sides[v] != 0) set.used.push_back(v);
        if (sides[v] & 1) set.used_front.push_back(v);
        if (sides[v] & 2) set.used_back.push_back(v);
    }
}

}  // namespace

void list_used_vertices(GeometrySet& set, GeometryScratch& scratch) {
    for (std::size_t i = 0; i < set.parts.size(); ++i) {
        GeometryPart& part = set.parts[i];
        part.used = std::uint32_t(set.used.size());
        part.used_front = std::uint32_t(set.used_front.size());
        part.used_back = std::uint32_t(set.used_back.size());
        if (part.mesh->vertex_count() <= 64)
            list_few_used(set, i);
        else
            list_many_used(set, i, scratch.sides);
    }
}

}  // namespace gw::fast
