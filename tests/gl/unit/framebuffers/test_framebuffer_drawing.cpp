// What is drawn to framebuffer objects: shared planes, textures, mipmaps, feedback, blits.
#include "tests/gl/unit/framebuffers/framebuffer.h"

namespace gw::gl {

/// Colours by turns with one buffer of depths: each keeps its own, the depths are common.
TEST(GlFramebuffers, ShareADepthBuffer) {
    const Window window;
    const GLuint depth = new_renderbuffer(GL_DEPTH_COMPONENT24, 8, 8);
    GLuint framebuffers[2], colors[2];
    for (int i = 0; i < 2; ++i) {
        colors[i] = new_texture(GL_RGBA8, 8, 8);
        framebuffers[i] = new_framebuffer();
        attach_texture(colors[i]);
        attach_renderbuffer(depth, GL_DEPTH_ATTACHMENT);
        clear_to(0, 0, 0);
    }
    glViewport(0, 0, 8, 8);
    glEnable(GL_DEPTH_TEST);
    glClear(GL_DEPTH_BUFFER_BIT);
    for (int step = 0; step < 6; ++step) {  // each nearer by 1/8
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffers[step % 2]);
        glColor3ub(GLubyte(10 * step + 1), 0, 0);
        fill(0.5f - 0.25f * float(step) / 2);
        glColor3ub(200, 0, 0);
        fill(0.75f);  // behind
        EXPECT_EQ(pixel_at(4, 4)[0], 10 * step + 1);
        EXPECT_NEAR(depth_at(4, 4), 0.75f - float(step) / 16, 1e-6) << step;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffers[0]);
    EXPECT_EQ(pixel_at(4, 4)[0], 41);
    attach_texture(colors[1]);  // two textures in turn on one framebuffer
    EXPECT_EQ(pixel_at(4, 4)[0], 51);
}

/// A depth buffer by turns with colours of its size and with smaller ones.
TEST(GlFramebuffers, HaveThePixelsThatAllImagesHave) {
    const Window window;
    const GLuint depth = new_renderbuffer(GL_DEPTH24_STENCIL8, 16, 16);
    new_framebuffer();
    attach_renderbuffer(new_renderbuffer(GL_RGBA8, 8, 4));
    attach_renderbuffer(depth, GL_DEPTH_STENCIL_ATTACHMENT);
    EXPECT_EQ(status(), GLenum(GL_FRAMEBUFFER_COMPLETE));
    glClearDepth(0.25);
    glClear(GL_DEPTH_BUFFER_BIT);
    clear_to(1, 2, 3);
    EXPECT_EQ(pixel_at(7, 3), (Bytes{1, 2, 3, 255}));
    attach_renderbuffer(new_renderbuffer(GL_RGBA8, 16, 16));
    EXPECT_NEAR(depth_at(7, 3), 0.25f, 1e-6);
    EXPECT_EQ(depth_at(8, 3), 0) << "beyond the smaller one";
    EXPECT_GL_ERROR(GL_NO_ERROR);
}

/// MuJoCo asks for them when it resizes its picture, whatever is offered.
TEST(GlFramebuffers, StoreFloatDepthsIn32Bits) {
    const Window window;
    for (const GLenum format : {GL_DEPTH32F_STENCIL8, GL_DEPTH_COMPONENT32F}) {
        new_framebuffer();
        attach_renderbuffer(new_renderbuffer(GL_RGBA8, 8, 8));
        attach_renderbuffer(new_renderbuffer(format, 8, 8), GL_DEPTH_ATTACHMENT);
        EXPECT_EQ(status(), GLenum(GL_FRAMEBUFFER_COMPLETE));
        GLint bits = 0;
        glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_DEPTH_SIZE, &bits);
        EXPECT_EQ(bits, 32);
        glClearDepth(0.75);
        glClear(GL_DEPTH_BUFFER_BIT);
        EXPECT_EQ(depth_at(7, 7), 0.75f);
        EXPECT_GL_ERROR(GL_NO_ERROR);
    }
}

/// What a framebuffer has not is not tested, although its texture's stencil is there.
TEST(GlFramebuffers, LackWhatIsNotAttached) {
    const Window window;
    const GLuint pair = new_renderbuffer(GL_DEPTH24_STENCIL8, 8, 8);
    new_framebuffer();
    attach_renderbuffer(new_renderbuffer(GL_RGBA8, 8, 8));
    attach_renderbuffer(pair, GL_DEPTH_STENCIL_ATTACHMENT);
    glClear(GL_STENCIL_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glViewport(0, 0, 8, 8);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_STENCIL_TEST);
    glDepthFunc(GL_NEVER);
    glStencilFunc(GL_NEVER, 0, 1);
    fill();
    EXPECT_EQ(pixel_at(1, 1)[0], 0);
    attach_renderbuffer(0, GL_DEPTH_STENCIL_ATTACHMENT);
    fill();
    EXPECT_EQ(pixel_at(1, 1)[0], 255);
    EXPECT_EQ(integer(GL_DEPTH_BITS), 0);
    GLubyte value = 0;
    glReadPixels(0, 0, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &value);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
}

