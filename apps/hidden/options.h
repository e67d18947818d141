// The options of gw hidden, and what each kind of run does with them. Parsing: hidden.cpp.
#pragma once

#include "apps/render/picture_options.h"
#include "hiddensurface/run/steps.h"

namespace gw::apps {

enum class Form { Text, Json, Csv };

struct HiddenOptions {
    PictureOptions picture{.size = {320, 240}};
    std::string algorithm;  ///< empty: all of hidden surfaces
    /// Seconds that a run may take by its estimate; 0: any.
    double limit = 300;
    std::filesystem::path steps, compare;
    hiddensurface::Level level = hiddensurface::Level::Polygon;
    int pictures = 48;
    Form form = Form::Text;

    std::filesystem::path quiz;  ///< a folder: make exercises
    int seed = 1, questions = 7;
    std::string kind;                          ///< of questions; empty: all in turn
    std::vector<std::filesystem::path> grade;  ///< key, answers
    std::filesystem::path fragments;           ///< a student's list
    /// files to write: the list as it should be, the mistakes
    std::filesystem::path truth, marked;
};

/// `algorithm` is one of hidden lines: draws them, with counts and steps (lines.cpp).
int hidden_lines(const HiddenOptions& options, Session& session);

/// Makes exercises (quiz.cpp). Needs no scene.
int hidden_quiz(const HiddenOptions& options, const Session& session);
/// Compares answers with a key; ExitCode Differs unless all are right (grade.cpp).
int hidden_grade(const HiddenOptions& options);
/// Compares a fragment list with the Z-buffer's picture, the same; writes `truth` and `marked`.
int hidden_fragments(const HiddenOptions& options, Session& session);

}  // namespace gw::apps
