#include "apps/describe/man_page.h"

#include "apps/command/versions.h"
#include "apps/describe/described.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <sstream>

namespace gw::apps {
namespace {

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

}  // namespace

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

}  // namespace gw::apps
