// Textures of depths, and their comparison with r. [GL14] 3.8.1, 3.8.14, [GL15] 3.8.14
#include "tests/gl/unit/support/window.h"

namespace gw::gl {
namespace {

using Pixel = std::array<GLubyte, 4>;

void expect_error(GLenum error, const char* what) { EXPECT_EQ(glGetError(), error) << what; }

void set_parameter(GLenum name, GLenum value) {
    glTexParameteri(GL_TEXTURE_2D, name, GLint(value));
}
void use_depths(GLsizei width, GLsizei height, const GLuint* depths,
                GLint format = GL_DEPTH_COMPONENT) {
    glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                 depths);
    set_parameter(GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    set_parameter(GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
}
Pixel looked_up(const Window& window, GLfloat s, GLfloat r) {
    glTexCoord3f(s, 0.5f, r);
    glRectf(-1, -1, 1, 1);
    return window.pixel(1, 1);
}

}  // namespace

TEST(GlDepthTextures, KeepThirtyTwoBits) {
    const Window window;
    constexpr GLuint depths[] = {0, 1, 0x12345678, 0x80000000, 0xFFFFFFFE, 0xFFFFFFFF};
    for (const GLint format :
         {GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32}) {
        use_depths(3, 2, depths, format);
        std::array<GLuint, 6> read{};
        glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, read.data());
        EXPECT_TRUE(std::equal(read.begin(), read.end(), depths));
        GLint value = 0;
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_INTERNAL_FORMAT, &value);
        EXPECT_EQ(value, format);
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_DEPTH_SIZE, &value);
        EXPECT_EQ(value, 24);
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_LUMINANCE_SIZE, &value);
        EXPECT_EQ(value, 0);
    }
    // Pixel transfer: scale and bias, clamped.
    glPixelTransferf(GL_DEPTH_SCALE, 0.5f);
    glPixelTransferf(GL_DEPTH_BIAS, 0.75f);
    constexpr GLfloat given[] = {0, 0.25f, 1};
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 1, 3, 1, GL_DEPTH_COMPONENT, GL_FLOAT, given);
    std::array<GLfloat, 6> read{};
    glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, read.data());
    EXPECT_EQ(read[3], 0.75f);
    EXPECT_EQ(read[4], 0.875f);
    EXPECT_EQ(read[5], 1.0f);
    expect_error(GL_NO_ERROR, "transfer");
}

TEST(GlDepthTextures, AreGreysOfTheirMode) {
    const Window window(4, 4);
    constexpr GLuint depths[] = {0x33333333};
    use_depths(1, 1, depths);
    glColor4ub(10, 20, 30, 40);
    EXPECT_EQ(looked_up(window, 0, 0), (Pixel{51, 51, 51, 40}));
    set_parameter(GL_DEPTH_TEXTURE_MODE, GL_INTENSITY);
    EXPECT_EQ(looked_up(window, 0, 0), (Pixel{51, 51, 51, 51}));
    set_parameter(GL_DEPTH_TEXTURE_MODE, GL_ALPHA);
    EXPECT_EQ(looked_up(window, 0, 0), (Pixel{10, 20, 30, 51}));
    set_parameter(GL_DEPTH_TEXTURE_MODE, GL_RGBA);
    expect_error(GL_INVALID_ENUM, "mode RGBA");
    GLint mode = 0;
    glGetTexParameteriv(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, &mode);
    EXPECT_EQ(mode, GL_ALPHA);
    glPushAttrib(GL_TEXTURE_BIT);
    set_parameter(GL_DEPTH_TEXTURE_MODE, GL_LUMINANCE);
    EXPECT_EQ(looked_up(window, 0, 0), (Pixel{51, 51, 51, 40}));
    glPopAttrib();
    EXPECT_EQ(looked_up(window, 0, 0), (Pixel{10, 20, 30, 51}));
}

