#include "gl/x11/surface.h"

#include "gl/x11/geometry.h"
#include "gl/x11/quiet_errors.h"

#include <algorithm>
#include <atomic>

namespace gw::gl::x11 {

namespace {

/// The name of a drawable in recordings: "window 2".
std::string recorded_name(Surface::Kind kind) {
    static std::atomic<int> count = 0;
    constexpr std::array words{"window ", "pixmap ", "pbuffer "};
    return words[std::size_t(kind)] + std::to_string(++count);
}

int size_on_machine(int pixels) { return std::clamp(pixels, 1, max_window_size); }

}  // namespace

Surface::Surface(Display* display, const XVisualInfo& visual, Buffers buffers, Kind kind,
                 XID target, int width, int height)
    : gl::Drawable(settings().profile, size_on_machine(width), size_on_machine(height),
                   recorded_name(kind), kind == Kind::Pixmap ? Buffers::Single : buffers),
      display_(display),
      kind_(kind),
      target_(target) {
    if (kind != Kind::Pbuffer)
        image_ = std::make_unique<ShownImage>(display, visual, target, height);
}

void Surface::present() {
    if (take_front_changed()) show();
}

void Surface::swap_buffers() {
    if (!is_double_buffered()) return;
    swap();
    follow_window();
}

// The display is locked before the drawable, as everywhere.
bool Surface::follow_window() {
    if (kind_ != Kind::Window) return true;
    if (image_->has_lost_display()) return false;
    const LockedDisplay locked(display_);
    const auto lock = exclusive();
    const std::optional<Geometry> window = geometry(display_, target_);
    if (!window) return false;
    image_->set_target_height(window->height);
    const int wide = size_on_machine(window->width), high = size_on_machine(window->height);
    if (wide != width() || high != height()) resize(wide, high);
    return true;
}

void Surface::show() {
    if (!image_ || image_->has_lost_display()) return;
    flush(Cause::Shown);
    const LockedDisplay locked(display_);
    const auto lock = exclusive();
    image_->show(*this);
}

void Surface::lose_display() {
    const auto lock = exclusive();
    if (image_) image_->lose_display();
}

}  // namespace gw::gl::x11
