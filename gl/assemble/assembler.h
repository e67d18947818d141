// Assembly: the vertices between Begin and End, and of several such runs, become one mesh as long
// as nothing changes but values of vertices. [GL11] 2.6. Does not transform.
#pragma once

#include "gw/command_list.h"
#include "gw/mesh.h"

#include <GL/gl.h>

#include <cstdint>
#include <vector>

namespace gw::gl {

struct Context;

/// A vertex with all values that GL gives to it.
struct AssembledVertex {
    vec4 position{0, 0, 0, 1};
    vec4 color{1, 1, 1, 1};
    vec4 texcoord{0, 0, 0, 1};
    vec3 normal{0, 0, 1};
    std::uint32_t edge_and_material = 1;  ///< bit 0: edge flag; the rest: index of the material

    bool edge() const { return (edge_and_material & 1) != 0; }
    std::uint32_t material() const { return edge_and_material >> 1; }
};

struct Assembler {
    bool inside = false;        ///< between Begin and End
    GLenum mode = GL_POINTS;    ///< of Begin
    std::size_t run_begin = 0;  ///< the first vertex since Begin

    Primitive primitive = Primitive::Points;
    std::vector<AssembledVertex> vertices;
    std::vector<std::uint32_t> indices;  ///< empty: 0, 1, 2, ...
    std::vector<std::uint32_t> polygon_sizes;
    std::vector<FaceMaterials> materials;
    bool material_changed = false;  ///< since the last vertex
    bool has_hidden_edges = false;  ///< a vertex without edge flag

    /// Forgets the mesh, keeps the memory.
    void clear();
};

/// Draws the mesh that has been assembled, if there is one. Everything that changes the state or
/// reads pixels calls it first.
void flush_mesh(Context& c);

/// Adds a vertex to the open mesh, in place of Vertex; for evaluators and arrays too.
void add_vertex(Context& c, const AssembledVertex& v);

}  // namespace gw::gl
