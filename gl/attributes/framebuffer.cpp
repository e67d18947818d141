// Clears, the accumulation buffer, draw and read buffers. [GL11] 4.2
#include "gl/api/calls.h"
#include "gl/api/finite.h"
#include "gl/context/context.h"
#include "gl/draw/finish.h"
#include "gl/draw/submit.h"
#include "gl/draw/targets.h"

namespace gw::gl {

namespace {

PlaneMask planes_of(GLbitfield mask) {
    PlaneMask planes = 0;
    if (mask & GL_COLOR_BUFFER_BIT) planes |= mask_of(Plane::Color);
    if (mask & GL_DEPTH_BUFFER_BIT) planes |= mask_of(Plane::Depth);
    if (mask & GL_STENCIL_BUFFER_BIT) planes |= mask_of(Plane::Stencil);
    if (mask & GL_ACCUM_BUFFER_BIT) planes |= mask_of(Plane::Accum);
    return planes;
}

constexpr GLbitfield all_buffers =
    GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_ACCUM_BUFFER_BIT;

bool is_auxiliary(GLenum mode) { return mode >= GL_AUX0 && mode <= GL_AUX3; }

/// The buffers that a framebuffer object has.
bool is_attached(GLenum mode) { return mode == GL_NONE || mode == GL_COLOR_ATTACHMENT0; }
bool is_attachment(GLenum mode) {
    return mode >= GL_COLOR_ATTACHMENT0 && mode <= GL_COLOR_ATTACHMENT0 + 31;
}

/// Whether drawables have one of the buffers: there are no right and no auxiliary ones. The one buffer
/// of a drawable is its back buffer too: programs of OSMesa, whose Mesa took it so, ask for that one.
bool names_a_buffer(GLenum mode) {
    return !is_auxiliary(mode) && !is_attachment(mode) && mode != GL_RIGHT &&
           mode != GL_FRONT_RIGHT && mode != GL_BACK_RIGHT;
}

}  // namespace

namespace execute {

void sample_coverage(Context& context, GLclampf value, GLboolean invert) {
    change(context, context.state.multisample.coverage_value, clamped(value, 0.0f, 1.0f));
    change(context, context.state.multisample.coverage_invert, invert != GL_FALSE);
}

void clear(Context& context, GLbitfield mask) {
    if (mask & ~all_buffers) return set_error(context, GL_INVALID_VALUE);
    flush_mesh(context);
    if (!can_draw(context)) return;
    const PlaneMask planes = planes_of(mask) & drawn_planes(context);
    if (planes == 0 || context.selection.mode != GL_RENDER) return;
    submit_command(context,
                   gw::Clear{planes, context.state.color_buffer.clear, context.state.depth.clear,
                             context.state.stencil.clear, context.state.accum.clear});
}

void accum(Context& context, GLenum op, GLfloat value) {
    if (op < GL_ACCUM || op > GL_ADD) return set_error(context, GL_INVALID_ENUM);
    flush_mesh(context);
    if (!can_draw(context)) return;
    if (context.framebuffers.draw) return set_error(context, GL_INVALID_OPERATION);
    if (context.selection.mode != GL_RENDER) return;
    constexpr std::array operations{AccumOp::Accum, AccumOp::Load, AccumOp::Return, AccumOp::Mult,
                                    AccumOp::Add};
    submit_command(context, Accumulate{operations[op - GL_ACCUM], float(finite(double(value)))});
}

void draw_buffer(Context& context, GLenum mode) {
    const bool known = mode == GL_NONE || mode == GL_FRONT_AND_BACK || is_auxiliary(mode) ||
                       (mode >= GL_FRONT_LEFT && mode <= GL_RIGHT) ||
                       (is_attachment(mode) && context.profile.extensions.surfaces);
    if (!known) return set_error(context, GL_INVALID_ENUM);
    const bool has = context.framebuffers.draw ? is_attached(mode) : names_a_buffer(mode);
    if (!has) return set_error(context, GL_INVALID_OPERATION);
    if (context.framebuffers.draw) context.framebuffers.draw->draw_buffer = mode;
    change(context, context.state.color_buffer.draw_buffer, mode);
}

void read_buffer(Context& context, GLenum mode) {
    const bool known =
        is_auxiliary(mode) || (mode >= GL_FRONT_LEFT && mode <= GL_RIGHT) ||
        ((mode == GL_NONE || is_attachment(mode)) && context.profile.extensions.surfaces);
    if (!known) return set_error(context, GL_INVALID_ENUM);
    const bool has =
        context.framebuffers.read ? is_attached(mode) : mode == GL_NONE || names_a_buffer(mode);
    if (!has) return set_error(context, GL_INVALID_OPERATION);
    if (context.framebuffers.read) context.framebuffers.read->read_buffer = mode;
    change(context, context.state.pixel.read_buffer, mode);
}

void flush(Context& context) { finish_drawing(context); }
void finish(Context& context) { finish_drawing(context); }

void hint(Context& context, GLenum target, GLenum mode) {
    if (mode != GL_FASTEST && mode != GL_NICEST && mode != GL_DONT_CARE)
        return set_error(context, GL_INVALID_ENUM);
    HintState& s = context.state.hint;
    switch (target) {
        case GL_PERSPECTIVE_CORRECTION_HINT: s.perspective_correction = mode; return;
        case GL_POINT_SMOOTH_HINT: s.point_smooth = mode; return;
        case GL_LINE_SMOOTH_HINT: s.line_smooth = mode; return;
        case GL_POLYGON_SMOOTH_HINT: s.polygon_smooth = mode; return;
        case GL_FOG_HINT: s.fog = mode; return;
        case GL_GENERATE_MIPMAP_HINT: s.generate_mipmap = mode; return;
        case GL_TEXTURE_COMPRESSION_HINT: s.texture_compression = mode; return;
    }
    set_error(context, GL_INVALID_ENUM);
}

}  // namespace execute

}  // namespace gw::gl
