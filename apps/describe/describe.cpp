// gw describe: scripts with which bash and zsh complete the command's words, and its man page. All
// are built from the options that --help lists.
#include "apps/command/command.h"
#include "apps/command/option_values.h"
#include "apps/command/terminal.h"
#include "apps/describe/described.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <sstream>
#include <string>

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

/// The first line of the text, escaped for a specification of zsh.
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

/// Text that roff reads as it stands: no escapes, and no line that looks like a request.
std::string roff(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n'))
            result += "\\&" + std::string(1, c);
        else
            result += c;
    }
    return result;
}

/// Lines stay lines.
std::string roff_lines(const std::string& text) {
    std::istringstream in(text);
    std::string result, line;
    while (std::getline(in, line)) result += (result.empty() ? "" : "\n.br\n") + roff(line);
    return result;
}

std::string option_entry(const DescribedOption& option) {
    std::vector<std::string> words;
    for (const std::string& word : option.words) words.push_back("\\fB" + roff(word) + "\\fR");
    const std::string type = option.type.empty() ? "" : " \\fI" + roff(option.type) + "\\fR";
    return fmt::format(".TP\n{}{}\n{}\n", fmt::join(words, ", "), type, roff_lines(option.about));
}

std::string command_section(const DescribedCommand& command) {
    std::string section =
        fmt::format(".SS gw {}\n{}\n", roff(command.name), roff_lines(command.about));
    for (const DescribedOption& option : command.options) section += option_entry(option);
    return section + fmt::format(".PP\n{}\n", roff_lines(command.footer));
}

std::string man_page(const CLI::App& root) {
    std::string page = fmt::format(
        ".\\\" made by gw describe man\n"
        ".TH GW 1 \"\" \"gw {}\" \"User Commands\"\n"
        ".SH NAME\n"
        "gw \\- {}\n"
        ".SH SYNOPSIS\n"
        ".B gw\n"
        "\\fICOMMAND\\fR [\\fIOPTION\\fR]...\n"
        ".SH COMMANDS\n",
        version(), roff("graphics workstation of 1991 in software, exact to the bit"));
    for (const DescribedCommand& command : described_commands(root))
        page += command_section(command);
    return page + fmt::format(".SH EXIT STATUS AND EXAMPLE\n{}\n", roff_lines(root.get_footer()));
}

std::string described(const CLI::App& root, const std::string& form) {
    if (form == "bash") return bash_completion(root);
    if (form == "zsh") return zsh_completion(root);
    return man_page(root);
}

}  // namespace

Command add_describe(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("describe", "Completion for bash and zsh, and the man page");
    const auto form = std::make_shared<std::string>();
    command
        ->add_option_function<std::string>(
            "FORM",
            [form](const std::string& word) {
                *form = one_of("FORM", word, {"bash", "zsh", "man"});
            },
            "bash, zsh or man")
        ->required();
    command->footer(
        "For this shell: source <(gw describe bash); to read: gw describe man | man -l -\n"
        "Example:\n  build/release/bin/gw describe man");
    return {command, [&app, form](Session&) {
                print(described(app, *form));
                return Done;
            }};
}

}  // namespace gw::apps
