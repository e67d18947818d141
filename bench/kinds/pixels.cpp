#include "bench/kinds/kinds.h"

#include <utility>

namespace gw::bench {

namespace {

constexpr int n = side;
constexpr GLbitfield color = GL_COLOR_BUFFER_BIT, depth = GL_DEPTH_BUFFER_BIT;

std::vector<unsigned char>& memory() {
    static std::vector<unsigned char> bytes(noise());
    return bytes;
}

void draw_triangles() {
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 20; ++i) {
        const float x = float(i) / 20;
        glColor3f(x, 1 - x, 0.5f);
        glVertex3f(-1 + 2 * x, -1, 0);
        glVertex3f(-0.9f + 2 * x, -1, 0.3f);
        glVertex3f(-0.5f + x, 1, 0.2f);
    }
    glEnd();
    glColor3f(1, 1, 1);
}

void draw_square(float size) {
    glEnable(GL_TEXTURE_2D);
    glBegin(GL_QUADS);
    for (const auto& [s, t] : {std::pair{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}}) {
        glTexCoord2f(s, t);
        glVertex2f(size * (2 * s - 1), size * (2 * t - 1));
    }
    glEnd();
    glDisable(GL_TEXTURE_2D);
}

/// Two textures that can be drawn to, and images with 4 samples.
struct Targets {
    GLuint texture[2] = {}, object[2] = {}, sampled = 0, given = 0;

    Targets() {
        for (int i = 0; i < 2; ++i) {
            texture[i] = make_texture(GL_TEXTURE_2D, GL_LINEAR);
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, n, n, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                         noise().data());
            glGenFramebuffers(1, &object[i]);
            glBindFramebuffer(GL_FRAMEBUFFER, object[i]);
            glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture[i],
                                   0);
            attach(0, GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8);
        }
        glGenFramebuffers(1, &sampled);
        glBindFramebuffer(GL_FRAMEBUFFER, sampled);
        attach(4, GL_COLOR_ATTACHMENT0, GL_RGBA8);
        attach(4, GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        given = make_texture(GL_TEXTURE_2D, GL_LINEAR);
    }

private:
    static void attach(int samples, GLenum point, GLenum format) {
        GLuint name = 0;
        glGenRenderbuffers(1, &name);
        glBindRenderbuffer(GL_RENDERBUFFER, name);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, n, n);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, name);
    }
};
Targets& targets() {
    static Targets all;
    return all;
}

void blit(GLuint from, GLuint to, int width, int bottom, int top, GLbitfield planes,
          GLenum filter = GL_NEAREST) {
    glBindFramebuffer(GL_FRAMEBUFFER, from);
    glClear(color | depth);
    draw_triangles();
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    glBlitFramebuffer(0, 0, n, n, 0, bottom, width, top, planes, filter);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}
Kind blit_kind(std::string name, GLuint Targets::*from, int width, int bottom, int top,
               GLbitfield planes, bool to_window, GLenum filter = GL_NEAREST) {
    return {"blit-" + std::move(name), [] {},
            [=] {
                const GLuint source = from ? targets().*from : targets().object[0];
                blit(source, to_window ? 0 : targets().object[1], width, bottom, top, planes,
                     filter);
            }};
}

Kind reading(std::string name, GLenum format, GLenum type) {
    return {"read-" + std::move(name), [] {},
            [=] {
                draw_triangles();
                glReadPixels(0, 0, n, n, format, type, memory().data());
            }};
}
Kind drawing(std::string name, GLenum format, GLenum type) {
    return {"draw-" + std::move(name), [] {},
            [=] {
                glRasterPos2f(-1, -1);
                glDrawPixels(n, n, format, type, noise().data());
            }};
}
Kind giving(std::string name, GLint internal_format, GLenum format, GLenum type) {
    return {"texture-" + std::move(name), [] {},
            [=] {
                glBindTexture(GL_TEXTURE_2D, targets().given);
                glTexImage2D(GL_TEXTURE_2D, 0, internal_format, n, n, 0, format, type,
                             noise().data());
                draw_square(0.1f);
            }};
}
Kind copying(std::string name, GLenum type, float zoom) {
    return {"copy-" + std::move(name), [] {},
            [=] {
                draw_triangles();
                glPixelZoom(zoom, 1);
                glRasterPos2f(zoom < 0 ? 0.99f : -0.99f, -0.99f);
                glCopyPixels(0, 0, n - 10, n - 10, type);
                glPixelZoom(1, 1);
            }};
}

