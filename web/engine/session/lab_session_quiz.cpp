// The questions of a quiz, and the steps that decide them.
#include "hiddensurface/quiz/quiz_data.h"
#include "web/engine/method.h"

namespace gw::lab {

namespace hs = hiddensurface;

namespace {

/// Options `seed`, `number`, and `kind` as `gw quiz --kind` has it.
hs::Question asked_question(const Json& options) {
    return hs::quiz_question(options.at("seed").get<std::uint32_t>(),
                             options.at("number").get<int>(), options.value("kind", ""));
}

/// The text of hs::quiz_json with this one question.
std::string quiz(LabSession&, const Json& options) {
    return hs::quiz_json({asked_question(options)});
}

std::string quiz_steps(LabSession&, const Json& options) {
    return hs::deciding_log(asked_question(options));
}

const Method quiz_methods[] = {{"quiz", quiz}, {"quiz_steps", quiz_steps}};

}  // namespace

}  // namespace gw::lab
