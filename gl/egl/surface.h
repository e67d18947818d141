// EGL's surfaces: surfaces of X11 with a configuration.
#pragma once

#include "gl/egl/configs.h"
#include "gl/x11/surface.h"

namespace gw::gl::egl {

struct Binding;

class Surface : public x11::Surface {
public:
    Surface(Display* native, const Config& config, Buffers buffers, Kind kind, XID target,
            int width, int height)
        : x11::Surface(native, config.visual, buffers, config.samples, kind, target, width, height),
          config_(config) {}

    const Config& config() const { return config_; }
    /// [EGL 1.5] 3.5: a pbuffer has a back buffer, a pixmap has not.
    EGLint render_buffer() const {
        return is_double_buffered() ? EGL_BACK_BUFFER : EGL_SINGLE_BUFFER;
    }

    bool largest = false;             ///< a pbuffer: LARGEST_PBUFFER
    EGLint mipmap_level = 0;          ///< of SurfaceAttrib
    const Binding* holder = nullptr;  ///< the thread whose context draws to it or reads from it

private:
    const Config config_;
};

}  // namespace gw::gl::egl
