// Programs of two dimensions: pixels, bitmaps, reading back.
#include "bench/programs/program.h"
#include "bench/programs/shapes.h"

#include <vector>

namespace gw::bench {

namespace {

constexpr GLuint glyphs = 100;
constexpr unsigned char glyph_rows[] = {0x00, 0xC6, 0xC6, 0xFE, 0xC6, 0x6C, 0x38, 0x10};

/// A font of bitmaps, as glXUseXFont and GLUT make it.
void begin_text() {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (GLuint i = 0; i < 128; ++i) {
        unsigned char rows[8];
        for (unsigned k = 0; k < 8; ++k)
            rows[k] = static_cast<unsigned char>(glyph_rows[k] ^ (i * k));
        glNewList(glyphs + i, GL_COMPILE);
        glBitmap(8, 8, 0, 0, 8, 0, rows);
        glEndList();
    }
    glListBase(glyphs);
}

/// Windows of a tool: panels, frames, buttons, and text in bitmaps.
void draw_text(int frame) {
    look_at_pixels();
    glClear(GL_COLOR_BUFFER_BIT);
    for (int i = 0; i < 40; ++i) {
        const int x = i % 5 * (window_width / 5), y = i / 5 * (window_height / 8);
        glColor3f(0.3f, 0.3f, 0.4f);
        glRecti(x + 2, y + 2, x + window_width / 5 - 2, y + window_height / 8 - 2);
        glColor3f(0.8f, 0.8f, 0.9f);
        glBegin(GL_LINE_LOOP);
        glVertex2i(x + 2, y + 2);
        glVertex2i(x + window_width / 5 - 2, y + 2);
        glVertex2i(x + window_width / 5 - 2, y + window_height / 8 - 2);
        glVertex2i(x + 2, y + window_height / 8 - 2);
        glEnd();
    }
    glColor3f(1, 1, 0.6f);
    for (int line = 0; line < 40; ++line) {
        char text[60];
        for (int k = 0; k < 60; ++k) text[k] = char('!' + (line * 7 + k + frame) % 90);
        glRasterPos2i(10, 6 + line * 11);
        glCallLists(60, GL_UNSIGNED_BYTE, text);
    }
}

/// An image viewer: DrawPixels, once as it is and once zoomed.
void draw_image(int frame) {
    static const std::vector<unsigned char> image = noise_image(256, 21);
    look_at_pixels();
    glClear(GL_COLOR_BUFFER_BIT);
    glPixelZoom(1, 1);
    glRasterPos2i(frame % 32, 0);
    glDrawPixels(256, 256, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
    glPixelZoom(1.5f, 1.5f);
    glRasterPos2i(250, 60);
    glDrawPixels(256, 200, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
}

/// A lit torus that the program reads back, as to save a film.
void draw_and_read(int frame) {
    static std::vector<unsigned char> pixels;
    look_from(4);
    glRotatef(2 * float(frame), 1, 1, 0);
    clear_all();
    glCallList(1);
    pixels.resize(std::size_t(window_width * window_height * 4));
    glReadPixels(0, 0, window_width, window_height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
}

void begin_read() {
    glEnable(GL_DEPTH_TEST);
    light_scene(1);
    glNewList(1, GL_COMPILE);
    draw_torus(0.5f, 1.2f, 40, 80);
    glEndList();
}

}  // namespace

std::vector<Program> pixel_programs() {
    return {{"text", "panels, outlines and 2,400 bitmap letters", begin_text, draw_text},
            {"image", "DrawPixels, plain and zoomed", [] {}, draw_image},
            {"read", "ReadPixels of each frame", begin_read, draw_and_read}};
}

}  // namespace gw::bench
