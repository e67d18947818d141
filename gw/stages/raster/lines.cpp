#include "gw/stages/raster/lines.h"

#include "gw/stages/resolve.h"

#include <optional>

namespace gw {
namespace {

/// The columns or rows whose centre lies between the ends. R9.4: the start counts, the end does not.
LineSteps steps_between(std::int64_t from, std::int64_t to, int s) {
    const std::int64_t half = std::int64_t{1} << (s - 1);
    // the first pixel whose centre is at v or above it; the last one at v or below it
    const auto above = [&](std::int64_t v) { return -((half - v) >> s); };
    const auto below = [&](std::int64_t v) { return (v - half) >> s; };
    if (from <= to) return {above(from), above(to) - above(from), true};
    return {below(from), below(from) - below(to), false};
}

/// R9.34: the column or row in whose diamond an end lies.
std::optional<std::int64_t> diamond_of(std::int64_t x, std::int64_t y, bool x_major,
                                       const LineRule& rule) {
    const int s = rule.subpixel_bits;
    const std::int64_t half = std::int64_t{1} << (s - 1), shift = (rule.width - 1) * half;
    (x_major ? y : x) -= shift;
    const std::int64_t i = (x - 1) >> s, j = y >> s;
    const std::int64_t dx = x - (i << s) - half, dy = y - (j << s) - half;
    const std::int64_t distance = std::abs(dx) + std::abs(dy);
    if (dx > 0 ? distance > half : distance >= half) return std::nullopt;
    return x_major ? i : j;
}

}  // namespace

LineRule line_rule(const State& state, int subpixel_bits) {
    return {whole_size(state.line_width), state.diamond_lines, subpixel_bits};
}

LineSteps line_steps(const LineEnds& e, const LineRule& rule) {
    const bool x_major = e.x_major();
    const auto& u = x_major ? e.x : e.y;
    const int s = rule.subpixel_bits;
    const std::int64_t half = std::int64_t{1} << (s - 1);
    LineSteps steps = steps_between(u[0], u[1], s);
    if (!rule.diamond) return steps;
    // The centres of a line that goes down: those of the same line up.
    if (!steps.up) {
        const LineSteps rising = steps_between(u[1], u[0], s);
        steps = {rising.first + rising.count - 1, rising.count, false};
    }
    const int step = steps.up ? 1 : -1;
    if (diamond_of(e.x[0], e.y[0], x_major, rule) == steps.first - step) {
        steps.first -= step;
        steps.count += 1;
        steps.outer_first = u[0] - (steps.first << s) != half;
    }
    const std::int64_t last = steps.first + step * (steps.count - 1);
    if (steps.count > 0 && diamond_of(e.x[1], e.y[1], x_major, rule) == last) steps.count -= 1;
    return steps;
}

}  // namespace gw
