// Pixels of the window in the program's memory.
#include "irisgl/calls/shared.h"
#include "irisgl/draw/apply.h"
#include "irisgl/draw/primitives.h"
#include "irisgl/state/program.h"

#include "generated/irisgl/calls.h"

#include <GL/gl.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace gw::irisgl::calls {

namespace {

using Pixels32 = std::vector<std::uint32_t>;

Bounds bounds_of(int x1, int y1, int x2, int y2) {
    return {std::min(x1, x2), std::max(x1, x2), std::min(y1, y2), std::max(y1, y2)};
}

/// In the memory of OpenGL: R lowest. Draws at whole pixels of the viewport's origin.
IndexColor code() { return IndexColor{std::min(current_window().profile().color_bits, 8)}; }

void select_read_buffer() {
    const State& s = state();
    const bool back =
        s.double_buffered && s.draw_mode == NORMALDRAW && s.pixels.source != SRC_FRONT;
    glReadBuffer(back ? GL_BACK : GL_FRONT);
}

/// Colours of the window, as words of IRIS GL: an index, or R, G, B, A from the lowest byte.
Pixels32 read(const Bounds& at) {
    Pixels32 out(std::size_t(at.width()) * std::size_t(at.height()));
    select_read_buffer();
    const int x = at.left + state().viewport.left, y = at.bottom + state().viewport.bottom;
    if (state().pixels.source == SRC_ZBUFFER) {
        std::vector<GLuint> depths(out.size());
        glReadPixels(x, y, at.width(), at.height(), GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                     depths.data());
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i] = std::uint32_t(long(depths[i] >> 8) + z_min);
        return out;
    }
    glReadPixels(x, y, at.width(), at.height(), GL_RGBA, GL_UNSIGNED_BYTE, out.data());
    if (draws_indices())
        for (std::uint32_t& p : out) p = code().index(p & 0xFF, p >> 8 & 0xFF);
    return out;
}

