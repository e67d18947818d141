// The pixels along a line that has no antialiasing. docs/manual/rasterization.md, "Coverage".
// Does not make fragments.
#pragma once

#include "gw/state.h"

#include <array>
#include <cstdint>
#include <cstdlib>

namespace gw {

/// What decides which pixels a line covers, beside its ends.
struct LineRule {
    int width = 1;  ///< whole pixels
    /// OpenGL's diamond rule, R9.34; else R9.4
    bool diamond = false;
    int subpixel_bits = 3;
    bool operator==(const LineRule&) const = default;
};
LineRule line_rule(const State& state, int subpixel_bits);

/// A line's ends in sub-pixels.
struct LineEnds {
    std::array<std::int64_t, 2> x{}, y{};

    bool x_major() const { return std::abs(x[1] - x[0]) >= std::abs(y[1] - y[0]); }
};

/// The columns (x-major) or rows of a line from one end to the other, in its direction: `count`
/// pixels from `first` on, up or down.
struct LineSteps {
    std::int64_t first = 0, count = 0;
    bool up = true;
    /// The first is that of corner 0's diamond, and its centre is not between the ends.
    bool outer_first = false;

    std::int64_t step_of(std::int64_t pixel) const { return up ? pixel - first : first - pixel; }
    /// The range in rising order.
    std::int64_t low() const { return up ? first : first - count + 1; }
    std::int64_t high() const { return low() + count; }
};
LineSteps line_steps(const LineEnds& ends, const LineRule& rule);

/// 1 if a line whose middle is on the boundary of two pixels covers the lower one, else 0: what the
/// numerator of R9.4's quotient loses.
constexpr int boundary_step(const LineEnds& e, const LineRule& rule) {
    if (!rule.diamond) return 0;
    const bool rises = (e.x[1] > e.x[0]) == (e.y[1] > e.y[0]) && e.y[1] != e.y[0];
    return e.x_major() && rises ? 0 : 1;
}

}  // namespace gw
