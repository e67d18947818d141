// The drawing of a quiz's question: what one needs to answer it. Does not make questions.
#pragma once

#include "hiddensurface/quiz/quiz.h"

#include <string>
#include <vector>

namespace gw::hiddensurface {

/// A polygon's corner in the window: pixels from the upper left corner, and Z, 0 nearest to 1
/// farthest.
struct QuizCorner {
    std::uint32_t polygon = 0;
    std::string name;  ///< "2b"
    double x = 0, y = 0, Z = 0;
};
/// The corners that the question needs; empty: none.
std::vector<QuizCorner> corners_of(const Question& question);

/// SVG 1.1, quiz_width x quiz_height units. Visible surfaces in flat colours with their numbers,
/// visible sides in full lines, hidden ones broken, corners named if the question needs them, its
/// point and scan line marked. A question about back faces shows sides only. `spoken`: what it says
/// to those who cannot see it, in XML's letters.
std::string drawing_of(const Question& question, const std::string& spoken);
/// For `spoken`: how many polygons there are, and where the marked pixel or scan line is.
Bilingual drawing_in_words(const Question& question);

}  // namespace gw::hiddensurface
