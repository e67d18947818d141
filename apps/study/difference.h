// The difference of two pictures. Does not draw.
#pragma once

#include "gw/machine.h"

#include <functional>
#include <memory>
#include <vector>

namespace gw::study {

/// R, G, B of every pixel, bottom row first, as fractions of white.
using Fractions = std::vector<double>;
Fractions fractions(Machine& machine);

/// `picture - truth` over all values, in 255ths of white: the levels of an 8-bit frame buffer.
struct Difference {
    double rms = 0;
    double mean = 0;     ///< above 0: the picture is brighter
    double largest = 0;  ///< the largest magnitude
};
/// The pictures have one size, which is not 0.
Difference difference(const Fractions& picture, const Fractions& truth);

/// Makes a machine of the profile with the study's window.
using MachineMaker = std::function<std::unique_ptr<Machine>(const Profile&)>;

}  // namespace gw::study
