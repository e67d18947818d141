#include "apps/picture/saved_options.h"

#include "apps/command/command.h"
#include "gw/error.h"
#include "render/options.h"
#include "scene/text/suggest.h"
#include "scene/toml/toml_view.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace gw::apps {
namespace {

std::vector<std::string> savable() {
    std::vector<std::string> names;
    for (const render::Option& option : render::options())
        if (is_saved(option.name)) names.push_back(option.name);
    return names;
}

void check_name(const scene::SavedOption& option) {
    const std::vector<std::string> known = savable();
    if (std::find(known.begin(), known.end(), option.name) == known.end())
        throw Error(option.origin.file, option.origin.line,
                    scene::unknown("key", option.name, known) + " (picture)");
}

}  // namespace

bool is_saved(const std::string& option) {
    return option != "threads" && option != "eye" && option != "at" && option != "up" &&
           option != "fov";
}

void take_saved_options(CLI::App& command) {
    const CLI::Option* scene = command.get_option_no_throw("SCENE");
    if (scene == nullptr || scene->count() == 0) return;
    for (const scene::SavedOption& saved : scene::saved_options(scene->as<std::string>())) {
        check_name(saved);
        CLI::Option* option = command.get_option_no_throw("--" + saved.name);
        if (option == nullptr || option->count() > 0) continue;
        try {
            option->add_result(saved.word);
            option->run_callback();
        } catch (const UsageError& error) {
            throw Error(saved.origin.file, saved.origin.line, error.what());
        } catch (const CLI::Error& error) {
            throw Error(saved.origin.file, saved.origin.line, error.what());
        }
    }
}

}  // namespace gw::apps
