// Names, bindings and deletion of framebuffer objects; completeness; queries.
#include "tests/gl/unit/framebuffers/framebuffer.h"

namespace gw::gl {

TEST(GlFramebuffers, NamesAreObjectsFromTheirFirstBindingOn) {
    const Window window;
    GLuint names[2] = {}, buffers[2] = {};
    glGenFramebuffers(2, names);
    glGenRenderbuffers(2, buffers);
    EXPECT_NE(names[0], 0u);
    EXPECT_NE(names[0], names[1]);
    EXPECT_FALSE(glIsFramebuffer(names[0]));
    EXPECT_FALSE(glIsRenderbuffer(buffers[0]));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, names[0]);
    glBindRenderbuffer(GL_RENDERBUFFER, buffers[0]);
    EXPECT_TRUE(glIsFramebuffer(names[0]));
    EXPECT_TRUE(glIsRenderbuffer(buffers[0]));
    EXPECT_EQ(integer(GL_READ_FRAMEBUFFER_BINDING), GLint(names[0]));
    EXPECT_EQ(integer(GL_DRAW_FRAMEBUFFER_BINDING), 0);
    EXPECT_EQ(integer(GL_RENDERBUFFER_BINDING), GLint(buffers[0]));
    glBindFramebuffer(GL_FRAMEBUFFER, names[1]);
    EXPECT_EQ(integer(GL_FRAMEBUFFER_BINDING), GLint(names[1]));
    glDeleteFramebuffers(2, names);
    glDeleteRenderbuffers(2, buffers);
    EXPECT_EQ(integer(GL_READ_FRAMEBUFFER_BINDING), 0);
    EXPECT_EQ(integer(GL_RENDERBUFFER_BINDING), 0);
    EXPECT_FALSE(glIsFramebuffer(names[1]));
    EXPECT_GL_ERROR(GL_NO_ERROR);
    glBindFramebuffer(GL_FRAMEBUFFER, 77);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
    glBindFramebufferEXT(GL_FRAMEBUFFER, 77);
    EXPECT_GL_ERROR(GL_NO_ERROR);
    EXPECT_TRUE(glIsFramebuffer(77));
}

TEST(GlFramebuffers, StatusFollowsTheRulesOfCompleteness) {
    const Window window;
    EXPECT_EQ(status(), GLenum(GL_FRAMEBUFFER_COMPLETE));
    new_framebuffer();
    EXPECT_EQ(status(), GLenum(GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT));
    attach_renderbuffer(new_renderbuffer(GL_RGBA8, 8, 8));
    EXPECT_EQ(status(), GLenum(GL_FRAMEBUFFER_COMPLETE));
    attach_renderbuffer(new_renderbuffer(GL_DEPTH_COMPONENT24, 8, 8));
    EXPECT_EQ(status(), GLenum(GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT)) << "depths as colours";
    attach_renderbuffer(new_renderbuffer(GL_RGB, 0, 8));
    EXPECT_EQ(status(), GLenum(GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT)) << "no size";
    attach_renderbuffer(0);
    const GLuint pair = new_renderbuffer(GL_DEPTH24_STENCIL8, 8, 8);
    attach_renderbuffer(pair, GL_DEPTH_STENCIL_ATTACHMENT);
    EXPECT_EQ(status(), GLenum(GL_FRAMEBUFFER_COMPLETE)) << "no colours, though buffers name them";
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    EXPECT_EQ(status(), GLenum(GL_FRAMEBUFFER_COMPLETE));
    const GLuint texture = new_texture(GL_RGBA8, 8, 8);
    attach_texture(texture);
    EXPECT_EQ(status(), GLenum(GL_FRAMEBUFFER_COMPLETE));
    attach_texture(texture, 1);
    EXPECT_EQ(status(), GLenum(GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT)) << "no such level";
    attach_texture(new_texture(GL_LUMINANCE, 8, 8));
    EXPECT_EQ(status(), GLenum(GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT)) << "luminance";
    const GLuint bordered = new_texture(GL_RGBA8, 8, 8);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 10, 10, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    attach_texture(bordered);
    EXPECT_EQ(status(), GLenum(GL_FRAMEBUFFER_UNSUPPORTED)) << "a border";
    EXPECT_GL_ERROR(GL_NO_ERROR);
}

