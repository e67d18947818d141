// A texture of one row with its environment, for tests of texture units.
#pragma once

#include "tests/gl/unit/support/window.h"

#include <array>
#include <vector>

namespace gw::gl {

using Pixel = std::array<GLubyte, 4>;

/// A texture of one row, on the active unit.
inline void use_texture(const std::vector<Pixel>& texels, GLenum environment = GL_MODULATE) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, GLsizei(texels.size()), 1, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GLint(environment));
    glEnable(GL_TEXTURE_2D);
}
/// The same of a unit; unit 0 is active afterwards.
inline void use_texture_of(GLenum unit, const std::vector<Pixel>& texels,
                           GLenum environment = GL_MODULATE) {
    glActiveTexture(unit);
    use_texture(texels, environment);
    glActiveTexture(GL_TEXTURE0);
}

}  // namespace gw::gl
