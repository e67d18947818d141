// What Enable and Disable switch: one table. [GL11] tables 6.5 to 6.22
#pragma once

#include "gl/state/state.h"

#include <span>

namespace gw::gl {

/// A switch and its place in the state.
struct Capability {
    GLenum name;
    bool& (*field)(State&, int index);
    int index = 0;  ///< of a light, clip plane, coordinate or map
};
std::span<const Capability> capabilities();

/// Null: no such capability.
const Capability* find_capability(GLenum name);

inline bool is_enabled(const State& s, const Capability& capability) {
    return capability.field(const_cast<State&>(s), capability.index);
}

}  // namespace gw::gl
