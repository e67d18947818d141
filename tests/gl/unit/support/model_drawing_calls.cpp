#include "tests/gl/unit/support/model_calls.h"

#include <algorithm>

namespace gw::gl::model {

namespace {

bool is_in(GLenum name, std::initializer_list<GLenum> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}
double clamped_unit(double v) { return std::clamp(v, 0.0, 1.0); }

/// A function of one enumeration that sets one variable.
struct Chooser {
    void (*gl)(GLenum);
    GLenum variable;
    std::vector<GLenum> names;
};
const std::vector<Chooser>& choosers() {
    static const std::vector<Chooser> all{
        {glFrontFace, GL_FRONT_FACE, {GL_CW, GL_CCW}},
        {glCullFace, GL_CULL_FACE_MODE, {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}},
        {glShadeModel, GL_SHADE_MODEL, {GL_FLAT, GL_SMOOTH}},
        {glDepthFunc, GL_DEPTH_FUNC, {GL_NEVER, GL_LESS, GL_GEQUAL, GL_ALWAYS}},
        {glLogicOp, GL_LOGIC_OP_MODE, {GL_CLEAR, GL_XOR, GL_EQUIV, GL_SET}},
        {glMatrixMode, GL_MATRIX_MODE, {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE}}};
    return all;
}

Pair choose(Dice& dice) {
    const Chooser& c = choosers()[std::size_t(dice.below(int(choosers().size())))];
    const bool wrong = dice.chance(15);
    const GLenum name = wrong ? 0x1234 : c.names[std::size_t(dice.below(int(c.names.size())))];
    return {{Place::Outside,
             [&c, name, wrong](Model& m) { m.set(c.variable, {double(name)}, !wrong); }},
            [&c, name] { c.gl(name); }};
}

Pair switch_capability(Dice& dice) {
    static const std::vector<GLenum> names = [] {
        std::vector<GLenum> out{GL_FOG_MODE, 0x1234};
        for (const auto& [name, value] : Model().values)
            if (model::is_capability(name)) out.push_back(name);
        return out;
    }();
    const GLenum name = names[std::size_t(dice.below(int(names.size())))];
    const bool on = dice.chance(50);
    return {{Place::Outside,
             [=](Model& m) { m.set(name, {on ? 1.0 : 0.0}, model::is_capability(name)); }},
            [=] { on ? glEnable(name) : glDisable(name); }};
}

Pair current_value(Dice& dice) {
    const double a = dice.real(), b = dice.real(), c = dice.real(), d = dice.real();
    const auto f = [](double v) { return GLfloat(v); };
    switch (dice.below(6)) {
        case 0:
            return {{Place::Anywhere,
                     [=](Model& m) {
                         m.set(GL_CURRENT_COLOR, {a, b, c, d});
                     }},
                    [=] { glColor4d(a, b, c, d); }};
        case 1:
            return {{Place::Anywhere,
                     [=](Model& m) {
                         m.set(GL_CURRENT_COLOR, {a, b, c, 1});
                     }},
                    [=] { glColor3f(f(a), f(b), f(c)); }};
        case 2:
            return {{Place::Anywhere,
                     [=](Model& m) {
                         m.set(GL_CURRENT_NORMAL, {a, b, c});
                     }},
                    [=] { glNormal3d(a, b, c); }};
        case 3:
            return {{Place::Anywhere,
                     [=](Model& m) {
                         m.set(GL_CURRENT_TEXTURE_COORDS, {a, b, 0, 1});
                     }},
                    [=] { glTexCoord2f(f(a), f(b)); }};
        case 4:
            return {{Place::Anywhere, [=](Model& m) { m.set(GL_CURRENT_INDEX, {a}); }},
                    [=] { glIndexd(a); }};
    }
    return {{Place::Anywhere, [=](Model& m) { m.set(GL_EDGE_FLAG, {a > 0 ? 1.0 : 0.0}); }},
            [=] { glEdgeFlag(a > 0 ? GL_TRUE : GL_FALSE); }};
}

Pair size(Dice& dice) {
    const double v = dice.real(), w = dice.real();
    const int factor = dice.below(400) - 20;
    const auto pattern = GLushort(dice.bits());
    switch (dice.below(4)) {
        case 0:
            return {{Place::Outside,
                     [=](Model& m) { m.set(GL_POINT_SIZE, {v}, v > 0, GL_INVALID_VALUE); }},
                    [=] { glPointSize(GLfloat(v)); }};
        case 1:
            return {{Place::Outside,
                     [=](Model& m) { m.set(GL_LINE_WIDTH, {v}, v > 0, GL_INVALID_VALUE); }},
                    [=] { glLineWidth(GLfloat(v)); }};
        case 2:
            return {{Place::Outside,
                     [=](Model& m) {
                         m.set(GL_LINE_STIPPLE_REPEAT, {double(std::clamp(factor, 1, 256))});
                         m.set(GL_LINE_STIPPLE_PATTERN, {double(pattern)});
                     }},
                    [=] { glLineStipple(factor, pattern); }};
    }
    return {{Place::Outside,
             [=](Model& m) {
                 m.set(GL_POLYGON_OFFSET_FACTOR, {v});
                 m.set(GL_POLYGON_OFFSET_UNITS, {w});
             }},
            [=] { glPolygonOffset(GLfloat(v), GLfloat(w)); }};
}

Pair polygon_mode(Dice& dice) {
    const GLenum face = dice.among({GL_FRONT, GL_BACK, GL_FRONT_AND_BACK});
    const GLenum mode = dice.among({GL_POINT, GL_LINE, GL_FILL});
    return {{Place::Outside,
             [=](Model& m) {
                 if (face == 0x1234 || mode == 0x1234) return m.fail(GL_INVALID_ENUM);
                 if (face != GL_BACK) m.values[GL_POLYGON_MODE][0] = mode;
                 if (face != GL_FRONT) m.values[GL_POLYGON_MODE][1] = mode;
             }},
            [=] { glPolygonMode(face, mode); }};
}

Pair fragment_test(Dice& dice) {
    const GLenum func = dice.among({GL_NEVER, GL_EQUAL, GL_LEQUAL, GL_NOTEQUAL});
    const GLenum op = dice.among({GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT});
    const GLenum op2 = dice.among({GL_KEEP, GL_INVERT});
    const GLenum source = dice.among({GL_ONE, GL_DST_COLOR, GL_SRC_ALPHA_SATURATE, GL_SRC_COLOR});
    const GLenum target = dice.among({GL_ZERO, GL_SRC_COLOR, GL_DST_ALPHA, GL_DST_COLOR});
    const int ref = dice.below(300) - 20;
    const double v = dice.real();
    switch (dice.below(4)) {
        case 0:
            return {{Place::Outside,
                     [=](Model& m) {
                         if (func == 0x1234) return m.fail(GL_INVALID_ENUM);
                         m.set(GL_ALPHA_TEST_FUNC, {double(func)});
                         m.set(GL_ALPHA_TEST_REF, {clamped_unit(v)});
                     }},
                    [=] { glAlphaFunc(func, GLclampf(v)); }};
        case 1:
            return {{Place::Outside,
                     [=](Model& m) {
                         if (func == 0x1234) return m.fail(GL_INVALID_ENUM);
                         m.set(GL_STENCIL_FUNC, {double(func)});
                         m.set(GL_STENCIL_REF, {double(std::clamp(ref, 0, 255))});
                     }},
                    [=] { glStencilFunc(func, ref, 255); }};
        case 2:
            return {{Place::Outside,
                     [=](Model& m) {
                         if (op == 0x1234 || op2 == 0x1234) return m.fail(GL_INVALID_ENUM);
                         m.set(GL_STENCIL_FAIL, {double(op)});
                         m.set(GL_STENCIL_PASS_DEPTH_FAIL, {double(op2)});
                         m.set(GL_STENCIL_PASS_DEPTH_PASS, {double(op)});
                     }},
                    [=] { glStencilOp(op, op2, op); }};
    }
    return {{Place::Outside,
             [=](Model& m) {
                 // [GL14] tables 4.1 and 4.2
                 if (!is_in(source, {GL_ONE, GL_DST_COLOR, GL_SRC_ALPHA_SATURATE, GL_SRC_COLOR}) ||
                     !is_in(target, {GL_ZERO, GL_SRC_COLOR, GL_DST_ALPHA, GL_DST_COLOR}))
                     return m.fail(GL_INVALID_ENUM);
                 m.set(GL_BLEND_SRC, {double(source)});
                 m.set(GL_BLEND_DST, {double(target)});
             }},
            [=] { glBlendFunc(source, target); }};
}

Pair clear_value(Dice& dice) {
    const double v = dice.real(), w = dice.real();
    const int s = dice.below(2000) - 500;
    const double u = clamped_unit(v), a = std::clamp(v, -1.0, 1.0);
    switch (dice.below(7)) {
        case 0:
            return {{Place::Outside,
                     [=](Model& m) {
                         m.set(GL_COLOR_CLEAR_VALUE, {u, u, 0.5, clamped_unit(w)});
                     }},
                    [=] { glClearColor(GLclampf(v), GLclampf(v), 0.5f, GLclampf(w)); }};
        case 1:
            return {{Place::Outside,
                     [=](Model& m) {
                         m.set(GL_ACCUM_CLEAR_VALUE, {a, 0, a, 1});
                     }},
                    [=] { glClearAccum(GLfloat(v), 0, GLfloat(v), 9); }};
        case 2:
            return {{Place::Outside, [=](Model& m) { m.set(GL_DEPTH_CLEAR_VALUE, {u}); }},
                    [=] { glClearDepth(v); }};
        case 3:
            return {{Place::Outside,
                     [=](Model& m) { m.set(GL_STENCIL_CLEAR_VALUE, {double(s & 255)}); }},
                    [=] { glClearStencil(s); }};
        case 4:
            return {{Place::Outside, [=](Model& m) { m.set(GL_INDEX_CLEAR_VALUE, {v}); }},
                    [=] { glClearIndex(GLfloat(v)); }};
        case 5:
            return {{Place::Outside,
                     [=](Model& m) {
                         const double on = v > 0 ? 1 : 0;
                         m.set(GL_COLOR_WRITEMASK, {on, 1, 0, on});
                         m.set(GL_DEPTH_WRITEMASK, m.values[GL_DEPTH_WRITEMASK]);
                     }},
                    [=] { glColorMask(v > 0, 2, 0, v > 0); }};
    }
    return {{Place::Outside, [=](Model& m) { m.set(GL_DEPTH_WRITEMASK, {v > 0 ? 1.0 : 0.0}); }},
            [=] { glDepthMask(v > 0); }};
}

Pair window_place(Dice& dice) {
    const int x = dice.below(40) - 20, y = dice.below(40), width = dice.below(40) - 4;
    const double v = dice.real(), w = dice.real();
    const Row box{double(x), double(y), double(width), 9};
    switch (dice.below(3)) {
        case 0:
            return {{Place::Outside,
                     [=](Model& m) { m.set(GL_VIEWPORT, box, width >= 0, GL_INVALID_VALUE); }},
                    [=] { glViewport(x, y, width, 9); }};
        case 1:
            return {{Place::Outside,
                     [=](Model& m) { m.set(GL_SCISSOR_BOX, box, width >= 0, GL_INVALID_VALUE); }},
                    [=] { glScissor(x, y, width, 9); }};
    }
    return {{Place::Outside,
             [=](Model& m) {
                 m.set(GL_DEPTH_RANGE, {clamped_unit(v), clamped_unit(w)});
             }},
            [=] { glDepthRange(v, w); }};
}

Pair fog_or_light_model(Dice& dice) {
    const double v = dice.real();
    const GLenum mode = dice.among({GL_LINEAR, GL_EXP, GL_EXP2});
    const bool right = mode != 0x1234;
    const std::array<GLfloat, 4> color{0.5f, GLfloat(v), 0, 2};
    switch (dice.below(6)) {
        case 0:
            return {{Place::Outside, [=](Model& m) { m.set(GL_FOG_MODE, {double(mode)}, right); }},
                    [=] { glFogi(GL_FOG_MODE, GLint(mode)); }};
        case 1:
            return {{Place::Outside,
                     [=](Model& m) { m.set(GL_FOG_DENSITY, {v}, v >= 0, GL_INVALID_VALUE); }},
                    [=] { glFogf(GL_FOG_DENSITY, GLfloat(v)); }};
        case 2:
            return {{Place::Outside,
                     [=](Model& m) {
                         m.set(GL_FOG_COLOR, {0.5, clamped_unit(v), 0, 1});  // [GL15] 3.10
                     }},
                    [=] { glFogfv(GL_FOG_COLOR, color.data()); }};
        case 3:
            return {{Place::Outside,
                     [=](Model& m) {
                         m.set(GL_LIGHT_MODEL_AMBIENT, {0.5, v, 0, 2});
                     }},
                    [=] { glLightModelfv(GL_LIGHT_MODEL_AMBIENT, color.data()); }};
        case 4:
            return {{Place::Outside,
                     [=](Model& m) { m.set(GL_LIGHT_MODEL_TWO_SIDE, {v != 0 ? 1.0 : 0.0}); }},
                    [=] { glLightModelf(GL_LIGHT_MODEL_TWO_SIDE, GLfloat(v)); }};
    }
    const GLenum face = dice.among({GL_FRONT, GL_BACK, GL_FRONT_AND_BACK});
    return {{Place::Outside,
             [=](Model& m) {
                 if (face == 0x1234) return m.fail(GL_INVALID_ENUM);
                 m.set(GL_COLOR_MATERIAL_FACE, {double(face)});
                 m.set(GL_COLOR_MATERIAL_PARAMETER, {GL_SPECULAR});
             }},
            [=] { glColorMaterial(face, GL_SPECULAR); }};
}

}  // namespace

std::span<const Maker> drawing_calls() {
    static constexpr Maker makers[] = {choose,      switch_capability, current_value,
                                       size,        polygon_mode,      fragment_test,
                                       clear_value, window_place,      fog_or_light_model};
    return makers;
}

}  // namespace gw::gl::model
