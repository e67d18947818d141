#include "irisgl/window/window.h"

#include "gl/draw/finish.h"
#include "gl/drawable/settings.h"
#include "irisgl/state/program.h"

#include <GL/gl.h>

#include <algorithm>
#include <utility>

namespace gw::irisgl {

class AsidePlanes : public gl::Drawable {
public:
    /// `which`: overlay, underlay, pop-up.
    AsidePlanes(Window& of, std::size_t which)
        : gl::Drawable(of.profile(), of.width(), of.height(), of.name() + words[which]),
          of_(of),
          which_(which) {}
    const Planes& shown() override { return of_.shown(); }
    gl::ShownIndices shown_indices() const override;
    bool take_changed() { return take_front_changed(); }

private:
    static constexpr std::array words{" overlay", " underlay", " pop-up"};

    Window& of_;
    std::size_t which_;
};

void PopupPlanes::fit(int w, int h) {
    if (w == width && h == height && !pixels.empty()) return;
    width = w;
    height = h;
    pixels.assign(std::size_t(w) * std::size_t(h), 0);
}

void PopupPlanes::clear() {
    std::fill(pixels.begin(), pixels.end(), std::uint8_t(0));
    is_used = false;
}

Window::Window(long id, int width, int height, std::unique_ptr<HostWindow> host)
    : gl::Drawable(gl::settings().profile, width, height, "window " + std::to_string(id),
                   gl::Buffers::Double),
      context(gl::settings().profile),
      id_(id),
      host_(std::move(host)) {
    state.viewport = state.screen_mask = {0, width - 1, 0, height - 1};
}

Window::~Window() {
    if (program().current == this) gl::make_current(nullptr, nullptr);
    end_background();
}

std::uint32_t Window::count_call() {
    if (std::exchange(call_frame_, frame()) != frame()) next_call_ = 0;
    return next_call_++;
}

void Window::make_current() {
    program().current = this;
    select_planes();
}

void Window::select_planes() {
    const long mode = state.draw_mode;
    gl::Drawable* to = this;
    if (mode == OVERDRAW || mode == UNDERDRAW || mode == PUPDRAW) {
        const std::size_t which = mode == UNDERDRAW ? 1 : mode == PUPDRAW ? 2 : 0;
        if (!aside_[which]) aside_[which] = std::make_unique<AsidePlanes>(*this, which);
        to = aside_[which].get();
    }
    gl::make_current(&context, to);
}

void Window::set_aside_bits(int which, long bits) {
    aside_bits_[std::size_t(which)] = int(std::clamp(bits, 0L, 8L));
}

void Window::take_size(int w, int h) {
    if (w == width() && h == height()) return;
    gl::make_current(nullptr, nullptr);
    resize(w, h);
    for (auto& planes : aside_) planes = nullptr;
    popup = {};
    if (program().current == this) select_planes();
}

void Window::show_front() {
    if (program().current == this) gl::finish_drawing(context);
    show_map();
}

void Window::show_map() {
    end_recolored_frame();
    for (const auto& planes : aside_)
        if (planes) planes->end_recolored_frame();
    present();
}

void Window::show_again() {
    if (host_ == nullptr) return;
    if (program().current == this) gl::finish_drawing(context);
    pixels_.resize(std::size_t(width()) * std::size_t(height()));
    read_packed(gw::ReadBuffer::Front, {0, 0, width(), height()}, gl::Cause::Shown, pixels_);
    compose(pixels_);
    host_->show(pixels_, width(), height());
    shown_map_ = program().colors.changes;
}

void Window::present() {
    if (host_ == nullptr) return;
    bool is_changed = take_front_changed() || shown_map_ != program().colors.changes;
    for (const auto& planes : aside_) is_changed |= planes && planes->take_changed();
    if (is_changed) {
        pixels_.resize(std::size_t(width()) * std::size_t(height()));
        read_packed(gw::ReadBuffer::Front, {0, 0, width(), height()}, gl::Cause::Shown, pixels_);
        compose(pixels_);
        host_->show(pixels_, width(), height());
        shown_map_ = program().colors.changes;
    }
}

namespace {

MapEntry mapped(const ColorMap& map, unsigned index) {
    const auto blink = map.blinks.find(index);
    if (blink != map.blinks.end() && blink->second.shows_other) return blink->second.other;
    return map.entries[map.place(index)];
}

std::uint32_t with_gamma(const ColorMap& map, std::uint32_t c) {
    return std::uint32_t(map.gamma[0][c & 0xFF]) | std::uint32_t(map.gamma[1][c >> 8 & 0xFF]) << 8 |
           std::uint32_t(map.gamma[2][c >> 16 & 0xFF]) << 16;
}

}  // namespace

gl::ShownIndices Window::shown_indices() const {
    if (state.rgb_mode) return {};
    const ColorMap& map = program().colors;
    gl::ShownIndices out{.bits = index_bits, .bits_in_r = std::min(profile().color_bits, 8)};
    for (unsigned i = 0; i <= index_mask; ++i)
        out.entries.push_back(with_gamma(map, mapped(map, i)));
    return out;
}

gl::ShownIndices AsidePlanes::shown_indices() const {
    const ColorMap& map = program().colors;
    gl::ShownIndices out{.planes = static_cast<gl::IndexPlanes>(which_ + 1),
                         .bits = of_.aside_index_bits(which_)};
    for (unsigned i = 0; i < 1u << out.bits; ++i)
        out.entries.push_back(with_gamma(map, map.aside[which_][i]));
    return out;
}

void Window::compose(std::span<std::uint32_t> pixels) {
    const ColorMap& map = program().colors;
    const IndexColor code{std::min(profile().color_bits, 8)};
    if (!state.rgb_mode)
        for (std::uint32_t& p : pixels) {
            const unsigned index = code.index(p & 0xFF, p >> 8 & 0xFF);
            p = mapped(map, index) | (index == 0 ? 0u : 0xFF000000u);
        }
    for (const std::size_t which : {1u, 0u, 2u}) {
        if (!aside_[which]) continue;
        const unsigned mask = (1u << aside_index_bits(which)) - 1;
        aside_[which]->flush(gl::Cause::Copy);
        const Planes& planes = aside_[which]->planes();
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const unsigned index = planes.color[i][0] & mask;
            const bool covers = index != 0 && (which != 1 || (pixels[i] & 0xFF000000u) == 0);
            if (covers) pixels[i] = map.aside[which][index] | 0xFF000000u;
        }
    }
    for (std::size_t i = 0; popup.is_used && i < pixels.size(); ++i)
        if (popup.pixels[i] != 0) pixels[i] = map.aside[2][popup.pixels[i]];
    for (std::uint32_t& p : pixels) p = with_gamma(map, p) | 0xFF000000u;
}

const Planes& Window::shown() {
    const Planes& now = planes();
    shown_ = Planes();
    shown_.width = now.width;
    shown_.height = now.height;
    pixels_.resize(now.color.size());
    const int bits = profile().color_bits;
    for (std::size_t i = 0; i < now.color.size(); ++i) {
        Rgba c = now.color[i];
        if (bits > 8)
            for (std::uint16_t& v : c) v = std::uint16_t(v >> (bits - 8));
        pixels_[i] = packed(c);
    }
    compose(pixels_);
    shown_.color.resize(pixels_.size());
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        shown_.color[i] = unpacked(pixels_[i]);
        if (bits > 8)
            for (std::uint16_t& v : shown_.color[i])
                v = std::uint16_t(v * ((1u << bits) - 1) / 255);
    }
    return shown_;
}

}  // namespace gw::irisgl
