// The images of framebuffer objects, and their queries. GL_ARB_framebuffer_object, 4.4.2, 4.4.4, 6.1.3
#include "gl/api/calls.h"
#include "gl/draw/submit.h"
#include "gl/draw/targets.h"
#include "gl/state/texture_targets.h"

#include <bit>

namespace gw::gl {

namespace {

/// The object that is bound to a target; null after an error. `window_error`: if it is the window.
Framebuffer* bound_framebuffer(Context& context, GLenum target, GLenum window_error) {
    if (target != GL_FRAMEBUFFER && target != GL_DRAW_FRAMEBUFFER && target != GL_READ_FRAMEBUFFER)
        return set_error(context, GL_INVALID_ENUM), nullptr;
    const Framebuffers& f = context.framebuffers;
    Framebuffer* const object = (target == GL_READ_FRAMEBUFFER ? f.read : f.draw).get();
    if (object == nullptr) set_error(context, window_error);
    return object;
}

/// The planes that an attachment point means; 0 after an error.
PlaneMask planes_of_point(Context& context, GLenum attachment) {
    switch (attachment) {
        case GL_COLOR_ATTACHMENT0: return mask_of(Plane::Color);
        case GL_DEPTH_ATTACHMENT: return mask_of(Plane::Depth);
        case GL_STENCIL_ATTACHMENT: return mask_of(Plane::Stencil);
        case GL_DEPTH_STENCIL_ATTACHMENT:
            return PlaneMask(mask_of(Plane::Depth) | mask_of(Plane::Stencil));
    }
    const bool is_further =
        attachment > GL_COLOR_ATTACHMENT0 && attachment <= GL_COLOR_ATTACHMENT0 + 31;
    set_error(context, is_further ? GL_INVALID_OPERATION : GL_INVALID_ENUM);
    return 0;
}

void attach(Context& context, Framebuffer& framebuffer, PlaneMask planes, const Attachment& to) {
    begin_change(context);
    for (const Plane plane : {Plane::Color, Plane::Depth, Plane::Stencil})
        if (planes & mask_of(plane)) framebuffer.at(plane) = to;
}

/// The texture image of a call; none after an error.
std::optional<Attachment> texture_image(Context& context, int dimensions, GLenum textarget,
                                        GLuint texture, GLint level, GLint layer) {
    const auto place = place_of(context.profile, textarget);
    if (!place || place->is_proxy) return set_error(context, GL_INVALID_ENUM), std::nullopt;
    const auto lock = context.shared->exclusive();
    const auto& named = context.shared->textures.named;
    const auto found = named.find(texture);
    if (found == named.end() || !found->second.object || dimensions_of(*place) != dimensions ||
        found->second.target != texture_targets[place->index])
        return set_error(context, GL_INVALID_OPERATION), std::nullopt;
    const int largest = largest_texture(context.profile, place->index);
    if (!has_level(place->index, level) || level >= int(std::bit_width(unsigned(largest))) ||
        layer < 0 || layer >= largest)
        return set_error(context, GL_INVALID_VALUE), std::nullopt;
    return Attachment{.texture = found->second.object,
                      .name = texture,
                      .target = place->index,
                      .place = {{place->face, std::size_t(level)}, layer}};
}

void attach_texture(Context& context, int dimensions, GLenum target, GLenum point, GLenum textarget,
                    GLuint texture, GLint level, GLint layer) {
    Framebuffer* const framebuffer = bound_framebuffer(context, target, GL_INVALID_OPERATION);
    if (framebuffer == nullptr) return;
    const PlaneMask planes = planes_of_point(context, point);
    if (planes == 0) return;
    if (texture == 0) return attach(context, *framebuffer, planes, {});
    if (const auto a = texture_image(context, dimensions, textarget, texture, level, layer))
        attach(context, *framebuffer, planes, *a);
}

/// The bits of a component of an attached image.
int component_bits(const Context& context, const Framebuffer& framebuffer, Plane plane,
                   GLenum pname) {
    const auto image = attached_image(framebuffer.at(plane));
    if (!image) return 0;
    const GLint format = image->internal_format;
    switch (pname) {
        case GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE: return depth_bits_of(context.profile, format);
        case GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE:
            return has_stencil(format) ? context.profile.stencil_bits : 0;
        case GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE:
            return base_format(format) == GL_RGBA ? context.profile.color_bits : 0;
    }
    return is_color_renderable(format) ? context.profile.color_bits : 0;
}

/// None: INVALID_ENUM.
std::optional<GLint> attachment_value(const Context& context, const Framebuffer& framebuffer,
                                      Plane plane, GLenum pname) {
    const Attachment& a = framebuffer.at(plane);
    if (pname == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE)
        return a.texture ? GL_TEXTURE : a.renderbuffer ? GL_RENDERBUFFER : GL_NONE;
    if (pname == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME) return GLint(a.name);
    switch (pname) {
        case GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE:
        case GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE:
        case GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE:
        case GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE:
        case GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE:
        case GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE:
            return component_bits(context, framebuffer, plane, pname);
        case GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE:
            return plane == Plane::Stencil ? GL_INDEX : GL_UNSIGNED_NORMALIZED;
        case GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING: {
            const auto image = attached_image(a);
            return image && is_srgb(image->internal_format) ? GL_SRGB : GL_LINEAR;
        }
    }
    if (!a.texture) return std::nullopt;
    switch (pname) {
        case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL: return GLint(a.place.key.level);
        case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE:
            return a.target == cube
                       ? GLint(GL_TEXTURE_CUBE_MAP_POSITIVE_X + GLenum(a.place.key.face))
                       : 0;
        case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER: return a.place.slice;
    }
    return std::nullopt;
}

/// What the window answers. None: INVALID_ENUM.
std::optional<GLint> window_value(const Context& context, GLenum attachment, GLenum pname) {
    const bool is_depth = attachment == GL_DEPTH, is_stencil = attachment == GL_STENCIL;
    const bool is_back = attachment == GL_BACK_LEFT;
    if (!is_depth && !is_stencil && !is_back && attachment != GL_FRONT_LEFT) return std::nullopt;
    const bool has =
        context.window != nullptr && (!is_back || context.window->is_double_buffered());
    const bool is_color = !is_depth && !is_stencil;
    switch (pname) {
        case GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE: return has ? GL_FRAMEBUFFER_DEFAULT : GL_NONE;
        case GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME: return 0;
        case GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE:
        case GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE:
        case GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE:
        case GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE: return is_color ? context.profile.color_bits : 0;
        case GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE: return is_depth ? context.profile.depth_bits : 0;
        case GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE:
            return is_stencil ? context.profile.stencil_bits : 0;
        case GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE:
            return is_stencil ? GL_INDEX : GL_UNSIGNED_NORMALIZED;
        case GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING: return GL_LINEAR;
    }
    return std::nullopt;
}

void answer(Context& context, std::optional<GLint> value, GLint* params) {
    if (!value) return set_error(context, GL_INVALID_ENUM);
    if (params != nullptr) *params = *value;
}

}  // namespace

namespace execute {

GLenum check_framebuffer_status(Context& context, GLenum target) {
    if (target != GL_FRAMEBUFFER && target != GL_DRAW_FRAMEBUFFER && target != GL_READ_FRAMEBUFFER)
        return set_error(context, GL_INVALID_ENUM), 0;
    const Framebuffers& f = context.framebuffers;
    return framebuffer_status(context, target == GL_READ_FRAMEBUFFER ? f.read : f.draw);
}

void framebuffer_texture_1d(Context& context, GLenum target, GLenum attachment, GLenum textarget,
                            GLuint texture, GLint level) {
    attach_texture(context, 1, target, attachment, textarget, texture, level, 0);
}

void framebuffer_texture_2d(Context& context, GLenum target, GLenum attachment, GLenum textarget,
                            GLuint texture, GLint level) {
    attach_texture(context, 2, target, attachment, textarget, texture, level, 0);
}

void framebuffer_texture_3d(Context& context, GLenum target, GLenum attachment, GLenum textarget,
                            GLuint texture, GLint level, GLint layer) {
    attach_texture(context, 3, target, attachment, textarget, texture, level, layer);
}

void framebuffer_renderbuffer(Context& context, GLenum target, GLenum attachment,
                              GLenum renderbuffertarget, GLuint renderbuffer) {
    Framebuffer* const framebuffer = bound_framebuffer(context, target, GL_INVALID_OPERATION);
    if (framebuffer == nullptr) return;
    const PlaneMask planes = planes_of_point(context, attachment);
    if (planes == 0) return;
    if (renderbuffertarget != GL_RENDERBUFFER) return set_error(context, GL_INVALID_ENUM);
    if (renderbuffer == 0) return attach(context, *framebuffer, planes, {});
    const auto lock = context.shared->exclusive();
    const auto& named = context.shared->renderbuffers.named;
    const auto found = named.find(renderbuffer);
    if (found == named.end() || !found->second) return set_error(context, GL_INVALID_OPERATION);
    attach(context, *framebuffer, planes,
           {.renderbuffer = found->second, .texture = nullptr, .name = renderbuffer});
}

void get_framebuffer_attachment_parameteriv(Context& context, GLenum target, GLenum attachment,
                                            GLenum pname, GLint* params) {
    const bool is_read = target == GL_READ_FRAMEBUFFER;
    const Framebuffers& f = context.framebuffers;
    const bool known = target == GL_FRAMEBUFFER || target == GL_DRAW_FRAMEBUFFER || is_read;
    if (known && !(is_read ? f.read : f.draw))
        return answer(context, window_value(context, attachment, pname), params);
    const Framebuffer* const framebuffer = bound_framebuffer(context, target, GL_INVALID_OPERATION);
    if (framebuffer == nullptr) return;
    const PlaneMask planes = planes_of_point(context, attachment);
    if (planes == 0) return;
    const bool is_pair = attachment == GL_DEPTH_STENCIL_ATTACHMENT;
    if (is_pair && framebuffer->at(Plane::Depth) != framebuffer->at(Plane::Stencil))
        return set_error(context, GL_INVALID_OPERATION);
    const Plane plane = planes & mask_of(Plane::Color)   ? Plane::Color
                        : planes & mask_of(Plane::Depth) ? Plane::Depth
                                                         : Plane::Stencil;
    const bool is_of_none = pname == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE ||
                            pname == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME;
    if (!framebuffer->at(plane).is_given() && !is_of_none)
        return set_error(context, GL_INVALID_OPERATION);
    answer(context, attachment_value(context, *framebuffer, plane, pname), params);
}

}  // namespace execute

}  // namespace gw::gl
