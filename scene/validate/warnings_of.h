// What a picture of a scene will not show, or not show right: one line each, for people. Valid scenes
// only; errors are the readers'. Does not print.
#pragma once

#include "gw/machine.h"
#include "scene/draw/view.h"
#include "scene/scene.h"

#include <span>
#include <string>
#include <vector>

namespace gw::scene {

/// How a picture is found.
enum class DrawnBy {
    Passes,  ///< with a near plane; lines and points too
    Depth,   ///< with a near plane; faces only
    Rays,    ///< faces only
};

/// A colour above is taken to be one of 0 to 255.
inline constexpr float in_bytes = 16;

/// The lines for this scene and view. Objects: those that the near plane or a light's map cuts off,
/// coincident ones, lines and points that are left out. Surfaces: maps without texture coordinates
/// or with an alpha that is not used, colours of 0 to 255, spots between vertices. Normals: of
/// length 0, or away from their faces. Empty: nothing to say.
std::vector<std::string> warnings_of(const Scene& scene, const View& view, DrawnBy by);

/// What radiosity leaves out of a scene besides: a line each for opacity, maps of Kd and lights
/// without a unit.
std::vector<std::string> left_out_by_radiosity(const Scene& scene);

/// A line if no pixel differs from the background though the scene has objects; empty: some do.
std::string empty_picture(const Scene& scene, std::span<const Rgba> picture, int color_bits);

}  // namespace gw::scene
