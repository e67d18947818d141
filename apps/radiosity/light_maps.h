// A solution as light maps for other programs: glTF 2.0 with a second set of texture coordinates, and
// the radiosities as EXR and as a PNG to look at. Does not solve.
#pragma once

#include "apps/radiosity/pictures.h"
#include "image/output/output_set.h"

namespace gw::apps {

/// Writes light_maps.gltf, light_maps.bin, light_map_1.exr, light_map_1.png ... into DIR; `prefix`
/// begins every name. Returns a line for printing. `scene` is the one that the model was made of.
std::string put_light_maps(const RadiosityOptions& options, const scene::Scene& scene,
                           const Solved& solved, const std::string& prefix,
                           image::OutputSet& files);

/// Writes the EXR files alone, on the same pages: PREFIXlight_map_1.exr ...
void put_light_map_values(const RadiosityOptions& options, const Solved& solved,
                          const std::string& prefix, image::OutputSet& files);

}  // namespace gw::apps
