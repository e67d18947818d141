// Pixels of the window in the program's memory.
#include "irisgl/calls/shared.h"
#include "irisgl/draw/apply.h"
#include "irisgl/draw/primitives.h"
#include "irisgl/state/program.h"

#include "generated/irisgl/calls.h"

#include <GL/gl.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
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
std::uint32_t gl_pixel(unsigned index) {
    return code().low(index) | code().high(index) << 8 | 0xFF000000u;
}

void select_read_buffer() {
    const State& s = state();
    const bool back =
        s.double_buffered && s.draw_mode == NORMALDRAW && s.pixels.source != SRC_FRONT;
    glReadBuffer(back ? GL_BACK : GL_FRONT);
}

/// Colours or depths of the buffer that OpenGL reads, as words of IRIS GL: an index, or R, G, B, A from
/// the lowest byte, or a signed depth.
Pixels32 read_selected(const Bounds& at, bool depths) {
    Pixels32 out(std::size_t(at.width()) * std::size_t(at.height()));
    const int x = at.left + state().viewport.left, y = at.bottom + state().viewport.bottom;
    if (depths) {
        std::vector<GLuint> values(out.size());
        glReadPixels(x, y, at.width(), at.height(), GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                     values.data());
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i] = std::uint32_t(long(values[i] >> 8) + z_min);
        return out;
    }
    glReadPixels(x, y, at.width(), at.height(), GL_RGBA, GL_UNSIGNED_BYTE, out.data());
    if (draws_indices())
        for (std::uint32_t& p : out) p = code().index(p & 0xFF, p >> 8 & 0xFF);
    return out;
}

/// The draw mode whose planes readsource names; 0: those of the draw mode.
long planes_of(long source) {
    return source == SRC_PUP     ? PUPDRAW
           : source == SRC_OVER  ? OVERDRAW
           : source == SRC_UNDER ? UNDERDRAW
                                 : 0;
}

Pixels32 read(const Bounds& at) {
    const long source = state().pixels.source, planes = planes_of(source);
    if (planes == 0) {
        select_read_buffer();
        return read_selected(at, source == SRC_ZBUFFER && state().draw_mode == NORMALDRAW);
    }
    const long mode = std::exchange(state().draw_mode, planes);
    current_window().select_planes();
    select_read_buffer();
    Pixels32 out = read_selected(at, false);
    state().draw_mode = mode;
    current_window().select_planes();
    return out;
}

