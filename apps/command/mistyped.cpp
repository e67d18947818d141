#include "apps/command/mistyped.h"

#include "scene/text/suggest.h"

#include <CLI/CLI.hpp>
#include <algorithm>
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

}  // namespace

std::optional<std::string> mistyped(const CLI::App& app) {
    const auto chosen = app.get_subcommands();
    const CLI::App& at = chosen.empty() ? app : *chosen.front();
    const std::vector<std::string> words = at.remaining();
    if (words.empty()) return {};
    const auto option =
        std::find_if(words.begin(), words.end(), [](const std::string& w) { return w[0] == '-'; });
    if (option != words.end()) {
        const std::string name = option->substr(0, option->find('='));
        return scene::unknown("option", name, long_names(at));
    }
    if (&at == &app) return scene::unknown("command", words.front(), command_names(app));
    return "unexpected word '" + scene::printable(words.front()) + "' after gw " + at.get_name() +
           "; expected what gw " + at.get_name() + " --help lists";
}

}  // namespace gw::apps
