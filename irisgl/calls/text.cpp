// Characters and raster fonts.
#include "irisgl/calls/shared.h"
#include "irisgl/draw/picking.h"
#include "irisgl/draw/primitives.h"
#include "irisgl/draw/screen_font.h"
#include "irisgl/state/program.h"

#include "generated/irisgl/calls.h"

#include <GL/gl.h>

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
    if (x1 <= x2) fill_pixels({x1, x2, y, y}, state().character_depth);
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

void draw_text(const Font& font, const std::string& text) {
    State& s = state();
    if (!s.is_character_valid || gives_feedback()) return;
    // Characters have no pattern, texture or sides.
    glPushAttrib(GL_ENABLE_BIT | GL_POLYGON_BIT);
    for (const GLenum off : {GL_POLYGON_STIPPLE, GL_CULL_FACE, GL_TEXTURE_2D}) glDisable(off);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    for (const char c : text) {
        const Glyph* const g = glyph_of(font, c);
        if (g == nullptr) continue;
        for (int row = 0; row < g->h; ++row)
            draw_row(*g, row, s.character[0] + g->xoff, s.character[1] + g->yoff + row);
        s.character[0] = short(std::clamp(s.character[0] + g->width, -0x8000, 0x7FFF));
    }
    glPopAttrib();
}

long width_of(const Font& font, const std::string& text) {
    long width = 0;
    for (const char c : text)
        if (const Glyph* const g = glyph_of(font, c)) width += g->width;
    return width;
}

int scaled(int pixels, double k) { return int(std::floor(pixels * k + 0.5)); }

/// Each pixel has the bit of the pixel that its centre lies in.
Glyph scaled(const Glyph& g, double k) {
    Glyph out{.w = scaled(g.w, k),
              .h = scaled(g.h, k),
              .xoff = scaled(g.xoff, k),
              .yoff = scaled(g.yoff, k),
              .width = scaled(g.width, k),
              .rows = {}};
    const int words = (out.w + 15) / 16, old_words = (g.w + 15) / 16;
    out.rows.resize(std::size_t(words) * std::size_t(out.h));
    const auto from = [&](int i, int most) {
        return std::min(int(std::floor((i + 0.5) / k)), most - 1);
    };
    for (int y = 0; y < out.h; ++y)
        for (int x = 0; x < out.w; ++x) {
            const int at = from(x, g.w), row = from(y, g.h);
            if ((g.rows[std::size_t(row * old_words + at / 16)] >> (15 - at % 16) & 1) != 0)
                out.rows[std::size_t(y * words + x / 16)] |= std::uint16_t(0x8000 >> x % 16);
        }
    return out;
}

const Font* managed(const char* function, long font) {
    const auto found = program().managed_fonts.find(font);
    if (found != program().managed_fonts.end()) return &found->second.font;
    warn(std::string(function) + ": font " + std::to_string(font) +
         "; expected a font of fmfindfont or fmscalefont; it is ignored");
    return nullptr;
}

long new_managed_font(double size) {
    auto& fonts = program().managed_fonts;
    const Font& base = font_of(0);
    ManagedFont made{.size = size, .font = {}};
    const double k = size / base.height;
    made.font.height = scaled(base.height, k);
    made.font.descender = scaled(base.descender, k);
    for (const Glyph& g : base.glyphs) made.font.glyphs.push_back(scaled(g, k));
    const long number = fonts.empty() ? 1 : fonts.rbegin()->first + 1;
    fonts[number] = std::move(made);
    return number;
}

}  // namespace

namespace {

bool is_byte_string(const char* function, long type) {
    if (type != STR_B)
        warn(std::string(function) + ": type " + std::to_string(type) +
             " is not offered: characters have one byte, STR_B; it is ignored");
    return type == STR_B;
}

}  // namespace

void character_move(double x, double y, double z) {
    State& s = state();
    const dvec4 clip = clip_from_object({x, y, z, 1});
    s.character_depth = clip.w > 0 ? clip.z / clip.w : 0;
    const auto is_in = [&](double v) { return v >= -clip.w && v <= clip.w; };
    s.is_character_valid = clip.w > 0 && is_in(clip.x) && is_in(clip.y) && is_in(clip.z);
    if (!s.is_character_valid) return;
    const dvec3 at = *window_from_object({x, y, z, 1});
    s.character = {short(std::floor(at.x)), short(std::floor(at.y))};
    mark_character({at.x - 0.5, at.y - 0.5, double(z_min) + at.z * double(z_max - z_min)});
}