TEST(GlFramebuffers, RgbHasNoAlpha) {
    const Window window;
    new_framebuffer();
    attach_texture(new_texture(GL_RGB, 8, 8));
    EXPECT_EQ(pixel_at(0, 0)[3], 255);
    clear_to(1, 2, 3, 50);
    EXPECT_EQ(pixel_at(0, 0), (Bytes{1, 2, 3, 255}));
    glViewport(0, 0, 8, 8);
    glColor4ub(9, 9, 9, 9);
    fill();
    EXPECT_EQ(pixel_at(0, 0), (Bytes{9, 9, 9, 255}));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, 4, 4, 0, 0, 4, 4, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(integer(GL_DRAW_FRAMEBUFFER_BINDING)));
    EXPECT_EQ(pixel_at(0, 0), (Bytes{0, 0, 0, 255}));
    EXPECT_EQ(pixel_at(4, 4), (Bytes{9, 9, 9, 255}));
}

/// Texels that were given, drawn over in a part, and sampled on both machines that draw.
class Sampled : public testing::TestWithParam<bool> {};
TEST_P(Sampled, TexturesHaveWhatWasDrawnToThem) {
    const Window window(8, 8);
    const GLuint texture = new_texture(GL_RGBA8, 8, 8);
    const std::vector<GLubyte> texels(8 * 8 * 4, 100);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    new_framebuffer();
    attach_texture(texture);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 4, 8);
    clear_to(1, 2, 3, 4);
    glDisable(GL_SCISSOR_TEST);
    EXPECT_EQ(pixel_at(5, 0), (Bytes{100, 100, 100, 100}));
    const GLubyte one[] = {7, 7, 7, 7};
    glTexSubImage2D(GL_TEXTURE_2D, 0, 3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, one);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (GetParam()) {
        new_framebuffer();
        attach_renderbuffer(new_renderbuffer(GL_RGBA8, 8, 8));
    }
    glViewport(0, 0, 8, 8);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    fill();
    EXPECT_EQ(pixel_at(0, 0), (Bytes{1, 2, 3, 4}));
    EXPECT_EQ(pixel_at(3, 3), (Bytes{7, 7, 7, 7}));
    EXPECT_EQ(pixel_at(4, 3), (Bytes{100, 100, 100, 100}));
    std::vector<Bytes> read(64);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
    EXPECT_EQ(read[0], (Bytes{1, 2, 3, 4}));
    EXPECT_GL_ERROR(GL_NO_ERROR);
}
INSTANTIATE_TEST_SUITE_P(GlFramebuffers, Sampled, testing::Bool());

/// A texture whose depths lie beside the colours that are drawn to is sampled all the same.
TEST(GlFramebuffers, SampleADepthTextureThatTheirColoursWereDrawnWith) {
    const Window window;
    const GLuint depth = new_texture(GL_DEPTH_COMPONENT24, 8, 8);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_INTENSITY);
    new_framebuffer();
    attach_renderbuffer(new_renderbuffer(GL_RGBA8, 8, 8));
    attach_texture(depth, 0, GL_DEPTH_ATTACHMENT);
    glViewport(0, 0, 8, 8);
    glClearDepth(0.5);
    glClear(GL_DEPTH_BUFFER_BIT);
    attach_texture(0, 0, GL_DEPTH_ATTACHMENT);
    glEnable(GL_TEXTURE_2D);
    const auto compared = [](float r) {
        glTexCoord3f(0.5f, 0.5f, r);
        glRecti(-1, -1, 1, 1);
        return pixel_at(2, 2)[0];
    };
    EXPECT_EQ(compared(0.75f), 0);
    EXPECT_EQ(compared(0.25f), 255);
}

TEST(GlFramebuffers, WarnOfATextureThatIsDrawnToAndSampled) {
    const Window window;
    const GLuint texture = new_texture(GL_RGBA8, 4, 4);
    new_framebuffer();
    attach_texture(texture);
    glViewport(0, 0, 4, 4);
    clear_to(100, 0, 0);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    testing::internal::CaptureStderr();
    fill();
    fill();
    glFlush();
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_EQ(pixel_at(1, 1)[0], 255) << "100 + 100, then + 200";
    EXPECT_NE(said.find("is sampled while framebuffer"), std::string::npos) << said;
    EXPECT_EQ(said.find('\n'), said.size() - 1) << said;
}

