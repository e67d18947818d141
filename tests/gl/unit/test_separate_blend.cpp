// Blending of alpha by a rule of its own, and rescaled normals. [GL12], [GL14]
#include "tests/gl/unit/support/picture.h"

namespace gw::gl {

/// [GL14] 4.1.7: alpha by its own factors and equation.
TEST(GlBlending, AlphaHasFactorsAndAnEquationOfItsOwn) {
    Window window(1, 1);
    glClearColor(100 / 255.0f, 100 / 255.0f, 100 / 255.0f, 200 / 255.0f);
    glEnable(GL_BLEND);
    const auto blended = [&] {
        glClear(GL_COLOR_BUFFER_BIT);
        glColor4ub(30, 20, 10, 5);
        glRecti(-1, -1, 1, 1);
        return window.pixel(0, 0);
    };
    glBlendFuncSeparate(GL_ONE, GL_ZERO, GL_ZERO, GL_ONE);
    EXPECT_EQ(blended(), (std::array<GLubyte, 4>{30, 20, 10, 200}));
    glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ZERO);
    EXPECT_EQ(blended(), (std::array<GLubyte, 4>{130, 120, 110, 5}));
    glBlendFunc(GL_ONE, GL_ONE);
    EXPECT_EQ(blended(), (std::array<GLubyte, 4>{130, 120, 110, 205}));
    glBlendEquationSeparate(GL_FUNC_ADD, GL_FUNC_REVERSE_SUBTRACT);
    EXPECT_EQ(blended(), (std::array<GLubyte, 4>{130, 120, 110, 195}));
    glBlendEquationSeparate(GL_FUNC_REVERSE_SUBTRACT, GL_MAX);
    EXPECT_EQ(blended(), (std::array<GLubyte, 4>{70, 80, 90, 200}));
    glBlendEquation(GL_FUNC_ADD);
    EXPECT_EQ(blended(), (std::array<GLubyte, 4>{130, 120, 110, 205}));
    glBlendFuncSeparate(GL_ONE, GL_ONE, GL_RED, GL_ONE);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_ENUM));
    const std::pair<GLenum, GLint> values[] = {
        {GL_BLEND_SRC_RGB, GL_ONE},           {GL_BLEND_DST_RGB, GL_ONE},
        {GL_BLEND_SRC_ALPHA, GL_ONE},         {GL_BLEND_DST_ALPHA, GL_ONE},
        {GL_BLEND_EQUATION_RGB, GL_FUNC_ADD}, {GL_BLEND_EQUATION_ALPHA, GL_FUNC_ADD}};
    for (const auto& [name, expected] : values) {
        GLint value = 0;
        glGetIntegerv(name, &value);
        EXPECT_EQ(value, expected) << name;
    }
}

/// [GL12] 2.10.3: rescaled normals have length 1 here, as normalized ones do.
TEST(GlLighting, RescaledNormalsAreNormalizedOnes) {
    const auto draw = [](GLenum normals) {
        glEnable(GL_LIGHTING);
        glEnable(GL_LIGHT0);
        glEnable(normals);
        glScalef(0.25f, 0.25f, 0.25f);
        glNormal3f(0.6f, 0, 0.8f);
        glRecti(16, 16, 100, 100);
    };
    expect_same_picture([&] { draw(GL_NORMALIZE); }, [&] { draw(GL_RESCALE_NORMAL); });
    EXPECT_NE(drawn([&] { draw(GL_NORMALIZE); }), drawn([&] { draw(GL_LIGHT1); }));
}

}  // namespace gw::gl
