// Assembles a context's vertices: several runs become one mesh while only values of vertices
// change. [GL11] 2.6. Knows no context.
#pragma once

#include "gl/assemble/assembly.h"
#include "gl/assemble/run_calls.h"
#include "gl/state/state.h"
#include "gw/material.h"

#include <vector>

namespace gw::gl {

struct Assembler {
    bool inside = false;                   ///< between Begin and End
    bool keeps_further_texcoords = false;  ///< of the open run: units 1 to 3 have textures
    Assembly mesh;
    std::vector<FaceMaterials> materials;  ///< of the mesh's vertices
    bool material_changed = false;         ///< since the last vertex
    RunCalls run_calls;                    ///< of the open run, while calls are kept

    /// Forgets the mesh, keeps the memory.
    void clear() {
        mesh.clear();
        materials.clear();
        material_changed = false;
    }
};

/// A vertex of the current values, at (0, 0, 0, 1).
inline AssembledVertex current_vertex(const CurrentState& now) {
    return {{0, 0, 0, 1},        now.color,          now.texcoord,           now.normal,
            now.secondary_color, now.fog_coordinate, now.edge_flag ? 1u : 0u};
}

}  // namespace gw::gl
