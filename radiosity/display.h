// Solved pixmaps as pictures [F2.3], drawn by the machine from any view without solving again: as textures,
// or as Gouraud-shaded triangle strips at the pixmaps' resolution. Does not write files; gamma is the
// output's.
#pragma once

#include "gw/command_list.h"
#include "radiosity/solution.h"
#include "scene/view.h"

#include <vector>

namespace gw::radiosity {

/// What is shown at each texel: radiosity, with the estimate of what is yet to come where `with_ambient`
/// [F1c]. Texels that nothing covers show their nearest neighbour, so that no dark border is interpolated in.
std::vector<dvec3> shown(const Model& model, const Solution& solution, bool with_ambient);

/// `scale` times a radiosity is what the frame buffer holds, clamped to 1. Sides of figures that do not emit
/// are not drawn. The colour plane is cleared to `background`.
struct Brightness {
    double scale = 1;
    vec3 background{0};
};

/// A pixmap is a texture, bilinear, with a border of one texel that repeats the outermost ones: nothing leaks
/// in.
CommandList texture_list(const Model& model, const std::vector<dvec3>& colors, const scene::View& view,
                         const Brightness& brightness);

/// Each triangle as one strip of rows, divided at least as finely as the pixmap (Fig. 4), colours looked up
/// bilinearly at the vertices. Strips are made in parallel.
CommandList strip_list(const Model& model, const std::vector<dvec3>& colors, const scene::View& view,
                       const Brightness& brightness, int threads = 0);

}  // namespace gw::radiosity
