#include "apps/hidden/quiz/quiz_page.h"

#include "hiddensurface/quiz/quiz_drawing.h"

#include <fmt/format.h>

namespace gw::apps {

namespace hs = hiddensurface;

namespace {

constexpr const char* style = R"(
@page { size: A4; margin: 14mm }
body { font: 11pt/1.45 "DejaVu Sans", "Noto Sans CJK JP", "IPAexGothic", sans-serif;
       max-width: 182mm; margin: 8mm auto; padding: 0 4mm; color: #111; background: #fff }
h1 { font-size: 16pt; margin: 0 0 2mm }
header p { margin: 0 0 5mm }
article { break-inside: avoid; border-top: 0.3mm solid #999; padding: 4mm 0 }
h2 { font-size: 12pt; margin: 0 0 2mm }
p { margin: 0 0 2mm }
.both { display: grid; grid-template-columns: 100mm 1fr; gap: 4mm }
svg { width: 100mm; height: auto; overflow: visible; print-color-adjust: exact; -webkit-print-color-adjust: exact }
table { border-collapse: collapse; font-size: 9pt }
td, th { border: 0.2mm solid #aaa; padding: 0.3mm 2mm; text-align: right }
ol { list-style: lower-alpha; margin: 0 0 2mm; padding-left: 6mm }
.answer { border: 0.3mm solid #333; padding: 1.5mm 3mm; margin-top: 2mm }
.given { font-weight: bold }
@media print {
  body { font-size: 10pt; max-width: none; margin: 0; padding: 0 }
  article { padding: 2.5mm 0 }
  .both { grid-template-columns: 76mm 1fr }
  svg { width: 76mm }
  table { font-size: 8pt }
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
        "<style>{1}</style>\n<header>\n<h1>{0}</h1>\n<p>{2} &nbsp; "
        "<small>{3}</small></p>\n</header>\n<main>\n{4}</main>\n</html>\n",
        html.plain(title), style, name, html.spans(seed), body,
        sheet.language == QuizLanguage::Japanese ? "ja" : "en");
}

}  // namespace

std::string handout_page(const QuizSheet& sheet) {
    const QuizHtml html{sheet.language};
    std::string body;
    for (std::size_t i = 0; i < sheet.questions.size(); ++i)
        body += article_of(sheet.questions[i], i + 1, html,
                           "<p class=\"answer\">" + html.spans({"Answer", "解答"}) + ":</p>");
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
        std::string end = fmt::format("<div class=\"answer\"><p class=\"given\">{}</p>\n{}",
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