/// Draws one rectangle of OpenGL's pixels, without the state that would change them.
void draw_words(const Bounds& at, const Pixels32& words, float zoom_x, float zoom_y) {
    glPushAttrib(GL_ENABLE_BIT | GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (const GLenum off : {GL_TEXTURE_2D, GL_TEXTURE_1D, GL_FOG, GL_LIGHTING}) glDisable(off);
    glPixelZoom(zoom_x, zoom_y);
    glWindowPos2i(at.left + state().viewport.left, at.bottom + state().viewport.bottom);
    glDrawPixels(at.width(), at.height(), GL_RGBA, GL_UNSIGNED_BYTE, words.data());
    glPixelZoom(1, 1);
    glPopAttrib();
}

/// Words of IRIS GL become depths.
void draw_depths(const Bounds& at, const Pixels32& words) {
    std::vector<GLuint> depths;
    for (const std::uint32_t word : words)
        depths.push_back(GLuint((std::int32_t(word << 8) >> 8) - z_min) << 8 |
                         GLuint((std::int32_t(word << 8) >> 8) - z_min) >> 16);
    glPushAttrib(GL_ENABLE_BIT | GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glDepthMask(GL_TRUE);
    glPixelZoom(state().pixels.zoom_x, state().pixels.zoom_y);
    glWindowPos2i(at.left + state().viewport.left, at.bottom + state().viewport.bottom);
    glDrawPixels(at.width(), at.height(), GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depths.data());
    glPixelZoom(1, 1);
    glPopAttrib();
}

/// With the write masks, zoomed, and into the depths if zdraw says so.
void write(const Bounds& at, Pixels32 words) {
    if (words.empty()) return;
    const State& s = state();
    if (s.draws_depth || s.pixels.memory.are_depths) draw_depths(at, words);
    if (s.pixels.memory.are_depths) return;
    if (draws_indices())
        for (std::uint32_t& word : words) word = gl_pixel(word & index_mask);
    draw_words(at, words, s.pixels.zoom_x, s.pixels.zoom_y);
}

/// Where the pixels of a rectangle are in the program's memory: a bit's number.
struct Layout {
    Bounds at;
    PixelMemory memory;
    long words_of_row() const {
        const long needed = (memory.offset + at.width() * memory.size + 31) / 32;
        return memory.stride > 0 ? memory.stride : needed;
    }
    std::size_t bit(int x, int y) const {
        const long row = memory.top_to_bottom ? at.height() - 1 - y : y;
        const long column = memory.right_to_left ? at.width() - 1 - x : x;
        return std::size_t(row * words_of_row() * 32 + memory.offset + column * memory.size);
    }
};

/// `size` bits of the program's memory, the highest of a word first; of 64 the lower 32.
std::uint32_t bits_of(Words p, std::size_t at, long size) {
    if (size == 32 && at % 32 == 0) return p.get(at / 32);
    std::uint32_t value = 0;
    for (long i = 0; i < size; ++i, ++at)
        value = value << 1 | (p.get(at / 32) >> (31 - at % 32) & 1);
    return value;
}

void set_bits(Words p, std::size_t at, long size, std::uint32_t value) {
    if (size == 32 && at % 32 == 0) return p.set(at / 32, value);
    for (long i = size - 1; i >= 0; --i, ++at) {
        const std::uint32_t one = std::uint32_t(1) << (31 - at % 32), old = p.get(at / 32);
        const bool on = i < 32 && (value >> i & 1) != 0;
        p.set(at / 32, on ? old | one : old & ~one);
    }
}

std::uint32_t shifted(std::uint32_t value, long by) { return by >= 0 ? value << by : value >> -by; }

std::uint32_t with_sum(std::uint32_t value, long add) {
    return (value & 0xFF000000u) | ((value + std::uint32_t(add)) & 0xFFFFFFu);
}

bool is_sane(const Bounds& at) { return at.width() <= 8192 && at.height() <= 8192; }

}  // namespace

Pixels32 read_rectangle(int left, int bottom, int width, int height) {
    const Bounds at{left, left + width - 1, bottom, bottom + height - 1};
    return is_sane(at) ? read(at) : Pixels32();
}

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
    const Layout layout{at, state().pixels.memory};
    const PixelMemory& m = layout.memory;
    for (int y = 0; y < at.height(); ++y)
        for (int x = 0; x < at.width(); ++x) {
            const std::uint32_t word = shifted(all[std::size_t(y * at.width() + x)], -m.shift);
            set_bits(p, layout.bit(x, y), m.size, m.add != 0 ? with_sum(word, m.add) : word);
        }
    return long(all.size());
}

void rectwrite(Screencoord x1, Screencoord y1, Screencoord x2, Screencoord y2, short* p) {
    const Bounds at = bounds_of(x1, y1, x2, y2);
    if (p == nullptr || !is_sane(at)) return;
    Pixels32 all;
    for (std::size_t i = 0; i < std::size_t(at.width()) * std::size_t(at.height()); ++i)
        all.push_back(std::uint16_t(p[i]));
    write(at, std::move(all));
}

void lrectwrite(Screencoord x1, Screencoord y1, Screencoord x2, Screencoord y2, Words p) {
    const Bounds at = bounds_of(x1, y1, x2, y2);
    if (!p.is_given() || !is_sane(at)) return;
    const Layout layout{at, state().pixels.memory};
    const PixelMemory& m = layout.memory;
    Pixels32 all;
    for (int y = 0; y < at.height(); ++y)
        for (int x = 0; x < at.width(); ++x) {
            std::uint32_t word = shifted(bits_of(p, layout.bit(x, y), m.size), m.shift);
            if (m.expands) word = (word & 1) != 0 ? m.c1 : m.c0;
            all.push_back(m.add != 0 ? with_sum(word, m.add) : word);
        }
    write(at, std::move(all));
}

