// The assembler of a context: several runs become one mesh as long as nothing changes but the values
// of vertices. [GL11] 2.6. Does not transform.
#pragma once

#include "gl/assemble/assembly.h"
#include "gl/assemble/run_calls.h"
#include "gw/material.h"

#include <span>
#include <vector>

namespace gw::gl {

struct Context;

struct Assembler {
    bool inside = false;  ///< between Begin and End
    Assembly mesh;
    std::vector<FaceMaterials> materials;  ///< of the mesh's vertices
    bool material_changed = false;         ///< since the last vertex
    RunCalls run_calls;                    ///< of the open run, while calls are kept

    /// Forgets the mesh, keeps the memory.
    void clear();
};

/// Draws the mesh that has been assembled, if there is one. Everything that changes the state or
/// reads pixels calls it first.
void flush_mesh(Context& c);

/// Adds a vertex to the open mesh, in place of Vertex; for evaluators too. Not a finite position: the
/// vertex is dropped.
void add_vertex(Context& c, AssembledVertex v);
void add_vertices(Context& c, std::span<const AssembledVertex> added);

/// A vertex of the current values, at (0, 0, 0, 1).
AssembledVertex current_vertex(const Context& c);

}  // namespace gw::gl
