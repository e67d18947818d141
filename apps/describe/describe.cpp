// gw describe: the command's own words for a shell that completes them and for man. Built from the
// same options as --help.
#include "apps/command/command.h"
#include "apps/command/option_values.h"
#include "apps/command/terminal.h"
#include "apps/describe/completion.h"
#include "apps/describe/man_page.h"

#include <CLI/CLI.hpp>

namespace gw::apps {
namespace {

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
