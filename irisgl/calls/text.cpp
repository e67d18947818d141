// Characters and raster fonts.
#include "irisgl/calls/shared.h"
#include "irisgl/draw/primitives.h"
#include "irisgl/draw/screen_font.h"
#include "irisgl/state/program.h"

#include "generated/irisgl/calls.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace gw::irisgl::calls {

namespace {

const Font& font_of(short n) {
    auto& fonts = program().fonts;
    if (!fonts.contains(0)) fonts[0] = screen_font();
    const auto found = fonts.find(n);
    return found == fonts.end() ? fonts.at(0) : found->second;
}

const Font& font_now() { return font_of(state().now.font); }

const Glyph* glyph_of(const Font& font, char c) {
    const std::size_t i = static_cast<unsigned char>(c);
    return i < font.glyphs.size() ? &font.glyphs[i] : nullptr;
}

void fill_run(int x1, int x2, int y) {
    const Bounds& m = state().screen_mask;
    if (y < m.bottom || y > m.top) return;
    x1 = std::max(x1, m.left);
    x2 = std::min(x2, m.right);
    if (x1 <= x2) fill_pixels({x1, x2, y, y});
}

/// A row of a glyph: runs of set bits.
void draw_row(const Glyph& g, int row, int x, int y) {
    const int words = (g.w + 15) / 16;
    const auto bit = [&](int i) {
        return i < g.w && (g.rows[std::size_t(row * words + i / 16)] >> (15 - i % 16) & 1) != 0;
    };
    for (int i = 0; i < g.w; ++i) {
        if (!bit(i)) continue;
        int end = i;
        while (bit(end + 1)) ++end;
        fill_run(x + i, x + end, y);
        i = end;
    }
}

}  // namespace

void character_move(double x, double y, double z) {
    State& s = state();
    const dvec4 clip = clip_from_object({x, y, z, 1});
    const auto is_in = [&](double v) { return v >= -clip.w && v <= clip.w; };
    s.is_character_valid = clip.w > 0 && is_in(clip.x) && is_in(clip.y) && is_in(clip.z);
    if (!s.is_character_valid) return;
    const dvec3 at = *window_from_object({x, y, z, 1});
    s.character = {short(std::floor(at.x)), short(std::floor(at.y))};
}

void getcpos(short* x, short* y) {
    *x = state().character[0];
    *y = state().character[1];
}

void charstr(const std::string& text) {
    State& s = state();
    if (!s.is_character_valid) return;
    for (const char c : text) {
        const Glyph* const g = glyph_of(font_now(), c);
        if (g == nullptr) continue;
        for (int row = 0; row < g->h; ++row)
            draw_row(*g, row, s.character[0] + g->xoff, s.character[1] + g->yoff + row);
        s.character[0] = short(s.character[0] + g->width);
    }
}

void defrasterfont(short n, short height, short count, Fontchar* chars, short rasters,
                   unsigned short* raster) {
    if (n == 0 || chars == nullptr || raster == nullptr || count < 0)
        return warn("defrasterfont: font " + std::to_string(n) +
                    "; expected a number other than 0 and "
                    "characters; it is ignored");
    Font font{.glyphs = {}, .height = height, .descender = 0};
    for (int i = 0; i < count; ++i) {
        const Fontchar& c = chars[i];
        Glyph g{.w = c.w, .h = c.h, .xoff = c.xoff, .yoff = c.yoff, .width = c.width, .rows = {}};
        const int words = (c.w + 15) / 16 * c.h;
        if (c.offset + words > rasters) g.h = 0;
        for (int k = 0; g.h > 0 && k < words; ++k) g.rows.push_back(raster[c.offset + k]);
        font.descender = std::max(font.descender, -int(c.yoff));
        font.glyphs.push_back(std::move(g));
    }
    program().fonts[n] = std::move(font);
}

void font(short n) {
    if (n != 0 && !program().fonts.contains(n))
        warn("font: font " + std::to_string(n) + " is not defined; font 0 is taken");
    state().now.font = program().fonts.contains(n) ? n : short(0);
}
long getfont() { return state().now.font; }
long getheight() { return font_now().height; }
long getdescender() { return font_now().descender; }
long strwidth(const std::string& s) {
    long width = 0;
    for (const char c : s)
        if (const Glyph* const g = glyph_of(font_now(), c)) width += g->width;
    return width;
}

}  // namespace gw::irisgl::calls
