// Random changes of GL's state, one at a time: the parts of the machine's state that are made anew
// complete those that are kept, to the state that is made as a whole.
#include "gl/draw/machine_state.h"
#include "gl/draw/submit.h"
#include "tests/gl/unit/support/window.h"

#include <random>

namespace gw::gl {
namespace {

class Dice {
public:
    explicit Dice(unsigned seed) : engine_(seed) {}
    int below(int n) { return int(engine_() % unsigned(n)); }
    bool chance() { return below(2) == 0; }
    float real() { return float(below(9)) / 8; }
    GLenum among(std::initializer_list<GLenum> all) { return all.begin()[below(int(all.size()))]; }

private:
    std::mt19937 engine_;
};

void enable(Dice& d) {
    const GLenum cap = d.among({GL_ALPHA_TEST,
                                GL_BLEND,
                                GL_CLIP_PLANE0,
                                GL_COLOR_LOGIC_OP,
                                GL_COLOR_MATERIAL,
                                GL_COLOR_SUM,
                                GL_CULL_FACE,
                                GL_DEPTH_TEST,
                                GL_FOG,
                                GL_LIGHT0,
                                GL_LIGHT1,
                                GL_LIGHTING,
                                GL_LINE_SMOOTH,
                                GL_LINE_STIPPLE,
                                GL_MULTISAMPLE,
                                GL_NORMALIZE,
                                GL_POINT_SMOOTH,
                                GL_POINT_SPRITE,
                                GL_POLYGON_OFFSET_FILL,
                                GL_POLYGON_SMOOTH,
                                GL_POLYGON_STIPPLE,
                                GL_RESCALE_NORMAL,
                                GL_SAMPLE_COVERAGE,
                                GL_SCISSOR_TEST,
                                GL_STENCIL_TEST,
                                GL_TEXTURE_1D,
                                GL_TEXTURE_2D,
                                GL_TEXTURE_3D,
                                GL_TEXTURE_CUBE_MAP,
                                GL_TEXTURE_GEN_S,
                                GL_TEXTURE_GEN_T,
                                GL_TEXTURE_CUBE_MAP_SEAMLESS,
                                GL_SAMPLE_ALPHA_TO_ONE,
                                GL_SAMPLE_ALPHA_TO_COVERAGE});
    d.chance() ? glEnable(cap) : glDisable(cap);
}

void set_matrix(Dice& d) {
    glMatrixMode(d.among({GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE}));
    switch (d.below(4)) {
        case 0: return glLoadIdentity();
        case 1: return glTranslatef(d.real(), d.real(), d.real());
        case 2: return glPushMatrix();
        default: return glPopMatrix();
    }
}

void set_transform(Dice& d) {
    const double plane[] = {d.real(), d.real(), d.real(), d.real()};
    switch (d.below(4)) {
        case 0: return glViewport(d.below(4), d.below(4), d.below(9), d.below(9));
        case 1: return glDepthRange(d.real(), d.real());
        case 2: return glClipPlane(GL_CLIP_PLANE0, plane);
        default:
            return glClipControl(d.among({GL_LOWER_LEFT, GL_UPPER_LEFT}),
                                 d.among({GL_NEGATIVE_ONE_TO_ONE, GL_ZERO_TO_ONE}));
    }
}

void set_shapes(Dice& d) {
    switch (d.below(9)) {
        case 0: return glPointSize(1 + d.real());
        case 1: return glLineWidth(1 + 4 * d.real());
        case 2: return glLineStipple(1 + d.below(3), GLushort(d.below(65536)));
        case 3:
            return glPolygonMode(d.among({GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}),
                                 d.among({GL_POINT, GL_LINE, GL_FILL}));
        case 4: return glPolygonOffset(d.real(), d.real());
        case 5: return glCullFace(d.among({GL_FRONT, GL_BACK}));
        case 6: return glFrontFace(d.among({GL_CW, GL_CCW}));
        case 7: return glPointParameterf(GL_POINT_SIZE_MAX, 1 + 9 * d.real());
        default: {
            const std::vector<GLubyte> pattern(128, GLubyte(d.below(4)));
            return glPolygonStipple(pattern.data());
        }
    }
}

void set_lights(Dice& d) {
    const float color[] = {d.real(), d.real(), d.real(), d.real()};
    switch (d.below(6)) {
        case 0: return glLightfv(GL_LIGHT0, d.among({GL_AMBIENT, GL_DIFFUSE, GL_POSITION}), color);
        case 1: return glLightf(GL_LIGHT1, GL_SPOT_CUTOFF, 90 * d.real());
        case 2: return glLightModelfv(GL_LIGHT_MODEL_AMBIENT, color);
        case 3:
            return glLightModeli(d.among({GL_LIGHT_MODEL_LOCAL_VIEWER, GL_LIGHT_MODEL_TWO_SIDE}),
                                 d.below(2));
        case 4: return glShadeModel(d.among({GL_FLAT, GL_SMOOTH}));
        default:
            return glColorMaterial(d.among({GL_FRONT, GL_FRONT_AND_BACK}),
                                   d.among({GL_AMBIENT, GL_DIFFUSE}));
    }
}

void set_texture(Dice& d) {
    const float color[] = {d.real(), d.real(), d.real(), d.real()};
    const GLenum target =
        d.among({GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP});
    switch (d.below(10)) {
        case 0: return glActiveTexture(GL_TEXTURE0 + GLenum(d.below(4)));
        case 1: return glBindTexture(target, GLuint(4 * d.below(3)) + (target & 3));
        case 2:
            return glTexParameteri(target, GL_TEXTURE_MIN_FILTER,
                                   GLint(d.among({GL_NEAREST, GL_LINEAR})));
        case 3: return glTexParameterfv(target, GL_TEXTURE_BORDER_COLOR, color);
        case 4:
            return glTexParameteri(target, GL_TEXTURE_WRAP_T,
                                   GLint(d.among({GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE})));
        case 5:
            return glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE,
                             GLint(d.among({GL_MODULATE, GL_DECAL, GL_BLEND, GL_COMBINE})));
        case 6: return glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
        case 7: return glTexGenfv(GL_S, d.among({GL_OBJECT_PLANE, GL_EYE_PLANE}), color);
        case 8: return glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, d.below(2));
        default: return glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, d.real());
    }
}

