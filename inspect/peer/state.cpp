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

void apply(const CullState& cull) {
    enable(GL_CULL_FACE, cull.enable);
    gl().CullFace(token(cull.face));
    gl().FrontFace(cull.front == Winding::CCW ? GL_CCW : GL_CW);
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

void apply_primitives(const State& s) {
    require_size(s.point_smooth ? GL_SMOOTH_POINT_SIZE_RANGE : GL_ALIASED_POINT_SIZE_RANGE,
                 s.point_size, "point_size");
    require_size(s.line_smooth ? GL_SMOOTH_LINE_WIDTH_RANGE : GL_ALIASED_LINE_WIDTH_RANGE,
                 s.line_width, "line_width");
    gl().PointSize(s.point_size);
    gl().LineWidth(s.line_width);
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

void apply_face(GLenum side, const auto& face) {
    gl().StencilFuncSeparate(side, token(face.func), face.ref, face.mask);
    gl().StencilOpSeparate(side, token(face.fail), token(face.zfail), token(face.zpass));
    gl().StencilMaskSeparate(side, face.write_mask);
}

void apply(const StencilState& stencil) {
    enable(GL_STENCIL_TEST, stencil.test);
    apply_face(GL_FRONT_AND_BACK, stencil);
    if (stencil.two_side) apply_face(GL_BACK, stencil.back);
}

/// OSMesa has one colour plane.
void apply(DrawBuffer buffer) {
    if (buffer == DrawBuffer::Back || buffer == DrawBuffer::FrontAndBack)
        throw Error(
            "draw_buffer = Back; expected None or Front: OpenGL's window here has one plane");
    gl().DrawBuffer(buffer == DrawBuffer::None ? GL_NONE : GL_FRONT);
}

void apply_fragments(const State& s) {
    apply(s.draw_buffer);
    enable(GL_SCISSOR_TEST, s.scissor.test);
    gl().Scissor(s.scissor.box.x, s.scissor.box.y, s.scissor.box.width, s.scissor.box.height);
    enable(GL_ALPHA_TEST, s.alpha.test);
    gl().AlphaFunc(token(s.alpha.func), s.alpha.ref);
    enable(GL_DEPTH_TEST, s.depth.test);
    gl().DepthFunc(token(s.depth.func));
    gl().DepthMask(s.depth.mask);
    enable(GL_BLEND, s.blend.enable);
    gl().BlendFunc(token(s.blend.src), token(s.blend.dst));
    gl().BlendEquation(token(s.blend.equation));
    gl().BlendColor(s.blend.color.x, s.blend.color.y, s.blend.color.z, s.blend.color.w);
    enable(GL_COLOR_LOGIC_OP, s.logic_op.enable);
    gl().LogicOp(token(s.logic_op.op));
    gl().ColorMask(s.color_mask.r, s.color_mask.g, s.color_mask.b, s.color_mask.a);
}

}  // namespace

void apply(const State& state, int width, int height) {
    apply(state.viewport, state.depth_range, width, height);
    apply(state.clip_planes);
    apply(state.cull);
    apply_primitives(state);
    apply(state.stencil);
    apply_fragments(state);
}

}  // namespace gw::peer
