#include "apps/hidden/quiz/quiz_page.h"

#include "apps/command/page_style.h"
#include "hiddensurface/quiz/quiz_drawing.h"

#include <fmt/format.h>

namespace gw::apps {

namespace hs = hiddensurface;

namespace {

/// What only these pages have: sheets of paper, always light, and drawings beside questions.
constexpr std::string_view own_style = R"(
@page { size: A4; margin: 14mm }
body { max-width: 200mm; background: var(--paper) }
h1 { margin: 0 0 .2em; font-size: 1.5em }
header { padding: 1em 0 .6em }
p, header p { margin: 0 0 .4em }
article { break-inside: avoid; border-top: 1px solid var(--line); padding: 1em 0 }
h2 { margin: 0 0 .4em }
.both { display: grid; grid-template-columns: 100mm 1fr; gap: var(--gap) }
svg { width: 100mm; height: auto; overflow: visible }
table { font-size: var(--small); margin-bottom: .4em }
td, th { border: 1px solid var(--line); padding: .05em .5em; text-align: right }
ol { list-style: lower-alpha; margin: 0 0 .4em; padding-left: 1.6em }
.answer p:last-child { margin: 0 }
.given { font-weight: bold }
@media print {
  :root { font-size: 10pt; background: none }
  body { max-width: none; padding: 0 }
  article { padding: 2.5mm 0 }
  .both { grid-template-columns: 76mm 1fr }
  svg { width: 76mm }
  .card { border-color: var(--ink) }
}
@media (max-width: 640px) { .both { grid-template-columns: 1fr } svg { width: 100% } }
)";

std::string choices_of(const hs::Question& question, const QuizHtml& html) {
    if (question.choices.empty()) return "";
    std::string list = "<ol>\n";
    for (const hs::Bilingual& choice : question.choices)
        list += "<li>" + html.lines(choice) + "</li>\n";
    return list + "</ol>\n";
}

std::string article_of(const hs::Question& question, std::size_t number, const QuizHtml& html,
                       const std::string& end) {
    const std::string spoken = escaped_xml(html.plain(hs::drawing_in_words(question)));
    return fmt::format(
        "<article>\n<h2>{}. {}</h2>\n"
        "{}<div class=\"both\">{}<div>{}{}{}</div></div>\n</article>\n",
        number, html.spans(hs::title_of_kind(question.kind)), html.paragraphs(question.text),
        hs::drawing_of(question, spoken), choices_of(question, html), html.corner_table(question),
        end);
}

std::string page_of(const QuizSheet& sheet, const hs::Bilingual& title, const std::string& name,
                    const std::string& body) {
    const QuizHtml html{sheet.language};
    const hs::Bilingual seed{fmt::format("seed {}", sheet.seed),
                             fmt::format("問題集 {}", sheet.seed)};
    return fmt::format(
        "<!doctype html>\n<html lang=\"{5}\">\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n<title>{0}</title>\n"
        "<style>\n{1}{6}</style>\n<header>\n<h1>{0}</h1>\n<p>{2} &nbsp; "
        "<small>{3}</small></p>\n</header>\n<main>\n{4}</main>\n</html>\n",
        html.plain(title), embedded_style("page.css"), name, html.spans(seed), body,
        sheet.language == QuizLanguage::Japanese ? "ja" : "en", own_style);
}

}  // namespace

std::string handout_page(const QuizSheet& sheet) {
    const QuizHtml html{sheet.language};
    std::string body;
    for (std::size_t i = 0; i < sheet.questions.size(); ++i)
        body += article_of(sheet.questions[i], i + 1, html,
                           "<p class=\"answer card\">" + html.spans({"Answer", "解答"}) + ":</p>");
    const std::string name =
        html.plain({"Name", "氏名"}) + ": " +
        (sheet.student.empty() ? "____________________" : escaped_xml(sheet.student));
    return page_of(sheet, {"Hidden surfaces: questions", "隠面消去の問題"}, name, body);
}

std::string answers_page(const QuizSheet& sheet, const std::vector<std::string>& players) {
    const QuizHtml html{sheet.language};
    std::string body;
    for (std::size_t i = 0; i < sheet.questions.size(); ++i) {
        const hs::Question& question = sheet.questions[i];
        std::string end = fmt::format("<div class=\"answer card\"><p class=\"given\">{}</p>\n{}",
                                      escaped_xml(question.answer), html.paragraphs(question.why));
        if (!players[i].empty())
            end += fmt::format("<p><a href=\"{}\">{}</a>: {}, {}</p>", escaped_xml(players[i]),
                               html.spans({"The step that decides", "判断が決まるステップ"}),
                               question.decided.algorithm, question.decided.step);
        body += article_of(question, i + 1, html, end + "</div>");
    }
    return page_of(sheet, {"Hidden surfaces: answers", "隠面消去の解答"},
                   escaped_xml(sheet.student), body);
}

}  // namespace gw::apps
