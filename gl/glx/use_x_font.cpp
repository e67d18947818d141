// UseXFont: display lists of Bitmap calls from the glyphs of an X font. [GLX 1.4] 3.3.9. Its manual
// page has the origin of y as descent - 1: text is one row higher than X draws it.
#include "gl/glx/displays.h"

#include "gl/context/c_boundary.h"
#include "gl/glx/current.h"
#include "gl/x11/quiet_errors.h"

#include <X11/Xmd.h>
// The numbers of the requests.
#include <GL/glxproto.h>

namespace {

using namespace gw::gl;
using namespace gw::gl::glx;

/// A glyph as Bitmap takes it: bottom row first, the leftmost pixel in bit 7.
struct Glyph {
    int width = 0, height = 0;
    float x_origin = 0, y_origin = 0, advance = 0;
    std::vector<GLubyte> bits;
};

/// The metrics of a character; null: the font does not have it.
const XCharStruct* metrics(const XFontStruct& font, unsigned character) {
    const unsigned row = character >> 8, column = character & 0xFF;
    const unsigned columns = font.max_char_or_byte2 - font.min_char_or_byte2 + 1;
    const bool one_row = font.min_byte1 == 0 && font.max_byte1 == 0;
    const unsigned in_row = one_row ? character : column;
    if (in_row < font.min_char_or_byte2 || in_row > font.max_char_or_byte2) return nullptr;
    if (!one_row && (row < font.min_byte1 || row > font.max_byte1)) return nullptr;
    if (font.per_char == nullptr) return &font.max_bounds;
    const unsigned rows_before = one_row ? 0 : row - font.min_byte1;
    return &font.per_char[rows_before * columns + in_row - font.min_char_or_byte2];
}

/// Draws a character into a pixmap of depth 1 and reads it back.
void draw_glyph(Display* display, Font font, unsigned character, const XCharStruct& m, Glyph& out) {
    const auto width = unsigned(out.width), height = unsigned(out.height);
    const Pixmap pixmap =
        XCreatePixmap(display, RootWindow(display, DefaultScreen(display)), width, height, 1);
    XGCValues values{};
    values.font = font;
    values.foreground = 0;
    const GC gc = XCreateGC(display, pixmap, GCFont | GCForeground, &values);
    XFillRectangle(display, pixmap, gc, 0, 0, width, height);
    XSetForeground(display, gc, 1);
    const XChar2b text{static_cast<unsigned char>(character >> 8),
                       static_cast<unsigned char>(character & 0xFF)};
    XDrawString16(display, pixmap, gc, -m.lbearing, m.ascent, &text, 1);
    if (XImage* const image = XGetImage(display, pixmap, 0, 0, width, height, 1, XYPixmap)) {
        const std::size_t row = std::size_t(out.width + 7) / 8;
        for (int y = 0; y < out.height; ++y)
            for (int x = 0; x < out.width; ++x)
                if (XGetPixel(image, x, out.height - 1 - y) != 0)
                    out.bits[std::size_t(y) * row + std::size_t(x) / 8] |= GLubyte(0x80 >> x % 8);
        XDestroyImage(image);
    }
    XFreeGC(display, gc);
    XFreePixmap(display, pixmap);
}

Glyph glyph_of(Display* display, const XFontStruct& font, Font name, unsigned character) {
    Glyph out;
    const XCharStruct* const m = metrics(font, character);
    if (m == nullptr) return out;
    out.advance = float(m->width);
    out.width = m->rbearing - m->lbearing;
    out.height = m->ascent + m->descent;
    if (out.width <= 0 || out.height <= 0) return out.width = out.height = 0, out;
    out.x_origin = float(-m->lbearing);
    out.y_origin = float(m->descent - 1);
    out.bits.resize(std::size_t(out.width + 7) / 8 * std::size_t(out.height));
    draw_glyph(display, name, character, *m, out);
    return out;
}

/// Rows of bytes without gaps, as Glyph has them.
void set_unpack() {
    glPixelStorei(GL_UNPACK_SWAP_BYTES, GL_FALSE);
    glPixelStorei(GL_UNPACK_LSB_FIRST, GL_FALSE);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 0);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

}  // namespace

#pragma GCC visibility push(default)
extern "C" {

void glXUseXFont(Font name, int first, int count, int list) {
    at_c_boundary([&] {
        Display* const display = glXGetCurrentDisplay();
        if (display == nullptr || count <= 0) return;
        if (current->lists.open)
            return send_error(display, GlxError::ContextState, current_binding().context->name,
                              X_GLXUseXFont);
        XFontStruct* font = nullptr;
        {
            const x11::QuietErrors quiet(display);
            font = XQueryFont(display, name);
        }
        if (font == nullptr) return send_error(display, BadFont, name, X_GLXUseXFont);
        glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
        set_unpack();
        for (int i = 0; i < count; ++i) {
            const Glyph glyph = glyph_of(display, *font, name, unsigned(first + i));
            glNewList(GLuint(list + i), GL_COMPILE);
            glBitmap(glyph.width, glyph.height, glyph.x_origin, glyph.y_origin, glyph.advance, 0,
                     glyph.bits.data());
            glEndList();
        }
        glPopClientAttrib();
        XFreeFontInfo(nullptr, font, 1);
    });
}

}  // extern "C"
#pragma GCC visibility pop