void rectcopy(Screencoord x1, Screencoord y1, Screencoord x2, Screencoord y2, Screencoord x,
              Screencoord y) {
    const Bounds at = bounds_of(x1, y1, x2, y2);
    if (!is_sane(at)) return;
    write({x, x + at.width() - 1, y, y + at.height() - 1}, read(at));
}

void rectzoom(float x, float y) {
    if (!(x > 0 && y > 0 && x <= 4096 && y <= 4096))
        return warn("rectzoom: expected factors above 0, up to 4096; it is ignored");
    state().pixels.zoom_x = x;
    state().pixels.zoom_y = y;
}

void pixmode(long mode, long value) {
    PixelMemory& m = state().pixels.memory;
    const auto is_one_of = [&](std::initializer_list<long> values) {
        return std::find(values.begin(), values.end(), value) != values.end();
    };
    const long size = std::labs(value);
    bool valid = true;
    switch (mode) {
        case PM_SHIFT:
            valid = size < 32 && (size == 1 || size % 4 == 0) && size != 20 && size != 28;
            if (valid) m.shift = value;
            break;
        case PM_EXPAND: m.expands = value != 0; break;
        case PM_C0: m.c0 = std::uint32_t(value); break;
        case PM_C1: m.c1 = std::uint32_t(value); break;
        case PM_ADD24: m.add = value; break;
        case PM_SIZE:
            valid = is_one_of({1, 4, 8, 12, 16, 24, 32, 64});
            if (valid) m.size = value;
            break;
        case PM_OFFSET:
            valid = value >= 0 && value < 32;
            if (valid) m.offset = value;
            break;
        case PM_STRIDE:
            valid = value >= 0 && value <= 8192;
            if (valid) m.stride = value;
            break;
        case PM_TTOB: m.top_to_bottom = value != 0; break;
        case PM_RTOL: m.right_to_left = value != 0; break;
        case PM_ZDATA: m.are_depths = value != 0; break;
        default: valid = false;
    }
    if (!valid)
        warn("pixmode: mode " + std::to_string(mode) + " with value " + std::to_string(value) +
             "; expected PM_SHIFT to PM_ZDATA and a value of the manual's; it is ignored");
}

void readsource(long source) {
    if (source < SRC_AUTO || source > SRC_UNDER)
        return warn("readsource: " + std::to_string(source) +
                    "; expected SRC_AUTO to SRC_UNDER; it is ignored");
    state().pixels.source = source;
}

// Colours as they are shown, of the whole screen's pixels: those of the window.
long readdisplay(Screencoord x1, Screencoord y1, Screencoord x2, Screencoord y2, Words p,
                 unsigned long hints) {
    const Bounds at = bounds_of(x1, y1, x2, y2);
    if (!p.is_given() || !is_sane(at)) return 0;
    Window& w = current_window();
    w.show_front();
    const Planes& planes = w.shown();
    std::size_t i = 0;
    for (int y = at.bottom - w.y; y <= at.top - w.y; ++y)
        for (int x = at.left - w.x; x <= at.right - w.x; ++x) {
            const bool inside = x >= 0 && y >= 0 && x < w.width() && y < w.height();
            const std::uint32_t c = inside ? packed(planes.color[planes.index(x, y)]) : 0;
            p.set(i++, (hints & RD_ALPHAONE) != 0 ? c | 0xFF000000u : c);
        }
    return long(i);
}

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
    if (n <= 0 || r == nullptr || g == nullptr || b == nullptr) return 0;
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
    if (n <= 0 || r == nullptr || g == nullptr || b == nullptr) return;
    const int x = state().character[0] - state().viewport.left,
              y = state().character[1] - state().viewport.bottom;
    Pixels32 all;
    for (int i = 0; i < n; ++i)
        all.push_back(std::uint32_t(r[i]) | std::uint32_t(g[i]) << 8 | std::uint32_t(b[i]) << 16 |
                      0xFF000000u);
    write({x, x + n - 1, y, y}, std::move(all));
}

}  // namespace gw::irisgl::calls
