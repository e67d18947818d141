// GLX_SGI_swap_control and GLX_MESA_swap_control. The machine has no monitor: a swap never waits,
// and the interval is kept only to be asked for.
#include "gl/glx/current.h"

namespace {

thread_local int swap_interval = 0;

}  // namespace

#pragma GCC visibility push(default)
extern "C" {

int glXSwapIntervalSGI(int interval) {
    if (glXGetCurrentContext() == nullptr) return GLX_BAD_CONTEXT;
    if (interval <= 0) return GLX_BAD_VALUE;
    swap_interval = interval;
    return 0;
}

int glXSwapIntervalMESA(unsigned interval) {
    if (glXGetCurrentContext() == nullptr) return GLX_BAD_CONTEXT;
    swap_interval = int(interval);
    return 0;
}

int glXGetSwapIntervalMESA() { return swap_interval; }

}  // extern "C"
#pragma GCC visibility pop
