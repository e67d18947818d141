// Moodle XML, as https://docs.moodle.org/en/Moodle_XML_format describes it.
#include "apps/hidden/page.h"
#include "apps/hidden/quiz/quiz_export.h"
#include "hiddensurface/quiz/quiz_drawing.h"

#include <fmt/format.h>

#include <sstream>

namespace gw::apps {

namespace hs = hiddensurface;

namespace {

/// HTML in a <text>.
std::string html_text(const std::string& html) { return "<text>" + escaped_xml(html) + "</text>"; }

/// `percent` as Moodle's list of fractions has it: at most 5 digits after the point.
std::string moodle_answer(const std::string& html, double percent, const char* rest = "") {
    return fmt::format(
        "<answer fraction=\"{:.7g}\" format=\"html\">{}{}"
        "<feedback format=\"html\"><text></text></feedback></answer>\n",
        percent, html_text(html), rest);
}

std::string moodle_choices(const char* single, const std::string& answers) {
    return fmt::format(
        "<single>{}</single>\n<shuffleanswers>false</shuffleanswers>\n"
        "<answernumbering>{}</answernumbering>\n{}",
        single, single == std::string("true") ? "abc" : "none", answers);
}

/// Right numbers share 100 %; a wrong one costs as much as a right one gives.
std::string moodle_numbers(const hs::Question& question) {
    std::vector<bool> is_right(std::size_t(question.among) + 1);
    std::istringstream words(question.answer);
    int count = 0;
    for (std::size_t number; words >> number; ++count) is_right[number] = true;
    std::string answers;
    for (std::size_t number = 1; number < is_right.size(); ++number)
        answers +=
            moodle_answer(std::to_string(number), (is_right[number] ? 100.0 : -100.0) / count);
    return moodle_choices("false", answers);
}

std::string moodle_answers(const hs::Question& question, const QuizHtml& html) {
    if (question.among > 0) return moodle_numbers(question);
    if (question.choices.empty())
        return moodle_answer(question.answer, 100, "<tolerance>0</tolerance>");
    std::string answers;
    for (std::size_t i = 0; i < question.choices.size(); ++i)
        answers += moodle_answer(html.lines(question.choices[i]),
                                 question.answer[0] == char('a' + i) ? 100 : 0);
    return moodle_choices("true", answers);
}

std::string moodle_question(const QuizSheet& sheet, std::size_t i) {
    const QuizHtml html{sheet.language};
    const hs::Question& question = sheet.questions[i];
    const bool is_number = question.choices.empty() && question.among == 0;
    const std::string picture = fmt::format("picture_{}_{:02}.svg", sheet.seed, i + 1);
    const std::string spoken = escaped_xml(html.plain(hs::drawing_in_words(question)));
    const std::string text =
        fmt::format("{}<p><img src=\"@@PLUGINFILE@@/{}\" alt=\"{}\" width=\"480\"/></p>\n{}",
                    html.paragraphs(question.text), picture, spoken, html.corner_table(question));
    return fmt::format(
        "<question type=\"{}\">\n<name><text>{} {} (seed {})</text></name>\n"
        "<questiontext format=\"html\">{}\n<file name=\"{}\" path=\"/\" "
        "encoding=\"base64\">{}</file></questiontext>\n"
        "<generalfeedback format=\"html\">{}</generalfeedback>\n"
        "<defaultgrade>1</defaultgrade>\n<penalty>0.3333333</penalty>\n<hidden>0</hidden>\n"
        "{}</question>\n",
        is_number ? "numerical" : "multichoice",
        escaped_xml(html.plain(hs::title_of_kind(question.kind))), i + 1, sheet.seed,
        html_text(text), picture, base64(hs::drawing_of(question, spoken)),
        html_text(html.paragraphs(question.why)), moodle_answers(question, html));
}

}  // namespace

std::string moodle_xml(const QuizSheet& sheet) {
    std::string xml = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<quiz>\n"
        "<question type=\"category\"><category><text>$course$/top/{}, seed {}</text></category>"
        "</question>\n",
        QuizHtml{sheet.language}.plain({"Hidden surfaces", "隠面消去"}), sheet.seed);
    for (std::size_t i = 0; i < sheet.questions.size(); ++i) xml += moodle_question(sheet, i);
    return xml + "</quiz>\n";
}

}  // namespace gw::apps
