// What adding the passes of many lights loses, in the frame buffer and in the accumulation buffer:
// rounding of dim lights, saturation of bright ones. The truth is one pass of all lights at 16 bits
// (the same vertices, pixels and interpolation).
#pragma once

#include "scene/scene.h"
#include "study/difference.h"
#include "study/plot/plot.h"

#include <functional>
#include <string>
#include <vector>

namespace gw::study {

/// All of one picture, not far from white at its brightest, lit by n lights of 1/n of that each.
struct Adding {
    std::string profile;
    int lights = 0;
    Difference frame_buffer;   ///< each pass added by blending
    Difference accumulation;   ///< each light's passes summed in the accumulation buffer
    Difference full_strength;  ///< lights n times as strong, summed there, returned times 1/n
    /// share of the lit values that lights of full strength saturate in the frame buffer
    double saturated = 0;
};

/// The scene's own lights are replaced. Its materials: diffuse and specular, no maps, background
/// black.
/// `width`, `height`: of the machines.
std::vector<Adding> adding(scene::Scene scene, const std::vector<int>& lights,
                           const std::vector<Profile>& profiles, const MachineMaker& make,
                           int width, int height,
                           const std::function<void(const std::string&)>& say);

/// rms of the three ways against the number of lights.
plot::Plot adding_plot(const std::vector<Adding>& rows);

}  // namespace gw::study
