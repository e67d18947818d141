// A question's scene in view, and what the algorithms make of it. Does not ask.
#pragma once

#include "gw/machine.h"
#include "hiddensurface/quiz/quiz.h"
#include "hiddensurface/run/compare.h"

namespace gw::hiddensurface {

/// Refers to the scene, which must stay.
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
