// The questions of a quiz, one function each: a random scene and what is asked about it; none where
// this scene is not worth asking about. Each answer is what the algorithm itself does or counts.
#pragma once

#include "hiddensurface/quiz/quiz.h"
#include "hiddensurface/quiz/quiz_scenes.h"

namespace gw::hiddensurface {

/// Four orders of four polygons, one of which paints the picture.
std::optional<Question> ask_order(QuizRandom& random);
/// Which of Newell's tests decides about two triangles.
std::optional<Question> ask_test(QuizRandom& random);
/// How many pieces Newell, Newell and Sancha's algorithm draws.
std::optional<Question> ask_pieces(QuizRandom& random);
/// Which faces of a solid look away, from coordinates.
std::optional<Question> ask_facing(QuizRandom& random);
/// How often the Z-buffer writes a pixel.
std::optional<Question> ask_writes(QuizRandom& random);
/// How many sample spans a scan line has.
std::optional<Question> ask_spans(QuizRandom& random);
/// Appel's number in the middle of a side.
std::optional<Question> ask_invisibility(QuizRandom& random);

/// "1 4 6"
std::string words_of(const std::vector<std::uint32_t>& ids);

}  // namespace gw::hiddensurface
