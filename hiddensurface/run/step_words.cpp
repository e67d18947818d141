#include "hiddensurface/run/step_words.h"

#include "gw/error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace gw::hiddensurface {

namespace {

std::string text_of(bool value) { return value ? "1" : "0"; }
std::string text_of(std::int64_t value) { return std::to_string(value); }
/// Six digits, of large numbers all whole ones: as web/model/steps/sentence.ts.
std::string text_of(double value) {
    const bool large = std::abs(value) >= 1e5 && std::abs(value) < 1e15;
    return large ? fmt::format("{:.0f}", std::round(value)) : fmt::format("{:.6g}", value);
}
std::string text_of(const std::string& value) { return value; }
template <class T>
std::string text_of(const std::vector<T>& values) {
    std::string text;
    if (values.empty()) return "\u2013";
    for (const T& value : values) text += (text.empty() ? "" : ", ") + text_of(value);
    return text;
}

/// A word in braces: of the step, or one of its values.
std::string value_of(const Step& step, const PictureGrid& grid, const std::string& name) {
    const Rect& w = step.window;
    if (name == "pieces") return text_of(step.pieces);
    if (name == "first" && !step.pieces.empty()) return step.pieces[0];
    if (name == "second" && step.pieces.size() > 1) return step.pieces[1];
    if (w.width > 0) {
        if (name == "row") return std::to_string(grid.height - w.y - w.height);
        if (name == "left") return std::to_string(w.x);
        if (name == "right") return std::to_string(w.x + w.width - 1);
        if (name == "width") return std::to_string(w.width);
        if (name == "height") return std::to_string(w.height);
    }
    for (const auto& [known, value] : step.values)
        if (known == name) return std::visit([](const auto& v) { return text_of(v); }, value);
    throw Error("a step " + step.test + "." + step.result + " has no value '" + name +
                "'; expected those of its sentence");
}

}  // namespace

std::string_view step_words() { return embedded_words("step_words.json"); }

std::string sentence_of(const Step& step, const PictureGrid& grid, const std::string& language) {
    static const auto words = nlohmann::json::parse(step_words());
    const auto test = words.find(step.test);
    if (test == words.end() || !test->contains(step.result)) return step.test + ": " + step.result;
    const std::string pattern = test->at(step.result).at(language);
    std::string text;
    for (std::size_t at = 0; at < pattern.size();) {
        const std::size_t open = pattern.find('{', at), close = pattern.find('}', at);
        text += pattern.substr(at, open - at);
        if (open == pattern.npos) break;
        text += value_of(step, grid, pattern.substr(open + 1, close - open - 1));
        at = close + 1;
    }
    return text;
}

}  // namespace gw::hiddensurface
