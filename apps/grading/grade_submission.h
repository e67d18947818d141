// Runs one submission on every scene and grades its answers. Does not write the class's files.
#pragma once

#include "apps/grading/graded.h"
#include "apps/grading/isolation.h"
#include "apps/grading/submission.h"

namespace gw::apps {

struct GradingTask {
    std::string name;                ///< of the scene
    std::filesystem::path scene;     ///< its file
    std::filesystem::path polygons;  ///< what a program gets, in a file that all may read
};

struct Grading {
    std::vector<GradingTask> tasks;
    Allowance allowance;
    std::size_t output = std::size_t{16} << 20;  ///< bytes that an answer may have
    std::string size;                            ///< "320x240"
    std::string command;                         ///< to run a submission; "" to find one
    int points = 10;                             ///< of a scene
    std::string language = "en";                 ///< of the feedback
    std::string about;                           ///< all that marks depend on besides the files
    std::filesystem::path scratch;               ///< whose folders all may enter
};

/// Writes players and results.json to `folder`. If `resume` and the results there have the same
/// digest, they are taken over. `slot`: as in Confined.
GradedSubmission grade_submission(const Grading& grading, const Submission& submission,
                                  const std::filesystem::path& folder, bool resume, int slot);

}  // namespace gw::apps
