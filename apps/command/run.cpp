// From arguments to an exit code. The only place that catches.
#include "apps/command/command.h"
#include "apps/command/mistyped.h"
#include "apps/command/terminal.h"
#include "apps/command/versions.h"
#include "gw/error.h"

#include <CLI/CLI.hpp>
#include <new>

namespace gw::apps {
namespace {

constexpr const char* about =
    "A graphics workstation of 1991 in software, and the rendering that was invented for it.";

int report(ExitCode code, std::string_view what) {
    print_error("gw: " + as_one_line(what) + "\n");
    return code;
}

void add_commands(CLI::App& app, std::vector<Command>& commands) {
    for (auto add : {add_render, add_passes, add_record,  add_replay,    add_verify,
                     add_diff,   add_pixel,  add_maps,    add_inspect,   add_hidden,
                     add_styles, add_cast,   add_compare, add_radiosity, add_figures,
                     add_study,  add_golden, add_info,    add_describe,  add_conformance}) {
        commands.push_back(add(app));
        commands.back().app->allow_extras();  // so that `mistyped` sees the word
    }
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
        if (*command.app) return command.run(session);
    }
    throw UsageError("no command; expected one of those that gw --help lists");
}

}  // namespace

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
