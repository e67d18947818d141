// Random scenes are tried until one gives a good question.
#include "hiddensurface/quiz/quiz.h"

#include "gw/error.h"
#include "hiddensurface/quiz/questions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace gw::hiddensurface {
namespace {

constexpr int most_tries = 400;

struct Kind {
    std::string name;
    Bilingual title;
    std::optional<Question> (*make)(QuizRandom&);
};
const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all{
        {"order", {"Painting order", "描く順"}, ask_order},
        {"test", {"Newell's tests", "Newell の判定"}, ask_test},
        {"pieces", {"Cut polygons", "ポリゴンの分割"}, ask_pieces},
        {"facing", {"Back faces", "裏を向いた面"}, ask_facing},
        {"writes", {"Z-buffer", "Zバッファ"}, ask_writes},
        {"spans", {"Scan line", "走査線"}, ask_spans},
        {"invisibility", {"Quantitative invisibility", "不可視度"}, ask_invisibility}};
    return all;
}

const Kind& kind_named(const std::string& name) {
    const auto found = std::ranges::find(kinds(), name, &Kind::name);
    if (found == kinds().end())
        throw Error("quiz: unknown kind '" + name + "'; expected one of quiz_kinds()");
    return *found;
}

Question make_question(const Kind& kind, std::uint32_t seed, std::uint32_t number) {
    QuizRandom random(seed, number);
    for (int i = 0; i < most_tries; ++i)
        if (auto question = kind.make(random)) {
            question->scene.name = kind.name;
            return std::move(*question);
        }
    throw Error(
        fmt::format("quiz: no scene for question {} ({}) of seed {}; expected one in {} tries",
                    number, kind.name, seed, most_tries));
}

}  // namespace

const std::vector<std::string>& quiz_kinds() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const Kind& kind : kinds()) all.push_back(kind.name);
        return all;
    }();
    return names;
}

const Bilingual& title_of_kind(const std::string& kind) { return kind_named(kind).title; }

Question quiz_question(std::uint32_t seed, int number, const std::string& kind) {
    const auto place = std::size_t(number - 1) % kinds().size();
    return make_question(kind.empty() ? kinds()[place] : kind_named(kind), seed,
                         std::uint32_t(number));
}

std::vector<Question> make_quiz(std::uint32_t seed, int count, const std::string& kind) {
    std::vector<Question> quiz;
    for (int number = 1; number <= count; ++number)
        quiz.push_back(quiz_question(seed, number, kind));
    return quiz;
}

std::string canonical_answer(const std::string& text) {
    std::string clean;
    for (const char c : text) {
        const bool blank = std::isspace(static_cast<unsigned char>(c)) != 0 || c == ',' || c == ';';
        clean += blank ? ' ' : char(std::tolower(static_cast<unsigned char>(c)));
    }
    std::istringstream words(clean);
    std::vector<std::string> all;
    for (std::string word; words >> word;) all.push_back(word);
    std::stable_sort(all.begin(), all.end(), [](const std::string& a, const std::string& b) {
        return a.size() != b.size() ? a.size() < b.size() : a < b;
    });
    std::string out;
    for (const std::string& word : all) out += (out.empty() ? "" : " ") + word;
    return out;
}

}  // namespace gw::hiddensurface
