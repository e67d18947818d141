// Exercises: small random scenes, a question about each, and the answer, computed by the algorithms
// themselves. The same seed gives the same quiz everywhere. Does not write files or grade:
// apps/hidden/quiz/grade.cpp does.
#pragma once

#include "hiddensurface/interface/algorithm.h"

#include <optional>

namespace gw::hiddensurface {

/// A text in the languages of the pages.
struct Bilingual {
    std::string en{}, ja{};
};

/// The step that decides an answer, in the log of an algorithm on the question's scene.
struct DecidingStep {
    std::string algorithm{};
    Level level = Level::Polygon;
    std::size_t step = 1;  ///< the first is 1
};

struct Question {
    std::string kind;                ///< quiz_kinds()
    Bilingual text{};                ///< the question, and the form of the answer
    std::vector<Bilingual> choices;  ///< a, b, c, ...; empty: the answer is a number or numbers
    int among = 0;                   ///< the answer is some of the numbers 1 to this; 0: one number
    std::string answer;              ///< canonical: "b", "3", "1 4 6"
    Bilingual why{};
    DecidingStep decided{};
    bool needs_corners = false;  ///< no answer without the corners' coordinates in the window
    scene::Scene scene;          ///< polygons are numbered by their identifiers
    std::optional<dvec2> point;  ///< marked in the picture: pixels, y up
    std::optional<int> row;      ///< a scan line marked, bottom row 0
};

/// order, test, pieces, facing, writes, spans, invisibility.
const std::vector<std::string>& quiz_kinds();
/// A kind's name for people: "Painting order".
const Bilingual& title_of_kind(const std::string& kind);
/// The window of all its pictures.
inline constexpr int quiz_width = 320, quiz_height = 240;

/// `count` questions of one kind, or if `kind` is empty, of all kinds in turn. Each depends only on
/// the seed and its number, so a longer quiz begins like a shorter one.
std::vector<Question> make_quiz(std::uint32_t seed, int count, const std::string& kind = "");
/// The one with this number, 1 first.
Question quiz_question(std::uint32_t seed, int number, const std::string& kind = "");

/// An answer in the form for comparisons: small letters, words in ascending order, one blank between
/// them ("4, 1" is "1 4").
std::string canonical_answer(const std::string& text);

}  // namespace gw::hiddensurface
