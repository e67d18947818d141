// A quiz as a page to print: questions with drawings; or their answers, with links to the steps that
// decide them. Does not make questions or write files.
#pragma once

#include "apps/hidden/quiz/quiz_html.h"

#include <string>
#include <vector>

namespace gw::apps {

struct QuizSheet {
    std::string student;  ///< empty: a line to write the name on
    int seed = 1;
    std::vector<hiddensurface::Question> questions;
    QuizLanguage language = QuizLanguage::Both;
};

/// The handout, without answers. HTML without scripts.
std::string handout_page(const QuizSheet& sheet);

/// The questions with their answers. `players`: the page of each question's steps, as a link; empty:
/// none.
std::string answers_page(const QuizSheet& sheet, const std::vector<std::string>& players);

}  // namespace gw::apps
