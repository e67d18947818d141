// Cursors: their images, colours and types.
#include "irisgl/calls/shared.h"
#include "irisgl/state/program.h"
#include "irisgl/window/window.h"

#include "generated/irisgl/calls.h"

#include <string>
#include <utility>

namespace gw::irisgl::calls {

namespace {

/// 1 .. 3 of the four values of a pixel: the maps' entries of CURSORDRAW.
void show_cursor() {
    Program& p = program();
    for (auto& [id, window] : p.windows) {
        if (window->host() == nullptr) continue;
        const auto found = p.cursors.find(p.cursor);
        if (!p.is_cursor_on)
            window->host()->show_cursor(false);
        else if (p.cursor == 0 || found == p.cursors.end())
            window->host()->show_cursor(true);
        else
            window->host()->show_image(found->second, p.colors.aside[3]);
    }
}

}  // namespace

long cursor_words() {
    constexpr long words[] = {16, 32, 64, 128, 0};
    return words[program().cursor_type];
}

void curstype(long type) {
    if (type < C16X1 || type > CCROSS)
        return warn("curstype: " + std::to_string(type) +
                    "; expected C16X1 to CCROSS; it is ignored");
    program().cursor_type = std::size_t(type);
}

void defcursor(short n, Values image) {
    if (n == 0) return warn("defcursor: cursor 0 is the arrow; it is ignored");
    const std::size_t type = program().cursor_type;
    if (type != CCROSS && image.empty()) return warn("defcursor: no image is given; it is ignored");
    CursorImage made;
    made.size = type == C32X1 || type == C32X2 ? 32 : 16;
    made.is_cross = type == CCROSS;
    if (made.is_cross) made.x = made.y = 15;
    const std::size_t row_words = std::size_t(made.size) / 16,
                      plane = row_words * std::size_t(made.size);
    made.pixels.assign(std::size_t(made.size * made.size), 0);
    for (std::size_t i = 0; i < made.pixels.size() && !image.empty(); ++i) {
        const std::size_t x = i % std::size_t(made.size), y = i / std::size_t(made.size);
        for (std::size_t bit = 0; (bit + 1) * plane <= image.size(); ++bit)
            if ((unsigned(image[bit * plane + y * row_words + x / 16]) >> (15 - x % 16) & 1) != 0)
                made.pixels[i] = std::uint8_t(made.pixels[i] | 1u << bit);
    }
    program().cursors[n] = std::move(made);
    show_cursor();
}

void curorigin(short n, short x, short y) {
    const auto found = program().cursors.find(n);
    if (found == program().cursors.end())
        return warn("curorigin: cursor " + std::to_string(n) + " is not defined; it is ignored");
    if (x < 0 || y < 0 || x >= found->second.size || y >= found->second.size)
        return warn("curorigin: the origin is outside the image; it is ignored");
    found->second.x = x;
    found->second.y = y;
    show_cursor();
}

void setcursor(short n, Colorindex, Colorindex) {
    if (n != 0 && !program().cursors.contains(n))
        return warn("setcursor: cursor " + std::to_string(n) + " is not defined; it is ignored");
    program().cursor = n;
    show_cursor();
}

void getcursor(short* n, unsigned short* c, unsigned short* mask, long* on) {
    *n = program().cursor;
    *c = *mask = 0;
    *on = program().is_cursor_on ? 1 : 0;
}

void curson() {
    program().is_cursor_on = true;
    show_cursor();
}
void cursoff() {
    program().is_cursor_on = false;
    show_cursor();
}

void RGBcursor(short n, short r, short g, short b, short, short, short) {
    const auto byte = [](short v) { return MapEntry(v < 0 ? 0 : v > 255 ? 255 : v); };
    program().colors.aside[3][1] = byte(r) | byte(g) << 8 | byte(b) << 16;
    setcursor(n, 0, 0);
}

void gRGBcursor(short* n, short* r, short* g, short* b, short* rm, short* gm, short* bm, long* on) {
    const MapEntry c = program().colors.aside[3][1];
    *n = program().cursor;
    *r = short(c & 0xFF);
    *g = short(c >> 8 & 0xFF);
    *b = short(c >> 16 & 0xFF);
    *rm = *gm = *bm = 255;
    *on = program().is_cursor_on ? 1 : 0;
}

}  // namespace gw::irisgl::calls
