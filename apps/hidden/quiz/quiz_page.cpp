#include "apps/hidden/quiz/quiz_page.h"

#include "apps/hidden/quiz/quiz_drawing.h"

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

/// A kind's name for people.
hs::Bilingual title_of(const std::string& kind) {
    if (kind == "order") return {"Painting order", "描く順"};
    if (kind == "test") return {"Newell's tests", "Newell の判定"};
    if (kind == "pieces") return {"Cut polygons", "ポリゴンの分割"};
    if (kind == "facing") return {"Back faces", "裏を向いた面"};
    if (kind == "writes") return {"Z-buffer", "Zバッファ"};
    if (kind == "spans") return {"Scan line", "走査線"};
    return {"Quantitative invisibility", "不可視度"};
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '"')
            out += "&quot;";
        else
            out += c;
    }
    return out;
}

std::string paragraphs(const hs::Bilingual& text) {
    return fmt::format("<p lang=\"en\">{}</p>\n<p lang=\"ja\">{}</p>\n", escaped(text.en),
                       escaped(text.ja));
}

std::string choices_of(const hs::Question& question) {
    if (question.choices.empty()) return "";
    std::string html = "<ol>\n";
    for (const hs::Bilingual& choice : question.choices)
        html += choice.en == choice.ja
                    ? fmt::format("<li>{}</li>\n", escaped(choice.en))
                    : fmt::format(
                          "<li><span lang=\"en\">{}</span><br><span lang=\"ja\">{}</span></li>\n",
                          escaped(choice.en), escaped(choice.ja));
    return html + "</ol>\n";
}

std::string corner_table(const hs::Question& question) {
    const auto corners = corners_of(question);
    if (corners.empty()) return "";
    std::string html = "<table><tr><th></th><th>x</th><th>y</th><th>Z</th></tr>\n";
    for (const QuizCorner& corner : corners)
        html += fmt::format("<tr><th>{}</th><td>{:.1f}</td><td>{:.1f}</td><td>{:.4f}</td></tr>\n",
                            corner.name, corner.x, corner.y, corner.Z);
    return html +
           "</table>\n<p><small><span lang=\"en\">Pixels from the upper left; Z: 0 nearest, 1 "
           "farthest.</span> <span lang=\"ja\">左上からの画素。Z は 0 が最も近く、1 "
           "が最も遠い。</span></small></p>\n";
}

std::string question_of(const hs::Question& question, std::size_t number, const std::string& end) {
    const hs::Bilingual title = title_of(question.kind);
    return fmt::format(
        "<article>\n<h2>{}. <span lang=\"en\">{}</span> / <span lang=\"ja\">{}</span></h2>\n"
        "{}<div class=\"both\">{}<div>{}{}{}</div></div>\n</article>\n",
        number, title.en, title.ja, paragraphs(question.text), drawing_of(question),
        choices_of(question), corner_table(question), end);
}

std::string page_of(const QuizSheet& sheet, const std::string& title, const std::string& name,
                    const std::string& body) {
    return fmt::format(
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n<title>{0}</title>\n"
        "<style>{1}</style>\n<header>\n<h1>{0}</h1>\n<p>{2} &nbsp; "
        "<small>seed {3}</small></p>\n</header>\n{4}</html>\n",
        title, style, name, sheet.seed, body);
}

}  // namespace

std::string handout_page(const QuizSheet& sheet) {
    std::string body;
    for (std::size_t i = 0; i < sheet.questions.size(); ++i)
        body += question_of(sheet.questions[i], i + 1,
                            "<p class=\"answer\"><span lang=\"en\">Answer</span> / <span "
                            "lang=\"ja\">解答</span>:</p>");
    const std::string name =
        "Name / 氏名: " + (sheet.student.empty() ? "____________________" : escaped(sheet.student));
    return page_of(sheet, "Hidden surfaces: questions / 隠面消去の問題", name, body);
}

std::string answers_page(const QuizSheet& sheet, const std::vector<std::string>& players) {
    std::string body;
    for (std::size_t i = 0; i < sheet.questions.size(); ++i) {
        const hs::Question& question = sheet.questions[i];
        std::string end = fmt::format("<div class=\"answer\"><p class=\"given\">{}</p>\n{}",
                                      escaped(question.answer), paragraphs(question.why));
        if (!players[i].empty())
            end += fmt::format(
                "<p><a href=\"{}\"><span lang=\"en\">The step that decides</span> / <span "
                "lang=\"ja\">判断が決まるステップ</span></a>: {}, {}</p>",
                escaped(players[i]), question.decided.algorithm, question.decided.step);
        body += question_of(question, i + 1, end + "</div>");
    }
    return page_of(sheet, "Hidden surfaces: answers / 隠面消去の解答", escaped(sheet.student),
                   body);
}

}  // namespace gw::apps
