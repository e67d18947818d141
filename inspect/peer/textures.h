// Textures, texture slots and planes of surfaces as OpenGL's texture objects on texture units. Does
// not choose texture coordinates.
#pragma once

#include "gw/command_list.h"

#include <GL/gl.h>

#include <array>
#include <cstdint>
#include <map>

namespace gw::peer {

/// By texture unit: the target that its texture is bound to; 0: it has none.
using TextureTargets = std::array<GLenum, max_texture_units>;

/// Makes a unit the one that calls are about. Refuses units beside the first of an OpenGL 1.1.
void use_unit(std::size_t unit);
/// glEnable or glDisable of all units' textures.
void enable(const TextureTargets& targets, bool on);

class Textures {
public:
    /// Binds the texture of a unit, made on its first use, with the state's look-up and environment;
    /// returns its target, or 0 if there is none. `plane`: the object of a surface's plane.
    GLenum bind(std::size_t unit, const TextureBinding& binding, const TextureState& state,
                unsigned plane);
    /// glCopyTexImage2D from the current planes.
    void copy(const CopyTexture& command);

private:
    unsigned object(const TextureBinding& binding, GLenum target);
    /// by identity; keeps them alive, so that no address comes twice
    std::map<TextureRef, unsigned> made_;
    std::map<std::uint32_t, unsigned> slots_;
};

}  // namespace gw::peer