TEST(GlFramebuffers, DrawToLevelsFacesAndSlices) {
    const Window window(8, 8);
    GLuint names[2];
    glGenTextures(2, names);
    const GLuint framebuffer = new_framebuffer();
    glBindTexture(GL_TEXTURE_2D, names[0]);
    for (int level = 0; level < 4; ++level)
        glTexImage2D(GL_TEXTURE_2D, level, GL_RGBA, 8 >> level, 8 >> level, 0, GL_RGBA,
                     GL_UNSIGNED_BYTE, nullptr);
    for (int level = 0; level < 4; ++level) {
        attach_texture(names[0], level);
        clear_to(level + 1, 0, 0);
    }
    for (int level = 0; level < 4; ++level) {
        Bytes texels[64];
        glGetTexImage(GL_TEXTURE_2D, level, GL_RGBA, GL_UNSIGNED_BYTE, texels);
        EXPECT_EQ(texels[0], (Bytes{GLubyte(level + 1), 0, 0, 255}));
    }
    glBindTexture(GL_TEXTURE_3D, names[1]);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 2, 2, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    for (int slice = 0; slice < 4; ++slice) {
        glFramebufferTexture3D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_3D, names[1], 0,
                               slice);
        clear_to(0, slice + 1, 0);
    }
    Bytes volume[16];
    glGetTexImage(GL_TEXTURE_3D, 0, GL_RGBA, GL_UNSIGNED_BYTE, volume);
    for (int slice = 0; slice < 4; ++slice) EXPECT_EQ(volume[4 * slice][1], slice + 1);
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, names[1], 0, 2);
    EXPECT_EQ(pixel_at(0, 0), (Bytes{0, 3, 0, 255}));
    EXPECT_EQ(status(), GLenum(GL_FRAMEBUFFER_COMPLETE));
    glFramebufferTexture3D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_3D, names[1], 0, 4);
    EXPECT_EQ(status(), GLenum(GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    EXPECT_GL_ERROR(GL_NO_ERROR);
}

TEST(GlFramebuffers, MakeMipmapsOfWhatWasDrawn) {
    const Window window;
    const GLuint texture = new_texture(GL_RGBA8, 4, 4);
    new_framebuffer();
    attach_texture(texture);
    clear_to(100, 100, 100);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 2, 4);
    clear_to(200, 0, 0);
    glGenerateMipmap(GL_TEXTURE_2D);
    Bytes level[4];
    glGetTexImage(GL_TEXTURE_2D, 1, GL_RGBA, GL_UNSIGNED_BYTE, level);
    EXPECT_EQ(level[0], (Bytes{200, 0, 0, 255}));
    EXPECT_EQ(level[1], (Bytes{100, 100, 100, 255}));
    glGetTexImage(GL_TEXTURE_2D, 2, GL_RGBA, GL_UNSIGNED_BYTE, level);
    EXPECT_EQ(level[0], (Bytes{150, 50, 50, 255}));
}

/// Between objects, from the window, to the window; flipped; through the scissor box, not the masks.
TEST(GlFramebuffers, BlitBetweenAllKinds) {
    const Window window(8, 8);
    const auto left_and_right = [](int left, int right) {
        clear_to(right, 0, 0);
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, 4, 8);
        clear_to(left, 0, 0);
        glDisable(GL_SCISSOR_TEST);
    };
    GLuint objects[3] = {};
    for (int i = 1; i < 3; ++i) {
        objects[i] = new_framebuffer();
        attach_renderbuffer(new_renderbuffer(GL_RGBA8, 8, 8));
        attach_renderbuffer(new_renderbuffer(GL_DEPTH24_STENCIL8, 8, 8),
                            GL_DEPTH_STENCIL_ATTACHMENT);
    }
    for (const GLuint from : objects)
        for (const GLuint to : objects) {
            glBindFramebuffer(GL_FRAMEBUFFER, to);
            clear_to(0, 0, 0);
            glBindFramebuffer(GL_FRAMEBUFFER, from);
            left_and_right(10, 20);
            glClearDepth(0.5);
            glClearStencil(3);
            glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
            glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
            glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
            glBlitFramebuffer(0, 0, 8, 8, 8, 0, 0, 8,
                              GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT,
                              GL_NEAREST);
            glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
            glBindFramebuffer(GL_FRAMEBUFFER, to);
            EXPECT_EQ(pixel_at(1, 1)[0], 20) << from << " to " << to;
            EXPECT_EQ(pixel_at(6, 6)[0], 10) << from << " to " << to;
            EXPECT_NEAR(depth_at(3, 3), 0.5f, 1e-6) << from << " to " << to;
            GLubyte stencil = 0;
            glReadPixels(7, 7, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &stencil);
            EXPECT_EQ(stencil, 3) << from << " to " << to;
        }
    EXPECT_GL_ERROR(GL_NO_ERROR);
}

