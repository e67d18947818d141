// Framebuffer objects with samples. GL_ARB_framebuffer_object, [GL15] 3.2.1, 4.1.3
#include "tests/gl/unit/framebuffers/framebuffer.h"

namespace gw::gl {

namespace {

GLuint sampled_renderbuffer(GLenum format, int samples, int width, int height) {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    return name;
}

/// An object of 8 x 8 pixels with samples, cleared to 0, in pixel coordinates.
GLuint sampled_framebuffer(int samples) {
    const GLuint name = new_framebuffer();
    attach_renderbuffer(sampled_renderbuffer(GL_RGBA8, samples, 8, 8));
    attach_renderbuffer(sampled_renderbuffer(GL_DEPTH24_STENCIL8, samples, 8, 8),
                        GL_DEPTH_STENCIL_ATTACHMENT);
    glViewport(0, 0, 8, 8);
    glLoadIdentity();
    glOrtho(0, 8, 0, 8, -1, 1);
    clear_to(0, 0, 0, 0);
    return name;
}

/// The resolved colours of what is drawn to.
Bytes resolved_at(int x, int y) {
    const auto from = GLuint(integer(GL_DRAW_FRAMEBUFFER_BINDING));
    new_framebuffer();
    attach_renderbuffer(new_renderbuffer(GL_RGBA8, 8, 8));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    glBlitFramebuffer(0, 0, 8, 8, 0, 0, 8, 8, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    const auto to = GLuint(integer(GL_DRAW_FRAMEBUFFER_BINDING));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, to);
    const Bytes out = pixel_at(x, y);
    glBindFramebuffer(GL_FRAMEBUFFER, from);
    return out;
}

}  // namespace

TEST(GlSamples, ARenderbufferHasAsManyAsAskedOrMore) {
    const Window window;
    EXPECT_EQ(integer(GL_MAX_SAMPLES), 8);
    EXPECT_EQ(integer(GL_SAMPLES), 0);
    for (const auto& [asked, given] : {std::pair{0, 0}, {1, 2}, {2, 2}, {3, 4}, {5, 8}, {8, 8}}) {
        sampled_renderbuffer(GL_RGBA8, asked, 4, 4);
        GLint samples = -1;
        glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &samples);
        EXPECT_EQ(samples, given) << asked;
    }
    EXPECT_GL_ERROR(GL_NO_ERROR);
    sampled_renderbuffer(GL_RGBA8, 2, 8192, 8192);
    EXPECT_GL_ERROR(GL_OUT_OF_MEMORY);
    sampled_framebuffer(4);
    EXPECT_EQ(integer(GL_SAMPLES), 4);
    EXPECT_EQ(integer(GL_SAMPLE_BUFFERS), 1);
    attach_renderbuffer(new_renderbuffer(GL_DEPTH24_STENCIL8, 8, 8), GL_DEPTH_STENCIL_ATTACHMENT);
    EXPECT_EQ(status(), GLenum(GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE));
}

/// A square over half of a pixel: half of its samples, unless samples are off.
TEST(GlSamples, SmoothEdgesUnlessTheyAreOff) {
    for (const int samples : {2, 4, 8}) {
        const Window window;
        sampled_framebuffer(samples);
        glRectf(2.5f, 2, 6, 6);
        EXPECT_EQ(resolved_at(2, 3), (Bytes{128, 128, 128, 128})) << samples;
        EXPECT_EQ(resolved_at(3, 3), (Bytes{255, 255, 255, 255})) << samples;
        glDisable(GL_MULTISAMPLE);
        clear_to(0, 0, 0, 0);
        glRectf(2.25f, 2, 6, 6);
        EXPECT_EQ(resolved_at(2, 3), (Bytes{255, 255, 255, 255})) << samples;
        EXPECT_GL_ERROR(GL_NO_ERROR);
    }
}

TEST(GlSamples, CoverageAndAlphaTakeSomeAway) {
    const Window window;
    sampled_framebuffer(4);
    glEnable(GL_SAMPLE_COVERAGE);
    glSampleCoverage(0.25f, GL_FALSE);
    glRectf(0, 0, 8, 8);
    EXPECT_EQ(resolved_at(1, 1)[0], 64);
    glSampleCoverage(0.25f, GL_TRUE);
    clear_to(0, 0, 0, 0);
    glRectf(0, 0, 8, 8);
    EXPECT_EQ(resolved_at(1, 1)[0], 191);
    glDisable(GL_SAMPLE_COVERAGE);
    glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    glEnable(GL_SAMPLE_ALPHA_TO_ONE);
    clear_to(0, 0, 0, 0);
    glColor4f(1, 1, 1, 0.5f);
    glRectf(0, 0, 8, 8);
    EXPECT_EQ(resolved_at(1, 1), (Bytes{128, 128, 128, 128}));
}

/// [GL30] 4.3.2, 4.3.3
TEST(GlSamples, AreReadByBlitsOnly) {
    const Window window(8, 8);
    const GLuint sampled = sampled_framebuffer(4);
    pixel_at(0, 0);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, 4, 0);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, 8, 8, 0, 0, 4, 4, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, sampled);
    glClearDepth(0.25);
    glClear(GL_DEPTH_BUFFER_BIT);
    glRectf(2.5f, 2, 6, 6);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, 8, 8, 0, 0, 8, 8, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT,
                      GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    EXPECT_EQ(pixel_at(2, 3)[0], 128) << "to the window";
    EXPECT_NEAR(depth_at(2, 3), 0.25f, 1e-6);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, sampled);
    clear_to(0, 0, 0);
    glBlitFramebuffer(0, 0, 8, 8, 0, 0, 8, 8, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    EXPECT_EQ(resolved_at(2, 3)[0], 128) << "from the window";
    EXPECT_GL_ERROR(GL_NO_ERROR);
}

/// Depths with samples by turns with two colours: moved with all samples.
TEST(GlSamples, MoveWithTheirPlanes) {
    const Window window;
    const GLuint depth = sampled_renderbuffer(GL_DEPTH_COMPONENT24, 4, 8, 8);
    sampled_framebuffer(4);
    attach_renderbuffer(0, GL_DEPTH_STENCIL_ATTACHMENT);
    attach_renderbuffer(depth, GL_DEPTH_ATTACHMENT);
    glEnable(GL_DEPTH_TEST);
    glClear(GL_DEPTH_BUFFER_BIT);
    glRectf(0, 0, 2.5f, 8);  // half of the samples of a column
    sampled_framebuffer(4);
    attach_renderbuffer(0, GL_DEPTH_STENCIL_ATTACHMENT);
    attach_renderbuffer(depth, GL_DEPTH_ATTACHMENT);
    glTranslatef(0, 0, -0.5f);  // behind
    glRectf(0, 0, 8, 8);
    EXPECT_EQ(resolved_at(1, 1)[0], 0);
    EXPECT_EQ(resolved_at(2, 1)[0], 128);
    EXPECT_EQ(resolved_at(3, 1)[0], 255);
}

}  // namespace gw::gl