/// Draws one rectangle of OpenGL's pixels, without the state that would change them.
void draw_words(int x, int y, int width, int height, const Pixels32& words) {
    glPushAttrib(GL_ENABLE_BIT | GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (const GLenum off : {GL_TEXTURE_2D, GL_TEXTURE_1D, GL_FOG, GL_LIGHTING}) glDisable(off);
    glPixelZoom(state().pixels.zoom_x, state().pixels.zoom_y);
    glWindowPos2i(x + state().viewport.left, y + state().viewport.bottom);
    glDrawPixels(width, height, GL_RGBA, GL_UNSIGNED_BYTE, words.data());
    glPixelZoom(1, 1);
    glPopAttrib();
}

/// With the write mask: the pixels that are there keep the bits outside it.
void write(const Bounds& at, Pixels32 words) {
    if (words.empty()) return;
    if (!draws_indices()) return draw_words(at.left, at.bottom, at.width(), at.height(), words);
    const unsigned mask = planes_now().writemask & index_mask;
    Pixels32 old;
    if (mask != index_mask) old = read(at);
    for (std::size_t i = 0; i < words.size(); ++i) {
        unsigned index = words[i] & index_mask;
        if (!old.empty()) index = (index & mask) | (old[i] & ~mask);
        words[i] = code().low(index) | code().high(index) << 8 | 0xFF000000u;
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    draw_words(at.left, at.bottom, at.width(), at.height(), words);
}

/// The word of pixel (x, y) of a rectangle in the memory that pixmode describes.
std::size_t place(const Bounds& at, int x, int y) {
    const Pixels& p = state().pixels;
    const long stride = p.stride > 0 ? p.stride : at.width();
    const long row = p.top_to_bottom ? at.height() - 1 - y : y;
    const long column = p.right_to_left ? at.width() - 1 - x : x;
    return std::size_t(row * stride + column);
}

bool is_sane(const Bounds& at) { return at.width() <= 8192 && at.height() <= 8192; }

}  // namespace

long rectread(Screencoord x1, Screencoord y1, Screencoord x2, Screencoord y2, short* p) {
    const Bounds at = bounds_of(x1, y1, x2, y2);
    if (p == nullptr || !is_sane(at)) return 0;
    const Pixels32 all = read(at);
    for (std::size_t i = 0; i < all.size(); ++i) p[i] = short(all[i]);
    return long(all.size());
}

long lrectread(Screencoord x1, Screencoord y1, Screencoord x2, Screencoord y2, Words p) {
    const Bounds at = bounds_of(x1, y1, x2, y2);
    if (!p.is_given() || !is_sane(at)) return 0;
    const Pixels32 all = read(at);
    for (int y = 0; y < at.height(); ++y)
        for (int x = 0; x < at.width(); ++x)
            p.set(place(at, x, y), all[std::size_t(y * at.width() + x)]);
    return long(all.size());
}

void rectwrite(Screencoord x1, Screencoord y1, Screencoord x2, Screencoord y2, short* p) {
    const Bounds at = bounds_of(x1, y1, x2, y2);
    if (p == nullptr || !is_sane(at)) return;
    Pixels32 all;
    for (int i = 0; i < at.width() * at.height(); ++i) all.push_back(std::uint16_t(p[i]));
    write(at, std::move(all));
}

void lrectwrite(Screencoord x1, Screencoord y1, Screencoord x2, Screencoord y2, Words p) {
    const Bounds at = bounds_of(x1, y1, x2, y2);
    if (!p.is_given() || !is_sane(at)) return;
    Pixels32 all;
    for (int y = 0; y < at.height(); ++y)
        for (int x = 0; x < at.width(); ++x) all.push_back(p.get(place(at, x, y)));
    write(at, std::move(all));
}

void rectcopy(Screencoord x1, Screencoord y1, Screencoord x2, Screencoord y2, Screencoord x,
              Screencoord y) {
    const Bounds at = bounds_of(x1, y1, x2, y2);
    if (!is_sane(at)) return;
    write({x, x + at.width() - 1, y, y + at.height() - 1}, read(at));
}

void rectzoom(float x, float y) {
    state().pixels.zoom_x = x;
    state().pixels.zoom_y = y;
}

void pixmode(long mode, long value) {
    Pixels& p = state().pixels;
    if (mode == PM_TTOB)
        p.top_to_bottom = value != 0;
    else if (mode == PM_RTOL)
        p.right_to_left = value != 0;
    else if (mode == PM_STRIDE)
        p.stride = value;
    else if (mode < PM_SHIFT || mode > PM_ZDATA || (mode == PM_SIZE ? value != 32 : value != 0))
        warn("pixmode: mode " + std::to_string(mode) + " with value " + std::to_string(value) +
             " is not offered: words of 32 bits, TTOB, RTOL and STRIDE are; it is ignored");
}

void readsource(long source) { state().pixels.source = source; }

long readpixels(short n, Colorindex* c) {
    if (c == nullptr || n <= 0) return 0;
    const int x = state().character[0] - state().viewport.left,
              y = state().character[1] - state().viewport.bottom;
    const Pixels32 all = read({x, x + n - 1, y, y});
    for (std::size_t i = 0; i < all.size(); ++i) c[i] = Colorindex(all[i]);
    return n;
}
void writepixels(short n, Colorindex* c) {
    if (c == nullptr || n <= 0) return;
    const int x = state().character[0] - state().viewport.left,
              y = state().character[1] - state().viewport.bottom;
    write({x, x + n - 1, y, y}, Pixels32(c, c + n));
}
long read_rgb(short n, RGBvalue* r, RGBvalue* g, RGBvalue* b) {
    if (n <= 0) return 0;
    const int x = state().character[0] - state().viewport.left,
              y = state().character[1] - state().viewport.bottom;
    const Pixels32 all = read({x, x + n - 1, y, y});
    for (std::size_t i = 0; i < all.size(); ++i) {
        r[i] = RGBvalue(all[i]);
        g[i] = RGBvalue(all[i] >> 8);
        b[i] = RGBvalue(all[i] >> 16);
    }
    return n;
}
void write_rgb(short n, RGBvalue* r, RGBvalue* g, RGBvalue* b) {
    if (n <= 0) return;
    const int x = state().character[0] - state().viewport.left,
              y = state().character[1] - state().viewport.bottom;
    Pixels32 all;
    for (int i = 0; i < n; ++i)
        all.push_back(std::uint32_t(r[i]) | std::uint32_t(g[i]) << 8 | std::uint32_t(b[i]) << 16 |
                      0xFF000000u);
    write({x, x + n - 1, y, y}, std::move(all));
}

}  // namespace gw::irisgl::calls
