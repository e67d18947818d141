// Fog, the tests of fragments, blending, masks and the values of clears. [GL11] 3.9, 4.1, 4.2
#include "gl/api/calls.h"
#include "gl/api/finite.h"
#include "gl/context/context.h"
#include "gl/draw/submit.h"

#include "gw/describe/opengl.h"

#include <algorithm>
#include <optional>

namespace gw::gl {

namespace {

/// One of the machine's words that the profile has.
template <typename Enum>
std::optional<Enum> known_word(const Context& context, GLenum number) {
    const auto word = from_opengl<Enum>(number);
    return word && has_word(context.profile.extensions, *word) ? word : std::nullopt;
}

bool is_compare_func(const Context& context, GLenum func) {
    return known_word<CompareFunc>(context, func).has_value();
}
bool is_stencil_op(const Context& context, GLenum op) {
    return known_word<gw::StencilOp>(context, op).has_value();
}
bool is_source_factor(const Context& context, GLenum factor) {
    const auto word = known_word<BlendFactor>(context, factor);
    return word && (is_source(*word) || context.profile.extensions.blend_square);
}
bool is_destination_factor(const Context& context, GLenum factor) {
    const auto word = known_word<BlendFactor>(context, factor);
    if (word == BlendFactor::SrcAlphaSaturate) return false;
    return word && (is_destination(*word) || context.profile.extensions.blend_square);
}

/// Whether alpha may blend by a rule of its own; else an error.
bool may_separate(Context& context) {
    if (context.profile.extensions.blend_separate) return true;
    set_error(context, GL_INVALID_OPERATION);
    return false;
}

vec4 clamped_value(const vec4& v, float low) {
    return {clamped(v.x, low, 1.0f), clamped(v.y, low, 1.0f), clamped(v.z, low, 1.0f),
            clamped(v.w, low, 1.0f)};
}

}  // namespace

namespace execute {

void fog(Context& context, GLenum pname, const Params& params) {
    FogState& s = context.state.fog;
    switch (pname) {
        case GL_FOG_MODE: {
            const GLenum mode = params.token();
            if (!known_word<FogMode>(context, mode)) return set_error(context, GL_INVALID_ENUM);
            return change(context, s.mode, mode);
        }
        case GL_FOG_DENSITY:
            if (!(params[0] >= 0)) return set_error(context, GL_INVALID_VALUE);
            return change(context, s.density, float(params[0]));
        case GL_FOG_START: return change(context, s.start, float(params[0]));
        case GL_FOG_END: return change(context, s.end, float(params[0]));
        case GL_FOG_INDEX: return change(context, s.index, float(params[0]));
        case GL_FOG_COORDINATE_SOURCE: {
            const GLenum source = params.token();
            if (source != GL_FRAGMENT_DEPTH && source != GL_FOG_COORDINATE)
                return set_error(context, GL_INVALID_ENUM);
            return change(context, s.coordinate_source, source);
        }
        case GL_FOG_COLOR:
            if (params.count < 4) return set_error(context, GL_INVALID_ENUM);
            return change(context, s.color, glm::clamp(params.as_vec4(), 0.0f, 1.0f));
    }
    set_error(context, GL_INVALID_ENUM);
}

void scissor(Context& context, GLint x, GLint y, GLsizei width, GLsizei height) {
    if (width < 0 || height < 0) return set_error(context, GL_INVALID_VALUE);
    change(context, context.state.scissor.box, Rect{x, y, width, height});
}

void alpha_func(Context& context, GLenum func, GLclampf ref) {
    if (!is_compare_func(context, func)) return set_error(context, GL_INVALID_ENUM);
    change(context, context.state.color_buffer.alpha_func, func);
    change(context, context.state.color_buffer.alpha_ref, clamped(ref, 0.0f, 1.0f));
}

void stencil_func(Context& context, GLenum func, GLint ref, GLuint mask) {
    if (!is_compare_func(context, func)) return set_error(context, GL_INVALID_ENUM);
    change(context, context.state.stencil.func, func);
    change(context, context.state.stencil.ref,
           std::clamp(ref, 0, (1 << context.profile.stencil_bits) - 1));
    change(context, context.state.stencil.mask, mask);
}

void stencil_op(Context& context, GLenum fail, GLenum zfail, GLenum zpass) {
    if (!is_stencil_op(context, fail) || !is_stencil_op(context, zfail) ||
        !is_stencil_op(context, zpass))
        return set_error(context, GL_INVALID_ENUM);
    change(context, context.state.stencil.fail, fail);
    change(context, context.state.stencil.zfail, zfail);
    change(context, context.state.stencil.zpass, zpass);
}

void depth_func(Context& context, GLenum func) {
    if (!is_compare_func(context, func)) return set_error(context, GL_INVALID_ENUM);
    change(context, context.state.depth.func, func);
}

void blend_func(Context& context, GLenum sfactor, GLenum dfactor) {
    blend_func_separate(context, sfactor, dfactor, sfactor, dfactor);
}

void blend_func_separate(Context& context, GLenum src_rgb, GLenum dst_rgb, GLenum src_alpha,
                         GLenum dst_alpha) {
    if (!is_source_factor(context, src_rgb) || !is_destination_factor(context, dst_rgb) ||
        !is_source_factor(context, src_alpha) || !is_destination_factor(context, dst_alpha))
        return set_error(context, GL_INVALID_ENUM);
    if ((src_rgb != src_alpha || dst_rgb != dst_alpha) && !may_separate(context)) return;
    ColorBufferState& s = context.state.color_buffer;
    change(context, s.blend_src, src_rgb);
    change(context, s.blend_dst, dst_rgb);
    change(context, s.blend_src_alpha, src_alpha);
    change(context, s.blend_dst_alpha, dst_alpha);
}

void blend_color(Context& context, GLclampf red, GLclampf green, GLclampf blue, GLclampf alpha) {
    if (!context.profile.extensions.blend_color) return set_error(context, GL_INVALID_OPERATION);
    change(context, context.state.color_buffer.blend_color,
           clamped_value({red, green, blue, alpha}, 0));
}

void blend_equation(Context& context, GLenum mode) { blend_equation_separate(context, mode, mode); }

void blend_equation_separate(Context& context, GLenum mode_rgb, GLenum mode_alpha) {
    if (!known_word<gw::BlendEquation>(context, mode_rgb) ||
        !known_word<gw::BlendEquation>(context, mode_alpha))
        return set_error(context, GL_INVALID_ENUM);
    if (mode_rgb != mode_alpha && !may_separate(context)) return;
    change(context, context.state.color_buffer.blend_equation, mode_rgb);
    change(context, context.state.color_buffer.blend_equation_alpha, mode_alpha);
}

void logic_op(Context& context, GLenum opcode) {
    if (opcode < GL_CLEAR || opcode > GL_SET) return set_error(context, GL_INVALID_ENUM);
    change(context, context.state.color_buffer.logic_op_mode, opcode);
}

void index_mask(Context& context, GLuint mask) { context.state.color_buffer.index_mask = mask; }

void color_mask(Context& context, GLboolean red, GLboolean green, GLboolean blue, GLboolean alpha) {
    const std::array mask{red != GL_FALSE, green != GL_FALSE, blue != GL_FALSE, alpha != GL_FALSE};
    change(context, context.state.color_buffer.mask, mask);
}

void depth_mask(Context& context, GLboolean flag) {
    change(context, context.state.depth.mask, flag != GL_FALSE);
}
void stencil_mask(Context& context, GLuint mask) {
    change(context, context.state.stencil.write_mask, mask);
}

void clear_color(Context& context, GLclampf red, GLclampf green, GLclampf blue, GLclampf alpha) {
    context.state.color_buffer.clear = clamped_value({red, green, blue, alpha}, 0);
}
void clear_index(Context& context, GLfloat value) {
    context.state.color_buffer.clear_index = value;
}
void clear_depth(Context& context, GLclampd depth) {
    context.state.depth.clear = clamped(depth, 0.0, 1.0);
}
void clear_stencil(Context& context, GLint s) {
    context.state.stencil.clear = s & ((1 << context.profile.stencil_bits) - 1);
}
void clear_accum(Context& context, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha) {
    context.state.accum.clear = clamped_value({red, green, blue, alpha}, -1);
}

}  // namespace execute

}  // namespace gw::gl
