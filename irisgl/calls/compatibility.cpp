// Functions of the manual that concern other machines, and inquiries of the window's planes.
#include "irisgl/calls/shared.h"
#include "irisgl/draw/primitives.h"
#include "irisgl/state/program.h"

#include "generated/irisgl/calls.h"

#include "irisgl/include/gl/glws.h"

#include <GL/gl.h>

#include <algorithm>
#include <string>

namespace gw::irisgl::calls {

void nmode(long) {}  // normals always get the length 1

void displacepolygon(float scale) {
    (scale != 0 ? glEnable : glDisable)(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(scale, 0);
}

namespace {

void say_own_windows_only(const char* function) {
    warn(
        std::string(function) +
        " is not offered: programs draw into windows that winopen opens; it answers with an error");
}

}  // namespace

void* GLXgetconfig(void*, long, void*) {
    say_own_windows_only("GLXgetconfig");
    return nullptr;
}
long GLXlink(void*, void*) {
    say_own_windows_only("GLXlink");
    return GLWS_NOWINDOWCONFIG;
}
long GLXunlink(void*, unsigned long) { return GLWS_NOWINDOW; }
long GLXwinset(void*, unsigned long) {
    say_own_windows_only("GLXwinset");
    return GLWS_NOWINDOW;
}

void scrbox(long mode) {
    if (mode < SB_RESET || mode > SB_HOLD)
        return warn("scrbox: " + std::to_string(mode) +
                    "; expected SB_RESET, SB_TRACK or SB_HOLD; it is ignored");
    ScreenBox& box = state().box;
    if (mode == SB_RESET) box = {};
    box.is_tracked = mode == SB_TRACK;
}

void getscrbox(long* left, long* right, long* bottom, long* top) {
    const ScreenBox& box = state().box;
    *left = box.left;
    *right = box.right;
    *bottom = box.bottom;
    *top = box.top;
}

long getgconfig(long what) {
    if (program().current == nullptr) return -1;
    const State& s = state();
    switch (what) {
        case GC_BITS_CMODE: return s.rgb_mode ? 0 : index_bits;
        case GC_BITS_RED:
        case GC_BITS_GREEN:
        case GC_BITS_BLUE:
        case GC_BITS_ALPHA: return s.rgb_mode ? 8 : 0;
        case GC_BITS_ZBUFFER: return 24;
        case GC_ZMIN: return z_min;
        case GC_ZMAX: return z_max;
        case GC_BITS_STENCIL: return 8;
        case GC_BITS_ACBUF: return s.rgb_mode ? 16 : 0;
        case GC_DOUBLE: return s.double_buffered ? 1 : 0;
        case GC_MS_SAMPLES:
        case GC_BITS_MS_ZBUFFER:
        case GC_MS_ZMIN:
        case GC_MS_ZMAX:
        case GC_BITS_MS_STENCIL:
        case GC_STEREO: return 0;
    }
    return -1;
}

// "gethitcode: not recommended": clipping sets no bits here.
void clearhitcode() {}
long gethitcode() { return 0; }

// There are no textports, one monitor, planes of fixed sizes, one sample a pixel, and no stereo.
void textcolor(Colorindex) {}
void pagecolor(Colorindex) {}
void textinit() {}
long getothermonitor() { return 0; }
void RGBsize(unsigned long) {}
void zbsize(long) {}
void mssize(long, long, long) {}
void multisample(Boolean) {}
Boolean getmultisample() { return 0; }
void msalpha(long) {}
void msmask(float, Boolean) {}
void mspattern(long) {}
void mssample(long) {}
void monobuffer() {}
void stereobuffer() {}
void leftbuffer(Boolean) {}
void rightbuffer(Boolean) {}

}  // namespace gw::irisgl::calls
