// The error of a hemicube's form factors against its resolution, as drawn and oversampled [F2.2,
// F2.2o]: from a point to each texel of a wall, whose form factors have a closed form.
#pragma once

#include "image/plot/plot.h"

#include <functional>
#include <string>
#include <vector>

namespace gw::study {

/// Means over the turns of the hemicube.
struct HemicubeError {
    int size = 0;       ///< pixels across the hemicube
    double pixels = 0;  ///< pixels of the top face across a texel: n = R s / (2 d)
    double rms_drawn = 0, rms_oversampled = 0;  ///< error of a texel, as a part of its form factor
    double missed_drawn = 0, missed_oversampled = 0;  ///< share of the texels without any pixel
};
std::vector<HemicubeError> hemicube_errors(const std::vector<int>& sizes, int turns,
                                           const std::function<void(const std::string&)>& say);

plot::Plot hemicube_plot(const std::vector<HemicubeError>& rows);

}  // namespace gw::study
