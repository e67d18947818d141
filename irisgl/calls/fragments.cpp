// Blending, alpha test, logical operations, stencil, accumulation, fog, clipping planes.
#include "irisgl/calls/shared.h"
#include "irisgl/draw/apply.h"
#include "irisgl/draw/primitives.h"
#include "irisgl/state/program.h"

#include "generated/irisgl/calls.h"

#include <GL/gl.h>

#include <algorithm>
#include <string>

namespace gw::irisgl::calls {

namespace {

/// False, with a warning, if a word is outside its range.
bool is_word(const char* function, long value, long most) {
    if (value >= 0 && value <= most) return true;
    warn(std::string(function) + ": " + std::to_string(value) + "; expected 0 to " +
         std::to_string(most) + "; it is ignored");
    return false;
}

constexpr GLenum logic_ops[] = {GL_CLEAR,         GL_AND,         GL_AND_REVERSE, GL_COPY,
                                GL_AND_INVERTED,  GL_NOOP,        GL_XOR,         GL_OR,
                                GL_NOR,           GL_EQUIV,       GL_INVERT,      GL_OR_REVERSE,
                                GL_COPY_INVERTED, GL_OR_INVERTED, GL_NAND,        GL_SET};

}  // namespace

void set_dither(long mode) {
    (mode != DT_OFF && state().rgb_mode ? glEnable : glDisable)(GL_DITHER);
}

void blendfunction(long source, long destination) {
    if (!is_word("blendfunction", source, BF_MAX) || !is_word("blendfunction", destination, BF_MCC))
        return;
    if (destination == BF_MIN_SA_MDA)
        return warn("blendfunction: BF_MIN_SA_MDA is a factor of the source; it is ignored");
    state().blend_source = source;
    state().blend_destination = destination;
    glDisable(GL_COLOR_LOGIC_OP);  // the later of the two holds
    apply_blending();
}
void blendcolor(float r, float g, float b, float a) { glBlendColor(r, g, b, a); }

void afunction(long ref, long function) {
    if (!is_word("afunction", function, AF_ALWAYS)) return;
    (function == AF_ALWAYS ? glDisable : glEnable)(GL_ALPHA_TEST);
    glAlphaFunc(GL_NEVER + GLenum(function), float(ref) / 255);
}

void logicop(long op) {
    if (!is_word("logicop", op, LO_ONE)) return;
    if (op != LO_SRC) {
        state().blend_source = BF_ONE;
        state().blend_destination = BF_ZERO;
        apply_blending();
    }
    (op == LO_SRC ? glDisable : glEnable)(GL_COLOR_LOGIC_OP);
    glLogicOp(logic_ops[op]);
}

void acbuf(long op, float value) {
    constexpr GLenum ops[] = {GL_ACCUM, GL_ACCUM, GL_LOAD, GL_RETURN, GL_MULT, GL_ADD};
    if (!is_word("acbuf", op, AC_ADD)) return;
    glReadBuffer(state().double_buffered && state().draw_mode == NORMALDRAW ? GL_BACK : GL_FRONT);
    if (op != AC_CLEAR) return glAccum(ops[op], value);
    glClearAccum(value, value, value, value);
    glClear(GL_ACCUM_BUFFER_BIT);
}
void acsize(long) {}
void stensize(long planes) { is_word("stensize", planes, 8); }

void stencil(long enable, unsigned long ref, long function, unsigned long mask, long fail,
             long pass, long zpass) {
    (enable != 0 ? glEnable : glDisable)(GL_STENCIL_TEST);
    if (enable == 0) return;
    if (!is_word("stencil", function, SF_ALWAYS) || !is_word("stencil", fail, ST_INVERT) ||
        !is_word("stencil", pass, ST_INVERT) || !is_word("stencil", zpass, ST_INVERT))
        return;
    glStencilFunc(GL_NEVER + GLenum(function), GLint(ref), GLuint(mask));
    state().stencil_operations = {fail, pass, zpass};
    apply_depth();
}
void sclear(unsigned long value) {
    glClearStencil(GLint(value & 0xFF));
    glClear(GL_STENCIL_BUFFER_BIT);
}
void swritemask(unsigned long mask) { glStencilMask(GLuint(mask)); }

void fog(long mode, Values params) {
    if (!is_word("fogvertex", mode, FG_PIX_EXP2)) return;
    if (mode == FG_OFF || mode == FG_ON) return (mode == FG_ON ? glEnable : glDisable)(GL_FOG);
    const bool linear = mode == FG_VTX_LIN || mode == FG_PIX_LIN;
    if (params.size() < (linear ? 5u : 4u)) return;
    glFogi(GL_FOG_MODE, linear                                     ? GL_LINEAR
                        : mode == FG_VTX_EXP || mode == FG_PIX_EXP ? GL_EXP
                                                                   : GL_EXP2);
    if (linear) {
        glFogf(GL_FOG_START, params[0]);
        glFogf(GL_FOG_END, params[1]);
    } else {
        glFogf(GL_FOG_DENSITY, std::max(params[0], 0.0f));
    }
    const std::size_t at = linear ? 2 : 1;
    const float color[] = {params[at], params[at + 1], params[at + 2], 1};
    glFogfv(GL_FOG_COLOR, color);
}

void clipplane(long index, long mode, Values params) {
    if (!is_word("clipplane", index, 5) || !is_word("clipplane", mode, CP_DEFINE)) return;
    const GLenum name = GL_CLIP_PLANE0 + GLenum(index);
    if (mode != CP_DEFINE) return (mode == CP_ON ? glEnable : glDisable)(name);
    load_matrices();
    const double equation[] = {double(params[0]), double(params[1]), double(params[2]),
                               double(params[3])};
    glClipPlane(name, equation);
}

}  // namespace gw::irisgl::calls