void draw_to_texture() {
    glBindFramebuffer(GL_FRAMEBUFFER, targets().object[0]);
    glClear(color);
    draw_triangles();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glBindTexture(GL_TEXTURE_2D, targets().texture[0]);
    draw_square(0.9f);
}
/// Passes from one texture to the other, as filters of pictures make them.
void draw_by_turns() {
    for (int i = 0; i < 4; ++i) {
        glBindFramebuffer(GL_FRAMEBUFFER, targets().object[i % 2]);
        glBindTexture(GL_TEXTURE_2D, targets().texture[1 - i % 2]);
        draw_square(1);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}
void copy_to_texture(GLint internal_format) {
    draw_triangles();
    glBindTexture(GL_TEXTURE_2D, targets().given);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GLenum(internal_format), 0, 0, n, n, 0);
    draw_square(0.7f);
}
void accumulate() {
    draw_triangles();
    glAccum(GL_LOAD, 0.5f);
    glAccum(GL_ACCUM, 0.5f);
    glAccum(GL_RETURN, 1);
}

}  // namespace

std::vector<Kind> pixel_kinds() {
    const auto none = [] {};
    return {
        copying("colors", GL_COLOR, 1),
        copying("mirrored", GL_COLOR, -1),
        copying("stencils", GL_STENCIL, 1),
        {"copy-to-texture", none, [] { copy_to_texture(GL_RGBA); }},
        {"copy-depths-to-texture", none, [] { copy_to_texture(GL_DEPTH_COMPONENT24); }},
        {"draw-to-texture", none, draw_to_texture},
        {"draw-by-turns", none, draw_by_turns},
        blit_kind("equal", nullptr, n, 0, n, color, false),
        blit_kind("flipped", nullptr, n, n, 0, color, false),
        blit_kind("halved", nullptr, n / 2, 0, n / 2, color, false, GL_LINEAR),
        blit_kind("to-window", nullptr, n, 0, n, color, true),
        blit_kind("samples", &Targets::sampled, n, 0, n, color, false),
        blit_kind("samples-to-window", &Targets::sampled, n, 0, n, color | depth, true),
        reading("rgba", GL_RGBA, GL_UNSIGNED_BYTE),
        reading("rgb", GL_RGB, GL_UNSIGNED_BYTE),
        reading("bgra-words", GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV),
        reading("floats", GL_RGBA, GL_FLOAT),
        reading("depths", GL_DEPTH_COMPONENT, GL_FLOAT),
        reading("depths-stencils", GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8),
        reading("stencils", GL_STENCIL_INDEX, GL_UNSIGNED_BYTE),
        drawing("rgba", GL_RGBA, GL_UNSIGNED_BYTE),
        drawing("rgb", GL_RGB, GL_UNSIGNED_BYTE),
        drawing("luminance", GL_LUMINANCE, GL_UNSIGNED_BYTE),
        drawing("floats", GL_RGBA, GL_FLOAT),
        drawing("depths", GL_DEPTH_COMPONENT, GL_FLOAT),
        drawing("stencils", GL_STENCIL_INDEX, GL_UNSIGNED_BYTE),
        giving("rgba", GL_RGBA, GL_RGBA, GL_UNSIGNED_BYTE),
        giving("bgra-words", GL_RGBA, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV),
        giving("565", GL_RGB, GL_RGB, GL_UNSIGNED_SHORT_5_6_5),
        giving("4444", GL_RGBA, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4),
        giving("luminance", GL_LUMINANCE, GL_LUMINANCE, GL_UNSIGNED_BYTE),
        giving("floats", GL_RGBA, GL_RGBA, GL_FLOAT),
        giving("depths", GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT),
        {"get-texture", none,
         [] {
             glBindTexture(GL_TEXTURE_2D, targets().texture[0]);
             glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, memory().data());
         }},
        {"bitmap", none,
         [] {
             glRasterPos2f(-1, -1);
             glBitmap(n, n, 0, 0, 0, 0, noise().data());
         }},
        {"accumulate", none, accumulate},
    };
}

}  // namespace gw::bench
