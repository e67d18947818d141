#include "hiddensurface/quiz/quiz_data.h"

#include "gw/machine.h"
#include "hiddensurface/lines/draw_lines.h"
#include "hiddensurface/quiz/quiz_drawing.h"
#include "hiddensurface/run/compare.h"
#include "hiddensurface/run/step_json.h"

#include <nlohmann/json.hpp>

namespace gw::hiddensurface {
namespace {

using QuizJson = nlohmann::ordered_json;

QuizJson bilingual_json(const Bilingual& text) { return {{"en", text.en}, {"ja", text.ja}}; }

QuizJson question_json(const Question& q) {
    QuizJson json{{"kind", q.kind},
                  {"title", bilingual_json(title_of_kind(q.kind))},
                  {"text", bilingual_json(q.text)},
                  {"choices", QuizJson::array()},
                  {"among", q.among},
                  {"answer", q.answer},
                  {"why", bilingual_json(q.why)},
                  {"drawing", drawing_of(q, "")},
                  {"spoken", bilingual_json(drawing_in_words(q))},
                  {"corners", QuizJson::array()},
                  {"algorithm", q.decided.algorithm},
                  {"step", q.decided.step}};
    for (const Bilingual& choice : q.choices) json["choices"].push_back(bilingual_json(choice));
    for (const QuizCorner& c : corners_of(q))
        json["corners"].push_back(QuizJson::array({c.name, c.x, c.y, c.Z}));
    if (q.point) json["pixel"] = {int(q.point->x), quiz_height - 1 - int(q.point->y)};
    return json;
}

}  // namespace

std::string quiz_json(const std::vector<Question>& questions) {
    QuizJson all = QuizJson::array();
    for (const Question& question : questions) all.push_back(question_json(question));
    return all.dump();
}

std::string deciding_log(const Question& question) {
    const scene::View view = scene::make_view(question.scene, quiz_width, quiz_height);
    const Input input = make_input(question.scene, view, vgx());
    const auto machine = make_fast(vgx(), quiz_width, quiz_height, {.threads = 1});
    const DecidingStep& decided = question.decided;
    StepLog log(decided.level);
    LogSubject subject{.algorithm = decided.algorithm, .title = "", .level = decided.level};
    if (const LineAlgorithm* lines = line_algorithm_named(decided.algorithm)) {
        subject.title = lines->title;
        subject.lines = true;
        const LineResult result = run_on(*machine, *lines, input, log);
        return log_text(input, subject, log.steps(), log_end(log.steps().size(), result.counts));
    }
    const Algorithm& algorithm = algorithm_named(decided.algorithm);
    subject.title = algorithm.title;
    subject.in_world = algorithm.in_world;
    StepLog none;
    const auto expected = run_on(*machine, algorithm_named("z-buffer"), input, none);
    Result result = run_on(*machine, algorithm, input, log);
    compare(result, expected.ids, input);
    return log_text(input, subject, log.steps(),
                    log_end(log.steps().size(), result.counts, grid_of(input),
                            blame_of(log.steps(), result, input.view.width)));
}

}  // namespace gw::hiddensurface
