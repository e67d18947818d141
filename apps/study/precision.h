// The precision of pictures: rounding of added passes, and the distance of renderers. Plots both.
// Does not print.
#pragma once

#include "apps/study/difference.h"
#include "image/plot/plot.h"
#include "scene/scene.h"

#include <functional>
#include <string>
#include <vector>

namespace gw::study {

/// The error of adding the passes of many lights, in the frame buffer and in the accumulation
/// buffer: rounding of dim lights, saturation of bright ones. The truth is one pass of all lights at
/// 16 bits, with the same vertices, pixels and interpolation. All errors are of one picture, almost
/// white at its brightest, lit by n lights of 1/n strength.
struct Adding {
    std::string profile;
    int lights = 0;
    Difference frame_buffer;   ///< each pass added by blending
    Difference accumulation;   ///< each light's passes summed in the accumulation buffer
    Difference full_strength;  ///< lights n times as strong, summed there, returned times 1/n
    /// share of the lit values that lights of full strength saturate in the frame buffer
    double saturated = 0;
};

/// Replaces the scene's lights. Its materials must be diffuse and specular without maps, its
/// background black. `width` and `height` are the machines'.
std::vector<Adding> adding(scene::Scene scene, const std::vector<int>& lights,
                           const std::vector<Profile>& profiles, const MachineMaker& make,
                           int width, int height,
                           const std::function<void(const std::string&)>& say);

/// The rms errors against the number of lights.
plot::Plot adding_plot(const std::vector<Adding>& rows);

/// The distance of the hardware's picture (eq. 1 [K2]) and the multi-pass one (eq. 2 [K3]) from the
/// scan-line picture (eq. 3 [K3s]), which shades every pixel. All three have the same polygons and
/// profile.
struct Distance {
    std::string profile;
    int sides = 0;  ///< of a ring's cross section; twice as many segments around
    double hardware = 0, multipass = 0;  ///< rms in 255ths of white
};

/// A scene whose objects are all replaced by a torus of this radius and tube, with the same place
/// and material.
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