TEST(GlFramebuffers, BlitsOfUnequalDepthsAreErrors) {
    const Window window;
    new_framebuffer();
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    attach_renderbuffer(new_renderbuffer(GL_DEPTH_COMPONENT16, 8, 8), GL_DEPTH_ATTACHMENT);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, 8, 8, 0, 0, 8, 8, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
    glBlitFramebuffer(0, 0, 8, 8, 0, 0, 8, 8, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    EXPECT_GL_ERROR(GL_NO_ERROR);
}

/// Their buffers are a framebuffer's own; an attribute stack does not carry one's to another.
TEST(GlFramebuffers, KeepTheirOwnBuffers) {
    const Window window(8, 8, opengl(), Buffers::Double);
    EXPECT_EQ(integer(GL_DRAW_BUFFER), GL_BACK);
    glPushAttrib(GL_COLOR_BUFFER_BIT);
    const GLuint name = new_framebuffer();
    glDrawBuffer(GL_NONE);
    glPopAttrib();
    EXPECT_EQ(integer(GL_DRAW_BUFFER), GL_NONE);
    EXPECT_EQ(integer(GL_READ_BUFFER), GL_COLOR_ATTACHMENT0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    EXPECT_EQ(integer(GL_DRAW_BUFFER), GL_BACK);
    EXPECT_EQ(integer(GL_READ_BUFFER), GL_BACK);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, name);
    EXPECT_EQ(integer(GL_DRAW_BUFFER), GL_NONE);
}

/// A query counts in window and object as one.
TEST(GlFramebuffers, QueriesGoOnWhenTheyAreBound) {
    const Window window(8, 8);
    glBeginQuery(GL_SAMPLES_PASSED, 1);
    fill();
    new_framebuffer();
    attach_renderbuffer(new_renderbuffer(GL_RGBA8, 4, 4));
    fill();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    fill();
    glEndQuery(GL_SAMPLES_PASSED);
    GLuint count = 0;
    glGetQueryObjectuiv(1, GL_QUERY_RESULT, &count);
    EXPECT_EQ(count, 64u + 16u + 64u);
}

/// More images than the machine has surfaces.
TEST(GlFramebuffers, ManyTexturesAreDrawnToAndKept) {
    const Window window;
    new_framebuffer();
    std::vector<GLuint> names;
    for (int i = 0; i < 1200; ++i) {
        names.push_back(new_texture(GL_RGBA8, 2, 2));
        attach_texture(names.back());
        clear_to(i % 251, i / 251, 0);
    }
    EXPECT_GL_ERROR(GL_NO_ERROR);
    for (int i = 0; i < 1200; ++i) {
        Bytes texels[4];
        glBindTexture(GL_TEXTURE_2D, names[std::size_t(i)]);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
        ASSERT_EQ(texels[3], (Bytes{GLubyte(i % 251), GLubyte(i / 251), 0, 255})) << i;
    }
}

TEST(GlFramebuffers, DepthAndStencilTexturesKeepBoth) {
    const Window window;
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    const GLuint texels[] = {0x80000000u | 5, 0xFFFFFF00u | 6, 7, 0x12345600u | 8};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, 2, 2, 0, GL_DEPTH_STENCIL,
                 GL_UNSIGNED_INT_24_8, texels);
    new_framebuffer();
    attach_texture(name, 0, GL_DEPTH_STENCIL_ATTACHMENT);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    GLuint read[4] = {};
    glReadPixels(0, 0, 2, 2, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, read);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(read[i], texels[i]) << i;
    glClearStencil(9);
    glClear(GL_STENCIL_BUFFER_BIT);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, read);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(read[i], (texels[i] & ~255u) | 9) << i;
    EXPECT_GL_ERROR(GL_NO_ERROR);
}

/// Images of sides up to 8,192, drawn to beyond what a window has.
TEST(GlFramebuffers, ReachEightThousandPixels) {
    const Window window;
    new_framebuffer();
    attach_renderbuffer(new_renderbuffer(GL_RGBA8, 8192, 4));
    glViewport(0, 0, 8192, 4);
    glColor3ub(1, 2, 3);
    fill();
    EXPECT_EQ(pixel_at(8191, 3), (Bytes{1, 2, 3, 255}));
    const GLubyte dot[] = {9, 9, 9, 9};
    glWindowPos2i(8000, 1);
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, dot);
    EXPECT_EQ(pixel_at(8000, 1), (Bytes{9, 9, 9, 9}));
    EXPECT_GL_ERROR(GL_NO_ERROR);
}

}  // namespace gw::gl
