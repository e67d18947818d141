// How far two pictures are apart. Does not draw.
#pragma once

#include "gw/machine.h"

#include <functional>
#include <memory>
#include <vector>

namespace gw::study {

/// R, G, B of every pixel, bottom row first, as fractions of white.
using Fractions = std::vector<double>;
Fractions fractions(Machine& machine);

/// Of `picture - truth` over all values, in 255ths of white: the levels of an 8-bit frame buffer.
struct Difference {
    double rms = 0;
    double mean = 0;     ///< above 0: the picture is brighter
    double largest = 0;  ///< of its magnitude
};
/// Both of one size, which is not 0.
Difference difference(const Fractions& picture, const Fractions& truth);

/// A machine of the profile with the window that is studied.
using MachineMaker = std::function<std::unique_ptr<Machine>(const Profile&)>;

}  // namespace gw::study
