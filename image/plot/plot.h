// Small line and scatter plots as SVG text, their numbers as CSV text, and the slope of a power
// law. Does not measure, and does not write files.
#pragma once

#include "gw/base/types.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gw::plot {

/// Points (x, y) in the order of the line.
struct Series {
    std::string name;  ///< in the legend, and the column's name
    std::vector<dvec2> points;
    bool line = true, markers = true;
    bool dashed = false;  ///< for theory beside measurements
    /// of colour, line and marker; the place among the series if not given
    std::optional<std::size_t> style{};
};

struct Axis {
    std::string label;
    int log = 0;  ///< base of a logarithmic axis, 2 or 10; 0: linear
};

struct Plot {
    std::string title;
    std::string caption;  ///< below the plot, in lines of its own
    std::string command;  ///< the command that makes the plot, below the caption
    Axis x, y;
    std::vector<Series> series;
};

/// The plot, 720 pixels wide. A point's values appear when the pointer rests on its marker. Throws
/// Error if there is no point, a coordinate is not finite, or not above 0 on a logarithmic axis.
std::string svg(const Plot& plot);

/// "x,series 1,series 2": a row for every x, ascending. A field is empty if its series has no such
/// point. Numbers read back as the same doubles.
std::string csv(const Plot& plot);

/// The law y = factor x^exponent fitted to points, by least squares of log y over log x.
struct PowerLaw {
    double factor = 0, exponent = 0;
    double operator()(double x) const;
};
/// Throws Error for fewer than two different x, or a coordinate that is not above 0.
PowerLaw power_law(const std::vector<dvec2>& points);

}  // namespace gw::plot
