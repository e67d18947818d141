#include "gl/assemble/assembler.h"

#include "gl/api/calls.h"
#include "gl/context/context.h"
#include "gl/draw/submit.h"

#include <cmath>
#include <numeric>

namespace gw::gl {

namespace {

/// A mesh of more vertices ends with its run.
constexpr std::size_t full_mesh = 1u << 16;

Primitive primitive_of(GLenum mode) {
    switch (mode) {
        case GL_POINTS: return Primitive::Points;
        case GL_LINES: return Primitive::Lines;
        case GL_LINE_STRIP:
        case GL_LINE_LOOP: return Primitive::LineStrip;
        case GL_QUADS:
        case GL_QUAD_STRIP: return Primitive::Quads;
        case GL_POLYGON: return Primitive::Polygons;
    }
    return Primitive::Triangles;
}

bool is_finite(const vec4& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

/// From here on, the mesh names its vertices by indices.
void use_indices(Assembler& a) {
    if (!a.indices.empty()) return;
    a.indices.resize(a.run_begin);
    std::iota(a.indices.begin(), a.indices.end(), 0u);
}

/// The run's vertices are used in their order, `count` of them.
void keep_order(Assembler& a, std::size_t count) {
    a.vertices.resize(a.run_begin + count);
    if (a.indices.empty()) return;
    for (std::size_t i = 0; i < count; ++i)
        a.indices.push_back(static_cast<std::uint32_t>(a.run_begin + i));
}

/// All sides of strips and fans are edges of an outline. [GL11] 2.6.2
void set_edges(Assembler& a) {
    for (std::size_t i = a.run_begin; i < a.vertices.size(); ++i)
        a.vertices[i].edge_and_material |= 1u;
}

/// [GL11] 2.6.1; the vertex that gives a flat-shaded triangle its colour stays the last.
void end_triangles(Assembler& a, std::size_t n, bool fan) {
    if (n < 3) return a.vertices.resize(a.run_begin);
    set_edges(a);
    use_indices(a);
    const auto first = static_cast<std::uint32_t>(a.run_begin);
    for (std::uint32_t i = 2; i < n; ++i) {
        const std::uint32_t swap = i % 2;  // every second triangle of a strip
        const std::uint32_t v0 = fan ? 0 : i - 2 + swap, v1 = fan ? i - 1 : i - 1 - swap;
        a.indices.insert(a.indices.end(), {first + v0, first + v1, first + i});
    }
}

/// Quad i of a strip begins with its fourth corner, so that its third, which gives a flat-shaded
/// quad of a strip its colour, stands last. [GL11] table 2.12
void end_quad_strip(Assembler& a, std::size_t n) {
    if (n < 4) return a.vertices.resize(a.run_begin);
    set_edges(a);
    use_indices(a);
    const auto first = static_cast<std::uint32_t>(a.run_begin);
    for (std::uint32_t i = 0; i + 3 < n; i += 2)
        a.indices.insert(a.indices.end(), {first + i + 2, first + i, first + i + 1, first + i + 3});
}

void end_line_strip(Assembler& a, std::size_t n) {
    if (n < 2) return a.vertices.resize(a.run_begin);
    if (a.mode == GL_LINE_LOOP) a.vertices.push_back(AssembledVertex(a.vertices[a.run_begin]));
    keep_order(a, a.vertices.size() - a.run_begin);
}

void end_polygon(Assembler& a, std::size_t n) {
    if (n < 3) return a.vertices.resize(a.run_begin);
    a.polygon_sizes.push_back(static_cast<std::uint32_t>(n));
    keep_order(a, n);
}

/// Ends a run; vertices of an incomplete primitive are dropped.
void end_run(Assembler& a) {
    const std::size_t n = a.vertices.size() - a.run_begin;
    switch (a.mode) {
        case GL_POINTS: return keep_order(a, n);
        case GL_LINES: return keep_order(a, n - n % 2);
        case GL_TRIANGLES: return keep_order(a, n - n % 3);
        case GL_QUADS: return keep_order(a, n - n % 4);
        case GL_LINE_STRIP:
        case GL_LINE_LOOP: return end_line_strip(a, n);
        case GL_TRIANGLE_STRIP: return end_triangles(a, n, false);
        case GL_TRIANGLE_FAN: return end_triangles(a, n, true);
        case GL_QUAD_STRIP: return end_quad_strip(a, n);
        case GL_POLYGON: return end_polygon(a, n);
    }
}

}  // namespace

void Assembler::clear() {
    vertices.clear();
    indices.clear();
    polygon_sizes.clear();
    materials.clear();
    material_changed = has_hidden_edges = false;
}

void flush_mesh(Context& c) {
    if (c.assembler.vertices.empty()) return;
    if (!c.assembler.inside) submit_mesh(c);
    c.assembler.clear();
}

void add_vertex(Context& c, const AssembledVertex& v) {
    Assembler& a = c.assembler;
    if (!a.inside || !is_finite(v.position)) return;
    if (a.vertices.empty() || a.material_changed) {
        a.materials.push_back(face_materials(c));
        a.material_changed = false;
    }
    a.vertices.push_back(v);
    const auto material = static_cast<std::uint32_t>(a.materials.size() - 1);
    a.vertices.back().edge_and_material = material << 1 | (v.edge_and_material & 1u);
    if (!v.edge()) a.has_hidden_edges = true;
}

namespace execute {

void begin(Context& c, GLenum mode) {
    Assembler& a = c.assembler;
    if (mode > GL_POLYGON) return set_error(c, GL_INVALID_ENUM);
    if (a.inside) return set_error(c, GL_INVALID_OPERATION);
    const Primitive primitive = primitive_of(mode);
    if (primitive != a.primitive || primitive == Primitive::LineStrip ||
        a.vertices.size() >= full_mesh)
        flush_mesh(c);
    a.primitive = primitive;
    a.mode = mode;
    a.run_begin = a.vertices.size();
    a.inside = true;
}

void end(Context& c) {
    if (!c.assembler.inside) return set_error(c, GL_INVALID_OPERATION);
    end_run(c.assembler);
    c.assembler.inside = false;
}

void vertex(Context& c, float x, float y, float z, float w) {
    const CurrentState& now = c.state.current;
    add_vertex(c, {{x, y, z, w}, now.color, now.texcoord, now.normal, now.edge_flag ? 1u : 0u});
}

void color(Context& c, float red, float green, float blue, float alpha) {
    c.state.current.color = {red, green, blue, alpha};
}
void tex_coord(Context& c, float s, float t, float r, float q) {
    c.state.current.texcoord = {s, t, r, q};
}
void normal(Context& c, float x, float y, float z) { c.state.current.normal = {x, y, z}; }
void edge_flag(Context& c, GLboolean flag) { c.state.current.edge_flag = flag != GL_FALSE; }
void index(Context& c, float value) { c.state.current.index = value; }

void rect(Context& c, double x1, double y1, double x2, double y2) {
    begin(c, GL_POLYGON);
    vertex(c, float(x1), float(y1), 0, 1);
    vertex(c, float(x2), float(y1), 0, 1);
    vertex(c, float(x2), float(y2), 0, 1);
    vertex(c, float(x1), float(y2), 0, 1);
    end(c);
}

}  // namespace execute

}  // namespace gw::gl
