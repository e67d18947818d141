#include "apps/hidden/quiz/quiz_html.h"

#include "hiddensurface/quiz/quiz_drawing.h"

#include <fmt/format.h>

namespace gw::apps {

namespace hs = hiddensurface;

std::string escaped_xml(const std::string& text) {
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

std::string QuizHtml::plain(const hs::Bilingual& text) const {
    if (language == QuizLanguage::English || text.en == text.ja) return text.en;
    return language == QuizLanguage::Japanese ? text.ja : text.en + " / " + text.ja;
}

std::string QuizHtml::elements(const hs::Bilingual& text, const char* element,
                               const char* between) const {
    const auto in = [&](const char* code, const std::string& words) {
        return fmt::format("<{0} {1}=\"{2}\">{3}</{0}>", element, attribute, code,
                           escaped_xml(words));
    };
    if (text.en == text.ja) return fmt::format("<{0}>{1}</{0}>", element, escaped_xml(text.en));
    if (language == QuizLanguage::English) return in("en", text.en);
    if (language == QuizLanguage::Japanese) return in("ja", text.ja);
    return in("en", text.en) + between + in("ja", text.ja);
}

std::string QuizHtml::corner_table(const hs::Question& question) const {
    const auto corners = hs::corners_of(question);
    if (corners.empty()) return "";
    std::string html =
        "<table><thead><tr><td></td><th>x</th><th>y</th><th>Z</th></tr></thead>\n<tbody>\n";
    for (const hs::QuizCorner& corner : corners)
        html += fmt::format("<tr><th>{}</th><td>{:.1f}</td><td>{:.1f}</td><td>{:.4f}</td></tr>\n",
                            corner.name, corner.x, corner.y, corner.Z);
    const hs::Bilingual units{"Pixels from the upper left; Z: 0 nearest, 1 farthest.",
                              "左上からの画素。Z は 0 が最も近く、1 が最も遠い。"};
    return html + "</tbody></table>\n<p><small>" + elements(units, "span", " ") + "</small></p>\n";
}

}  // namespace gw::apps
