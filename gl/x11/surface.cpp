#include "gl/x11/surface.h"

#include "gl/x11/geometry.h"
#include "gl/x11/quiet_errors.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>

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

Surface::Surface(Display* display, const XVisualInfo& visual, Buffers buffers, int samples,
                 Kind kind, XID target, int width, int height)
    : gl::Drawable(settings().profile, size_on_machine(width), size_on_machine(height),
                   recorded_name(kind), kind == Kind::Pixmap ? Buffers::Single : buffers, samples),
      display_(display),
      kind_(kind),
      target_(target) {
    warn_of_size(width, height);
    if (kind != Kind::Pbuffer)
        image_ = std::make_unique<ShownImage>(display, visual, target, height);
}

void Surface::warn_of_size(int width, int height) {
    if (has_warned_ || (width <= max_window_size && height <= max_window_size)) return;
    has_warned_ = true;
    std::fprintf(stderr, "gw: warning: %s: %d x %d pixels; the machine draws at most %d x %d\n",
                 name().c_str(), width, height, max_window_size, max_window_size);
}

Surface::~Surface() { end_background(); }

void Surface::present() {
    if (take_front_changed()) show();
}

void Surface::wait_until_shown() {
    if (!image_ || image_->has_lost_display()) return;
    const LockedDisplay locked(display_);
    image_->wait();
}

std::optional<Surface::FrameTarget> Surface::frame_target() {
    if (kind_ != Kind::Window || image_->has_lost_display()) return std::nullopt;
    if (!own_) own_ = std::make_unique<OwnConnection>(display_);
    if (!own_->is_ready()) return std::nullopt;
    const auto words = image_->shared_words(width(), height(), profile().color_bits);
    if (!words) return std::nullopt;
    return FrameTarget{words->pixels, words->layout, [this, height = image_->target_height()] {
                           return image_->put(*own_, height);
                       }};
}

// When the program ends, Xlib does as well: nothing is shown.
//
// The server answers: what the program asked of the window before is done when the frame comes.
void Surface::swap_buffers() {
    const Background::Use use;
    if (!is_double_buffered() || !use) return;
    const std::optional<Geometry> window = window_size();
    if (window) {
        const LockedDisplay locked(display_);
        const auto lock = exclusive();
        image_->set_target_height(window->height);
        image_->fit(width(), height());
    }
    swap();
    if (window) take(*window);
}

bool Surface::follow_window() {
    if (kind_ != Kind::Window) return true;
    const std::optional<Geometry> window = window_size();
    if (window) take(*window);
    return window.has_value();
}

// The display is locked before the drawable, as everywhere.
std::optional<Geometry> Surface::window_size() const {
    if (kind_ != Kind::Window || image_->has_lost_display()) return std::nullopt;
    const LockedDisplay locked(display_);
    return geometry(display_, target_);
}

void Surface::take(const Geometry& window) {
    const auto lock = exclusive();
    image_->set_target_height(window.height);
    warn_of_size(window.width, window.height);
    const int wide = size_on_machine(window.width), high = size_on_machine(window.height);
    if (wide != width() || high != height()) resize(wide, high);
}

void Surface::show() {
    const Background::Use use;
    if (!image_ || image_->has_lost_display() || !use) return;
    flush(Cause::Shown);
    const LockedDisplay locked(display_);
    const auto lock = exclusive();
    image_->show(*this);
}

void Surface::lose_display() {
    const auto lock = exclusive();
    end_background();
    own_ = nullptr;
    if (image_) image_->lose_display();
}

}  // namespace gw::gl::x11
