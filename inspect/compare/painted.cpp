#include "inspect/compare/painted.h"

namespace gw::inspect {
namespace {

Paint paint_of(const Command& command) {
    const auto is_textured = [](const auto* c) { return c && c->map.enabled(); };
    const bool textured =
        is_textured(std::get_if<Draw>(&command)) || is_textured(std::get_if<DrawPixels>(&command));
    return textured ? Paint::Textured : Paint::Plain;
}

}  // namespace

Painted::Painted(const Recording& recording)
    : FollowingObserver(recording),
      width_(recording.width),
      front_(std::size_t(recording.width) * std::size_t(recording.height)),
      back_(front_) {}

void Painted::begin_command(std::size_t place) {
    FollowingObserver::begin_command(place);
    paint_ = paint_of(command());
    if (std::holds_alternative<SwapBuffers>(command())) {
        front_.swap(back_);
        has_exchanged_ = true;
    }
    if (std::holds_alternative<BeginPass>(command())) has_exchanged_ = false;
    if (const auto* set = std::get_if<SetState>(&command()))
        drawn_ = set->state->draw_buffer == DrawBuffer::Back ? Plane::Back : Plane::Color;
}

void Painted::paint(int x, int y, Paint paint, const PixelValues& before,
                    const PixelValues& after) {
    const std::size_t i = std::size_t(y) * std::size_t(width_) + std::size_t(x);
    if (before.color != after.color) front_[i] = paint;
    if (before.back != after.back) back_[i] = paint;
}

void Painted::fragment(const Fragment& f, Fate fate, const PixelValues& before,
                       const PixelValues& after) {
    if (fate == Fate::Written)
        paint(f.x, f.y, f.coverage != 0 ? Paint::Smooth : paint_, before, after);
}

void Painted::pixel(int x, int y, const PixelValues& before, const PixelValues& after) {
    if (!std::holds_alternative<SwapBuffers>(command())) paint(x, y, Paint::Plain, before, after);
}

}  // namespace gw::inspect
