#include "scene/toml/toml_text.h"

#include "gw/error.h"
#include "scene/text/encoding.h"

#include <algorithm>
#include <optional>
#include <string_view>

namespace gw::scene {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

/// Passes over the text once, string by string and comment by comment.
class Walk {
public:
    Walk(const std::string& file, std::string& text, std::vector<std::size_t>* headers)
        : file_(file), text_(text), headers_(headers) {}

    void run() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '#')
                comment();
            else if ((c == '"' || c == '\'') && may_begin_string())
                string(c);
            else
                outside(c);
        }
    }

private:
    /// A string may begin as a key, a part of one, or a value. Elsewhere toml++ takes a quotation
    /// mark for a part of a wrong number or word.
    bool may_begin_string() const {
        const std::string_view before = value_ ? "=[,\n" : "[{,.\n";
        return !word_ && before.find(before_) != std::string_view::npos;
    }

    void outside(char c) {
        if (is_beyond_ascii(c))
            fail(
                "a character beyond ASCII outside of a string; expected quotation marks around it");
        if (is_space(c) || c == ',' || c == ']' || c == '}') word_ = false;
        if (c == '.' && value_) check_point();
        if (!word_) structure(c);
        if (c != ' ' && c != '\t' && c != '\r') before_ = c;
        ++at_;
    }

    /// TOML has digits on both sides of a number's point.
    void check_point() const {
        const auto is_digit = [&](std::size_t at) {
            return at < text_.size() && text_[at] >= '0' && text_[at] <= '9';
        };
        const bool before = at_ > 0 && is_digit(at_ - 1), after = is_digit(at_ + 1);
        const bool ends =
            at_ + 1 == text_.size() ||
            std::string_view(" \t\r\n,]}eE").find(text_[at_ + 1]) != std::string_view::npos;
        if (before == after || (before && !ends)) return;
        fail(before ? "a number ends with its point; expected a digit after it: 1.0, not 1."
                    : "a number begins with its point; expected a digit before it: 0.1, not .1");
    }

    void structure(char c) {
        switch (c) {
            case ' ':
            case '\t':
            case '\r': break;
            case '\n': end_line(); break;
            case ',':
                dots_ = 0;
                value_ = !open_.empty() && open_.back().bracket == '[';
                break;
            case '[':
            case '{':
                value_ ? open(c) : begin_header();
                value_ = value_ && c == '[';
                break;
            case ']':
            case '}':
                value_ = !open_.empty();
                if (value_) close_bracket();
                break;
            case '.':
                if (!value_) ++dots_;
                check_levels();
                [[fallthrough]];
            default: word_ = value_; value_ = value_ || c == '=';
        }
    }

    void end_line() {
        line_begin_ = at_ + 1;
        value_ = value_ && !open_.empty();
        if (!open_.empty()) return;
        if (in_header_) header_dots_ = dots_;
        in_header_ = false;
        dots_ = 0;
    }

    void begin_header() {
        if (in_header_ || !open_.empty()) return;
        in_header_ = true;
        header_dots_ = 0;
        if (headers_) headers_->push_back(line_begin_);
    }

    /// The dots of the key before a bracket count until the bracket is closed.
    void open(char bracket) {
        open_.push_back({bracket, dots_});
        levels_ += 1 + dots_;
        dots_ = 0;
        check_levels();
    }

    void close_bracket() {
        dots_ = open_.back().dots;
        levels_ -= 1 + dots_;
        open_.pop_back();
    }

    void check_levels() const {
        if (levels_ + dots_ + (in_header_ ? 0 : header_dots_) >= most_toml_levels)
            fail("too many levels of keys and brackets; expected fewer than " +
                 std::to_string(most_toml_levels));
    }

    void comment() {
        for (; at_ < text_.size() && text_[at_] != '\n'; ++at_)
            if (is_beyond_ascii(text_[at_])) text_[at_] = '?';
    }

    void string(char quote) {
        const std::string three(3, quote);
        const bool lines = stands_here(three);
        const std::string_view end = std::string_view(three).substr(0, lines ? 3 : 1);
        at_ += end.size();
        before_ = quote;
        while (at_ < text_.size() && (lines || text_[at_] != '\n')) {
            if (stands_here(end)) return close(quote, end.size());
            if (quote == '"' && text_[at_] == '\\')
                escape(lines);
            else
                ++at_;
        }
    }

    /// Three quotation marks may come after up to two that belong to the string.
    void close(char quote, std::size_t marks) {
        at_ += marks;
        for (int more = 0; marks == 3 && more < 2 && at_ < text_.size() && text_[at_] == quote;
             ++more)
            ++at_;
    }

    void escape(bool lines) {
        ++at_;
        const std::size_t next = at_;
        while (lines && at_ < text_.size() && is_space(text_[at_])) ++at_;
        if (lines && at_ < text_.size() && is_beyond_ascii(text_[at_]))
            fail("a character beyond ASCII after a backslash; expected it in the line before");
        if (at_ == next && at_ < text_.size() && text_[at_] != '\n') ++at_;
    }

    bool stands_here(std::string_view word) const {
        return text_.compare(at_, word.size(), word) == 0;
    }

    [[noreturn]] void fail(std::string_view what) const {
        const auto here = text_.begin() + std::ptrdiff_t(at_);
        throw Error(file_, 1 + static_cast<int>(std::count(text_.begin(), here, '\n')), what);
    }

    struct Bracket {
        char bracket;
        int dots;  ///< of the key before it
    };

    const std::string& file_;
    std::string& text_;
    std::vector<std::size_t>* headers_;
    std::size_t at_ = 0;
    char before_ = '\n';         ///< the last character outside of comments that is not a blank
    std::vector<Bracket> open_;  ///< of arrays and inline tables
    int levels_ = 0;             ///< of the open brackets and their keys
    int dots_ = 0;               ///< in the key that is read now
    int header_dots_ = 0;        ///< in the last header
    bool in_header_ = false;
    std::size_t line_begin_ = 0;
    bool value_ = false;  ///< a value comes next, not a key
    bool word_ = false;   ///< within a value without quotation marks
};

}  // namespace

std::string toml_text(const std::string& file, std::string text,
                      std::vector<std::size_t>* headers) {
    constexpr std::string_view not_utf8 = "is not UTF-8; expected UTF-8 text";
    const std::optional<int> foreign = line_beyond_utf8(text);
    try {
        Walk(file, text, headers).run();
    } catch (const Error&) {
        if (foreign) throw Error(file, *foreign, not_utf8);
        throw;
    }
    if (foreign)
        if (const auto line = line_beyond_utf8(text)) throw Error(file, *line, not_utf8);
    return text;
}

}  // namespace gw::scene
