// What Enable and Disable switch: one table. [GL11] tables 6.5 to 6.22
#pragma once

#include "gl/state/state.h"
#include "gw/profile.h"

#include <span>

namespace gw::gl {

/// A switch and its place in the state.
struct Capability {
    GLenum name;
    bool& (*field)(State&, int index);
    int index = 0;                        ///< of a light, clip plane, coordinate or map
    bool Extensions::*feature = nullptr;  ///< that the profile must have
    bool is_of_unit = false;  ///< each texture unit has one; the field is the active one's
};
std::span<const Capability> capabilities();

/// Null: the profile has no such capability.
const Capability* find_capability(const Profile& profile, GLenum name);

/// Calls take(field) for each switch in order, of each texture unit.
template <class Take>
void for_each_switch(State& s, Take take) {
    const std::size_t active = s.texture.active;
    for (const Capability& capability : capabilities())
        for (std::size_t unit = 0; unit < (capability.is_of_unit ? texture_unit_count : 1);
             ++unit) {
            if (capability.is_of_unit) s.texture.active = unit;
            take(capability.field(s, capability.index));
        }
    s.texture.active = active;
}

inline bool is_enabled(const State& s, const Capability& capability) {
    return capability.field(const_cast<State&>(s), capability.index);
}

}  // namespace gw::gl
