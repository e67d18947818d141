// The drawables of GLX: a window, a pixmap or a pbuffer with a machine of its size.
#pragma once

#include "gl/glx/configs.h"
#include "gl/glx/shown_image.h"

#include <memory>

namespace gw::gl::glx {

class Surface : public gl::Drawable {
public:
    enum class Kind { Window, Pixmap, Pbuffer };
    /// A pixmap has one buffer: the pixmap. `target` is the X window or pixmap; 0 for a pbuffer.
    /// Sizes beyond the machine's are cut off at the top and on the right.
    Surface(Display* display, const Config& config, Kind kind, XID target, int width, int height);

    Kind kind() const { return kind_; }
    XID target() const { return target_; }
    const Config& config() const { return config_; }

    /// Shows the front buffer if it has changed.
    void present() override;
    /// SwapBuffers: of double-buffered windows and pbuffers.
    void swap_buffers();
    /// Takes the window's present size. A new size makes new buffers.
    void follow_window();

    /// The program closed the display: nothing is shown any more.
    void lose_display();

    bool has_glx_name = false;               ///< a window: glXCreateWindow gave it one
    unsigned long event_mask = 0;            ///< of glXSelectEvent
    bool preserved = true, largest = false;  ///< of a pbuffer

private:
    void show();

    Display* const display_;
    const Config config_;
    const Kind kind_;
    const XID target_;
    std::unique_ptr<ShownImage> image_;  ///< null: there is nowhere to show
};

}  // namespace gw::gl::glx
