// A quiz as a page to print: questions with drawings in English and Japanese; or their answers, with
// links to the steps that decide them. Does not make questions or write files.
#pragma once

#include "hiddensurface/quiz/quiz.h"

#include <string>
#include <vector>

namespace gw::apps {

struct QuizSheet {
    std::string student;  ///< empty: a line to write the name on
    int seed = 1;
    std::vector<hiddensurface::Question> questions;
};

/// The handout, without answers. HTML without scripts.
std::string handout_page(const QuizSheet& sheet);

/// The questions with their answers. `players`: the page of each question's steps, as a link; empty:
/// none.
std::string answers_page(const QuizSheet& sheet, const std::vector<std::string>& players);

}  // namespace gw::apps
