#include "apps/command/shell_command.h"

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

}  // namespace gw::apps
