// Runs of vertices in a display list, assembled once. A list that is played draws their meshes, as
// immediate mode would have made them.
#pragma once

#include "gl/assemble/assembly.h"
#include "gl/assemble/mesh.h"
#include "gl/drawable/call_trace.h"
#include "gl/lists/display_list.h"

#include <array>
#include <vector>

namespace gw::gl {

/// Some of a vertex's values.
struct GivenValues {
    bool color = false, normal = false, texcoord = false, edge_flag = false;
    bool secondary_color = false, fog_coordinate = false;
    std::array<bool, texture_unit_count - 1> further_texcoords{};  ///< of units 1 to 3
    bool operator==(const GivenValues&) const = default;
};

struct SealedRuns {
    struct PartMesh {
        VertexValues values;  ///< that it has
        MeshRef mesh;
        bool shares = false;  ///< corners share vertices where it is worth it
    };
    struct Part {
        Assembly assembly;
        std::vector<PartMesh> meshes;
        std::vector<CallRun> calls;  ///< numbers in the list; empty: they are not kept
    };
    std::vector<Part> parts;
    GivenValues given;        ///< all vertices have these; the others are the current ones
    GivenValues given_after;  ///< the runs leave these current, from `last`
    AssembledVertex last;
    FurtherTexcoords last_further;
    bool has_line_strips = false;
    bool is_small = false;
};

/// Draws the runs and sets the current values. Returns false, and does nothing, if the runs depend
/// on the state. They do so between Begin and End, as line strips with a stipple or in feedback,
/// and under an edge flag of false. Nor does it draw small runs that larger meshes can take up: the
/// state has not changed since the last small ones.
bool draw_runs(Context& context, SealedRuns& runs);

}  // namespace gw::gl
