// Textures and texture slots as OpenGL's texture objects. Does not choose texture coordinates.
#pragma once

#include "gw/command_list.h"

#include <GL/gl.h>

#include <cstdint>
#include <map>

namespace gw::peer {

class Textures {
public:
    /// Binds the draw's texture, made on its first use, with the state's filters, wrap and
    /// environment; returns its target, or 0 if there is none.
    GLenum bind(const TextureBinding& binding, const TextureState& state);
    /// glCopyTexImage2D from the current planes.
    void copy(const CopyTexture& command);

private:
    unsigned object(const TextureBinding& binding, GLenum target);
    /// by identity; keeps them alive, so that no address comes twice
    std::map<TextureRef, unsigned> made_;
    std::map<std::uint32_t, unsigned> slots_;
};

}  // namespace gw::peer
