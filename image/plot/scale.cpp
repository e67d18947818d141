// Ticks: 1, 2, 5 times a power of ten; on logarithmic axes powers of the base.
#include "image/plot/scale.h"

#include "gw/base/elementary.h"
#include "gw/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gw::plot {
namespace {

double logarithm(double value, int base) { return gw::log(value) / gw::log(base); }

void check(const Axis& axis, double value) {
    if (!std::isfinite(value))
        throw Error(fmt::format("plot: axis '{}': {}; expected finite values", axis.label, value));
    if (axis.log != 0 && !(value > 0))
        throw Error(fmt::format("plot: logarithmic axis '{}': {}; expected values above 0",
                                axis.label, value));
}

/// The smallest of 1, 2, 5 times a power of ten that is at least `least`.
double round_step(double least) {
    const double decade = gw::pow(10, std::floor(logarithm(least, 10)));
    for (double factor : {1.0, 2.0, 5.0})
        if (factor * decade >= least * (1 - 1e-9)) return factor * decade;
    return 10 * decade;
}

Scale linear(double low, double high) {
    if (low == high) {
        const double margin = low == 0 ? 1 : std::abs(low) / 2;
        return linear(low - margin, high + margin);
    }
    constexpr double most_ticks = 7;
    const double step = round_step((high - low) / most_ticks);
    const double first = std::floor(low / step + 1e-9), last = std::ceil(high / step - 1e-9);
    Scale scale{first * step, last * step};
    for (double i = first; i <= last; ++i)
        scale.ticks.push_back({i * step, fmt::format("{:.6g}", i * step)});
    return scale;
}

Tick power(int base, int exponent) {
    const double value = gw::pow(base, exponent);
    return {value, fmt::format("{:.6g}", value)};
}

Scale logarithmic(double low, double high, int base) {
    const int first = int(std::floor(logarithm(low, base) + 1e-9));
    const int last = std::max(first + 1, int(std::ceil(logarithm(high, base) - 1e-9)));
    Scale scale{double(first), double(last), base};
    for (int e = first; e <= last; ++e) {
        scale.ticks.push_back(power(base, e));
        if (base != 10 || e == last) continue;
        for (int m = 2; m < 10; ++m) {
            const double value = m * scale.ticks[scale.ticks.size() + 1 - std::size_t(m)].value;
            const bool few = last - first <= 2 && (m == 2 || m == 5);
            scale.ticks.push_back({value, few ? fmt::format("{:.6g}", value) : ""});
        }
    }
    return scale;
}

}  // namespace

double Scale::place(double value) const {
    return ((log != 0 ? logarithm(value, log) : value) - low) / (high - low);
}

Scale make_scale(const Axis& axis, const std::vector<double>& values) {
    if (values.empty()) throw Error("plot: no points; expected one or more");
    for (const double value : values) check(axis, value);
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return axis.log != 0 ? logarithmic(*low, *high, axis.log) : linear(*low, *high);
}

}  // namespace gw::plot
