#include "apps/describe/completion.h"

#include "apps/describe/described.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

namespace gw::apps {
namespace {

std::string names_of(const std::vector<DescribedCommand>& commands) {
    std::vector<std::string> names;
    for (const DescribedCommand& command : commands) names.push_back(command.name);
    return fmt::format("{}", fmt::join(names, " "));
}

std::string dashed_words(const DescribedCommand& command) {
    std::vector<std::string> words;
    for (const DescribedOption& option : command.options)
        if (!option.positional) words.insert(words.end(), option.words.begin(), option.words.end());
    return fmt::format("{}", fmt::join(words, " "));
}

/// "render:--profile" to "vgx reality ideal", as lines of a `case`.
std::string value_cases(const std::vector<DescribedCommand>& commands) {
    std::string lines;
    for (const DescribedCommand& command : commands)
        for (const DescribedOption& option : command.options)
            if (!option.positional && !option.values.empty())
                lines += fmt::format("        {}:{}) words=\"{}\" ;;\n", command.name,
                                     option.words.back(), fmt::join(option.values, " "));
    return lines;
}

/// "text" with what zsh reads in a specification taken care of.
std::string zsh_text(const std::string& text) {
    std::string result;
    for (const char c : text.substr(0, text.find('\n'))) {
        if (c == '\'') {
            result += "'\\''";
            continue;
        }
        if (c == ':' || c == '[' || c == ']' || c == '\\') result += '\\';
        result += c;
    }
    return result;
}

std::string zsh_argument(const DescribedOption& option) {
    if (!option.values.empty())
        return fmt::format(":{}:({})", option.type, fmt::join(option.values, " "));
    return fmt::format(":{}:_files", zsh_text(option.type.empty() ? "file" : option.type));
}

std::string zsh_option(const DescribedOption& option) {
    if (option.positional) return fmt::format("        '{}'", zsh_argument(option));
    std::string lines;
    for (const std::string& word : option.words)
        lines +=
            fmt::format("{}        '{}[{}]{}'", lines.empty() ? "" : " \\\n", word,
                        zsh_text(option.about), option.type.empty() ? "" : zsh_argument(option));
    return lines;
}

std::string zsh_case(const DescribedCommand& command) {
    std::vector<std::string> options;
    for (const DescribedOption& option : command.options) options.push_back(zsh_option(option));
    return fmt::format("    {}) _arguments \\\n{} ;;\n", command.name, fmt::join(options, " \\\n"));
}

}  // namespace

std::string bash_completion(const CLI::App& root) {
    const auto commands = described_commands(root);
    std::string options;
    for (const DescribedCommand& command : commands)
        options +=
            fmt::format("            {}) words=\"{}\" ;;\n", command.name, dashed_words(command));
    return fmt::format(R"(# bash completion of gw; made by gw describe bash
_gw() {{
    local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} command=${{COMP_WORDS[1]}} words=
    if ((COMP_CWORD == 1)); then
        words="{} --help --version"
    else
        case $command:$before in
{}        esac
        if [[ -z $words && $word == -* ]]; then
            case $command in
{}            esac
        fi
    fi
    COMPREPLY=($(compgen -W "$words" -- "$word"))
    ((${{#COMPREPLY[@]}})) || COMPREPLY=($(compgen -f -- "$word"))
}}
complete -o filenames -F _gw gw
)",
                       names_of(commands), value_cases(commands), options);
}

std::string zsh_completion(const CLI::App& root) {
    const auto commands = described_commands(root);
    std::string list, cases;
    for (const DescribedCommand& command : commands) {
        list += fmt::format("    '{}:{}'\n", command.name, zsh_text(command.about));
        cases += zsh_case(command);
    }
    return fmt::format(R"(#compdef gw
# zsh completion of gw; made by gw describe zsh
local -a commands=(
{})
if ((CURRENT == 2)); then
    _describe command commands
    return
fi
local command=$words[2]
shift words
((CURRENT--))
case $command in
{}esac
)",
                       list, cases);
}

}  // namespace gw::apps
