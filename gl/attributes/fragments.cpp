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
std::optional<Enum> known_word(const Context& c, GLenum number) {
    const auto word = from_opengl<Enum>(number);
    return word && has_word(c.profile.extensions, *word) ? word : std::nullopt;
}

bool is_compare_func(const Context& c, GLenum func) {
    return known_word<CompareFunc>(c, func).has_value();
}
bool is_stencil_op(const Context& c, GLenum op) {
    return known_word<gw::StencilOp>(c, op).has_value();
}
bool is_source_factor(const Context& c, GLenum factor) {
    const auto word = known_word<BlendFactor>(c, factor);
    return word && is_source(*word);
}
bool is_destination_factor(const Context& c, GLenum factor) {
    const auto word = known_word<BlendFactor>(c, factor);
    return word && is_destination(*word);
}

vec4 clamped_value(const vec4& v, float low) {
    return {clamped(v.x, low, 1.0f), clamped(v.y, low, 1.0f), clamped(v.z, low, 1.0f),
            clamped(v.w, low, 1.0f)};
}

}  // namespace

namespace execute {

void fog(Context& c, GLenum pname, const Params& params) {
    FogState& s = c.state.fog;
    switch (pname) {
        case GL_FOG_MODE: {
            const GLenum mode = params.token();
            if (!known_word<FogMode>(c, mode)) return set_error(c, GL_INVALID_ENUM);
            return change(c, s.mode, mode);
        }
        case GL_FOG_DENSITY:
            if (!(params[0] >= 0)) return set_error(c, GL_INVALID_VALUE);
            return change(c, s.density, float(params[0]));
        case GL_FOG_START: return change(c, s.start, float(params[0]));
        case GL_FOG_END: return change(c, s.end, float(params[0]));
        case GL_FOG_INDEX: return change(c, s.index, float(params[0]));
        case GL_FOG_COLOR:
            if (params.count < 4) return set_error(c, GL_INVALID_ENUM);
            return change(c, s.color, params.as_vec4());
    }
    set_error(c, GL_INVALID_ENUM);
}

void scissor(Context& c, GLint x, GLint y, GLsizei width, GLsizei height) {
    if (width < 0 || height < 0) return set_error(c, GL_INVALID_VALUE);
    change(c, c.state.scissor.box, Rect{x, y, width, height});
}

void alpha_func(Context& c, GLenum func, GLclampf ref) {
    if (!is_compare_func(c, func)) return set_error(c, GL_INVALID_ENUM);
    change(c, c.state.color_buffer.alpha_func, func);
    change(c, c.state.color_buffer.alpha_ref, clamped(ref, 0.0f, 1.0f));
}

void stencil_func(Context& c, GLenum func, GLint ref, GLuint mask) {
    if (!is_compare_func(c, func)) return set_error(c, GL_INVALID_ENUM);
    change(c, c.state.stencil.func, func);
    change(c, c.state.stencil.ref, std::clamp(ref, 0, (1 << c.profile.stencil_bits) - 1));
    change(c, c.state.stencil.mask, mask);
}

void stencil_op(Context& c, GLenum fail, GLenum zfail, GLenum zpass) {
    if (!is_stencil_op(c, fail) || !is_stencil_op(c, zfail) || !is_stencil_op(c, zpass))
        return set_error(c, GL_INVALID_ENUM);
    change(c, c.state.stencil.fail, fail);
    change(c, c.state.stencil.zfail, zfail);
    change(c, c.state.stencil.zpass, zpass);
}

void depth_func(Context& c, GLenum func) {
    if (!is_compare_func(c, func)) return set_error(c, GL_INVALID_ENUM);
    change(c, c.state.depth.func, func);
}

void blend_func(Context& c, GLenum sfactor, GLenum dfactor) {
    if (!is_source_factor(c, sfactor) || !is_destination_factor(c, dfactor))
        return set_error(c, GL_INVALID_ENUM);
    change(c, c.state.color_buffer.blend_src, sfactor);
    change(c, c.state.color_buffer.blend_dst, dfactor);
}

void blend_color(Context& c, GLclampf red, GLclampf green, GLclampf blue, GLclampf alpha) {
    if (!c.profile.extensions.blend_color) return set_error(c, GL_INVALID_OPERATION);
    change(c, c.state.color_buffer.blend_color, clamped_value({red, green, blue, alpha}, 0));
}

void blend_equation(Context& c, GLenum mode) {
    if (!known_word<gw::BlendEquation>(c, mode)) return set_error(c, GL_INVALID_ENUM);
    change(c, c.state.color_buffer.blend_equation, mode);
}

void logic_op(Context& c, GLenum opcode) {
    if (opcode < GL_CLEAR || opcode > GL_SET) return set_error(c, GL_INVALID_ENUM);
    change(c, c.state.color_buffer.logic_op_mode, opcode);
}

void index_mask(Context& c, GLuint mask) { c.state.color_buffer.index_mask = mask; }

void color_mask(Context& c, GLboolean red, GLboolean green, GLboolean blue, GLboolean alpha) {
    const std::array mask{red != GL_FALSE, green != GL_FALSE, blue != GL_FALSE, alpha != GL_FALSE};
    change(c, c.state.color_buffer.mask, mask);
}

void depth_mask(Context& c, GLboolean flag) { change(c, c.state.depth.mask, flag != GL_FALSE); }
void stencil_mask(Context& c, GLuint mask) { change(c, c.state.stencil.write_mask, mask); }

void clear_color(Context& c, GLclampf red, GLclampf green, GLclampf blue, GLclampf alpha) {
    c.state.color_buffer.clear = clamped_value({red, green, blue, alpha}, 0);
}
void clear_index(Context& c, GLfloat value) { c.state.color_buffer.clear_index = value; }
void clear_depth(Context& c, GLclampd depth) { c.state.depth.clear = clamped(depth, 0.0, 1.0); }
void clear_stencil(Context& c, GLint s) {
    c.state.stencil.clear = s & ((1 << c.profile.stencil_bits) - 1);
}
void clear_accum(Context& c, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha) {
    c.state.accum.clear = clamped_value({red, green, blue, alpha}, -1);
}

}  // namespace execute

}  // namespace gw::gl
