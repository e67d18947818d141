// Assembly: the vertices of runs from Begin to End become the vertices and indices of one mesh.
// [GL11] 2.6.1. Knows no context and no state.
#pragma once

#include "gl/state/state.h"
#include "gw/mesh.h"

#include <GL/gl.h>

#include <cstdint>
#include <span>
#include <vector>

namespace gw::gl {

/// A vertex with all values that GL gives to it.
struct AssembledVertex {
    vec4 position{0, 0, 0, 1};
    vec4 color{1, 1, 1, 1};
    vec4 texcoord{0, 0, 0, 1};
    vec3 normal{0, 0, 1};
    vec3 secondary_color{0, 0, 0};
    float fog_coordinate = 0;
    std::uint32_t edge_and_material = 1;  ///< bit 0: edge flag; the rest: index of the material

    bool edge() const { return (edge_and_material & 1) != 0; }
    std::uint32_t material() const { return edge_and_material >> 1; }
    bool operator==(const AssembledVertex&) const = default;
};

struct Assembly {
    Primitive primitive = Primitive::Points;
    std::vector<AssembledVertex> vertices;
    /// As many as vertices, or none: then no vertex has any.
    std::vector<FurtherTexcoords> further_texcoords;
    std::vector<std::uint32_t> indices;  ///< empty: 0, 1, 2, ...
    std::vector<std::uint32_t> polygon_sizes;
    bool has_hidden_edges = false;  ///< a vertex without edge flag

    /// Whether a run of this mode can be part of this mesh. `whole_strips`: line strips stay whole,
    /// for a stipple that runs on; else they become single lines.
    bool takes(GLenum mode, bool whole_strips) const;
    void begin(GLenum mode, bool whole_strips);
    void add(const AssembledVertex& v) {
        vertices.push_back(v);
        if (!v.edge()) has_hidden_edges = true;
    }
    /// Vertices of one material.
    void add(std::span<const AssembledVertex> added, std::uint32_t material);
    /// Ends the run; vertices of an incomplete primitive are dropped.
    void end();
    /// The vertices of each primitive of a mode whose primitives share none; 0: another mode.
    static int separate_corners(GLenum mode);
    /// Ends a run of separate primitives, given by indices from its first vertex on. Returns false,
    /// and drops the run, if it has fewer vertices.
    bool end_shared(std::size_t vertex_count, std::span<const std::uint32_t> run_indices);
    /// Forgets the mesh, keeps the memory.
    void clear();
    bool empty() const { return vertices.empty(); }
    /// Points, lines, triangles, quads or polygons of complete runs.
    std::size_t primitive_count() const;
    /// Whether all bits are the same.
    bool operator==(const Assembly& other) const;

private:
    GLenum mode_ = GL_POINTS;    ///< of the run
    std::size_t run_begin_ = 0;  ///< the run's first vertex

    void use_indices();
    void keep_vertices(std::size_t count);
    std::uint32_t* add_indices(std::size_t count);
    void keep_order(std::size_t count);
    void set_edges();
    void end_triangles(std::size_t n);
    void end_quad_strip(std::size_t n);
    void end_lines(std::size_t n);
    void end_polygon(std::size_t n);
};

}  // namespace gw::gl
