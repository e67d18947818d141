// The attribute stack's entries: groups of the state that PushAttrib copies. [GL11] 6.1.10
#pragma once

#include "gl/state/state.h"

#include <array>
#include <vector>

namespace gw::gl {

inline constexpr std::size_t attribute_stack_depth = 16;

struct SavedAttributes {
    GLbitfield mask = 0;
    State state;                ///< its groups of `mask` count
    std::vector<bool> enables;  ///< GL_ENABLE_BIT: in the order of capabilities()
    /// GL_TEXTURE_BIT: the parameters of the bound textures
    std::array<TextureParameters, texture_target_count> textures{};
};

}  // namespace gw::gl
