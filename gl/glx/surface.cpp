#include "gl/glx/surface.h"

#include "gl/glx/displays.h"

#include <algorithm>
#include <atomic>

namespace gw::gl::glx {

namespace {

/// The name of a drawable in recordings: "window 2".
std::string recorded_name(Surface::Kind kind) {
    static std::atomic<int> count = 0;
    constexpr std::array words{"window ", "pixmap ", "pbuffer "};
    return words[std::size_t(kind)] + std::to_string(++count);
}

Buffers buffers_of(Surface::Kind kind, const Config& config) {
    return config.double_buffered && kind != Surface::Kind::Pixmap ? Buffers::Double
                                                                   : Buffers::Single;
}

int size_on_machine(int pixels) { return std::clamp(pixels, 1, max_window_size); }

}  // namespace

Surface::Surface(Display* display, const Config& config, Kind kind, XID target, int width,
                 int height)
    : gl::Drawable(settings().profile, size_on_machine(width), size_on_machine(height),
                   recorded_name(kind), buffers_of(kind, config)),
      display_(display),
      config_(config),
      kind_(kind),
      target_(target) {
    if (kind != Kind::Pbuffer)
        image_ = std::make_unique<ShownImage>(display, config.visual, target, height);
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
void Surface::follow_window() {
    if (kind_ != Kind::Window || !image_ || image_->has_lost_display()) return;
    const LockedDisplay locked(display_);
    const auto lock = exclusive();
    const std::optional<Geometry> window = geometry(display_, target_);
    if (!window) return;
    image_->set_target_height(window->height);
    const int wide = size_on_machine(window->width), high = size_on_machine(window->height);
    if (wide != width() || high != height()) resize(wide, high);
}

void Surface::show() {
    if (!image_ || image_->has_lost_display()) return;
    flush();
    const LockedDisplay locked(display_);
    const auto lock = exclusive();
    image_->show(*this);
}

void Surface::lose_display() {
    const auto lock = exclusive();
    if (image_) image_->lose_display();
}

}  // namespace gw::gl::glx
