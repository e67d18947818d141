// An axis as numbers: the interval it shows, where a value lies in it, and its ticks.
#pragma once

#include "study/plot/plot.h"

namespace gw::plot {

struct Tick {
    double value = 0;
    std::string text;  ///< empty: a tick without a number
};

struct Scale {
    double low = 0, high = 1;  ///< of what is placed: the value, or its logarithm
    int log = 0;
    std::vector<Tick> ticks;

    /// 0 at the axis' beginning, 1 at its end.
    double place(double value) const;
};

/// The scale that shows all values, ends at ticks included. Throws Error as svg does.
Scale make_scale(const Axis& axis, const std::vector<double>& values);

}  // namespace gw::plot