/// Shadow maps: many programs do not set the buffers to NONE.
TEST(GlFramebuffers, WithoutColoursHaveDepthsWhateverTheirBuffersName) {
    const Window window;
    new_framebuffer();
    attach_texture(new_texture(GL_DEPTH_COMPONENT24, 8, 8), 0, GL_DEPTH_ATTACHMENT);
    glViewport(0, 0, 8, 8);
    glEnable(GL_DEPTH_TEST);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    fill(0.5f);
    EXPECT_NEAR(depth_at(4, 4), 0.75f, 1e-6);
    EXPECT_GL_ERROR(GL_NO_ERROR);
    pixel_at(4, 4);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION) << "there are no colours";
    glCopyPixels(0, 0, 4, 4, GL_COLOR);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
}

TEST(GlFramebuffers, IncompleteOnesAreNotDrawnToOrRead) {
    const Window window;
    new_framebuffer();
    const auto fails = [](auto call) {
        call();
        return glGetError() == GL_INVALID_FRAMEBUFFER_OPERATION;
    };
    EXPECT_TRUE(fails([] { glClear(GL_COLOR_BUFFER_BIT); }));
    EXPECT_TRUE(fails([] { glBegin(GL_POINTS); }));
    EXPECT_TRUE(fails([] { glRecti(0, 0, 1, 1); }));
    EXPECT_TRUE(fails([] { pixel_at(0, 0); }));
    EXPECT_TRUE(fails([] { glCopyPixels(0, 0, 1, 1, GL_COLOR); }));
    EXPECT_TRUE(fails([] { glBitmap(0, 0, 0, 0, 0, 0, nullptr); }));
    EXPECT_TRUE(fails([] { glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 1, 1, 0); }));
    EXPECT_TRUE(
        fails([] { glBlitFramebuffer(0, 0, 1, 1, 0, 0, 1, 1, GL_COLOR_BUFFER_BIT, GL_NEAREST); }));
    glNewList(1, GL_COMPILE);
    glRecti(0, 0, 1, 1);
    glEndList();
    EXPECT_TRUE(fails([] { glCallList(1); }));
}

TEST(GlFramebuffers, WrongCallsSetErrors) {
    const Window window;
    const GLuint buffer = new_renderbuffer(GL_RGBA8, 4, 4), texture = new_texture(GL_RGB, 4, 4);
    attach_renderbuffer(buffer);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);  // framebuffer 0
    new_framebuffer();
    attach_renderbuffer(buffer, GL_COLOR_ATTACHMENT0 + 1);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
    attach_renderbuffer(buffer, GL_COLOR);
    EXPECT_GL_ERROR(GL_INVALID_ENUM);
    attach_renderbuffer(99);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
    attach_texture(99);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
    attach_texture(texture, 14);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
    glFramebufferTexture1D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_1D, texture, 0);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture, 0, 0);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);  // it has two dimensions
    glRenderbufferStorage(GL_RENDERBUFFER, GL_LUMINANCE, 4, 4);
    EXPECT_GL_ERROR(GL_INVALID_ENUM);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 8193, 4);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, integer(GL_MAX_SAMPLES) + 1, GL_RGBA8, 4, 4);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
    glDrawBuffer(GL_BACK);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
    glDrawBuffer(GL_COLOR_ATTACHMENT0 + 1);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
    glBlitFramebuffer(0, 0, 1, 1, 0, 0, 1, 1, 1, GL_NEAREST);
    EXPECT_GL_ERROR(GL_INVALID_VALUE);
    glBlitFramebuffer(0, 0, 1, 1, 0, 0, 1, 1, GL_DEPTH_BUFFER_BIT, GL_LINEAR);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
    glGenerateMipmap(GL_RGBA);
    EXPECT_GL_ERROR(GL_INVALID_ENUM);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDrawBuffer(GL_COLOR_ATTACHMENT0);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
}

