// A scene that changes with time: keys, the values between them, and the instants of a film's
// pictures. Does not draw, and does not know what a value is of.
#pragma once

#include "scene/scene.h"

#include <functional>
#include <string>
#include <vector>

namespace gw::scene {

enum class Interpolation {
    Step,    ///< the key before
    Linear,  ///< along the line between two keys
    Smooth,  ///< along a cubic through all keys, whose slope at each is that between its neighbours
};

/// Values of `width` numbers at increasing times, in seconds. Before the first key it is the first
/// one's value, after the last the last one's.
struct Keys {
    std::vector<double> times;
    std::vector<double> values;  ///< of the first key, then the second ...
    std::size_t width = 1;
    Interpolation interpolation = Interpolation::Linear;
    /// of Smooth: the slopes at which the curve reaches and leaves each key, per second. Empty: those
    /// between its neighbours
    std::vector<double> slopes_in, slopes_out;

    std::vector<double> at(double time) const;
};

struct Film {
    std::string name;    ///< of glTF's animation; else empty
    double rate = 24;    ///< pictures a second
    double shutter = 0;  ///< how long it is open, of the time from one picture to the next, 0 .. 1
    int instants = 8;    ///< pictures superposed while it is open
    double seconds = 0;  ///< the time of the last key
    /// Sets all that changes to its value at a time. Throws Error if no scene may have such values.
    std::function<void(Scene&, double time)> pose;

    /// Picture 1 is at time 0.
    double time_of(int picture) const { return (picture - 1) / rate; }
    /// The number of pictures to the last key.
    int pictures() const;
    /// The instants that a picture superposes: spread evenly about its time while the shutter is open,
    /// or its time alone.
    std::vector<double> instants_of(int picture) const;
};

}  // namespace gw::scene
