// gw pixel: prints every fragment of one pixel of a recording, and its fate.
#include "apps/command/command.h"
#include "apps/command/option_values.h"
#include "apps/command/table.h"
#include "apps/command/terminal.h"
#include "apps/recordings/recording_files.h"
#include "gw/error.h"
#include "inspect/replay/pixel_history.h"
#include "scene/draw/draw_commands.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace gw::apps {
namespace {

struct PixelOptions {
    RecordingChoice recording;
    int x = 0, y = 0;
    std::uint32_t surface = 0;
    bool json = false, quiet = false;
};

void add_options(CLI::App& command, PixelOptions& options) {
    add_recording_options(command, options.recording);
    add_surface_option(command, options.surface);
    const auto coordinate = [&](const char* name, int& to, const char* help) {
        command
            .add_option_function<std::string>(
                name,
                [name, &to](const std::string& word) {
                    to = whole_number_from(name, word, 0, max_surface_size - 1);
                },
                help)
            ->required()
            ->type_name("N");
    };
    coordinate("X", options.x, "Column of the picture, from 0 at the left");
    coordinate("Y", options.y, "Row of the picture, from 0 at the top");
    command.add_flag("--json", options.json, "As JSON");
    command.add_flag("--quiet", options.quiet, "No progress");
}

int show_pixel(const PixelOptions& options, Session& session) {
    Progress progress("reading", options.quiet);
    const inspect::Recording recording = load_recording(options.recording, session);
    const Surface size = chosen_surface(recording, options.recording, options.surface);
    if (options.x >= size.width || options.y >= size.height)
        throw Error(fmt::format(
            "pixel {} {} is outside the picture of {} x {}; expected 0..{} 0..{}", options.x,
            options.y, size.width, size.height, size.width - 1, size.height - 1));
    progress.at("replaying on the reference machine");
    const int y = size.height - 1 - options.y;
    auto events = inspect::pixel_history(recording, options.x, y, options.surface);
    if (writes_identifiers(recording))
        for (inspect::PixelEvent& event : events)
            if (event.fragment) event.polygon = scene::id_of(event.fragment->color);
    print(options.json
              ? history_json(recording, options.x, y, events, options.surface)
                        .dump(2, ' ', true, nlohmann::ordered_json::error_handler_t::replace) +
                    "\n"
              : table(history_rows(events)));
    return Done;
}

}  // namespace

Command add_pixel(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("pixel", "The history of a pixel: every fragment, and why it died");
    const auto options = std::make_shared<PixelOptions>();
    add_options(*command, *options);
    command->footer(
        "Example:\n  build/release/bin/gw record scenes/rings.toml -o rings.gwt --size 320x240 && "
        "build/release/bin/gw pixel rings.gwt 160 120");
    return {command, [options](Session& session) { return show_pixel(*options, session); }};
}

}  // namespace gw::apps