TEST(GlFramebuffers, QueriesTellWhatIsAttached) {
    const Window window;
    const GLuint pair = new_renderbuffer(GL_DEPTH24_STENCIL8, 6, 5),
                 color = new_texture(GL_RGB, 6, 5);
    GLint value = 0;
    for (const auto& [name, expected] : {std::pair<GLenum, GLint>{GL_RENDERBUFFER_WIDTH, 6},
                                         {GL_RENDERBUFFER_HEIGHT, 5},
                                         {GL_RENDERBUFFER_INTERNAL_FORMAT, GL_DEPTH24_STENCIL8},
                                         {GL_RENDERBUFFER_RED_SIZE, 0},
                                         {GL_RENDERBUFFER_DEPTH_SIZE, 24},
                                         {GL_RENDERBUFFER_STENCIL_SIZE, 8},
                                         {GL_RENDERBUFFER_SAMPLES, 0}}) {
        glGetRenderbufferParameteriv(GL_RENDERBUFFER, name, &value);
        EXPECT_EQ(value, expected) << std::hex << name;
    }
    const GLint type = GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE;
    EXPECT_EQ(attachment_value(GL_FRONT_LEFT, type), GL_FRAMEBUFFER_DEFAULT);
    new_framebuffer();
    EXPECT_EQ(attachment_value(GL_COLOR_ATTACHMENT0, type), GL_NONE);
    EXPECT_EQ(attachment_value(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME), 0);
    EXPECT_GL_ERROR(GL_NO_ERROR);
    EXPECT_EQ(attachment_value(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE), -1);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
    attach_texture(color);
    attach_renderbuffer(pair, GL_DEPTH_STENCIL_ATTACHMENT);
    EXPECT_EQ(attachment_value(GL_COLOR_ATTACHMENT0, type), GL_TEXTURE);
    EXPECT_EQ(attachment_value(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME),
              GLint(color));
    EXPECT_EQ(attachment_value(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE), 0);
    EXPECT_EQ(attachment_value(GL_DEPTH_STENCIL_ATTACHMENT, type), GL_RENDERBUFFER);
    EXPECT_EQ(attachment_value(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE), 24);
    EXPECT_EQ(integer(GL_ALPHA_BITS), 0);
    EXPECT_EQ(integer(GL_STENCIL_BITS), 8);
    EXPECT_EQ(integer(GL_DRAW_BUFFER), GL_COLOR_ATTACHMENT0);
    EXPECT_EQ(integer(GL_MAX_COLOR_ATTACHMENTS), 1);
    EXPECT_EQ(integer(GL_MAX_RENDERBUFFER_SIZE), 8192);
    attach_renderbuffer(0, GL_STENCIL_ATTACHMENT);
    EXPECT_GL_ERROR(GL_NO_ERROR);
    attachment_value(GL_DEPTH_STENCIL_ATTACHMENT, type);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION);
}

/// Their names are the share group's; framebuffers are a context's own.
TEST(GlFramebuffers, ContextsShareRenderbuffersOnly) {
    Window window;
    const GLuint buffer = new_renderbuffer(GL_RGBA8, 4, 4), framebuffer = new_framebuffer();
    attach_renderbuffer(buffer);
    clear_to(10, 20, 30);
    {
        Context other(window.context.profile, window.context.shared);
        make_current(&other, nullptr, nullptr);
        EXPECT_TRUE(glIsRenderbuffer(buffer));
        EXPECT_FALSE(glIsFramebuffer(framebuffer));
        new_framebuffer();
        attach_renderbuffer(buffer);
        EXPECT_EQ(pixel_at(3, 3), (Bytes{10, 20, 30, 255})) << "without a window";
        clear_to(1, 2, 3);
        make_current(&window.context, &window.drawable);
    }
    EXPECT_EQ(pixel_at(0, 0), (Bytes{1, 2, 3, 255}));
    EXPECT_GL_ERROR(GL_NO_ERROR);
}

TEST(GlFramebuffers, DeletedImagesLeaveTheBoundFramebufferOnly) {
    const Window window;
    const GLuint texture = new_texture(GL_RGBA8, 4, 4), buffer = new_renderbuffer(GL_RGBA8, 4, 4);
    const GLuint kept = new_framebuffer();
    attach_texture(texture);
    clear_to(9, 8, 7);
    new_framebuffer();
    attach_texture(texture);
    glDeleteTextures(1, &texture);
    EXPECT_EQ(status(), GLenum(GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT));
    attach_renderbuffer(buffer);
    glDeleteRenderbuffers(1, &buffer);
    EXPECT_EQ(status(), GLenum(GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT));
    glBindFramebuffer(GL_FRAMEBUFFER, kept);
    EXPECT_EQ(status(), GLenum(GL_FRAMEBUFFER_COMPLETE));
    EXPECT_EQ(pixel_at(2, 2), (Bytes{9, 8, 7, 255}));
}

TEST(GlFramebuffers, WithoutAWindowTheirDefaultIsUndefined) {
    Context context(opengl());
    make_current(&context, nullptr, nullptr);
    EXPECT_EQ(status(), GLenum(GL_FRAMEBUFFER_UNDEFINED));
    new_framebuffer();
    attach_renderbuffer(new_renderbuffer(GL_RGBA8, 16, 16));
    glViewport(0, 0, 16, 16);
    glColor4ub(1, 2, 3, 4);
    fill();
    EXPECT_EQ(pixel_at(15, 0), (Bytes{1, 2, 3, 4}));
    make_current(nullptr, nullptr);
}

}  // namespace gw::gl
