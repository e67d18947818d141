#include "irisgl/draw/apply.h"

#include "irisgl/draw/lighting.h"
#include "irisgl/draw/primitives.h"
#include "irisgl/state/program.h"

#include <GL/gl.h>

#include <algorithm>
#include <array>

namespace gw::irisgl {

namespace {

void set(GLenum capability, bool on) { (on ? glEnable : glDisable)(capability); }

/// A pattern of 16 or 32 bits as OpenGL's stipple, bottom row first. One of 64: its lower left corner.
std::array<GLubyte, 128> stipple_of(const Pattern& pattern) {
    std::array<GLubyte, 128> out{};
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x)
            if (pattern.bit(x, y)) out[std::size_t(y * 4 + x / 8)] |= GLubyte(0x80 >> x % 8);
    return out;
}

/// A line style's lowest bit is drawn first, as OpenGL's.
std::uint16_t linestyle_of(short index) {
    const auto found = program().linestyles.find(index);
    return found == program().linestyles.end() ? std::uint16_t(0xFFFF) : found->second;
}

}  // namespace

void apply_viewport() {
    const State& s = state();
    const Bounds &v = s.viewport, &m = s.screen_mask;
    glViewport(v.left, v.bottom, std::max(v.width(), 0), std::max(v.height(), 0));
    glEnable(GL_SCISSOR_TEST);
    glScissor(m.left, m.bottom, std::max(m.width(), 0), std::max(m.height(), 0));
}

void apply_lines() {
    const State& s = state();
    glLineWidth(float(std::max(s.now.line_width, 1.0)));
    glPointSize(float(std::max(s.now.point_size, 1.0)));
    set(GL_LINE_STIPPLE, s.now.linestyle != 0);
    glLineStipple(GLint(std::clamp(s.now.linestyle_repeat, 1L, 255L)),
                  linestyle_of(s.now.linestyle));
    set(GL_LINE_SMOOTH, s.smooth.lines);
    set(GL_POINT_SMOOTH, s.smooth.points);
    set(GL_POLYGON_SMOOTH, s.smooth.polygons);
}

void apply_pattern() {
    const auto found = program().patterns.find(state().now.pattern);
    const bool on = state().now.pattern != 0 && found != program().patterns.end();
    set(GL_POLYGON_STIPPLE, on);
    if (!on) return;
    if (found->second.size == PATTERN_64)
        warn("setpattern: a pattern of 64 x 64 bits; the machine repeats its lower left 32 x 32");
    glPolygonStipple(stipple_of(found->second).data());
}

void apply_polygons() {
    const State& s = state();
    set(GL_CULL_FACE, s.backface || s.frontface);
    glCullFace(s.backface && s.frontface ? GL_FRONT_AND_BACK : s.frontface ? GL_FRONT : GL_BACK);
    const long mode = s.polygon_mode;
    glPolygonMode(GL_FRONT_AND_BACK, mode == PYM_POINT  ? GL_POINT
                                     : mode == PYM_FILL ? GL_FILL
                                                        : GL_LINE);
    glShadeModel(s.now.shade_model == FLAT ? GL_FLAT : GL_SMOOTH);
}

void apply_depth() {
    const State& s = state();
    set(GL_DEPTH_TEST, s.depth_test && s.draw_mode == NORMALDRAW);
    glDepthFunc(GL_NEVER + GLenum(s.depth_function));
    glDepthMask(s.depth_write ? GL_TRUE : GL_FALSE);
    glDepthRange(depth_of(s.near), depth_of(s.far));
}

void apply_buffers() {
    const State& s = state();
    if (s.draw_mode != NORMALDRAW || !s.double_buffered) return glDrawBuffer(GL_FRONT);
    const bool front = s.now.front, back = s.now.back;
    glDrawBuffer(front && back ? GL_FRONT_AND_BACK : front ? GL_FRONT : back ? GL_BACK : GL_NONE);
}

void apply_color_mask() {
    if (draws_indices()) return;  // set by each primitive
    const std::uint32_t mask = planes_now().rgb_mask;
    GLboolean on[4];
    for (int i = 0; i < 4; ++i) on[i] = (mask >> 8 * i & 0xFF) != 0;
    glColorMask(on[0], on[1], on[2], on[3]);
}

void apply_draw_mode() {
    apply_buffers();
    apply_depth();
    apply_color_mask();
}

void apply_all() {
    glDisable(GL_DITHER);
    glEnable(GL_NORMALIZE);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    apply_viewport();
    apply_lines();
    apply_pattern();
    apply_polygons();
    apply_draw_mode();
}

}  // namespace gw::irisgl
