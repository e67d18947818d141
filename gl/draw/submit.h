// Makes the machine's commands of the assembled mesh and GL's state.
#pragma once

#include "gl/assemble/assembly.h"
#include "gl/drawable/call_trace.h"
#include "gl/state/state_parts.h"
#include "gw/command_list.h"

#include <span>
#include <vector>

namespace gw::gl {

struct Context;

/// Draws the mesh that has been assembled, if there is one. Everything that changes the state or reads
/// pixels calls it first.
void flush_mesh(Context& context);

/// Before a change of the state: flushes the mesh, and notes the parts that change.
void begin_change(Context& context, StateParts parts = all_state_parts);

/// The same before a change of one field of the state.
void begin_change_of(Context& context, const void* field);

/// Flushes the mesh, then assigns a value of the state.
template <class T, class V>
void change(Context& context, T& field, const V& value) {
    if (field == T(value)) return;
    begin_change_of(context, &field);
    field = T(value);
}

/// The current materials of both faces.
FaceMaterials face_materials(const Context& context);

/// The enabled texture of a unit; cubes come before three dimensions, those before two. Null: none,
/// or it is not complete. [GL13] 3.8.15
TextureRef enabled_texture(Context& context, std::size_t unit = 0);
/// The enabled textures of units 1 to 3; null: there are none.
std::shared_ptr<const MoreBindings> further_textures(Context& context);

/// A draw with the current state. A vertex has `values` and `further` if the mesh has no array of
/// them.
Draw make_draw(Context& context, MeshRef mesh, const AssembledVertex& values,
               const FurtherTexcoords& further, const FaceMaterials& materials);
/// The same draw with a texture of two dimensions, so that the vertex stages make all texture
/// coordinates.
Draw with_texture_coordinates(Draw draw);
/// Adds a draw to the frame; in feedback and selection mode, reports its primitives. `calls` are
/// those of its primitives; none: the present call made them all.
void submit(Context& context, Draw draw, std::vector<CallRun> calls = {});

/// The call that is being carried out; none if calls are not kept.
std::vector<CallRun> present_call(const Context& context);

/// Brings Context::translated up to GL's state.
void update_machine_state(Context& context);

/// Sends GL's state to the drawable, for commands that do not draw meshes (clears, pixels). False if
/// there is no drawable.
bool submit_state(Context& context, std::span<const CallRun> calls = {});

/// Sends GL's state and a command to the drawable if there is one. No other thread's command comes
/// between the two.
void submit_command(Context& context, Command command, std::vector<CallRun> calls = {});

}  // namespace gw::gl
