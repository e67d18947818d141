// The questions of a quiz. Each function makes a random scene and a question about it, or none if
// the scene gives no good question. The answers are those of the algorithms themselves.
#pragma once

#include "gw/machine.h"
#include "hiddensurface/quiz/quiz.h"
#include "hiddensurface/quiz/quiz_scenes.h"
#include "hiddensurface/run/compare.h"

namespace gw::hiddensurface {

/// Four orders of four polygons: which one paints the picture?
std::optional<Question> ask_order(QuizRandom& random);
/// Two triangles: which of Newell's tests decides?
std::optional<Question> ask_test(QuizRandom& random);
/// Three triangles: how many pieces does Newell, Newell and Sancha's algorithm draw?
std::optional<Question> ask_pieces(QuizRandom& random);
/// A solid's coordinates: which faces look away?
std::optional<Question> ask_facing(QuizRandom& random);
/// Rectangles that face the eye: how often does the Z-buffer write a pixel?
std::optional<Question> ask_writes(QuizRandom& random);
/// Three triangles: how many sample spans does a scan line have?
std::optional<Question> ask_spans(QuizRandom& random);
/// Five triangles: what is Appel's number in the middle of a side?
std::optional<Question> ask_invisibility(QuizRandom& random);

/// "1 4 6"
std::string words_of(const std::vector<std::uint32_t>& ids);

/// A question's scene in view, and the results of algorithms on it. Refers to the scene.
struct QuestionContext {
    explicit QuestionContext(const scene::Scene& scene)
        : view(scene::make_view(scene, quiz_width, quiz_height)),
          input(make_input(scene, view, vgx())) {}
    QuestionContext(const QuestionContext&) = delete;
    scene::View view;
    Input input;

    Result run(const std::string& name) const {
        const auto machine = make_fast(vgx(), quiz_width, quiz_height, {.threads = 1});
        StepLog none;
        return run_on(*machine, algorithm_named(name), input, none);
    }
    std::vector<Step> steps(const std::string& name, Level finest) const {
        StepLog log(finest);
        algorithm_named(name).run(input, log);
        return log.steps();
    }
    std::size_t pixel(int x, int y) const { return std::size_t(y) * quiz_width + std::size_t(x); }
};

}  // namespace gw::hiddensurface
