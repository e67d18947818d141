// An axis as numbers: its interval, its ticks, and the place of a value.
#pragma once

#include "image/plot/plot.h"

namespace gw::plot {

struct Tick {
    double value = 0;
    std::string text;  ///< empty: a tick without a number
};

struct Scale {
    double low = 0, high = 1;  ///< of the values, or of their logarithms
    int log = 0;
    std::vector<Tick> ticks;

    /// The place of a value: 0 at the axis' beginning, 1 at its end.
    double place(double value) const;
};

/// The scale for all values, whose ends are ticks. Throws Error as svg does.
Scale make_scale(const Axis& axis, const std::vector<double>& values);

}  // namespace gw::plot
