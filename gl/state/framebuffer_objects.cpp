#include "gl/state/framebuffer_objects.h"

#include <GL/glext.h>

#include <algorithm>
#include <limits>

namespace gw::gl {

int depth_bits_of(const Profile& profile, GLint internal_format) {
    switch (internal_format) {
        case GL_DEPTH_COMPONENT16: return 16;
        case GL_DEPTH_COMPONENT24:
        case GL_DEPTH24_STENCIL8: return 24;
        case GL_DEPTH_COMPONENT32:
        case GL_DEPTH_COMPONENT32F:
        case GL_DEPTH32F_STENCIL8: return 32;
        case GL_DEPTH_COMPONENT:
        case GL_DEPTH_STENCIL: return profile.depth_bits;
    }
    return 0;
}

bool has_stencil(GLint internal_format) {
    switch (internal_format) {
        case GL_STENCIL_INDEX:
        case GL_STENCIL_INDEX1:
        case GL_STENCIL_INDEX4:
        case GL_STENCIL_INDEX8:
        case GL_STENCIL_INDEX16:
        case GL_DEPTH_STENCIL:
        case GL_DEPTH24_STENCIL8:
        case GL_DEPTH32F_STENCIL8: return true;
    }
    return false;
}

bool is_color_renderable(GLint internal_format) {
    const GLenum base = base_format(internal_format);
    return (base == GL_RGB || base == GL_RGBA) && !is_compressed(internal_format);
}

bool suits_plane(const Profile& profile, GLint internal_format, Plane plane) {
    if (plane == Plane::Color) return is_color_renderable(internal_format);
    return plane == Plane::Depth ? depth_bits_of(profile, internal_format) != 0
                                 : has_stencil(internal_format);
}

std::optional<AttachedImage> attached_image(const Attachment& a) {
    if (const Renderbuffer* const of = a.renderbuffer.get()) {
        if (of->width == 0 || of->height == 0) return std::nullopt;
        return AttachedImage{of->width, of->height, GLint(of->internal_format), of->samples};
    }
    if (a.texture == nullptr) return std::nullopt;
    const TextureImage& image = a.texture->image(a.place.key);
    if (image.width == 0 || image.height == 0 || image.border != 0 || a.place.slice >= image.depth)
        return std::nullopt;
    return AttachedImage{image.width, image.height, image.internal_format, 0};
}

namespace {

/// The machine's surfaces have no borders.
bool has_border(const Attachment& a) {
    return a.texture != nullptr && a.texture->image(a.place.key).border != 0;
}

}  // namespace

GLenum status_of(const Framebuffer& framebuffer, const Profile& profile) {
    std::optional<int> samples;
    bool are_equal = true, is_supported = true;
    for (const Plane plane : {Plane::Color, Plane::Depth, Plane::Stencil}) {
        const Attachment& attachment = framebuffer.at(plane);
        if (!attachment.is_given()) continue;
        if (has_border(attachment)) {
            is_supported = false;
            continue;
        }
        const auto image = attached_image(attachment);
        if (!image || !suits_plane(profile, image->internal_format, plane))
            return GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT;
        are_equal &= samples.value_or(image->samples) == image->samples;
        samples = image->samples;
    }
    if (!is_supported) return GL_FRAMEBUFFER_UNSUPPORTED;
    if (!samples) return GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT;
    return are_equal ? GL_FRAMEBUFFER_COMPLETE : GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE;
}

FramebufferSize size_of(const Framebuffer& framebuffer) {
    FramebufferSize out{std::numeric_limits<int>::max(), std::numeric_limits<int>::max()};
    for (const Attachment& attachment : framebuffer.attachments)
        if (const auto image = attached_image(attachment))
            out = {std::min(out.width, image->width), std::min(out.height, image->height)};
    return out;
}

bool has_one_size(const Framebuffer& framebuffer) {
    const FramebufferSize size = size_of(framebuffer);
    return std::ranges::all_of(framebuffer.attachments, [&](const Attachment& attachment) {
        const auto image = attached_image(attachment);
        return !image || (image->width == size.width && image->height == size.height);
    });
}

}  // namespace gw::gl