TEST(GlDepthTextures, AreComparedByEachFunction) {
    const Window window(4, 4);
    constexpr GLuint depths[] = {0x40000000, 0x80000000, 0xC0000000};
    use_depths(3, 1, depths);
    set_parameter(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    const struct {
        GLenum func;
        bool passes[3];  ///< of r = 1/2 at 1/4, 1/2, 3/4
    } cases[] = {{GL_NEVER, {false, false, false}},  {GL_LESS, {false, false, true}},
                 {GL_EQUAL, {false, true, false}},   {GL_LEQUAL, {false, true, true}},
                 {GL_GREATER, {true, false, false}}, {GL_NOTEQUAL, {true, false, true}},
                 {GL_GEQUAL, {true, true, false}},   {GL_ALWAYS, {true, true, true}}};
    for (const auto& c : cases) {
        set_parameter(GL_TEXTURE_COMPARE_FUNC, c.func);
        for (int i = 0; i < 3; ++i) {
            const GLubyte v = c.passes[i] ? 255 : 0;
            EXPECT_EQ(looked_up(window, (float(i) + 0.5f) / 3, 0.5f), (Pixel{v, v, v, 255}))
                << c.func << " of texel " << i;
        }
    }
    set_parameter(GL_TEXTURE_COMPARE_FUNC, GL_ADD);
    expect_error(GL_INVALID_ENUM, "no function");
    set_parameter(GL_TEXTURE_COMPARE_MODE, GL_LESS);
    expect_error(GL_INVALID_ENUM, "no mode");
}

TEST(GlDepthTextures, ColoursAreNotCompared) {
    const Window window(4, 4);
    constexpr Pixel color{9, 8, 7, 6};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, color.data());
    set_parameter(GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    set_parameter(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    EXPECT_EQ(looked_up(window, 0, 0.5f), color);
    // The same object gets depths, and colours again.
    constexpr GLuint near[] = {0};
    use_depths(1, 1, near);
    EXPECT_EQ(looked_up(window, 0, 0.5f), (Pixel{0, 0, 0, 255}));
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, color.data());
    EXPECT_EQ(looked_up(window, 0, 0.5f), color);
}

TEST(GlDepthTextures, CopiesAreExact) {
    const Window window(8, 8);
    glDepthFunc(GL_ALWAYS);
    glEnable(GL_DEPTH_TEST);
    glBegin(GL_QUADS);  // a slope
    glVertex3f(-1, -1, -0.9f);
    glVertex3f(1, -1, 0.3f);
    glVertex3f(1, 1, 0.95f);
    glVertex3f(-1, 1, -0.25f);
    glEnd();
    std::array<GLuint, 64> depths{}, read{};
    glReadPixels(0, 0, 8, 8, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depths.data());
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 0, 0, 8, 8, 0);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, read.data());
    EXPECT_EQ(read, depths);
    glClearDepth(0.5);
    glClear(GL_DEPTH_BUFFER_BIT);
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 2, 3, 0, 0, 4, 2);
    std::array<GLuint, 8> cleared{};
    glReadPixels(0, 0, 4, 2, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, cleared.data());
    for (std::size_t y = 0; y < 2; ++y)
        for (std::size_t x = 0; x < 4; ++x) depths[(y + 3) * 8 + x + 2] = cleared[4 * y + x];
    glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, read.data());
    EXPECT_EQ(read, depths);
    expect_error(GL_NO_ERROR, "copies");
}

