// The images of renderbuffer objects; GenerateMipmap. GL_ARB_framebuffer_object, 4.4.2, 3.8.8
#include "gl/api/calls.h"
#include "gl/draw/submit.h"
#include "gl/draw/targets.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdio>

namespace gw::gl {

namespace {

/// The formats of table 4.12; numbers 1 to 4 are not among them.
bool is_renderable(const Profile& profile, GLenum format) {
    if (format <= 4) return false;
    return std::ranges::any_of(
        std::array{Plane::Color, Plane::Depth, Plane::Stencil},
        [&](Plane plane) { return suits_plane(profile, GLint(format), plane); });
}

/// Programs ask for floats whether or not GL_ARB_depth_buffer_float is offered.
void warn_of_float_depths(GLenum format) {
    if (format != GL_DEPTH_COMPONENT32F && format != GL_DEPTH32F_STENCIL8) return;
    static std::atomic_flag warned;
    if (warned.test_and_set()) return;
    std::fprintf(stderr,
                 "gw: warning: glRenderbufferStorage asks for float depths; they are stored in 32 "
                 "bits from 0 to 1, evenly spaced\n");
}

/// None: INVALID_ENUM.
std::optional<GLint> renderbuffer_value(const Context& context, const Renderbuffer& of,
                                        GLenum pname) {
    const auto format = GLint(of.internal_format);
    const bool is_empty = of.width == 0 || of.height == 0;
    const auto bits = [&](bool has, int count) { return has && !is_empty ? count : 0; };
    switch (pname) {
        case GL_RENDERBUFFER_WIDTH: return of.width;
        case GL_RENDERBUFFER_HEIGHT: return of.height;
        case GL_RENDERBUFFER_INTERNAL_FORMAT: return format;
        case GL_RENDERBUFFER_SAMPLES: return of.samples;
        case GL_RENDERBUFFER_RED_SIZE:
        case GL_RENDERBUFFER_GREEN_SIZE:
        case GL_RENDERBUFFER_BLUE_SIZE:
            return bits(is_color_renderable(format), context.profile.color_bits);
        case GL_RENDERBUFFER_ALPHA_SIZE:
            return bits(base_format(format) == GL_RGBA, context.profile.color_bits);
        case GL_RENDERBUFFER_DEPTH_SIZE: return bits(true, depth_bits_of(context.profile, format));
        case GL_RENDERBUFFER_STENCIL_SIZE:
            return bits(has_stencil(format), context.profile.stencil_bits);
    }
    return std::nullopt;
}

}  // namespace

namespace execute {

void renderbuffer_storage(Context& context, GLenum target, GLsizei samples, GLenum internal_format,
                          GLsizei width, GLsizei height) {
    if (target != GL_RENDERBUFFER || !is_renderable(context.profile, internal_format))
        return set_error(context, GL_INVALID_ENUM);
    const auto is_side = [](GLsizei side) { return side >= 0 && side <= max_surface_size; };
    if (!is_side(width) || !is_side(height) || samples < 0 || samples > most_samples(context))
        return set_error(context, GL_INVALID_VALUE);
    Renderbuffer* const object = context.framebuffers.renderbuffer.get();
    if (object == nullptr) return set_error(context, GL_INVALID_OPERATION);
    warn_of_float_depths(internal_format);
    begin_change(context);
    const auto lock = context.shared->exclusive();
    const int given = samples == 0 ? 0 : std::max(2, int(std::bit_ceil(unsigned(samples))));
    if (given * std::int64_t{width} * height > max_surface_samples)
        return set_error(context, GL_OUT_OF_MEMORY);
    *object = {object->name, internal_format, width, height, given, nullptr};
}

void get_renderbuffer_parameteriv(Context& context, GLenum target, GLenum pname, GLint* params) {
    if (target != GL_RENDERBUFFER) return set_error(context, GL_INVALID_ENUM);
    const Renderbuffer* const object = context.framebuffers.renderbuffer.get();
    if (object == nullptr) return set_error(context, GL_INVALID_OPERATION);
    const auto value = renderbuffer_value(context, *object, pname);
    if (!value) return set_error(context, GL_INVALID_ENUM);
    if (params != nullptr) *params = *value;
}

void generate_mipmap(Context& context, GLenum target) {
    const auto index = target_index(context.profile, target);
    if (!index || *index == rectangular) return set_error(context, GL_INVALID_ENUM);
    begin_change(context);
    TextureObject& object = bound_texture(context, *index);
    update_texels(context, object);
    const auto lock = context.shared->exclusive();
    if (*index == cube && !has_base(object, cube)) return set_error(context, GL_INVALID_OPERATION);
    for (std::size_t face = 0; face <= object.further_faces.size(); ++face)
        object.generate_levels(face);
}

}  // namespace execute

}  // namespace gw::gl
