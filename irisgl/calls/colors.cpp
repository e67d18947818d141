// Colours, the map, write masks, clearing.
#include "irisgl/calls/shared.h"
#include "irisgl/draw/apply.h"
#include "irisgl/draw/picking.h"
#include "irisgl/draw/primitives.h"
#include "irisgl/state/program.h"

#include "generated/irisgl/calls.h"

#include <GL/gl.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace gw::irisgl::calls {

namespace {

float channel(std::uint32_t pack, int i) { return float(pack >> 8 * i & 0xFF) / 255; }
vec4 unpacked_color(std::uint32_t pack) {
    return {channel(pack, 0), channel(pack, 1), channel(pack, 2), channel(pack, 3)};
}
short byte_of(float v) { return short(std::floor(std::clamp(v, 0.0f, 1.0f) * 255 + 0.5f)); }

MapEntry entry(long r, long g, long b) {
    const auto byte = [](long v) { return MapEntry(std::clamp(v, 0L, 255L)); };
    return byte(r) | byte(g) << 8 | byte(b) << 16;
}

/// The map of the draw mode; null: the index is too large.
MapEntry* map_place(unsigned index) {
    ColorMap& map = program().colors;
    const Window* const w = program().current;
    const long mode = w != nullptr ? w->state.draw_mode : NORMALDRAW;
    if (mode == NORMALDRAW)
        return index < map.entries.size() ? &map.entries[map.place(index)] : nullptr;
    const std::size_t which = mode == OVERDRAW     ? 0
                              : mode == UNDERDRAW  ? 1
                              : mode == CURSORDRAW ? 3
                                                   : 2;
    return index < 256 ? &map.aside[which][index] : nullptr;
}

void fill_viewport() {
    if (picks() || gives_feedback()) return;
    const State& s = state();
    const Bounds &v = s.viewport, &m = s.screen_mask;
    const Bounds both{std::max(v.left, m.left), std::min(v.right, m.right),
                      std::max(v.bottom, m.bottom), std::min(v.top, m.top)};
    if (both.left > both.right || both.bottom > both.top) return;
    fill_pixels(both);
}

/// glClear in the viewport and the screen mask.
void clear_planes(GLbitfield planes) {
    const Bounds &v = state().viewport, &m = state().screen_mask;
    const int left = std::max(v.left, m.left), bottom = std::max(v.bottom, m.bottom);
    glScissor(left, bottom, std::max(0, std::min(v.right, m.right) - left + 1),
              std::max(0, std::min(v.top, m.top) - bottom + 1));
    glClear(planes);
    apply_viewport();
}

bool is_mask_whole() {
    return draws_indices() ? (planes_now().writemask & index_mask) == index_mask
                           : planes_now().rgb_mask == 0xFFFFFFFF;
}

void set_clear_color(const PlaneState& p) {
    if (!draws_indices()) return glClearColor(p.rgb.x, p.rgb.y, p.rgb.z, p.rgb.w);
    const int bits = current_window().profile().color_bits;
    const IndexColor code{std::min(bits, 8)};
    const unsigned index = unsigned(std::clamp(std::floor(p.index + 0.5), 0.0, double(index_mask)));
    const float most = float((1 << bits) - 1);
    glClearColor(float(code.low(index)) / most, float(code.high(index)) / most, 0, 1);
}

void clear_color() {
    if (state().now.pattern == 0) {
        set_clear_color(planes_now());
        if (is_mask_whole()) write_all_bits();
        clear_planes(GL_COLOR_BUFFER_BIT);
        return apply_color_mask();
    }
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    fill_viewport();
    apply_depth();
    apply_polygons();
}

}  // namespace

void color_index(double index) {
    PlaneState& p = planes_now();
    p.index = std::clamp(index, 0.0, double(index_mask));
    if (!draws_indices()) warn("color: the window is in RGB mode; color is for colour map mode");
    state().is_lit = false;
}

