// Surfaces as OpenGL's framebuffer objects, and blits between them. Does not draw to them.
#pragma once

#include "gw/command_list.h"

#include <GL/gl.h>

#include <cstdint>
#include <map>

namespace gw::peer {

class Framebuffers {
public:
    /// Makes a surface in place of the one that has the number. Its values are 0. Throws Error for
    /// depths that OpenGL has no format for. The window is bound afterwards.
    void make(const MakeSurface& command);
    /// Draws to it and reads from it; 0: the window.
    void use(std::uint32_t number);
    std::uint32_t in_use() const { return in_use_; }
    /// Null: the window.
    const gw::Surface* surface() const;

    /// The buffer for colours of what is in use; GL_NONE: it has none.
    GLenum color_buffer() const { return color_buffer(in_use_); }
    /// The texture object of a plane of a surface without samples.
    unsigned texture_of(const SurfacePlane& plane) const;
    /// `colors`: whether a colour buffer is drawn to.
    void blit(const Blit& command, bool colors);

private:
    struct Made {
        gw::Surface surface;
        GLuint framebuffer = 0;
        GLuint color = 0, depth = 0;  ///< textures; with samples, renderbuffers
    };
    GLenum color_buffer(std::uint32_t number) const;
    void destroy(std::uint32_t number);
    std::map<std::uint32_t, Made> made_;
    std::uint32_t in_use_ = 0;
};

}  // namespace gw::peer
