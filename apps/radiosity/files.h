// Saved pixmaps as files [F4]. Does not know when to save.
#pragma once

#include "image/output/output_set.h"
#include "radiosity/hemicube/form_factors.h"
#include "radiosity/solver/solution.h"

#include <filesystem>

namespace gw::apps {

void put_solution(image::OutputSet& files, const std::filesystem::path& file,
                  const radiosity::PixmapModel& model, const radiosity::FormFactorOptions& options,
                  const radiosity::Solution& solution);

/// Throws Error for a file that is missing, damaged, or of another scene, method or version.
radiosity::Solution load_solution(const std::filesystem::path& file,
                                  const radiosity::PixmapModel& model,
                                  const radiosity::FormFactorOptions& options);

}  // namespace gw::apps