void rgb(float r, float g, float b, float a) {
    State& s = state();
    planes_now().rgb = {r, g, b, a};
    if (s.bound.color_mode == LMC_COLOR) s.is_lit = false;
}
void rgb_bytes(double r, double g, double b) { rgba_bytes(r, g, b, 255); }
void rgba_bytes(double r, double g, double b, double a) {
    rgb(float(r / 255), float(g / 255), float(b / 255), float(a / 255));
}
void cpack(unsigned long c) {
    const vec4 v = unpacked_color(std::uint32_t(c));
    rgb(v.x, v.y, v.z, v.w);
}
long getcolor() { return long(planes_now().index); }
void gRGBcolor(short* r, short* g, short* b) {
    const vec4& c = planes_now().rgb;
    *r = byte_of(c.x);
    *g = byte_of(c.y);
    *b = byte_of(c.z);
}

void clear() {
    if (!state().double_buffered) pass(parts_of_flush);  // another picture begins
    clear_color();
}

void writemask(Colorindex mask) {
    planes_now().writemask = mask;
    apply_color_mask();
}
void RGBwritemask(short r, short g, short b) {
    wmpack(std::uint32_t(r & 0xFF) | std::uint32_t(g & 0xFF) << 8 | std::uint32_t(b & 0xFF) << 16 |
           0xFF000000u);
}
void wmpack(unsigned long mask) {
    planes_now().rgb_mask = std::uint32_t(mask);
    apply_color_mask();
}
long getwritemask() { return long(planes_now().writemask); }
void gRGBmask(short* r, short* g, short* b) {
    const std::uint32_t mask = planes_now().rgb_mask;
    *r = short(mask & 0xFF);
    *g = short(mask >> 8 & 0xFF);
    *b = short(mask >> 16 & 0xFF);
}

void mapcolor(Colorindex i, short r, short g, short b) {
    MapEntry* const place = map_place(i);
    if (place == nullptr)
        return warn("mapcolor: index " + std::to_string(i) + "; expected 0 to 4095; it is ignored");
    *place = entry(r, g, b);
    ++program().colors.changes;
}
void mapcolors(short first, short last, Values r, Values g, Values b) {
    for (std::size_t i = 0; first + long(i) <= last && i < r.size() && i < g.size() && i < b.size();
         ++i)
        mapcolor(Colorindex(first + int(i)), short(r[i]), short(g[i]), short(b[i]));
}
void getmcolor(Colorindex i, short* r, short* g, short* b) {
    const MapEntry* const place = map_place(i);
    const MapEntry c = place != nullptr ? *place : 0;
    *r = short(c & 0xFF);
    *g = short(c >> 8 & 0xFF);
    *b = short(c >> 16 & 0xFF);
}
void getmcolors(short first, short last, short* r, short* g, short* b) {
    if (r == nullptr || g == nullptr || b == nullptr) return;
    for (int i = first; i <= last; ++i) getmcolor(Colorindex(i), r++, g++, b++);
}
void gammaramp(Values r, Values g, Values b) {
    const Values all[] = {r, g, b};
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < 256; ++i)
            program().colors.gamma[c][i] = std::uint8_t(std::clamp(all[c][i], 0.0f, 255.0f));
    ++program().colors.changes;
}
void blink(short rate, Colorindex i, short r, short g, short b) {
    auto& blinks = program().colors.blinks;
    if (rate == -1) {
        blinks.clear();
    } else if (rate <= 0) {
        blinks.erase(i);
    } else if (!blinks.contains(i) && blinks.size() >= 20) {
        warn("blink: 20 colours blink; it is ignored");
    } else {
        blinks[i] = {.rate = rate, .other = entry(r, g, b)};
    }
    ++program().colors.changes;
}
void multimap() {
    program().colors.is_multi = true;
    ++program().colors.changes;
}
void onemap() {
    program().colors.is_multi = false;
    ++program().colors.changes;
}
void setmap(short number) {
    if (number < 0 || number > 15)
        return warn("setmap: map " + std::to_string(number) + "; expected 0 to 15; it is ignored");
    program().colors.number = unsigned(number);
    ++program().colors.changes;
}
long getmap() { return program().colors.is_multi ? long(program().colors.number) : 0; }
Boolean getcmmode() { return program().colors.is_multi ? CMAPMULTI : CMAPONE; }
void cyclemap(short duration, short map, short next) {
    if (map < 0 || map > 15 || next < 0 || next > 15)
        return warn("cyclemap: maps " + std::to_string(map) + " and " + std::to_string(next) +
                    "; expected 0 to 15; it is ignored");
    if (duration <= 0)
        program().colors.cycles.erase(unsigned(map));
    else
        program().colors.cycles[unsigned(map)] = {.duration = duration, .next = unsigned(next)};
}

