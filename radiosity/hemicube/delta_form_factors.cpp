#include "radiosity/hemicube/delta_form_factors.h"

#include "gw/base/elementary.h"

#include <cmath>
#include <cstddef>

namespace gw::radiosity {
namespace {

double atan(double t) { return atan2(t, 1); }

// d2/dxdy = 1 / (pi (1 + x^2 + y^2)^2): the top, at height 1 (Howell's B-4 as an indefinite
// integral).
double top_integral(double x, double y) {
    const double a = std::sqrt(1 + x * x), b = std::sqrt(1 + y * y);
    return (x / a * atan(y / a) + y / b * atan(x / b)) / (2 * pi);
}

// d2/dydz = z / (pi (1 + y^2 + z^2)^2): a side, z the height over the horizon (B-3).
double side_integral(double y, double z) {
    const double a = std::sqrt(1 + z * z);
    return -atan(y / a) / (2 * pi * a);
}

/// Differences of an integral at the corners of the pixels.
template <class Integral>
std::vector<double> pixels(int columns, int rows, double left, double bottom, Integral integral) {
    const double step = 2.0 / columns;
    std::vector<double> corner;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i)
            corner.push_back(integral(left + i * step, bottom + j * step));
    std::vector<double> values;
    const auto width = std::size_t(columns) + 1;
    for (std::size_t j = 0; j < std::size_t(rows); ++j)
        for (std::size_t i = 0; i < std::size_t(columns); ++i) {
            const double* c = &corner[j * width + i];
            values.push_back((c[width + 1] - c[width]) - (c[1] - c[0]));
        }
    return values;
}

}  // namespace

DeltaFormFactors delta_form_factors(int size) {
    return {size, pixels(size, size, -1, -1, top_integral),
            pixels(size, size / 2, -1, 0, side_integral)};
}

}  // namespace gw::radiosity
