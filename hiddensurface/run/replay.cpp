#include "hiddensurface/run/replay.h"

#include "gw/error.h"

#include <utility>

namespace gw::hiddensurface {
namespace {

void check(const Step& step, int width, int height) {
    for (const auto& [run, id] : step.painted)
        if (run.y < 0 || run.y >= height || run.x0 < 0 || run.x1 > width || run.x0 > run.x1)
            throw Error("a step paints outside the window; expected a log of this size");
    const Rect& w = step.window;
    if (w.x < 0 || w.y < 0 || w.width < 0 || w.height < 0 || w.width > width - w.x ||
        w.height > height - w.y)
        throw Error("a step is about pixels outside the window; expected a log of this size");
}

}  // namespace

Replay::Replay(std::vector<Step> steps, int width, int height)
    : steps_(std::move(steps)), ids_(std::size_t(width) * std::size_t(height)), width_(width) {
    for (const Step& step : steps_) check(step, width, height);
}

template <class Change>
void Replay::for_painted(const Step& step, const Change& change) {
    for (const auto& [run, id] : step.painted)
        for (int x = run.x0; x < run.x1; ++x)
            change(ids_[std::size_t(run.y) * std::size_t(width_) + std::size_t(x)], id);
}

void Replay::forward() {
    const Step& step = steps_.at(position());
    Undo undo;
    for_painted(step, [&](std::uint32_t& pixel, std::uint32_t id) {
        undo.ids.push_back(std::exchange(pixel, id));
    });
    if (step.action == Action::Sort) undo.order = std::exchange(order_, step.polygons);
    undo_.push_back(std::move(undo));
}

void Replay::backward() {
    const Undo undo = std::move(undo_.back());
    undo_.pop_back();
    const Step& step = steps_[position()];
    // A step may paint a pixel twice: what was there first comes back last.
    std::vector<std::uint32_t*> pixels;
    for_painted(step, [&](std::uint32_t& pixel, std::uint32_t) { pixels.push_back(&pixel); });
    for (std::size_t i = pixels.size(); i-- > 0;) *pixels[i] = undo.ids[i];
    if (step.action == Action::Sort) order_ = undo.order;
}

void Replay::go_to(std::size_t to) {
    while (position() < to && position() < size()) forward();
    while (position() > to) backward();
}

}  // namespace gw::hiddensurface
