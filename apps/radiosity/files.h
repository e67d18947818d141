// The files of gw radiosity beside its pictures: saved pixmaps [F4], and how the solution converges
// [F1c]. Does not know when to save.
#pragma once

#include "image/output/output_set.h"
#include "radiosity/hemicube/form_factors.h"
#include "radiosity/solver/shares.h"
#include "radiosity/solver/solution.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gw::apps {

void put_solution(image::OutputSet& files, const std::filesystem::path& file,
                  const radiosity::PixmapModel& model, const radiosity::FormFactorOptions& options,
                  const radiosity::Solution& solution);

/// Throws Error for a file that is missing, damaged, or of another scene, method or version.
radiosity::Solution load_solution(const std::filesystem::path& file,
                                  const radiosity::PixmapModel& model,
                                  const radiosity::FormFactorOptions& options);

/// Writes DIR/share_1.exr ... of the solver's parts.
void put_shares(image::OutputSet& files, const std::filesystem::path& folder,
                const radiosity::PixmapModel& model, const radiosity::FormFactorOptions& options,
                const std::vector<radiosity::Share>& shares);

/// A line for each lamp: its file, and its part of the emitted energy.
std::string text_of(const std::vector<radiosity::Share>& shares,
                    const radiosity::PixmapModel& model);

/// All shares of a folder. Throws Error as load_solution does, and if their shots differ.
std::vector<radiosity::Share> load_shares(const std::filesystem::path& folder,
                                          const radiosity::PixmapModel& model,
                                          const radiosity::FormFactorOptions& options);

/// The state after a shot. Shares are of the emitted energy.
struct Step {
    std::uint64_t shots = 0;
    double seconds = 0, unshot = 0, absorbed = 0, escaped = 0, imbalance = 0;
    int hemicubes = 0;
};

Step step_of(const radiosity::PixmapModel& model, const radiosity::Solution& solution,
             double seconds, int hemicubes);

/// The curve of `folder`'s convergence.csv up to the state `now`, of a solution that is continued;
/// `now` alone if no file there has that state.
std::vector<Step> resumed_curve(const std::filesystem::path& folder, const Step& now);

/// Writes convergence.csv.
void put_curve(const std::vector<Step>& steps, const std::filesystem::path& folder,
               image::OutputSet& files);

/// Writes convergence.csv, convergence.svg and convergence_seconds.svg: the unshot share against
/// shots and seconds.
void put_report(const std::vector<Step>& steps, const std::filesystem::path& folder,
                image::OutputSet& files);

}  // namespace gw::apps
