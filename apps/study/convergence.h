// The error of N superposed pictures [K1, K3.3, K4a] against many more, for N = 2, 4, 8, ...
// In theory, the error of N random samples of an edge falls like N^(-1/2). That of N samples spread
// well in d dimensions falls like N^(-1/2 - 1/(2d)) (Mitchell 1996). This is N^(-3/4) if the place in
// the pixel varies, N^(-5/8) if the place on the lamp varies too.
#pragma once

#include "apps/study/difference.h"
#include "image/plot/plot.h"
#include "scene/scene.h"

#include <functional>
#include <string>
#include <vector>

namespace gw::study {

struct ConvergenceOptions {
    int largest = 256;     ///< the largest N, doubling from 2
    int reference = 2048;  ///< samples of the truth: 16 bits, the profile's sub-pixel grid
    int width = 160, height = 120;
};

struct ProfileError {
    std::string profile;
    std::vector<dvec2> rms;  ///< (N, rms in 255ths of white)
    /// distance of its converged picture from that of a 256x256 sub-pixel grid
    double grid = 0;
    /// fitted to the errors of fewer samples than the sub-pixel grid has places
    plot::PowerLaw law;
};

/// An error for each profile. `say` gets the name of each picture. The lights' and emitters' own
/// numbers of samples are ignored.
std::vector<ProfileError> convergence(scene::Scene scene, const std::vector<Profile>& profiles,
                                      const MachineMaker& make, const ConvergenceOptions& options,
                                      const std::function<void(const std::string&)>& say);

/// The plot, with lines for random and for well spread samples; `dimensions` is d.
plot::Plot convergence_plot(const std::vector<ProfileError>& errors, const std::string& title,
                            int dimensions);

}  // namespace gw::study
