// From arguments to an exit code. The only place that catches.
#include "apps/command/command.h"
#include "apps/command/terminal.h"
#include "apps/picture/saved_options.h"
#include "gw/error.h"
#include "render/words/option_values.h"
#include "scene/text/suggest.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <new>
#include <optional>
#include <string>
#include <vector>

namespace gw::apps {
namespace {

std::vector<std::string> long_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    }
    return names;
}

std::vector<std::string> command_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands(nullptr))
        names.push_back(command->get_name());
    return names;
}

/// The first word that parsing left over: "unknown option --siez of gw render; the nearest known is
/// --size". Needs allow_extras().
std::optional<std::string> mistyped(const CLI::App& app) {
    const auto chosen = app.get_subcommands();
    const CLI::App& at = chosen.empty() ? app : *chosen.front();
    std::vector<std::string> words = at.remaining();
    std::erase(words, "--");  // CLI11 keeps the mark, though not the words behind it
    if (words.empty()) return {};
    if (&at == &app && words.front()[0] != '-')
        return scene::unknown("command", words.front(), command_names(app));
    const auto option =
        std::find_if(words.begin(), words.end(), [](const std::string& w) { return w[0] == '-'; });
    if (option != words.end()) {
        const std::string name = option->substr(0, option->find('='));
        return scene::unknown("option", name, long_names(at));
    }
    return "unexpected word '" + scene::printable(words.front()) + "' after gw " + at.get_name() +
           "; expected what gw " + at.get_name() + " --help lists";
}

bool is_blank(const std::string& value) {
    return value.find_first_not_of(" \t\n\r\v\f") == value.npos;
}

/// An option that was given without a value, as by an unset variable of a shell, must not pass for
/// an absent one. Nor must '-', which means standard output elsewhere, become a file of that name.
/// The words for a program of gw gl are the program's.
void check_values(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options()) {
        const std::vector<std::string>& values = option->results();
        const std::size_t ours = option->get_name() == "PROGRAM" ? 1 : values.size();
        for (std::size_t i = 0; i < std::min(ours, values.size()); ++i) {
            if (is_blank(values[i]))
                throw UsageError(option->get_name() + " is empty; expected " +
                                 option->get_type_name());
            if (values[i] == "-")
                throw UsageError(option->get_name() +
                                 " is '-', but no command reads or writes standard streams; "
                                 "expected " +
                                 option->get_type_name());
        }
    }
    for (const CLI::App* inner : command.get_subcommands()) check_values(*inner);
}

constexpr const char* about =
    "A graphics workstation of 1991 in software, and the rendering that was invented for it.";

int report(ExitCode code, std::string_view what) {
    print_error("gw: " + as_one_line(what) + "\n");
    return code;
}

void add_commands(CLI::App& app, std::vector<Command>& commands) {
    for (auto add :
         {add_render,   add_join,        add_passes,    add_record,       add_replay, add_verify,
          add_diff,     add_pixel,       add_maps,      add_inspect,      add_hidden, add_play,
          add_quiz,     add_grade,       add_autograde, add_fragments,    add_styles, add_cast,
          add_compare,  add_radiosity,   add_figures,   add_study,        add_golden, add_info,
          add_describe, add_conformance, add_gl,        add_irisgl_config}) {
        commands.push_back(add(app));
    }
#ifdef GW_WITH_WINDOW
    commands.push_back(add_view(app));
#endif
    // so that `mistyped` sees the word
    for (const Command& command : commands) command.app->allow_extras();
}

int parse_and_run(CLI::App& app, const std::vector<Command>& commands, Session& session) {
    try {
        app.parse(std::vector<std::string>(session.words.rbegin(), session.words.rend()));
    } catch (const CLI::CallForVersion& asked) {
        print(asked.what() + std::string("\n"));
        return Done;
    } catch (const CLI::Success&) {
        print(app.help());
        return Done;
    } catch (const CLI::ParseError& error) {
        throw UsageError(mistyped(app).value_or(error.what()));
    }
    if (const auto word = mistyped(app)) throw UsageError(*word);
    for (const Command& command : commands) {
        if (!*command.app) continue;
        check_values(*command.app);
        take_saved_options(*command.app);
        return command.run(session);
    }
    throw UsageError("no command; expected one of those that gw --help lists");
}

std::string shell_word(const std::string& word) {
    if (!word.empty() && word.find_first_of(" \t\n'\"\\$&;()<>|*?[]{}#~`!") == word.npos)
        return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

}  // namespace

std::string version() { return GW_VERSION; }

std::string shell_command(const std::vector<std::string>& words) {
    std::string text = "build/release/bin/gw";
    for (const std::string& word : words) text += " " + shell_word(word);
    return text;
}

int run_command(Session session) {
    CLI::App app{about, "gw"};
    app.footer(
        "Exit codes: 0 done, 1 wrong input or output that cannot be written, 2 usage, 3 a "
        "difference found.\n"
        "Example:\n"
        "  build/release/bin/gw render scenes/rings.toml -o rings.png");
    app.set_version_flag("--version", "gw " + version());
    app.allow_extras();
    std::vector<Command> commands;
    add_commands(app, commands);
    return parse_and_run(app, commands, session);
}

int run(const std::vector<std::string>& arguments) {
    try {
        const int code = run_command({.words = arguments});
        flush_output();
        return code;
    } catch (const render::OptionError& error) {
        return report(Usage, error.what());
    } catch (const UsageError& error) {
        return report(Usage, error.what());
    } catch (const Error& error) {
        return report(Failed, error.what());
    } catch (const std::bad_alloc&) {
        return report(Failed, "out of memory");
    } catch (const std::exception& error) {
        return report(Failed, error.what());
    }
}

}  // namespace gw::apps
