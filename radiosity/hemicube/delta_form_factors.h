// The form factor of every pixel of a hemicube: the exact integral of cos / (pi r^2) over the
// pixel, in closed form. Of a hemicube of side 2 around a point: top at distance 1, sides 1 high.
// Knows no buffers and no figures.
#pragma once

#include <vector>

namespace gw::radiosity {

/// `size` pixels across, even. Rows from the horizon up (sides) or from one side to the other
/// (top).
struct DeltaFormFactors {
    int size = 0;
    std::vector<double> top;   ///< size x size
    std::vector<double> side;  ///< size x size / 2: all four sides are alike
};

DeltaFormFactors delta_form_factors(int size);

}  // namespace gw::radiosity
