// A scene's objects as figures with ST and pixmaps [F2.1]: given ST, or automatic ones if they are
// missing. Does not solve.
#pragma once

#include "radiosity/model/pixmap_model.h"

#include <functional>
#include <vector>

namespace gw::radiosity {

struct ModelOptions {
    /// instead of the scene's; 0: the scene's, or 48 along its longest side
    double texels_per_unit = 0;
    int patch = 4;  ///< the texels along a side of a patch, which is a block
};

/// Throws Error, with the file and line of the object's pixmap if it has one. Reasons are: ST that
/// are missing, outside 0 .. 1, without area or covering a texel twice; an object without area that
/// is to emit; a reflectance above 1; a pixmap that is larger than 4096 texels a side or shared with
/// another size.
PixmapModel make_model(const scene::Scene& scene, const ModelOptions& options = {});

/// A warning if objects without area have no figure.
std::vector<std::string> left_out(const PixmapModel& model);

/// The emission of each texel if every figure emitted so many times what it does, by channel.
std::vector<dvec3> emission_times(const PixmapModel& model,
                                  const std::function<dvec3(const Figure&)>& factor);

/// Throws Error if no figure emits and no lamp sends light directly: there is nothing to solve. Form
/// factors need no light.
void check_emission(const PixmapModel& model);

}  // namespace gw::radiosity
