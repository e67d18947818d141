// Framebuffer objects for tests: with images of a size, bound while the test draws.
#pragma once

#include "tests/gl/unit/support/window.h"

#include <GL/glext.h>

#include <cstdio>

namespace gw::gl {

using Bytes = std::array<GLubyte, 4>;

inline GLuint new_renderbuffer(GLenum format, int width, int height) {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
    return name;
}

/// A texture of two dimensions that is not filtered, without texels.
inline GLuint new_texture(GLint format, int width, int height) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    const bool is_depth = format == GL_DEPTH_COMPONENT24;
    glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0,
                 is_depth ? GL_DEPTH_COMPONENT : GL_RGBA, is_depth ? GL_FLOAT : GL_UNSIGNED_BYTE,
                 nullptr);
    return name;
}

/// A new framebuffer object, bound to draw and to read.
inline GLuint new_framebuffer() {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    return name;
}
inline void attach_texture(GLuint texture, GLint level = 0, GLenum point = GL_COLOR_ATTACHMENT0) {
    glFramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, texture, level);
}
inline void attach_renderbuffer(GLuint renderbuffer, GLenum point = GL_COLOR_ATTACHMENT0) {
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, renderbuffer);
}
inline GLenum status() { return glCheckFramebufferStatus(GL_FRAMEBUFFER); }

inline void clear_to(int red, int green, int blue, int alpha = 255) {
    glClearColor(float(red) / 255, float(green) / 255, float(blue) / 255, float(alpha) / 255);
    glClear(GL_COLOR_BUFFER_BIT);
}
inline Bytes pixel_at(int x, int y) {
    Bytes out{};
    glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, out.data());
    return out;
}
inline float depth_at(int x, int y) {
    float out = -1;
    glReadPixels(x, y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &out);
    return out;
}
/// A square over the whole viewport, textured from corner to corner.
inline void fill(float z = 0) {
    glBegin(GL_QUADS);
    for (const auto& [s, t] : {std::array{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}}) {
        glTexCoord2f(s, t);
        glVertex3f(2 * s - 1, 2 * t - 1, z);
    }
    glEnd();
}
inline GLint integer(GLenum name) {
    GLint out = -1;
    glGetIntegerv(name, &out);
    return out;
}
inline GLint attachment_value(GLenum point, GLenum name) {
    GLint out = -1;
    glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, point, name, &out);
    return out;
}
#define EXPECT_GL_ERROR(code) EXPECT_EQ(glGetError(), GLenum(code))

}  // namespace gw::gl