void getcpos(short* x, short* y) {
    *x = state().character[0];
    *y = state().character[1];
}

void charstr(const std::string& text) { draw_text(font_now(), text); }
void lcharstr(long type, const std::string& text) {
    if (is_byte_string("lcharstr", type)) charstr(text);
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
        if (c.offset + words > int(std::uint16_t(rasters))) g.h = 0;
        for (int k = 0; g.h > 0 && k < words; ++k) g.rows.push_back(raster[c.offset + k]);
        font.descender = std::max(font.descender, -int(c.yoff));
        font.glyphs.push_back(std::move(g));
    }
    program().fonts[n] = std::move(font);
}

// "The value of a character is the number that a string has for it": 0 to 255 here.
void deflfont(short n, short count, Lfontchar* chars, long rasters, unsigned short* raster) {
    if (n == 0 || chars == nullptr || raster == nullptr || count < 0 || rasters > most_values)
        return warn("deflfont: font " + std::to_string(n) +
                    "; expected a number other than 0 and characters; it is ignored");
    Font font{.glyphs = std::vector<Glyph>(256), .height = 0, .descender = 0};
    for (int i = 0; i < count; ++i) {
        const Lfontchar& c = chars[i];
        const long words = c.w > 0 && c.h > 0 ? (c.w + 15L) / 16 * c.h : 0;
        if (c.value > 255 || long(c.offset) + words > rasters) continue;
        Glyph& g = font.glyphs[c.value];
        g = {.w = words > 0 ? c.w : 0,
             .h = words > 0 ? c.h : 0,
             .xoff = c.xoff,
             .yoff = c.yoff,
             .width = c.xmove,
             .rows = {raster + c.offset, raster + c.offset + words}};
        font.height = std::max(font.height, c.h + c.yoff);
        font.descender = std::max(font.descender, -int(c.yoff));
    }
    font.height += font.descender;
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
long strwidth(const std::string& s) { return width_of(font_now(), s); }
long lstrwidth(long type, const std::string& s) {
    return is_byte_string("lstrwidth", type) ? strwidth(s) : 0;
}

// The font manager: its one face is font 0, whatever is asked for.

void fminit() {}
void fmenumerate(fmfaceproc proc) {
    char face[] = "Screen";
    if (proc != nullptr) proc(face);
}
fmfonthandle fmfindfont(const std::string& face) {
    if (face != "Screen") warn("fmfindfont: there is one face, Screen; it stands for " + face);
    return new_managed_font(1);
}
fmfonthandle fmscalefont(fmfonthandle font, double size) {
    if (managed("fmscalefont", font) == nullptr) return 0;
    const double to = program().managed_fonts[font].size * size;
    if (to > 0 && to <= 1000) return new_managed_font(to);
    warn("fmscalefont: a line of " + std::to_string(to) + " pixels; expected up to 1000");
    return 0;
}
void fmfreefont(fmfonthandle font) { program().managed_fonts.erase(font); }
void fmsetfont(fmfonthandle font) {
    if (managed("fmsetfont", font) != nullptr) program().managed_font = font;
}
long fmprstr(const std::string& s) {
    const Font* const font = managed("fmprstr", program().managed_font);
    if (font == nullptr) return -1;
    draw_text(*font, s);
    return width_of(*font, s);
}
long fmgetstrwidth(fmfonthandle font, const std::string& s) {
    const Font* const found = managed("fmgetstrwidth", font);
    return found == nullptr ? -1 : width_of(*found, s);
}
long fmgetfontinfo(fmfonthandle font, fmfontinfo* info) {
    const Font* const found = managed("fmgetfontinfo", font);
    if (found == nullptr || info == nullptr) return -1;
    *info = {};
    info->fixed_width = 1;
    info->height = info->ysize = found->height;
    info->yorig = found->descender;
    info->width = info->xsize = width_of(*found, "M");
    info->nglyphs = long(found->glyphs.size());
    return 0;
}

}  // namespace gw::irisgl::calls
