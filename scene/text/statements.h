// Statements of OBJ and MTL files: one per line, a keyword and the rest. Knows blanks, comments,
// line ends and lines continued with '\'. Does not know any keyword.
#pragma once

#include <string>
#include <string_view>

namespace gw::scene {

class Statements {
public:
    /// `text` must outlive the object; `file` is its name in errors.
    Statements(std::string file, std::string_view text);

    /// Goes to the next statement; false at the end. Throws Canceled now and then, if it was asked
    /// to end.
    bool next();

    std::string_view keyword() const { return keyword_; }
    /// The text after the keyword, trimmed. Comments are still in it, since names may hold '#'.
    std::string_view rest() const { return rest_; }
    /// The line the statement begins on, from 1.
    int line() const { return line_; }
    const std::string& file() const { return file_; }
    [[noreturn]] void fail(std::string_view what) const;

private:
    std::string_view logical_line();

    std::string file_, joined_;
    const char *at_, *end_;
    int next_line_ = 1, line_ = 0;
    std::string_view keyword_, rest_;
};

/// Space, tab, carriage return, vertical tab, form feed; not the newline, which ends a statement.
inline bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n'); }

/// The text without blanks at its ends.
std::string_view trim(std::string_view text);

/// The text with A .. Z as a .. z.
std::string lower(std::string_view text);

/// Takes the next word off the text; empty at its end, and at a '#' that begins a comment.
inline std::string_view take_word(std::string_view& text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    if (text.starts_with('#')) text = {};
    std::size_t size = 0;
    while (size < text.size() && !is_blank(text[size])) ++size;
    const std::string_view word = text.substr(0, size);
    text.remove_prefix(size);
    return word;
}

}  // namespace gw::scene
