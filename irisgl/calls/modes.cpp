// Colour modes, buffers, swaps, inquiries.
#include "irisgl/calls/shared.h"
#include "irisgl/draw/apply.h"
#include "irisgl/draw/primitives.h"
#include "irisgl/state/program.h"

#include "generated/irisgl/calls.h"

#include "gl/draw/finish.h"

#include <GL/gl.h>

#include <algorithm>
#include <cstring>
#include <map>

namespace gw::irisgl::calls {

namespace {

/// A change of the colour mode or of the buffers. Colours and masks begin anew, as after gconfig.
void change(bool& member, bool to) {
    if (member == to) return;
    current_window().show_front();
    member = to;
    state().now.planes[plane_of(NORMALDRAW)] = {};
    state().now.front = !state().double_buffered;
    state().now.back = true;
    apply_all();
}

}  // namespace

void cmode() { change(state().rgb_mode, false); }
void rgb_mode() { change(state().rgb_mode, true); }
void singlebuffer() { change(state().double_buffered, false); }
void doublebuffer() { change(state().double_buffered, true); }
void gconfig() {
    state().now.planes[plane_of(NORMALDRAW)] = {};
    apply_color_mask();
}

long getdisplaymode() {
    const State& s = state();
    if (s.rgb_mode) return s.double_buffered ? DMRGBDOUBLE : DMRGB;
    return s.double_buffered ? DMDOUBLE : DMSINGLE;
}
long getplanes() {
    const State& s = state();
    if (s.draw_mode == OVERDRAW) return current_window().aside_bits(0);
    if (s.draw_mode == UNDERDRAW) return current_window().aside_bits(1);
    if (s.draw_mode == PUPDRAW) return 2;
    return s.rgb_mode ? 24 : index_bits;
}
void overlay(long planes) { current_window().set_aside_bits(0, planes); }
void underlay(long planes) { current_window().set_aside_bits(1, planes); }

void drawmode(long mode) {
    if (mode != NORMALDRAW && mode != PUPDRAW && mode != OVERDRAW && mode != UNDERDRAW &&
        mode != CURSORDRAW)
        return warn(
            "drawmode: expected NORMALDRAW, PUPDRAW, OVERDRAW, UNDERDRAW or CURSORDRAW; it is "
            "ignored");
    if (mode == state().draw_mode) return;
    state().draw_mode = mode;
    if (mode == CURSORDRAW) return;  // only its map is used
    current_window().select_planes();
    apply_draw_mode();
}
long getdrawmode() { return state().draw_mode; }

void frontbuffer(Boolean on) {
    state().now.front = on != 0;
    apply_buffers();
}
void backbuffer(Boolean on) {
    state().now.back = on != 0;
    apply_buffers();
}
long getbuffer() {
    const State& s = state();
    if (!s.double_buffered) return 0;
    return (s.now.back ? BCKBUFFER : 0) | (s.now.front ? FRNTBUFFER : 0);
}

void swapbuffers() {
    Window& w = current_window();
    if (!w.state.double_buffered) {  // no buffers are exchanged; a loop of frames is shown and ends
        w.show_front();
        return next_frame();
    }
    gl::finish_frame(w.context);
    w.swap();
    next_frame();
}
void mswapbuffers(long which) {
    if ((which & NORMALDRAW) != 0) swapbuffers();  // the other planes have one buffer
}
void swapinterval(short) {}
void gflush() {
    current_window().show_front();
    pass(parts_of_flush);
}
void finish() { gflush(); }
void gsync() {
    wait_on_screen(1000 / 60);
    pass(parts_of_frame);
}
long sginap(long ticks) {
    gflush();
    wait_on_screen(int(std::clamp(ticks, 0L, 6000L)) * 10);
    pass(parts_of_frame);
    return 0;
}

void greset() {
    Window& w = current_window();
    const bool rgb = w.state.rgb_mode, twice = w.state.double_buffered;
    w.state = {};
    w.state.rgb_mode = rgb;
    w.state.double_buffered = twice;
    w.state.now.front = !twice;
    ortho2(-0.5f, float(w.width()) - 0.5f, -0.5f, float(w.height()) - 0.5f);
    w.state.viewport = w.state.screen_mask = {0, w.width() - 1, 0, w.height() - 1};
    reset_all();
}

long getgdesc(long what) {
    static const std::map<long, long> answers{{GD_XPMAX, 1280},
                                              {GD_YPMAX, 1024},
                                              {GD_XMMAX, 340},
                                              {GD_YMMAX, 270},
                                              {GD_ZMIN, z_min},
                                              {GD_ZMAX, z_max},
                                              {GD_BITS_NORM_SNG_RED, 8},
                                              {GD_BITS_NORM_SNG_GREEN, 8},
                                              {GD_BITS_NORM_SNG_BLUE, 8},
                                              {GD_BITS_NORM_DBL_RED, 8},
                                              {GD_BITS_NORM_DBL_GREEN, 8},
                                              {GD_BITS_NORM_DBL_BLUE, 8},
                                              {GD_BITS_NORM_SNG_CMODE, index_bits},
                                              {GD_BITS_NORM_DBL_CMODE, index_bits},
                                              {GD_BITS_NORM_ZBUFFER, 24},
                                              {GD_BITS_OVER_SNG_CMODE, 8},
                                              {GD_BITS_UNDR_SNG_CMODE, 8},
                                              {GD_BITS_PUP_SNG_CMODE, 2},
                                              {GD_BITS_NORM_SNG_ALPHA, 8},
                                              {GD_BITS_NORM_DBL_ALPHA, 8},
                                              {GD_BITS_CURSOR, 1},
                                              {GD_BLEND, 1},
                                              {GD_DITHER, 1},
                                              {GD_LINESMOOTH_RGB, 1},
                                              {GD_PNTSMOOTH_RGB, 1},
                                              {GD_LOGICOP, 1},
                                              {GD_NSCRNS, 1},
                                              {GD_NBLINKS, 20},
                                              {GD_NVERTEX_POLY, GD_NOLIMIT},
                                              {GD_READSOURCE, 1},
                                              {GD_READSOURCE_ZBUFFER, 1},
                                              {GD_WSYS, GD_WSYS_4S},
                                              {GD_ZDRAW_PIXELS, 1},
                                              {GD_NMMAPS, 16},
                                              {GD_TIMERHZ, 60},
                                              {GD_AFUNCTION, 1},
                                              {GD_BITS_ACBUF, 16},
                                              {GD_BITS_STENCIL, 8},
                                              {GD_CLIPPLANES, 6},
                                              {GD_FOGVERTEX, 1},
                                              {GD_FOGPIXEL, 1},
                                              {GD_LIGHTING_TWOSIDE, 1},
                                              {GD_POLYMODE, 1},
                                              {GD_POLYSMOOTH, 1},
                                              {GD_SUBPIXEL_LINE, 1},
                                              {GD_SUBPIXEL_PNT, 1},
                                              {GD_SUBPIXEL_POLY, 1},
                                              {GD_TEXTURE, 1},
                                              {GD_TEXTURE_PERSP, 1},
                                              {GD_SCRNTYPE, GD_SCRNTYPE_WM},
                                              {GD_BITS_NORM_SNG_MMAP, 8},
                                              {GD_BITS_NORM_DBL_MMAP, 8},
                                              {GD_OVERUNDER_SHARED, 0},
                                              {GD_CIFRACT, 1},
                                              {GD_CROSSHAIR_CINDEX, 1},
                                              {GD_LINESMOOTH_CMODE, 1},
                                              {GD_PNTSMOOTH_CMODE, 0},
                                              {GD_NURBS_ORDER, 8},
                                              {GD_TRIMCURVE_ORDER, 8},
                                              {GD_PATSIZE_64, 1},
                                              {GD_PUP_TO_OVERUNDER, 0},
                                              {GD_STEREO, 0},
                                              {GD_ZDRAW_GEOM, 1},
                                              {GD_TEXTPORT, 0},
                                              {GD_FRAMEGRABBER, 0},
                                              {GD_DBBOX, 0},
                                              {GD_ALPHA_OVERUNDER, 0},
                                              {GD_BITS_ACBUF_HW, 0},
                                              {GD_SCRBOX, 1},
                                              {GD_MUXPIPES, 0},
                                              {GD_MULTISAMPLE, 0},
                                              {GD_TEXTURE_3D, 0},
                                              {GD_TEXTURE_LUT, 0},
                                              {GD_TEXTURE_SHARP, 0},
                                              {GD_TEXTURE_DETAIL, 0},
                                              {GD_STEREO_IN_WINDOW, 0},
                                              {GD_BLENDCOLOR, 1},
                                              {GD_LIGHTING_SPOTLIGHT, 1},
                                              {GD_LIGHTING_ATT2, 1},
                                              {GD_AFUNCTION_MODES, 1}};
    const auto found = answers.find(what);
    return found == answers.end() ? -1 : found->second;
}

long gversion(char* v) {
    if (v != nullptr) std::strcpy(v, "GL4DVGX-4.0");
    return 0;
}

}  // namespace gw::irisgl::calls
