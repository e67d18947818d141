#include "apps/describe/shell_words.h"

namespace gw::apps {
namespace {

std::string quoted(const std::string& word) {
    if (!word.empty() && word.find_first_of(" \t\n'\"\\$&;()<>|*?[]{}#~`!") == word.npos)
        return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

}  // namespace

std::string shell_command(const std::vector<std::string>& words) {
    std::string text = "build/release/bin/gw";
    for (const std::string& word : words) text += " " + quoted(word);
    return text;
}

std::vector<std::string> shell_words(const std::string& command) {
    std::vector<std::string> words;
    bool inside = false, is_quoted = false;
    for (std::size_t i = 0; i < command.size(); ++i) {
        const char c = command[i];
        const bool ends = c == ' ' && !is_quoted;
        if (!ends && !inside) words.emplace_back();
        inside = !ends;
        if (c == '\'')
            is_quoted = !is_quoted;
        else if (c == '\\' && !is_quoted && i + 1 < command.size())
            words.back() += command[++i];
        else if (!ends)
            words.back() += c;
    }
    return words;
}

}  // namespace gw::apps
