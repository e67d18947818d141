#include "hiddensurface/run/steps.h"

#include "gw/base/cancel.h"
#include "gw/error.h"

#include <array>
#include <charconv>
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
        throw Error("a step marks pixels outside the window; expected a log of this size");
}

}  // namespace

const char* name_of(Level level) {
    constexpr std::array names{"polygon", "line", "span", "pixel"};
    return names[std::size_t(level)];
}
const char* name_of(Action action) {
    constexpr std::array names{"compare", "decide", "sort", "split", "draw"};
    return names[std::size_t(action)];
}

std::uint32_t polygon_of(const std::string& piece) {
    std::uint32_t polygon = 0;
    std::from_chars(piece.data(), piece.data() + piece.size(), polygon);
    return polygon;
}

void StepLog::add(Step step) {
    end_if_canceled();
    if (!wants(step.level) && !(on_ && step.action == Action::Draw)) return;
    if (steps_.size() == most_steps)
        throw Error(
            "the log has more than 2,000,000 steps; expected a smaller --size or a coarser "
            "--level");
    for (WatchedCount& watched : watched_)
        if (const std::uint64_t now = *watched.count; now != watched.last) {
            step.counts.emplace_back(watched.name, now);
            watched.last = now;
        }
    steps_.push_back(std::move(step));
}

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
    if (step.action == Action::Sort) undo.order = std::exchange(order_, step.pieces);
    undo_.push_back(std::move(undo));
}

void Replay::backward() {
    const Undo undo = std::move(undo_.back());
    undo_.pop_back();
    const Step& step = steps_[position()];
    // A step may paint a pixel twice: restore in reverse, so that the first value comes back last.
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
