#include "apps/describe/described.h"

#include "gw/profile.h"
#include "hiddensurface/interface/algorithm.h"
#include "render/options.h"

#include <CLI/CLI.hpp>

namespace gw::apps {
namespace {

std::vector<std::string> algorithm_names() {
    std::vector<std::string> names;
    for (const auto& algorithm : hiddensurface::algorithms()) names.push_back(algorithm.name);
    return names;
}

/// The values of an option of this name, which are the same in every command.
std::vector<std::string> values_of(const std::string& option) {
    if (option == "--algorithm") return algorithm_names();
    for (const render::Option& known : render::options())
        if (option == "--" + known.name) return known.words;
    return {};
}

DescribedOption described(const CLI::Option& option) {
    DescribedOption result;
    result.positional = option.get_positional();
    if (result.positional)
        result.words = {option.get_name(true)};
    else {
        for (const std::string& name : option.get_snames()) result.words.push_back("-" + name);
        for (const std::string& name : option.get_lnames()) result.words.push_back("--" + name);
    }
    if (option.get_items_expected_max() > 0) result.type = option.get_type_name();
    result.about = option.get_description();
    result.values = values_of(result.words.back());
    return result;
}

}  // namespace

std::vector<DescribedCommand> described_commands(const CLI::App& root) {
    std::vector<DescribedCommand> commands;
    for (const CLI::App* app : root.get_subcommands([](const CLI::App*) { return true; })) {
        DescribedCommand command{app->get_name(), app->get_description(), app->get_footer(), {}};
        for (const CLI::Option* option : app->get_options())
            if (!option->get_group().empty())  // else only an error has it
                command.options.push_back(described(*option));
        commands.push_back(std::move(command));
    }
    return commands;
}

}  // namespace gw::apps
