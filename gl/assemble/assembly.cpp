#include "gl/assemble/assembly.h"

#include <cstring>
#include <numeric>

namespace gw::gl {

namespace {

/// A mesh of more vertices ends with its run.
constexpr std::size_t full_mesh = 1u << 16;

bool is_line_strip(GLenum mode) { return mode == GL_LINE_STRIP || mode == GL_LINE_LOOP; }

Primitive primitive_of(GLenum mode, bool whole_strips) {
    if (is_line_strip(mode)) return whole_strips ? Primitive::LineStrip : Primitive::Lines;
    switch (mode) {
        case GL_POINTS: return Primitive::Points;
        case GL_LINES: return Primitive::Lines;
        case GL_QUADS:
        case GL_QUAD_STRIP: return Primitive::Quads;
        case GL_POLYGON: return Primitive::Polygons;
    }
    return Primitive::Triangles;
}

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

}  // namespace

void Assembly::add(std::span<const AssembledVertex> added, std::uint32_t material) {
    const std::size_t first = vertices.size();
    vertices.insert(vertices.end(), added.begin(), added.end());
    for (AssembledVertex& v : std::span(vertices).subspan(first)) {
        if (!v.edge()) has_hidden_edges = true;
        v.edge_and_material = material << 1 | (v.edge_and_material & 1u);
    }
}

bool Assembly::operator==(const Assembly& other) const {
    static_assert(sizeof(AssembledVertex) == 20 * sizeof(float));  // no padding
    return primitive == other.primitive && same_bytes(vertices, other.vertices) &&
           same_bytes(further_texcoords, other.further_texcoords) && indices == other.indices &&
           polygon_sizes == other.polygon_sizes;
}

bool Assembly::takes(GLenum mode, bool whole_strips) const {
    if (vertices.empty()) return true;
    return primitive == primitive_of(mode, whole_strips) && primitive != Primitive::LineStrip &&
           vertices.size() < full_mesh;
}

void Assembly::begin(GLenum mode, bool whole_strips) {
    primitive = primitive_of(mode, whole_strips);
    mode_ = mode;
    run_begin_ = vertices.size();
}

void Assembly::clear() {
    vertices.clear();
    further_texcoords.clear();
    indices.clear();
    polygon_sizes.clear();
    has_hidden_edges = false;
}

std::size_t Assembly::primitive_count() const {
    const std::size_t corners = indices.empty() ? vertices.size() : indices.size();
    switch (primitive) {
        case Primitive::Points: return corners;
        case Primitive::Lines: return corners / 2;
        case Primitive::LineStrip: return corners == 0 ? 0 : corners - 1;
        case Primitive::Quads: return corners / 4;
        case Primitive::Polygons: return polygon_sizes.size();
        default: return corners / 3;
    }
}

/// From here on, the mesh names its vertices by indices.
void Assembly::use_indices() {
    if (!indices.empty()) return;
    indices.resize(run_begin_);
    std::iota(indices.begin(), indices.end(), 0u);
}

/// Room for so many further indices.
std::uint32_t* Assembly::add_indices(std::size_t count) {
    indices.resize(indices.size() + count);
    return indices.data() + (indices.size() - count);
}

/// The run has its first `count` vertices only.
void Assembly::keep_vertices(std::size_t count) {
    vertices.resize(run_begin_ + count);
    if (!further_texcoords.empty()) further_texcoords.resize(run_begin_ + count);
}

/// The run's first `count` vertices are used in their order.
void Assembly::keep_order(std::size_t count) {
    keep_vertices(count);
    if (indices.empty()) return;
    std::uint32_t* const at = add_indices(count);
    std::iota(at, at + count, static_cast<std::uint32_t>(run_begin_));
}

/// All sides of strips and fans are edges of an outline. [GL11] 2.6.2
void Assembly::set_edges() {
    for (std::size_t i = run_begin_; i < vertices.size(); ++i) vertices[i].edge_and_material |= 1u;
}

/// The vertex that gives a flat-shaded triangle its colour stays the last. [GL11] table 2.12
void Assembly::end_triangles(std::size_t n) {
    if (n < 3) return keep_vertices(0);
    set_edges();
    use_indices();
    const bool is_fan = mode_ == GL_TRIANGLE_FAN;
    const auto first = static_cast<std::uint32_t>(run_begin_);
    std::uint32_t* at = add_indices(3 * (n - 2));
    for (std::uint32_t i = 2; i < n; ++i) {
        const std::uint32_t swap = i % 2;  // every second triangle of a strip
        *at++ = first + (is_fan ? 0 : i - 2 + swap);
        *at++ = first + (is_fan ? i - 1 : i - 1 - swap);
        *at++ = first + i;
    }
}

/// Quad i of a strip begins with its fourth corner. So its third, which gives a flat-shaded quad of
/// a strip its colour, stands last. [GL11] table 2.12
void Assembly::end_quad_strip(std::size_t n) {
    if (n < 4) return keep_vertices(0);
    set_edges();
    use_indices();
    const auto first = static_cast<std::uint32_t>(run_begin_);
    std::uint32_t* at = add_indices((n - 2) / 2 * 4);
    for (std::uint32_t i = 0; i + 3 < n; i += 2)
        for (const std::uint32_t corner : {2, 0, 1, 3}) *at++ = first + i + corner;
}

void Assembly::end_lines(std::size_t n) {
    if (n < 2) return keep_vertices(0);
    const bool is_loop = mode_ == GL_LINE_LOOP;
    if (primitive == Primitive::LineStrip) {
        if (!is_loop) return;
        vertices.push_back(AssembledVertex(vertices[run_begin_]));
        if (!further_texcoords.empty())
            further_texcoords.push_back(FurtherTexcoords(further_texcoords[run_begin_]));
        return;
    }
    use_indices();
    const auto first = static_cast<std::uint32_t>(run_begin_);
    for (std::uint32_t i = 0; i + 1 < n; ++i)
        indices.insert(indices.end(), {first + i, first + i + 1});
    if (is_loop) indices.insert(indices.end(), {std::uint32_t(first + n - 1), first});
}

void Assembly::end_polygon(std::size_t n) {
    if (n < 3) return keep_vertices(0);
    polygon_sizes.push_back(static_cast<std::uint32_t>(n));
    keep_order(n);
}

int Assembly::separate_corners(GLenum mode) {
    switch (mode) {
        case GL_POINTS: return 1;
        case GL_LINES: return 2;
        case GL_TRIANGLES: return 3;
        case GL_QUADS: return 4;
    }
    return 0;
}

bool Assembly::end_shared(std::size_t vertex_count, std::span<const std::uint32_t> run_indices) {
    if (vertices.size() - run_begin_ != vertex_count) {
        keep_vertices(0);
        return false;
    }
    use_indices();
    std::uint32_t* at = add_indices(run_indices.size());
    for (const std::uint32_t i : run_indices) *at++ = static_cast<std::uint32_t>(run_begin_) + i;
    return true;
}

void Assembly::end() {
    const std::size_t n = vertices.size() - run_begin_;
    switch (mode_) {
        case GL_POINTS: return keep_order(n);
        case GL_LINES: return keep_order(n - n % 2);
        case GL_LINE_STRIP:
        case GL_LINE_LOOP: return end_lines(n);
        case GL_TRIANGLES: return keep_order(n - n % 3);
        case GL_TRIANGLE_STRIP:
        case GL_TRIANGLE_FAN: return end_triangles(n);
        case GL_QUADS: return keep_order(n - n % 4);
        case GL_QUAD_STRIP: return end_quad_strip(n);
        case GL_POLYGON: return end_polygon(n);
    }
}

}  // namespace gw::gl
