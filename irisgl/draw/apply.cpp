#include "irisgl/draw/apply.h"

#include "gl/draw/submit.h"
#include "irisgl/draw/primitives.h"
#include "irisgl/state/program.h"
#include "irisgl/window/window.h"

#include <GL/gl.h>

#include <algorithm>
#include <array>

namespace gw::irisgl {

namespace {

void set(GLenum capability, bool on) { (on ? glEnable : glDisable)(capability); }

/// A pattern as OpenGL's stipple, bottom row first: its 32 x 32 bits from (left, bottom).
std::array<GLubyte, 128> stipple_of(const Pattern& pattern, int left = 0, int bottom = 0) {
    std::array<GLubyte, 128> out{};
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x)
            if (pattern.bit(left + x, bottom + y))
                out[std::size_t(y * 4 + x / 8)] |= GLubyte(0x80 >> x % 8);
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

const Pattern* pattern_now() {
    const auto found = program().patterns.find(state().now.pattern);
    return state().now.pattern != 0 && found != program().patterns.end() ? &found->second : nullptr;
}

void apply_pattern() {
    const Pattern* const pattern = pattern_now();
    set(GL_POLYGON_STIPPLE, pattern != nullptr);
    if (pattern != nullptr) glPolygonStipple(stipple_of(*pattern).data());
}

// The machine's patterns have 32 x 32 bits: of 64 x 64, each square of 32 x 32 pixels has its quarter.
void draw_in_pattern(const Bounds& pixels, const std::function<void()>& draw) {
    const Pattern* const pattern = pattern_now();
    if (pattern == nullptr || pattern->size != PATTERN_64) return draw();
    const Bounds& m = state().screen_mask;
    const Window& w = current_window();
    const Bounds in{
        std::max({pixels.left, m.left, 0}), std::min({pixels.right, m.right, w.width() - 1}),
        std::max({pixels.bottom, m.bottom, 0}), std::min({pixels.top, m.top, w.height() - 1})};
    for (int y = in.bottom & ~31; y <= in.top; y += 32)
        for (int x = in.left & ~31; x <= in.right; x += 32) {
            const int left = std::max(x, in.left), bottom = std::max(y, in.bottom);
            glScissor(left, bottom, std::min(x + 31, in.right) - left + 1,
                      std::min(y + 31, in.top) - bottom + 1);
            glPolygonStipple(stipple_of(*pattern, x & 63, y & 63).data());
            draw();
        }
    glScissor(m.left, m.bottom, std::max(m.width(), 0), std::max(m.height(), 0));
}

void apply_polygons() {
    const State& s = state();
    set(GL_CULL_FACE, s.backface || s.frontface);
    glCullFace(s.backface && s.frontface ? GL_FRONT_AND_BACK : s.frontface ? GL_FRONT : GL_BACK);
    const long mode = s.polygon_mode;
    glPolygonMode(GL_FRONT_AND_BACK, mode == PYM_POINT                           ? GL_POINT
                                     : mode == PYM_LINE || mode == PYM_LINE_FAST ? GL_LINE
                                                                                 : GL_FILL);
    glShadeModel(s.now.shade_model == FLAT ? GL_FLAT : GL_SMOOTH);
}

namespace {

constexpr GLenum stencil_ops[] = {GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT};

}  // namespace

void apply_depth() {
    const State& s = state();
    const bool tests = s.depth_test && !s.compares_color && s.draw_mode == NORMALDRAW;
    set(GL_DEPTH_TEST, tests);
    // Without the Z-buffer, pass is what happens if the stencil's test passes.
    const auto operation = [&](std::size_t i) {
        return stencil_ops[std::size_t(s.stencil_operations[i])];
    };
    glStencilOp(operation(0), operation(1), operation(tests ? 2 : 1));
    glDepthFunc(GL_NEVER + GLenum(s.depth_function));
    glDepthMask(s.depth_write ? GL_TRUE : GL_FALSE);
    glDepthRange(depth_of_range(s.near), depth_of_range(s.far));
}

namespace {

constexpr GLenum source_factors[] = {GL_ZERO,
                                     GL_ONE,
                                     GL_DST_COLOR,
                                     GL_ONE_MINUS_DST_COLOR,
                                     GL_SRC_ALPHA,
                                     GL_ONE_MINUS_SRC_ALPHA,
                                     GL_DST_ALPHA,
                                     GL_ONE_MINUS_DST_ALPHA,
                                     GL_SRC_ALPHA_SATURATE,
                                     GL_CONSTANT_ALPHA,
                                     GL_ONE_MINUS_CONSTANT_ALPHA,
                                     GL_CONSTANT_COLOR,
                                     GL_ONE_MINUS_CONSTANT_COLOR};
constexpr GLenum destination_factors[] = {GL_ZERO,
                                          GL_ONE,
                                          GL_SRC_COLOR,
                                          GL_ONE_MINUS_SRC_COLOR,
                                          GL_SRC_ALPHA,
                                          GL_ONE_MINUS_SRC_ALPHA,
                                          GL_DST_ALPHA,
                                          GL_ONE_MINUS_DST_ALPHA,
                                          GL_ZERO,
                                          GL_CONSTANT_ALPHA,
                                          GL_ONE_MINUS_CONSTANT_ALPHA,
                                          GL_CONSTANT_COLOR,
                                          GL_ONE_MINUS_CONSTANT_COLOR};

/// zsource(ZSRC_COLOR): the lesser or greater colour stays. 0: colours are not compared.
GLenum color_comparison() {
    const State& s = state();
    if (!s.compares_color || !s.depth_test || s.draw_mode != NORMALDRAW) return 0;
    if (s.depth_function == ZF_LESS || s.depth_function == ZF_LEQUAL) return GL_MIN;
    if (s.depth_function == ZF_GREATER || s.depth_function == ZF_GEQUAL) return GL_MAX;
    if (s.depth_function != ZF_ALWAYS)
        warn("zsource: colours are compared by ZF_LESS, LEQUAL, GREATER, GEQUAL; all are drawn");
    return 0;
}

}  // namespace

void apply_blending() {
    const State& s = state();
    const long source = s.blend_source, destination = s.blend_destination;
    GLenum equation = color_comparison();
    if (equation == 0)
        equation = source == BF_MIN ? GL_MIN : source == BF_MAX ? GL_MAX : GL_FUNC_ADD;
    const bool adds = equation == GL_FUNC_ADD;
    set(GL_BLEND, !adds || source != BF_ONE || destination != BF_ZERO);
    glBlendEquation(equation);
    glBlendFunc(adds ? source_factors[source] : GL_ONE,
                adds ? destination_factors[destination] : GL_ONE);
}

void apply_buffers() {
    const State& s = state();
    if (s.draw_mode != NORMALDRAW || !s.double_buffered) return glDrawBuffer(GL_FRONT);
    const bool front = s.now.front, back = s.now.back;
    glDrawBuffer(front && back ? GL_FRONT_AND_BACK : front ? GL_FRONT : back ? GL_BACK : GL_NONE);
}

namespace {

/// A mask of 8 bits as one of planes of `bits`: as a colour of 8 bits becomes one of theirs.
std::uint16_t widened(unsigned mask, int bits) {
    return std::uint16_t(mask << (bits - 8) | mask >> (16 - bits));
}

void set_mask_bits(const std::array<std::uint16_t, 4>& bits) {
    gl::Context& context = current_window().context;
    gl::change(context, context.state.color_buffer.mask_bits, bits);
}

void write_bits_of_index(unsigned mask) {
    const IndexColor code{std::min(current_window().profile().color_bits, 8)};
    const unsigned low = code.low(mask), high = code.high(mask);
    glColorMask(low != 0, high != 0, GL_FALSE, GL_FALSE);
    const auto part = [](unsigned bits, unsigned all) {
        return std::uint16_t(bits == all ? 0xFFFF : bits);
    };
    set_mask_bits(
        {part(low, code.low(index_mask)), part(high, code.high(index_mask)), 0xFFFF, 0xFFFF});
}

void write_bits_of_colors(std::uint32_t mask) {
    const int bits = current_window().profile().color_bits;
    const auto of = [&](int channel) { return mask >> 8 * channel & 0xFF; };
    const auto part = [&](int channel) {
        return of(channel) == 0xFF ? std::uint16_t(0xFFFF) : widened(of(channel), bits);
    };
    glColorMask(of(0) != 0, of(1) != 0, of(2) != 0, of(3) != 0);
    set_mask_bits({part(0), part(1), part(2), part(3)});
}

}  // namespace

void apply_color_mask() {
    const PlaneState& p = planes_now();
    draws_indices() ? write_bits_of_index(p.writemask & index_mask)
                    : write_bits_of_colors(p.rgb_mask);
}

void write_all_bits() {
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    set_mask_bits({0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF});
}

void apply_draw_mode() {
    apply_buffers();
    apply_depth();
    apply_blending();
    apply_color_mask();
}

void reset_all() {
    for (const GLenum off :
         {GL_ALPHA_TEST, GL_STENCIL_TEST, GL_FOG, GL_TEXTURE_2D, GL_COLOR_LOGIC_OP, GL_LIGHTING,
          GL_COLOR_MATERIAL, GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R, GL_TEXTURE_GEN_Q,
          GL_POLYGON_OFFSET_FILL})
        glDisable(off);
    for (int i = 0; i < 6; ++i) glDisable(GL_CLIP_PLANE0 + GLenum(i));
    for (int i = 0; i < light_count; ++i) glDisable(GL_LIGHT0 + GLenum(i));
    glStencilMask(0xFF);
    apply_all();
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
