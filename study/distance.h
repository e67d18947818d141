// How far the hardware's picture (eq. 1 [K2]) and the multi-pass one (eq. 2 [K3]) are from the
// scan-line one (eq. 3 [K3s]), which shades every pixel, for rings of fewer and more polygons.
#pragma once

#include "scene/scene.h"
#include "study/difference.h"
#include "study/plot/plot.h"

#include <functional>
#include <string>
#include <vector>

namespace gw::study {

/// All three of the same polygons, drawn by the same profile.
struct Distance {
    std::string profile;
    /// of a ring's cross section; twice as many segments around
    int sides = 0;
    double hardware = 0, multipass = 0;  ///< rms in 255ths of white
};

/// `rings`: every object is replaced by a torus of this radius and tube, where and as the object
/// was.
struct Rings {
    scene::Scene scene;
    double radius = 1.1, tube = 0.29;
};
std::vector<Distance> distances(const Rings& rings, const std::vector<int>& sides,
                                const std::vector<Profile>& profiles, const MachineMaker& make,
                                int width, int height,
                                const std::function<void(const std::string&)>& say);

plot::Plot distance_plot(const std::vector<Distance>& rows);

}  // namespace gw::study
