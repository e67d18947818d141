// The attribute stack's entries: groups of the state that PushAttrib copies. [GL11] 6.1.10
#pragma once

#include "gl/state/state.h"

#include <array>
#include <vector>

namespace gw::gl {

struct Context;

inline constexpr std::size_t attribute_stack_depth = 16;

struct SavedAttributes {
    GLbitfield mask = 0;
    State state;                ///< its groups of `mask` count
    std::vector<bool> enables;  ///< GL_ENABLE_BIT: in the order of capabilities()
    /// GL_TEXTURE_BIT: the parameters of the bound textures
    std::array<TextureParameters, texture_target_count> textures{};
};

/// Copies the groups of PushAttrib's bits from a context to one that is not current, with the
/// bindings of textures as far as both share them. [GLX 1.4] 3.3.7, CopyContext
void copy_attributes(Context& to, const Context& from, GLbitfield mask);

}  // namespace gw::gl
