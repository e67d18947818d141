// A surface of GLX or EGL: a window, a pixmap or a pbuffer with a machine of its size.
#pragma once

#include "gl/x11/geometry.h"
#include "gl/x11/own_connection.h"
#include "gl/x11/shown_image.h"

#include <memory>
#include <optional>

namespace gw::gl::x11 {

class Surface : public gl::Drawable {
public:
    enum class Kind { Window, Pixmap, Pbuffer };
    /// A pixmap has one buffer: the pixmap. `target` is the X window or pixmap; 0 for a pbuffer,
    /// which needs no display and visual. Sizes beyond the machine's are cut off at the top and on
    /// the right.
    Surface(Display* display, const XVisualInfo& visual, Buffers buffers, int samples, Kind kind,
            XID target, int width, int height);
    ~Surface() override;

    Kind kind() const { return kind_; }
    XID target() const { return target_; }

    /// Shows the front buffer if it has changed.
    void present() override;
    void wait_until_shown() override;
    bool is_off_screen() const override { return kind_ == Kind::Pbuffer; }
    /// SwapBuffers: of double-buffered windows and pbuffers.
    void swap_buffers();
    /// Takes the window's present size. A new size makes new buffers. False if the window is gone.
    bool follow_window();

    /// The program closed the display: nothing is shown any more.
    void lose_display();

private:
    std::optional<FrameTarget> frame_target() override;
    void show();
    /// None: there is no window, or it is gone.
    std::optional<Geometry> window_size() const;
    void take(const Geometry& window);
    /// Says once that a part of the window is not drawn, if so.
    void warn_of_size(int width, int height);

    Display* const display_;
    const Kind kind_;
    const XID target_;
    bool has_warned_ = false;
    std::unique_ptr<ShownImage> image_;   ///< null: there is nowhere to show
    std::unique_ptr<OwnConnection> own_;  ///< for frames that are shown from another thread
};

}  // namespace gw::gl::x11
