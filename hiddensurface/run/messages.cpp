#include "hiddensurface/run/messages.h"

#include "hiddensurface/run/step_words.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>
#include <vector>

namespace gw::hiddensurface {
namespace {

using Json = nlohmann::ordered_json;
using Texts = std::vector<std::string>;

/// What stands in the text for {0}, {1}, ... of the pattern, which come in this order.
std::optional<Texts> values_in(const std::string& text, const std::string& pattern) {
    Texts values;
    std::size_t at = 0, from = 0;
    for (std::size_t open; (open = pattern.find('{', from)) != pattern.npos; from = open + 3) {
        const std::string before = pattern.substr(from, open - from);
        if (text.compare(at, before.size(), before) != 0) return {};
        at += before.size();
        const std::string after =
            pattern.substr(open + 3, pattern.find('{', open + 3) - (open + 3));
        const bool is_last = open + 3 + after.size() == pattern.size();
        const std::size_t end = !is_last                     ? text.find(after, at + 1)
                                : text.size() > after.size() ? text.size() - after.size()
                                                             : text.npos;
        if (end == text.npos || end <= at) return {};
        values.push_back(text.substr(at, end - at));
        at = end;
    }
    if (text.compare(at, text.npos, pattern.substr(from)) != 0) return {};
    return values;
}

std::string said(const std::string& text, const Json& patterns) {
    for (const auto& [pattern, words] : patterns.items()) {
        const std::optional<Texts> values = values_in(text, pattern);
        if (!values) continue;
        const std::string& line = words.get_ref<const std::string&>();
        std::string filled;
        for (std::size_t at = 0; at < line.size();) {
            const std::size_t open = std::min(line.find('{', at), line.size());
            filled += line.substr(at, open - at);
            if (open < line.size()) {
                const std::string& value = values->at(line[open + 1] - '0');
                const bool is_quoted = open > 0 && line[open - 1] == '\'';
                filled += is_quoted ? value : said(value, patterns);
            }
            at = open + 3;
        }
        return filled;
    }
    return text;
}

/// Longer lines are not ours.
constexpr std::size_t longest_message = 400;

}  // namespace

std::string messages_in(const std::string& text, const std::string& language) {
    if (language == "en") return text;
    static const Json patterns = Json::parse(embedded_words("messages.ja.json"));
    std::string lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string line = text.substr(at, end - at);
        lines += line.size() > longest_message ? line : said(line, patterns);
        lines += end < text.size() ? "\n" : "";
        at = end + 1;
    }
    return lines;
}

}  // namespace gw::hiddensurface
