// The light of lamps without area, straight to the texels: six hemicubes about each lamp tell what it
// sees. Does not reflect it (Solver does).
#pragma once

#include "radiosity/hemicube/form_factors.h"
#include "radiosity/model/figures.h"

namespace gw::radiosity {

/// Fills model.direct from the scene's lights in candela; a world unit is a metre, so the irradiance
/// is in lux. Throws FormFactors::Canceled. The same bits for any number of threads.
void add_direct_light(const scene::Scene& scene, PixmapModel& model,
                      const FormFactorOptions& options);

/// make_model, with this light.
PixmapModel make_lit_model(const scene::Scene& scene, const ModelOptions& model,
                           const FormFactorOptions& options);

}  // namespace gw::radiosity
