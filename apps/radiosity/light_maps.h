// A solution as light maps for other programs: glTF 2.0 with a second set of texture coordinates, the
// radiosities as EXR, and as PNG that shows them. Does not solve.
#pragma once

#include "apps/radiosity/options.h"
#include "image/output/output_set.h"
#include "radiosity/solver/solver.h"

namespace gw::apps {

/// Writes light_maps.gltf, light_maps.bin, light_map_1.exr, light_map_1.png ... into DIR. Returns a
/// line for printing. `scene` is the one that the solver's model was made of.
std::string put_light_maps(const RadiosityOptions& options, const scene::Scene& scene,
                           const radiosity::Solver& solver, image::OutputSet& files);

}  // namespace gw::apps