/// What is bound may become a texture of depths, another size, or nothing.
void set_image(Dice& d) {
    const std::vector<float> texels(64, d.real());
    const int size = 1 << d.below(3);
    const GLenum format = d.among({GL_RGBA, GL_DEPTH_COMPONENT});
    glTexImage2D(GL_TEXTURE_2D, 0, GLint(format), size, size, 0, format, GL_FLOAT, texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE,
                    GLint(d.among({GL_NONE, GL_COMPARE_R_TO_TEXTURE})));
}

void set_fog(Dice& d) {
    const float color[] = {d.real(), d.real(), d.real(), d.real()};
    switch (d.below(4)) {
        case 0: return glFogi(GL_FOG_MODE, GLint(d.among({GL_LINEAR, GL_EXP, GL_EXP2})));
        case 1: return glFogf(d.among({GL_FOG_DENSITY, GL_FOG_START, GL_FOG_END}), d.real());
        case 2: return glFogfv(GL_FOG_COLOR, color);
        default:
            return glFogi(GL_FOG_COORDINATE_SOURCE,
                          GLint(d.among({GL_FOG_COORDINATE, GL_FRAGMENT_DEPTH})));
    }
}

void set_fragments(Dice& d) {
    const GLenum op = d.among({GL_KEEP, GL_INCR}), func = d.among({GL_LESS, GL_ALWAYS, GL_EQUAL}),
                 factor = d.among({GL_ONE, GL_ZERO, GL_SRC_ALPHA});
    switch (d.below(13)) {
        case 0: return glScissor(d.below(4), d.below(4), d.below(9), d.below(9));
        case 1: return glAlphaFunc(func, d.real());
        case 2: return glStencilFunc(func, d.below(4), GLuint(d.below(4)));
        case 3: return glStencilOp(op, GL_KEEP, op);
        case 4: return glStencilMask(GLuint(d.below(4)));
        case 5: return glDepthFunc(func);
        case 6: return glDepthMask(GLboolean(d.below(2)));
        case 7: return glBlendFuncSeparate(factor, GL_ONE, GL_ONE, factor);
        case 8: return glBlendEquation(d.among({GL_FUNC_ADD, GL_MIN}));
        case 9: return glBlendColor(d.real(), d.real(), d.real(), d.real());
        case 10: return glLogicOp(d.among({GL_COPY, GL_XOR}));
        case 11: return glColorMask(1, GLboolean(d.below(2)), 1, 1);
        default: return glSampleCoverage(d.real(), GLboolean(d.below(2)));
    }
}

void set_buffers(Dice& d) {
    switch (d.below(3)) {
        case 0: return glDrawBuffer(d.among({GL_FRONT, GL_BACK, GL_NONE, GL_FRONT_AND_BACK}));
        case 1: return glReadBuffer(d.among({GL_FRONT, GL_BACK}));
        default: glRenderMode(d.among({GL_RENDER, GL_FEEDBACK}));
    }
}

void nest_attributes(Dice& d) {
    d.chance() ? glPushAttrib(GLbitfield(d.below(1 << 20))) : glPopAttrib();
}

/// One framebuffer object, whose images come, go, and differ in size.
void use_object(Dice& d) {
    glBindFramebuffer(GL_FRAMEBUFFER, GLuint(d.below(2)));
    const GLuint texture = 4 * GLuint(d.below(3)) + (GL_TEXTURE_2D & 3);
    if (d.chance())
        glFramebufferTexture2D(GL_FRAMEBUFFER, d.among({GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT}),
                               GL_TEXTURE_2D, texture, 0);
}

void expect_whole_state(Context& context) {
    update_machine_state(context);
    gw::State whole;
    translate_state(context, all_state_parts, whole);
    ASSERT_EQ(*context.translated.state, whole);
    const LightsRef lights = machine_lights(context.state.lighting);
    ASSERT_EQ(lights == nullptr, context.translated.lights == nullptr);
    if (lights) {
        ASSERT_EQ(*lights, *context.translated.lights);
    }
}

}  // namespace

TEST(GlStateParts, OneChangeMakesAnewAllThatFollowsFromIt) {
    constexpr void (*changes[])(Dice&) = {enable,      enable,     set_matrix,     set_transform,
                                          set_shapes,  set_lights, set_texture,    set_texture,
                                          set_image,   set_fog,    set_fragments,  set_fragments,
                                          set_buffers, use_object, nest_attributes};
    std::vector<GLfloat> feedback(64);
    for (unsigned seed = 0; seed < 20; ++seed) {
        Window window(16, 16, opengl(), Buffers::Double, 4);
        glFeedbackBuffer(64, GL_2D, feedback.data());
        Dice dice(seed);
        for (int i = 0; i < 1000; ++i) {
            SCOPED_TRACE(testing::Message() << "seed " << seed << ", change " << i);
            changes[dice.below(int(std::size(changes)))](dice);
            expect_whole_state(window.context);
            if (HasFatalFailure()) return;
        }
    }
}

}  // namespace gw::gl
