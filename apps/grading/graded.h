// A submission with its marks, and the files that say them: Gradescope's results.json, a JUnit file, a
// table and a page. Does not run a submission.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace gw::apps {

/// How a submission did on a scene.
struct GradedScene {
    std::string scene;    ///< its name
    std::string outcome;  ///< a word of outcome_words()
    int points = 0, of = 0;
    double seconds = 0;
    std::string feedback;  ///< lines for the student, of any characters
    std::string player;    ///< the page of its steps, from the submission's folder; "" if none
};

/// right, wrong, endless, crashed, broken, flooding, memory, no program
std::vector<std::string> outcome_words();

struct GradedSubmission {
    std::string name;
    /// of its files and the task: equal ones have equal marks; "" if it was not run
    std::string digest;
    std::vector<GradedScene> scenes;
    std::string lacks;  ///< the program that this computer lacks to run it; "" if none

    int points() const;
    int of() const;
};

/// Where a submission's files are, from the class's folder.
std::filesystem::path folder_of_student(const std::string& name);

std::string results_json(const GradedSubmission& graded);
/// The submission that results_json wrote to a file; nothing if it is missing or another's.
std::optional<GradedSubmission> read_results(const std::filesystem::path& file);

/// For each: a submission that is not graded yet has no scenes.
std::string junit_xml(const std::vector<GradedSubmission>& all);
std::vector<std::vector<std::string>> grade_rows(const std::vector<GradedSubmission>& all,
                                                 const std::vector<std::string>& scenes);
std::string grades_csv(const std::vector<std::vector<std::string>>& rows);
/// In "en" or "ja".
std::string class_page(const std::vector<GradedSubmission>& all,
                       const std::vector<std::string>& scenes, const std::string& language);

}  // namespace gw::apps
