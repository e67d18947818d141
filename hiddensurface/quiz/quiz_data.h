// A quiz as data for pages: questions with their answers, and the steps that decide. Does not write
// files.
#pragma once

#include "hiddensurface/quiz/quiz.h"

namespace gw::hiddensurface {

/// JSON: `kind`, `title`, `text`, `choices`, `among`, `answer`, `why` of Question, texts as members
/// `en` and `ja`; `drawing`, SVG, and `spoken` for those who cannot see it; `corners`, rows of a
/// name, x, y and Z; `step`, the deciding one, and `pixel`, the marked one, y down.
std::string quiz_json(const std::vector<Question>& questions);

/// The log of the algorithm that decides the question, as `gw hidden --steps` writes it.
std::string deciding_log(const Question& question);

}  // namespace gw::hiddensurface
