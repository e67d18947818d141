// Framebuffer and renderbuffer objects as data. GL_ARB_framebuffer_object
#pragma once

#include "gl/state/free_names.h"
#include "gl/state/texture_objects.h"
#include "gw/planes.h"

#include <GL/gl.h>

#include <array>
#include <map>
#include <memory>

namespace gw::gl {

/// The bits of depth that a renderable format asks for; 0: it has no depth.
int depth_bits_of(const Profile& profile, GLint internal_format);
bool has_stencil(GLint internal_format);
/// RGB and RGBA, of any size.
bool is_color_renderable(GLint internal_format);
/// Whether a plane of an image can have this format.
bool suits_plane(const Profile& profile, GLint internal_format, Plane plane);

struct Renderbuffer {
    GLuint name = 0;
    GLenum internal_format = GL_RGBA;
    int width = 0, height = 0;
    int samples = 0;
    std::shared_ptr<SurfaceImage> image;  ///< null: its planes were not used yet
};
using RenderbufferRef = std::shared_ptr<Renderbuffer>;

/// The names of renderbuffers. Contexts may share them. Null: reserved, not bound yet.
struct RenderbufferNames {
    std::map<GLuint, RenderbufferRef> named;
    FreeNames free_names;
};

/// An image that a framebuffer has: a renderbuffer, a texture's, or none.
struct Attachment {
    RenderbufferRef renderbuffer;
    std::shared_ptr<TextureObject> texture;
    GLuint name = 0;  ///< of either
    std::size_t target = 0;
    ImageSlice place;

    bool is_given() const { return renderbuffer != nullptr || texture != nullptr; }
    bool operator==(const Attachment&) const = default;
};

struct Framebuffer {
    GLuint name = 0;
    std::array<Attachment, 3> attachments;  ///< of Color, Depth and Stencil
    GLenum draw_buffer = GL_COLOR_ATTACHMENT0, read_buffer = GL_COLOR_ATTACHMENT0;

    Attachment& at(Plane plane) { return attachments[std::size_t(plane)]; }
    const Attachment& at(Plane plane) const { return attachments[std::size_t(plane)]; }
};
using FramebufferRef = std::shared_ptr<Framebuffer>;

/// The framebuffers of a context. The object 0 is the drawable; here it is null. It keeps its buffers
/// while another one is bound.
struct Framebuffers {
    std::map<GLuint, FramebufferRef> named;  ///< null: reserved, not bound yet
    FreeNames free_names;
    FramebufferRef draw, read;
    GLenum window_draw_buffer = GL_FRONT, window_read_buffer = GL_FRONT;
    RenderbufferRef renderbuffer;
};

/// What a framebuffer object sees of an attached image.
struct AttachedImage {
    int width = 0, height = 0;
    GLint internal_format = 0;
    int samples = 0;
};
/// None: the attachment, or the image, is not there.
std::optional<AttachedImage> attached_image(const Attachment& attachment);
/// CheckFramebufferStatus. `mode`s are those of the framebuffer.
GLenum status_of(const Framebuffer& framebuffer, const Profile& profile);

/// The sides of what all attached images have. Precondition: the framebuffer is complete.
struct FramebufferSize {
    int width = 0, height = 0;
};
FramebufferSize size_of(const Framebuffer& framebuffer);
/// Whether all attached images have that size.
bool has_one_size(const Framebuffer& framebuffer);

}  // namespace gw::gl
