// From the assembled mesh and GL's state to the machine's commands.
#pragma once

#include "gl/assemble/assembly.h"
#include "gl/context/call_trace.h"
#include "gw/command_list.h"

#include <span>
#include <vector>

namespace gw::gl {

struct Context;

/// The machine's state and lights that follow from GL's, kept until a group changes.
struct MachineState {
    bool changed = true;
    gw::State state;
    LightsRef lights;
};

/// Draws what was assembled before a change of the state, and notes the change.
void begin_change(Context& c);

/// Assigns a value of the state. What was assembled before is drawn with the old one.
template <class T, class V>
void change(Context& c, T& field, const V& value) {
    if (field == T(value)) return;
    begin_change(c);
    field = T(value);
}

/// The current materials of both faces.
FaceMaterials face_materials(const Context& c);

/// The enabled texture; two dimensions come before one. Null: none, or it is not complete. [GL11]
/// 3.8.10
TextureRef enabled_texture(Context& c);

/// A draw with the current state. `values` are those of all vertices for which the mesh has none.
Draw make_draw(Context& c, MeshRef mesh, const AssembledVertex& values,
               const FaceMaterials& materials);
/// The same draw with a texture of two dimensions, so that the vertex stages make all texture
/// coordinates.
Draw with_texture_coordinates(Draw draw);
/// Adds a draw to the frame; in feedback and selection mode, reports its primitives. `calls` are
/// those of its primitives; none: the present call made them all.
void submit(Context& c, Draw draw, std::vector<CallRun> calls = {});
/// Draws what was assembled.
void submit_assembled(Context& c);

/// The call that is being carried out; none if calls are not kept.
std::vector<CallRun> present_call(const Context& c);

/// Brings machine_state up to GL's state.
void update_machine_state(Context& c);

/// Sends GL's state to the drawable, for commands that do not draw meshes (clears, pixels). False if
/// there is no drawable.
bool submit_state(Context& c, std::span<const CallRun> calls = {});

/// Sends GL's state and a command to the drawable if there is one. No other thread's command comes
/// between the two.
void submit_command(Context& c, Command command, std::vector<CallRun> calls = {});

}  // namespace gw::gl