TEST(GlDepthTextures, ASurfaceEqualsItsOwnMap) {
    const Window window(16, 16);
    glEnable(GL_DEPTH_TEST);
    const auto draw = [] {
        glBegin(GL_QUADS);
        for (const auto& [x, y, z] :
             {std::array{-1.0f, -1.0f, -0.7f}, {1, -1, 0.1f}, {1, 1, 0.6f}, {-1, 1, -0.2f}})
            glVertex3f(x, y, z);
        glEnd();
    };
    draw();
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 0, 0, 16, 16, 0);
    set_parameter(GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    set_parameter(GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    set_parameter(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    // The eye is the light: s, t, r are the window's coordinates, moved by two of 2^24 to the eye.
    constexpr GLfloat to_unit[4][4] = {
        {0.5f, 0, 0, 0.5f}, {0, 0.5f, 0, 0.5f}, {0, 0, 0.5f, 0.5f - 0x1p-23f}, {0, 0, 0, 1}};
    for (int i = 0; i < 4; ++i) {
        glTexGeni(GL_S + GLenum(i), GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR);
        glTexGenfv(GL_S + GLenum(i), GL_EYE_PLANE, to_unit[i]);
        glEnable(GL_TEXTURE_GEN_S + GLenum(i));
    }
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw();
    EXPECT_EQ(window.pixels(), std::vector(256, Pixel{255, 255, 255, 255}));
    set_parameter(GL_TEXTURE_COMPARE_FUNC, GL_GREATER);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw();
    EXPECT_EQ(window.pixels(), std::vector(256, Pixel{0, 0, 0, 255}));
}

TEST(GlDepthTextures, HaveTheErrorsOfTheSpecification) {
    const Window window;
    const auto image = [](GLenum target, GLint internal_format, GLenum format) {
        glTexImage2D(target, 0, internal_format, 4, 4, 0, format, GL_UNSIGNED_INT, nullptr);
    };
    image(GL_TEXTURE_2D, GL_DEPTH_COMPONENT, GL_RGBA);
    expect_error(GL_INVALID_OPERATION, "colours into depths");
    image(GL_TEXTURE_2D, GL_RGBA, GL_DEPTH_COMPONENT);
    expect_error(GL_INVALID_OPERATION, "depths into colours");
    image(GL_TEXTURE_CUBE_MAP_POSITIVE_X, GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT);
    expect_error(GL_INVALID_OPERATION, "a cube of depths");
    glTexImage3D(GL_TEXTURE_3D, 0, GL_DEPTH_COMPONENT, 4, 4, 4, 0, GL_DEPTH_COMPONENT,
                 GL_UNSIGNED_INT, nullptr);
    expect_error(GL_INVALID_OPERATION, "depths of three dimensions");
    image(GL_TEXTURE_2D, GL_STENCIL_INDEX, GL_STENCIL_INDEX);
    expect_error(GL_INVALID_ENUM, "stencil values");
    image(GL_TEXTURE_2D, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT);
    expect_error(GL_NO_ERROR, "depths");
    constexpr GLuint texel[4] = {};
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_INT, texel);
    expect_error(GL_INVALID_OPERATION, "a part of colours");
    GLuint read[64];
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_INT, read);
    expect_error(GL_INVALID_OPERATION, "depths as colours");
    image(GL_TEXTURE_2D, GL_RGBA, GL_RGBA);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, read);
    expect_error(GL_INVALID_OPERATION, "colours as depths");
    glTexImage1D(GL_TEXTURE_1D, 0, GL_DEPTH_COMPONENT, 4, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    expect_error(GL_NO_ERROR, "one dimension");
}

TEST(GlDepthTextures, ProfilesWithoutThemRefuseTheirFormats) {
    const Window window(8, 8, vgx());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 4, 4, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                 nullptr);
    EXPECT_NE(glGetError(), GLenum(GL_NO_ERROR));
    set_parameter(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    expect_error(GL_INVALID_ENUM, "comparison");
}

TEST(GlMultisample, ItsStateIsKeptWithoutEffect) {
    const Window window(4, 4);
    EXPECT_TRUE(glIsEnabled(GL_MULTISAMPLE));
    GLfloat value = 0;
    glGetFloatv(GL_SAMPLE_COVERAGE_VALUE, &value);
    EXPECT_EQ(value, 1);
    glPushAttrib(GL_MULTISAMPLE_BIT);
    glSampleCoverage(2, GL_TRUE);
    glGetFloatv(GL_SAMPLE_COVERAGE_VALUE, &value);
    EXPECT_EQ(value, 1) << "clamped";
    glSampleCoverage(0.25f, GL_TRUE);
    glGetFloatv(GL_SAMPLE_COVERAGE_VALUE, &value);
    EXPECT_EQ(value, 0.25f);
    GLboolean invert = GL_FALSE;
    glGetBooleanv(GL_SAMPLE_COVERAGE_INVERT, &invert);
    EXPECT_TRUE(invert);
    for (const GLenum cap :
         {GL_SAMPLE_COVERAGE, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_ALPHA_TO_ONE}) {
        EXPECT_FALSE(glIsEnabled(cap));
        glEnable(cap);
    }
    glDisable(GL_MULTISAMPLE);
    glColor4ub(1, 2, 3, 4);
    glRectf(-1, -1, 1, 1);
    EXPECT_EQ(window.pixel(0, 0), (Pixel{1, 2, 3, 4}));
    glPopAttrib();
    EXPECT_TRUE(glIsEnabled(GL_MULTISAMPLE));
    EXPECT_FALSE(glIsEnabled(GL_SAMPLE_COVERAGE));
    glGetFloatv(GL_SAMPLE_COVERAGE_VALUE, &value);
    EXPECT_EQ(value, 1);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

}  // namespace gw::gl
