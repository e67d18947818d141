#include "inspect/peer/framebuffers.h"

#include "gw/error.h"
#include "inspect/peer/commands.h"
#include "inspect/peer/gl.h"

#include <fmt/format.h>

#include <utility>

namespace gw::peer {
namespace {

/// A plane of depths always has stencil values beside it if OpenGL has such a format: blits are
/// between equal ones.
GLenum depth_format(const gw::Surface& s) {
    const int bits = s.depth_bits == 0 ? 24 : s.depth_bits;
    if (bits == 24) return GL_DEPTH24_STENCIL8;
    if (!s.has(Plane::Stencil) && bits == 16) return GL_DEPTH_COMPONENT16;
    if (!s.has(Plane::Stencil) && bits == 32) return GL_DEPTH_COMPONENT32;
    throw Error(
        fmt::format("surface: depth_bits = {}{}; OpenGL has 16, 24 and 32, and with stencil "
                    "values 24",
                    bits, s.has(Plane::Stencil) ? " with stencil values" : ""));
}

GLuint new_texture(GLenum format, const gw::Surface& s) {
    const bool is_color = format == GL_RGBA8;
    const bool is_pair = format == GL_DEPTH24_STENCIL8;
    GLuint name = 0;
    gl().GenTextures(1, &name);
    gl().BindTexture(GL_TEXTURE_2D, name);
    gl().TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), s.width, s.height, 0,
                    is_color  ? GL_RGBA
                    : is_pair ? GL_DEPTH_STENCIL
                              : GL_DEPTH_COMPONENT,
                    is_color  ? GL_UNSIGNED_BYTE
                    : is_pair ? GL_UNSIGNED_INT_24_8
                              : GL_UNSIGNED_INT,
                    nullptr);
    if (gl().version >= 12) gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    return name;
}

GLuint new_renderbuffer(GLenum format, const gw::Surface& s) {
    GLuint name = 0;
    gl().GenRenderbuffers(1, &name);
    gl().BindRenderbuffer(GL_RENDERBUFFER, name);
    gl().RenderbufferStorageMultisample(GL_RENDERBUFFER, s.samples, format, s.width, s.height);
    return name;
}

/// Attaches a new image to the framebuffer that is bound.
GLuint attach(GLenum format, const gw::Surface& s, std::initializer_list<GLenum> points) {
    const GLuint name = s.samples > 0 ? new_renderbuffer(format, s) : new_texture(format, s);
    for (const GLenum point : points)
        if (s.samples > 0)
            gl().FramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, name);
        else
            gl().FramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, name, 0);
    return name;
}

/// All values 0, whatever the masks are.
void clear_all(const gw::Surface& s) {
    gl().PushAttrib(GL_ALL_ATTRIB_BITS);
    gl().Disable(GL_SCISSOR_TEST);
    gl().ColorMask(true, true, true, true);
    gl().DepthMask(true);
    gl().StencilMask(~0u);
    clear({.planes = PlaneMask(s.planes & surface_planes), .depth = 0}, 1);
    gl().PopAttrib();
}

/// The corners of a rectangle along one side, the first one last if it is flipped.
std::pair<GLint, GLint> corners(int at, int size, bool flips) {
    return flips ? std::pair(at + size, at) : std::pair(at, at + size);
}

}  // namespace

void Framebuffers::destroy(std::uint32_t number) {
    const auto found = made_.find(number);
    if (found == made_.end()) return;
    const Made& made = found->second;
    for (const GLuint name : {made.color, made.depth})
        made.surface.samples > 0 ? gl().DeleteRenderbuffers(1, &name)
                                 : gl().DeleteTextures(1, &name);
    gl().DeleteFramebuffers(1, &made.framebuffer);
    made_.erase(found);
}

void Framebuffers::make(const MakeSurface& c) {
    required(gl().GenFramebuffers, "GL_ARB_framebuffer_object", "surfaces");
    destroy(c.number);
    const Surface& s = c.surface;
    if (s.width == 0) return use(0);
    const GLenum format = s.has(Plane::Depth) || s.has(Plane::Stencil) ? depth_format(s) : GL_NONE;
    Made& made = made_[c.number];
    made.surface = s;
    gl().GenFramebuffers(1, &made.framebuffer);
    gl().BindFramebuffer(GL_FRAMEBUFFER, made.framebuffer);
    if (s.has(Plane::Color)) made.color = attach(GL_RGBA8, s, {GL_COLOR_ATTACHMENT0});
    if (s.has(Plane::Depth) && s.has(Plane::Stencil))
        made.depth = attach(format, s, {GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT});
    else if (format != GL_NONE)
        made.depth = attach(
            format, s, {s.has(Plane::Depth) ? GLenum(GL_DEPTH_ATTACHMENT) : GL_STENCIL_ATTACHMENT});
    gl().DrawBuffer(color_buffer(c.number));
    gl().ReadBuffer(color_buffer(c.number));
    if (gl().CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error(fmt::format("surface {}: this OpenGL has no such framebuffer", c.number));
    clear_all(s);
    use(0);
}

void Framebuffers::use(std::uint32_t number) {
    in_use_ = number;
    if (!gl().BindFramebuffer) return;  // there is the window only
    gl().BindFramebuffer(GL_FRAMEBUFFER, number == 0 ? 0 : made_.at(number).framebuffer);
}

const gw::Surface* Framebuffers::surface() const {
    return in_use_ == 0 ? nullptr : &made_.at(in_use_).surface;
}

GLenum Framebuffers::color_buffer(std::uint32_t number) const {
    if (number == 0) return gl().color_buffer;
    return made_.at(number).surface.has(Plane::Color) ? GL_COLOR_ATTACHMENT0 : GL_NONE;
}

unsigned Framebuffers::texture_of(const SurfacePlane& plane) const {
    const Made& made = made_.at(plane.surface);
    return plane.plane == Plane::Depth ? made.depth : made.color;
}

void Framebuffers::blit(const Blit& c, bool colors) {
    const auto copy = [&](GLbitfield buffers, GLenum filter) {
        if (buffers == 0) return;
        const auto [x0, x1] = corners(c.source.x, c.source.width, c.flip_x);
        const auto [y0, y1] = corners(c.source.y, c.source.height, c.flip_y);
        gl().BlitFramebuffer(x0, y0, x1, y1, c.target.x, c.target.y, c.target.x + c.target.width,
                             c.target.y + c.target.height, buffers, filter);
    };
    const auto both_have = [&](Plane plane) {
        return (c.planes & mask_of(plane)) != 0 &&
               (c.from_surface == 0 || made_.at(c.from_surface).surface.has(plane)) &&
               (in_use_ == 0 || made_.at(in_use_).surface.has(plane));
    };
    required(gl().BlitFramebuffer, "GL_ARB_framebuffer_object", "a blit");
    gl().BindFramebuffer(GL_READ_FRAMEBUFFER,
                         c.from_surface == 0 ? 0 : made_.at(c.from_surface).framebuffer);
    copy(colors && both_have(Plane::Color) ? GL_COLOR_BUFFER_BIT : 0, token(c.filter));
    copy((both_have(Plane::Depth) ? GL_DEPTH_BUFFER_BIT : 0) |
             (both_have(Plane::Stencil) ? GL_STENCIL_BUFFER_BIT : 0),
         GL_NEAREST);
    use(in_use_);
}

}  // namespace gw::peer
