// gw replay: executes a recording without its scene.
#include "apps/command/command.h"
#include "apps/command/option_values.h"
#include "apps/command/terminal.h"
#include "apps/figures/folder_index.h"
#include "apps/recordings/machine_options.h"
#include "apps/recordings/osmesa.h"
#include "apps/recordings/recording_files.h"
#include "gw/error.h"
#include "gw/shown.h"
#include "image/planes.h"
#include "image/write.h"
#include "inspect/compare/compare_machines.h"
#include "inspect/replay/player.h"
#include "inspect/text/plural.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

namespace gw::apps {
namespace {

struct ReplayOptions {
    RecordingChoice recording;
    std::filesystem::path picture, planes;
    MachineOptions machine;
    bool on_osmesa = false;
};

void add_options(CLI::App& command, ReplayOptions& options) {
    add_recording_options(command, options.recording);
    command.add_option("-o,--output", options.picture, "The colour plane at the end, as a picture")
        ->type_name("IMAGE");
    command
        .add_option("--planes", options.planes,
                    "The planes at the end: values as EXR, false colours as PNG")
        ->type_name("DIR");
    add_machine_options(command, options.machine);
#ifdef GW_WITH_OSMESA
    command
        .add_option_function<std::string>(
            "--on",
            [&](const std::string& word) {
                options.on_osmesa = one_of("--on", word, {"osmesa"}) == "osmesa";
            },
            "osmesa: also through Mesa's OpenGL; prints how colour, "
            "Z and stencil differ after each pass")
        ->type_name("NAME");
#endif
}

void check(const ReplayOptions& options) {
    if (options.on_osmesa &&
        (options.machine.both() || !options.picture.empty() || !options.planes.empty()))
        throw UsageError(
            "--on osmesa only prints; expected no --output, --planes or --machine both");
    if (!options.picture.empty()) check_picture_target(options.picture);
}

void write_files(const ReplayOptions& options, const inspect::Recording& recording,
                 const Planes& planes, const Session& session) {
    image::OutputSet output(session.inputs);
    if (!options.planes.empty()) {
        output.make_folder(options.planes);
        image::put_planes(output, options.planes, planes, recording.profile);
    }
    if (!options.picture.empty())
        image::put_picture(output.add(options.picture),
                           image::picture_of(planes.color, planes.width, planes.height,
                                             recording.profile.color_bits));
    if (!options.planes.empty()) put_index(output, options.planes, session);
    output.commit();
}

int replay(const ReplayOptions& options, Session& session) {
    check(options);
    Progress progress("reading", options.machine.quiet);
    const inspect::Recording recording = load_recording(options.recording, session);
    session.inputs.check(options.picture);
    progress.at("replaying");
#ifdef GW_WITH_OSMESA
    if (options.on_osmesa) {
        print(compare_with_osmesa(recording, options.machine.make()));
        return Done;
    }
#endif
    if (options.machine.both()) {
        const auto finding =
            compare_machines(recording, inspect::maker_of("reference"), options.machine.make());
        if (finding) {
            print("reference (expected) and fast differ: " + text(*finding, recording.height));
            return Differs;
        }
    }
    const auto machine = options.machine.make()(recording);
    inspect::Player(recording, *machine).play();
    write_files(options, recording, machine->planes(), session);
    print(fmt::format("{}, {}, {} x {} pixels on profile {}{}\n",
                      inspect::plural(machine->passes().size(), "pass", "passes"),
                      inspect::plural(inspect::command_count(recording), "command", "commands"),
                      recording.width, recording.height, shown(recording.profile.name),
                      options.machine.both()
                          ? ": reference and fast agree in every plane and counter after every pass"
                          : ""));
    return Done;
}

}  // namespace

Command add_replay(CLI::App& app) {
    CLI::App* command = app.add_subcommand("replay", "A recording on a machine, without its scene");
    const auto options = std::make_shared<ReplayOptions>();
    add_options(*command, *options);
    command->footer(
        "Example:\n"
        "  build/release/bin/gw record scenes/rings.toml -o rings.gwt && build/release/bin/gw "
        "replay rings.gwt --machine both -o rings.png");
    return {command, [options](Session& session) { return replay(*options, session); }};
}

}  // namespace gw::apps