// Depth

void zclear() {
    glClearDepth(1);
    glDepthMask(GL_TRUE);
    clear_planes(GL_DEPTH_BUFFER_BIT);
    apply_depth();
}

void czclear(unsigned long color, long depth) {
    PlaneState p = planes_now();
    p.index = double(color & index_mask);
    p.rgb = unpacked_color(std::uint32_t(color));
    set_clear_color(p);
    if (!state().double_buffered) pass(parts_of_flush);
    const bool is_farthest = depth == 0xFFFFFFFFL;  // all bits: programs wrote it for that
    glClearDepth(is_farthest ? 1 : depth_of(depth));
    glDepthMask(GL_TRUE);
    write_all_bits();
    clear_planes(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    apply_color_mask();
    apply_depth();
}

void zbuffer(Boolean on) {
    state().depth_test = on != 0;
    apply_depth();
    apply_blending();
}
Boolean getzbuffer() { return state().depth_test ? 1 : 0; }
void zfunction(long function) {
    if (function < ZF_NEVER || function > ZF_ALWAYS)
        return warn("zfunction: " + std::to_string(function) +
                    "; expected ZF_NEVER to ZF_ALWAYS; it is ignored");
    state().depth_function = function;
    apply_depth();
    apply_blending();
}
void zsource(long source) {
    if (source != ZSRC_DEPTH && source != ZSRC_COLOR)
        return warn("zsource: " + std::to_string(source) +
                    "; expected ZSRC_DEPTH or ZSRC_COLOR; it is ignored");
    state().compares_color = source == ZSRC_COLOR;
    apply_depth();
    apply_blending();
}
void zwritemask(unsigned long mask) {
    state().depth_write = mask != 0;
    if (mask != 0 && (mask & 0xFFFFFF) != 0xFFFFFF)
        warn("zwritemask: a mask of some bits; the machine writes depths whole or not at all");
    apply_depth();
}
void zdraw(Boolean on) { state().draws_depth = on != 0; }
void lsetdepth(long near_, long far_) {
    state().near = std::int32_t(std::uint32_t(near_));
    state().far = std::int32_t(std::uint32_t(far_));
    apply_depth();
}
void setdepth(long near_, long far_) { lsetdepth(near_, far_); }
void lgetdepth(long* near_, long* far_) {
    *near_ = state().near;
    *far_ = state().far;
}
void getdepth(short* near_, short* far_) {
    *near_ = short(state().near);
    *far_ = short(state().far);
}
void depthcue(Boolean on) { state().cue.on = on != 0; }
Boolean getdcm() { return state().cue.on; }
void lshaderange(Colorindex low, Colorindex high, long near_, long far_) {
    DepthCue& cue = state().cue;
    cue.low = low;
    cue.high = high;
    cue.near = near_;
    cue.far = far_;
}
void lRGBrange(short r1, short g1, short b1, short r2, short g2, short b2, long near_, long far_) {
    DepthCue& cue = state().cue;
    cue.rgb = {float(r1), float(g1), float(b1), float(r2), float(g2), float(b2)};
    cue.near = near_;
    cue.far = far_;
}

}  // namespace gw::irisgl::calls
