// One function per group of the state.
#include "inspect/peer/commands.h"

#include "gw/error.h"
#include "gw/stages/resolve.h"
#include "inspect/peer/gl.h"

#include <fmt/format.h>

namespace gw::peer {
namespace {

void apply(const ViewportState& viewport, const DepthRangeState& range, int width, int height) {
    const bool whole = viewport.width == 0 && viewport.height == 0;
    if (whole)
        gl().Viewport(0, 0, width, height);
    else
        gl().Viewport(viewport.x, viewport.y, viewport.width, viewport.height);
    gl().DepthRange(range.near_value, range.far_value);
}

/// Planes are given in eye space.
void apply(const std::array<ClipPlane, max_clip_planes>& planes) {
    gl().MatrixMode(GL_MODELVIEW);
    gl().LoadIdentity();
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const GLenum name = GL_CLIP_PLANE0 + static_cast<GLenum>(i);
        gl().ClipPlane(name, &planes[i].plane[0]);
        enable(name, planes[i].enable);
    }
}

void apply(const ClipControlState& control) {
    if (gl().ClipControl)
        gl().ClipControl(token(control.origin), token(control.depth));
    else if (control != ClipControlState{})
        refuse("GL_ARB_clip_control", "clip_control");
}

void apply(const CullState& cull) {
    enable(GL_CULL_FACE, cull.enable);
    gl().CullFace(token(cull.face));
    gl().FrontFace(token(cull.front));
}

void require_size(GLenum range, float size, const char* what) {
    GLint limits[2] = {1, 1};
    gl().GetIntegerv(range, limits);
    if (size > float(limits[1]))
        throw Error(fmt::format("{} = {}; expected at most {}, OpenGL's limit here", what, size,
                                limits[1]));
}

void apply(const LineStippleState& stipple) {
    enable(GL_LINE_STIPPLE, stipple.enable);
    gl().LineStipple(stipple.factor, stipple.pattern);
}

/// Rows of four bytes, the leftmost pixel in the highest bit of the first.
void apply(const PolygonStippleState& stipple) {
    enable(GL_POLYGON_STIPPLE, stipple.pattern != nullptr);
    if (!stipple.pattern) return;
    std::array<GLubyte, 128> bytes;
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = GLubyte((*stipple.pattern)[i / 4] >> (24 - 8 * (i % 4)));
    gl().PolygonStipple(bytes.data());
}

void apply(const PointParameters& p) {
    if (!gl().PointParameterfv) {
        if (p != PointParameters{}) refuse("OpenGL 1.4", "point_parameters");
        return;
    }
    const GLfloat attenuation[] = {p.constant, p.linear, p.quadratic};
    gl().PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
    gl().PointParameterfv(GL_POINT_SIZE_MIN, &p.min_size);
    gl().PointParameterfv(GL_POINT_SIZE_MAX, &p.max_size);
}

void apply_sprites(const State& s) {
    if (gl().offers(20, "GL_ARB_point_sprite"))
        enable(GL_POINT_SPRITE, s.point_sprite);
    else if (s.point_sprite)
        refuse("GL_ARB_point_sprite", "point_sprite");
}

void apply(const MultisampleState& s) {
    if (!gl().SampleCoverage) return;
    enable(GL_MULTISAMPLE, s.enable);
    enable(GL_SAMPLE_ALPHA_TO_COVERAGE, s.alpha_to_coverage);
    enable(GL_SAMPLE_ALPHA_TO_ONE, s.alpha_to_one);
    enable(GL_SAMPLE_COVERAGE, s.coverage_test);
    gl().SampleCoverage(s.coverage, s.invert);
}

void apply_primitives(const State& s) {
    // OpenGL 1.1 tells the ranges of smooth ones only.
    const bool has_aliased = gl().version >= 12;
    require_size(
        s.point_smooth || !has_aliased ? GL_SMOOTH_POINT_SIZE_RANGE : GL_ALIASED_POINT_SIZE_RANGE,
        s.point_size, "point_size");
    require_size(
        s.line_smooth || !has_aliased ? GL_SMOOTH_LINE_WIDTH_RANGE : GL_ALIASED_LINE_WIDTH_RANGE,
        s.line_width, "line_width");
    gl().PointSize(s.point_size);
    gl().LineWidth(s.line_width);
    apply(s.point_parameters);
    apply_sprites(s);
    enable(GL_POINT_SMOOTH, s.point_smooth);
    enable(GL_LINE_SMOOTH, s.line_smooth);
    enable(GL_POLYGON_SMOOTH, s.polygon_smooth);
    gl().PolygonMode(GL_FRONT, token(mode_of(s, true)));
    gl().PolygonMode(GL_BACK, token(mode_of(s, false)));
    apply(s.line_stipple);
    apply(s.polygon_stipple);
    gl().PolygonOffset(s.polygon_offset.factor, s.polygon_offset.units);
    enable(GL_POLYGON_OFFSET_FILL, s.polygon_offset.enable);
    enable(GL_POLYGON_OFFSET_LINE, s.polygon_offset.lines);
    enable(GL_POLYGON_OFFSET_POINT, s.polygon_offset.points);
    const bool flat = s.shade_model == ShadeModel::Flat || s.color_source == ColorSource::PolygonId;
    gl().ShadeModel(flat ? GL_FLAT : GL_SMOOTH);
}

void apply(const StencilState& s) {
    enable(GL_STENCIL_TEST, s.test);
    gl().StencilFunc(token(s.func), s.ref, s.mask);
    gl().StencilOp(token(s.fail), token(s.zfail), token(s.zpass));
    gl().StencilMask(s.write_mask);
    if (!s.two_side) return;
    constexpr const char* feature = "stencil.two_side";
    required(gl().StencilFuncSeparate, "glStencilFuncSeparate", feature)(
        GL_BACK, token(s.back.func), s.back.ref, s.back.mask);
    required(gl().StencilOpSeparate, "glStencilOpSeparate", feature)(
        GL_BACK, token(s.back.fail), token(s.back.zfail), token(s.back.zpass));
    required(gl().StencilMaskSeparate, "glStencilMaskSeparate", feature)(GL_BACK,
                                                                         s.back.write_mask);
}

bool is_constant(BlendFactor f) { return f >= BlendFactor::ConstantColor; }

void apply_separate(const BlendState& s) {
    required(gl().BlendFuncSeparate, "glBlendFuncSeparate", "blend.alpha")(
        token(s.src), token(s.dst), token(s.alpha.src), token(s.alpha.dst));
    required(gl().BlendEquationSeparate, "glBlendEquationSeparate", "blend.alpha.equation")(
        token(s.equation), token(s.alpha.equation));
}

void apply(const BlendState& s) {
    enable(GL_BLEND, s.enable);
    if (is_constant(s.src) || is_constant(s.dst) || is_constant(s.alpha.src) ||
        is_constant(s.alpha.dst))
        required(gl().BlendColor, "GL_EXT_blend_color", "blend.color")(s.color.x, s.color.y,
                                                                       s.color.z, s.color.w);
    if (s.alpha.separate) return apply_separate(s);
    gl().BlendFunc(token(s.src), token(s.dst));
    if (gl().BlendEquation)
        gl().BlendEquation(token(s.equation));
    else if (s.equation != BlendEquation::Add)
        refuse("GL_EXT_blend_minmax", "blend.equation");
}

/// The player chooses which colour plane the buffer stands for.
void apply_fragments(const State& s, GLenum color_buffer) {
    gl().DrawBuffer(s.draw_buffer == DrawBuffer::None ? GL_NONE : color_buffer);
    enable(GL_SCISSOR_TEST, s.scissor.test);
    gl().Scissor(s.scissor.box.x, s.scissor.box.y, s.scissor.box.width, s.scissor.box.height);
    enable(GL_ALPHA_TEST, s.alpha.test);
    gl().AlphaFunc(token(s.alpha.func), s.alpha.ref);
    enable(GL_DEPTH_TEST, s.depth.test);
    gl().DepthFunc(token(s.depth.func));
    gl().DepthMask(s.depth.mask);
    apply(s.blend);
    enable(GL_COLOR_LOGIC_OP, s.logic_op.enable);
    gl().LogicOp(token(s.logic_op.op));
    if (s.color_mask_bits != ColorMaskBits{}) refuse("write masks by bit", "color_mask_bits");
    gl().ColorMask(s.color_mask.r, s.color_mask.g, s.color_mask.b, s.color_mask.a);
}

}  // namespace

void apply(const State& state, int width, int height, GLenum color_buffer) {
    apply(state.viewport, state.depth_range, width, height);
    apply(state.clip_control);
    apply(state.clip_planes);
    apply(state.cull);
    apply_primitives(state);
    apply(state.stencil);
    apply_fragments(state, color_buffer);
    apply(state.multisample);
}

}  // namespace gw::peer
