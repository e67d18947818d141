// The options of gw hidden, and its kinds of runs. hidden.cpp parses the options.
#pragma once

#include "apps/render/picture_options.h"
#include "hiddensurface/interface/steps.h"
#include "image/output/output_set.h"

namespace gw::apps {

enum class Form { Text, Json, Csv };

struct HiddenOptions {
    PictureOptions picture{{.size = {320, 240}}};
    /// Of surfaces or of lines: one, or two side by side; empty: all hidden-surface algorithms.
    std::vector<std::string> algorithms;
    double limit = 300;  ///< the longest estimated time of a run in seconds; 0: none
    std::filesystem::path steps, compare;
    hiddensurface::Level level = hiddensurface::Level::Polygon;
    Form form = Form::Text;

    std::filesystem::path polygons, play;  ///< for a program: a file to write, its answer

    std::filesystem::path quiz;  ///< the folder for exercises
    int seed = 1, questions = 7;
    std::string kind;                          ///< of the questions; empty: all kinds in turn
    std::string students;                      ///< students_from; empty: one quiz
    std::vector<std::filesystem::path> grade;  ///< key, answers: files, or folders of a class
    std::filesystem::path fragments;           ///< a student's list
    std::filesystem::path truth, marked;       ///< files to write: the correct list, the mistakes
};

/// Creates the folders of steps and comparison, so that a bad name is found early.
void make_folders(image::OutputSet& output, const HiddenOptions& options);
/// The folder of an algorithm's steps: of two, each has its own.
std::filesystem::path folder_of_steps(const HiddenOptions& options, const std::string& algorithm);

/// Draws with hidden-line algorithms, with counts and steps (lines.cpp).
int hidden_lines(const HiddenOptions& options, Session& session);

/// Writes the polygons for a program (play.cpp).
int hidden_polygons(const HiddenOptions& options, Session& session);
/// Draws a program's answer and grades it. Returns ExitCode Differs if a pixel is wrong (play.cpp).
int hidden_play(const HiddenOptions& options, Session& session);

/// Makes exercises (quiz/quiz.cpp). Needs no scene.
int hidden_quiz(const HiddenOptions& options, const Session& session);
/// Compares answers with a key. Returns ExitCode Differs unless all are right (quiz/grade.cpp).
int hidden_grade(const HiddenOptions& options);
/// Compares a fragment list with the Z-buffer's picture; writes `truth` and `marked`. Returns
/// ExitCode Differs unless all are right (quiz/grade.cpp).
int hidden_fragments(const HiddenOptions& options, Session& session);

}  // namespace gw::apps
