// Exercises: small random scenes, a question about each, and the answer, computed by the algorithms
// themselves. The same seed gives the same quiz everywhere. Does not write files or grade:
// apps/hidden/grade.cpp does.
#pragma once

#include "hiddensurface/run/algorithm.h"

#include <optional>

namespace gw::hiddensurface {

struct Question {
    std::string kind;                  ///< quiz_kinds()
    std::string text;                  ///< the question, and the form of the answer
    std::vector<std::string> choices;  ///< a, b, c, ...; empty: the answer is a number or numbers
    std::string answer;                ///< canonical: "b", "3", "1 4 6"
    std::string why;
    scene::Scene scene;          ///< polygons are numbered by their identifiers
    std::optional<dvec2> point;  ///< marked in the picture: pixels, y up
    std::optional<int> row;      ///< a scan line marked, bottom row 0
};

/// order, test, pieces, facing, writes, spans, invisibility.
const std::vector<std::string>& quiz_kinds();
/// The window of all its pictures.
inline constexpr int quiz_width = 320, quiz_height = 240;

/// `count` questions of one kind, or if `kind` is empty, of all kinds in turn. Each depends only on
/// the seed and its number, so a longer quiz begins like a shorter one.
std::vector<Question> make_quiz(std::uint32_t seed, int count, const std::string& kind = "");

/// An answer in the form for comparisons: small letters, words in ascending order, one blank between
/// them ("4, 1" is "1 4").
std::string canonical_answer(const std::string& text);

}  // namespace gw::hiddensurface
