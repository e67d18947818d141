// GLX's drawables: surfaces of X11 with a configuration.
#pragma once

#include "gl/glx/configs.h"
#include "gl/x11/surface.h"

namespace gw::gl::glx {

class Surface : public x11::Surface {
public:
    Surface(Display* display, const Config& config, Kind kind, XID target, int width, int height)
        : x11::Surface(display, config.visual,
                       config.double_buffered ? Buffers::Double : Buffers::Single, config.samples,
                       kind, target, width, height),
          config_(config) {}

    const Config& config() const { return config_; }

    bool has_glx_name = false;               ///< a window: glXCreateWindow gave it one
    unsigned long event_mask = 0;            ///< of glXSelectEvent
    bool preserved = true, largest = false;  ///< of a pbuffer

private:
    const Config config_;
};

}  // namespace gw::gl::glx
