// gw view: a window on the machine [K, F4].
#include "apps/command/command.h"
#include "apps/picture/picture_options.h"
#include "apps/view/viewer.h"
#include "apps/view/window.h"
#include "gw/error.h"

#include <CLI/CLI.hpp>

namespace gw::apps {
namespace {

/// How often finished work is looked for.
constexpr std::chrono::milliseconds busy_wait{1}, idle_wait{50};

struct ViewOptions {
    PictureOptions picture;
    std::filesystem::path folder{"."};
};

void show_window(Viewer& viewer, const std::string& title) {
    const image::Picture first = viewer.screen();
    const std::unique_ptr<Window> window = open_window(title, first.width, first.height);
    window->show(first);
    while (!viewer.is_finished()) {
        auto wait = viewer.is_busy() ? busy_wait : idle_wait;
        while (const auto input = window->next_input(wait)) {
            viewer.handle(*input);
            wait = {};
        }
        if (viewer.advance()) window->show(viewer.screen());
    }
}

int view(const ViewOptions& options, Session& session) {
    if (!std::filesystem::is_directory(options.folder))
        throw Error(options.folder.string() + " is no folder; expected one to save views in");
    ViewedScene viewed = load_viewed_scene(options.picture, options.folder, session);
    const Settings settings{.picture = options.picture, .camera = *viewed.scene.camera};
    Viewer viewer(std::move(viewed), settings);
    show_window(viewer, options.picture.scene.filename().string() + " - gw view");
    return Done;
}

}  // namespace

Command add_view(CLI::App& app) {
    CLI::App* command = app.add_subcommand("view", "A window: look at a scene from all sides");
    const auto options = std::make_shared<ViewOptions>();
    add_picture_options(*command, options->picture);
    command
        ->add_option("--into", options->folder,
                     "The folder in which s saves views and p pictures (default: this one)")
        ->type_name("DIR");
    command->footer(
        "Drag orbits, right or Shift pans, the wheel zooms; ? shows the keys.\n"
        "Example:\n  build/release/bin/gw view scenes/fig9.toml");
    return {command, [options](Session& session) { return view(*options, session); }};
}

}  // namespace gw::apps
