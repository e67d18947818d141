// From the assembled mesh and GL's state to the machine's commands.
#pragma once

#include "gw/command_list.h"

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

/// Draws the assembled mesh; in feedback and selection mode, reports it.
void submit_mesh(Context& c);

/// A draw of one point with the current values.
Draw point_draw(Context& c, const vec4& position);

/// Brings machine_state up to GL's state.
void update_machine_state(Context& c);

/// Sends GL's state to the drawable, for commands that do not draw meshes (clears, pixels). False if
/// there is no drawable.
bool submit_state(Context& c);

}  // namespace gw::gl
