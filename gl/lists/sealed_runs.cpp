#include "gl/lists/sealed_runs.h"

#include "gl/assemble/share_vertices.h"
#include "gl/context/context.h"
#include "gl/draw/submit.h"
#include "gl/draw/targets.h"

#include <utility>

namespace gw::gl {

namespace {

/// The mesh of a part for a draw that uses these values. Corners share vertices from the second use
/// on: some programs make a list for one frame. Recordings keep the vertices as they were given.
const MeshRef& mesh_for(SealedRuns::Part& part, const VertexValues& used) {
    for (SealedRuns::PartMesh& made : part.meshes) {
        if (made.values != used) continue;
        if (!made.shares && !calls_are_kept) {
            made.shares = true;
            MeshData data = made.mesh->data();
            if (share_vertices(data)) made.mesh = make_mesh(std::move(data));
        }
        return made.mesh;
    }
    part.meshes.push_back({used, mesh_of(part.assembly, {}, used)});
    return part.meshes.back().mesh;
}

/// The current values in place of arrays that a mesh lacks.
AssembledVertex common_values(const Context& context, const SealedRuns& runs,
                              const AssembledVertex& first) {
    AssembledVertex out = current_vertex(context.state.current);
    if (runs.given.color) out.color = first.color;
    if (runs.given.normal) out.normal = first.normal;
    if (runs.given.texcoord) out.texcoord = first.texcoord;
    if (runs.given.secondary_color) out.secondary_color = first.secondary_color;
    if (runs.given.fog_coordinate) out.fog_coordinate = first.fog_coordinate;
    return out;
}

/// The same of the texture coordinates of units 1 to 3.
FurtherTexcoords common_further(const Context& context, const SealedRuns& runs,
                                const SealedRuns::Part& part) {
    FurtherTexcoords out = context.state.current.further_texcoords;
    for (std::size_t i = 0; i < out.size(); ++i)
        if (runs.given.further_texcoords[i]) out[i] = part.assembly.further_texcoords.front()[i];
    return out;
}

void set_current(CurrentState& now, const SealedRuns& runs) {
    if (runs.given_after.color) now.color = runs.last.color;
    if (runs.given_after.normal) now.normal = runs.last.normal;
    if (runs.given_after.texcoord) now.texcoord = runs.last.texcoord;
    if (runs.given_after.secondary_color) now.secondary_color = runs.last.secondary_color;
    if (runs.given_after.fog_coordinate) now.fog_coordinate = runs.last.fog_coordinate;
    for (std::size_t i = 0; i < now.further_texcoords.size(); ++i)
        if (runs.given_after.further_texcoords[i]) now.further_texcoords[i] = runs.last_further[i];
    if (runs.given_after.edge_flag) now.edge_flag = runs.last.edge();
}

/// The calls of a part in the list that is being played.
std::vector<CallRun> played_calls(const Context& context, const SealedRuns::Part& part) {
    if (!calls_are_kept || context.calls.is_one_call) return {};
    std::vector<CallRun> calls = part.calls;
    for (CallRun& run : calls) run.call.list = context.calls.list;
    return calls;
}

/// Whether vertices before small runs, or after them, may share a mesh with theirs.
bool can_be_joined(const Context& context) {
    return !context.assembler.mesh.empty() ||
           context.translated.runs_drawn_at == context.translated.changes;
}

}  // namespace

bool draw_runs(Context& context, SealedRuns& runs) {
    if (runs.is_small && can_be_joined(context)) return false;
    if (context.assembler.inside || !is_draw_complete(context) ||
        (runs.has_line_strips &&
         (context.state.line.stipple || context.selection.mode == GL_FEEDBACK)) ||
        (!runs.given.edge_flag && !context.state.current.edge_flag))
        return false;
    flush_mesh(context);
    update_machine_state(context);
    VertexValues used = used_values(context.state, context.selection.mode == GL_FEEDBACK);
    used.materials = false;
    used.colors &= runs.given.color;
    used.normals &= runs.given.normal;
    used.texcoords &= runs.given.texcoord;
    used.secondary_colors &= runs.given.secondary_color;
    used.fog_coordinates &= runs.given.fog_coordinate;
    for (std::size_t i = 0; i < used.further_texcoords.size(); ++i)
        used.further_texcoords[i] &= runs.given.further_texcoords[i];
    const FaceMaterials materials = face_materials(context);
    for (SealedRuns::Part& part : runs.parts)
        submit(context,
               make_draw(context, mesh_for(part, used),
                         common_values(context, runs, part.assembly.vertices.front()),
                         common_further(context, runs, part), materials),
               played_calls(context, part));
    set_current(context.state.current, runs);
    if (runs.is_small) context.translated.runs_drawn_at = context.translated.changes;
    return true;
}

}  // namespace gw::gl
