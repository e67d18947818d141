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
    const char* name;
    std::optional<Question> (*make)(QuizRandom&);
};
constexpr Kind kinds[] = {{"order", ask_order},
                          {"test", ask_test},
                          {"pieces", ask_pieces},
                          {"facing", ask_facing},
                          {"writes", ask_writes},
                          {"spans", ask_spans},
                          {"invisibility", ask_invisibility}};

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
        for (const Kind& kind : kinds) all.push_back(kind.name);
        return all;
    }();
    return names;
}

std::vector<Question> make_quiz(std::uint32_t seed, int count, const std::string& kind) {
    std::vector<Question> quiz;
    for (int i = 0; i < count; ++i) {
        std::size_t k = std::size_t(i) % std::size(kinds);
        if (!kind.empty())
            k = std::size_t(std::find(quiz_kinds().begin(), quiz_kinds().end(), kind) -
                            quiz_kinds().begin());
        if (k >= std::size(kinds))
            throw Error("quiz: unknown kind '" + kind + "'; expected one of quiz_kinds()");
        quiz.push_back(make_question(kinds[k], seed, std::uint32_t(i + 1)));
    }
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
