// A quiz's texts as HTML that is XML too, in one language or both: for pages, Moodle and QTI. Does
// not lay out pages.
#pragma once

#include "hiddensurface/quiz/quiz.h"

#include <string>

namespace gw::apps {

enum class QuizLanguage { Both, English, Japanese };

/// Writes texts in the language of a quiz. `attribute` names an element's language.
struct QuizHtml {
    QuizLanguage language = QuizLanguage::Both;
    const char* attribute = "lang";

    /// Without markup: "Scan line / 走査線".
    std::string plain(const hiddensurface::Bilingual& text) const;
    /// An element for each language; one without a language if both texts are the same.
    std::string elements(const hiddensurface::Bilingual& text, const char* element,
                         const char* between) const;
    /// Elements of text side by side.
    std::string spans(const hiddensurface::Bilingual& text) const {
        return elements(text, "span", " / ");
    }
    std::string paragraphs(const hiddensurface::Bilingual& text) const {
        return elements(text, "p", "\n") + "\n";
    }
    /// A choice, one language above the other.
    std::string lines(const hiddensurface::Bilingual& text) const {
        return elements(text, "span", "<br/>");
    }
    /// The corners' coordinates in the window; empty if the question needs none.
    std::string corner_table(const hiddensurface::Question& question) const;
};

/// "&lt;"
std::string escaped_xml(const std::string& text);

}  // namespace gw::apps
