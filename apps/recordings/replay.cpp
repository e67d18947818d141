// gw replay: executes a recording without its scene.
#include "apps/command/command.h"
#include "apps/command/folder_index.h"
#include "apps/command/option_values.h"
#include "apps/command/terminal.h"
#include "apps/recordings/machine_options.h"
#include "apps/recordings/on_opengl.h"
#include "apps/recordings/recording_files.h"
#include "gw/error.h"
#include "gw/escape_controls.h"
#include "image/plane_pictures.h"
#include "image/planes.h"
#include "image/write.h"
#include "inspect/compare/compare_machines.h"
#include "inspect/replay/player.h"
#include "inspect/replay/shown_maps.h"
#include "inspect/text/plural.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

namespace gw::apps {
namespace {

struct ReplayOptions {
    RecordingChoice recording;
    std::filesystem::path picture, planes;
    MachineOptions machine;
    OnOpengl on;
    bool indices = false;
};

void add_options(CLI::App& command, ReplayOptions& options) {
    add_recording_options(command, options.recording);
    command.add_option("-o,--output", options.picture, "The colour plane at the end, as a picture")
        ->type_name("IMAGE");
    command
        .add_option("--planes", options.planes,
                    "The planes at the end: values as EXR, false colours as PNG")
        ->type_name("DIR");
    command.add_flag(
        "--indices", options.indices,
        "Of a program of IRIS GL in colour map mode: pictures have the indices, low bits "
        "in R, high bits in G, instead of the map's colours");
    add_machine_options(command, options.machine);
#ifdef GW_WITH_OPENGL
    command
        .add_option(
            "--on", options.on.implementation,
            "Also on another OpenGL: osmesa (Mesa), gl (libGL.so.1 on $DISPLAY), or the path "
            "of a libOSMesa or libGL; prints how colour, Z and stencil differ. With --output: "
            "a picture of the differences after the pass that has most")
        ->type_name("NAME|PATH");
    command
        .add_option_function<std::string>(
            "--passes",
            [&](const std::string& word) {
                options.on.passes = range_from("--passes", word, 0, 99'999'999);
            },
            "With --on: compare only these passes, numbered from 0")
        ->type_name("A-B");
#endif
}

void check(const ReplayOptions& options) {
    const bool on_opengl = !options.on.implementation.empty();
    if (on_opengl && (options.machine.both() || !options.planes.empty()))
        throw UsageError(
            "--on compares with the reference machine; expected no --planes or --machine both");
    if (!on_opengl && options.on.passes) throw UsageError("--passes: expected --on");
    if (!options.picture.empty()) check_picture_target(options.picture);
}

#ifdef GW_WITH_OPENGL
/// The differences of one window.
bool replay_on(const ReplayOptions& options, const inspect::Recording& recording) {
    const OpenglComparison comparison = compare_on_opengl(recording, options.on);
    print(comparison.text);
    if (!options.picture.empty()) {
        const WorstPass& worst = comparison.worst;
        image::write_picture(
            options.picture,
            image::distance_picture(worst.distances, recording.width, recording.height));
        print(fmt::format("{}: the colours after pass \"{}\", {}\n", options.picture.string(),
                          escape_controls(worst.name),
                          inspect::plural(worst.pixels, "pixel", "pixels")));
    }
    return comparison.same;
}

/// The window that was chosen, or all.
int replay_on_opengl(const ReplayOptions& options, Session& session) {
    const inspect::Stream stream = load_windows(options.recording, session);
    session.inputs.check(options.picture);
    if (stream.windows.size() > 1 && !options.picture.empty())
        throw UsageError("--output: one picture; expected --window");
    bool same = true;
    for (const inspect::WindowRecording& window : stream.windows) {
        if (stream.windows.size() > 1)
            print(fmt::format("window {}\n", escape_controls(window.name)));
        same = replay_on(options, window.recording) && same;
    }
    return same ? Done : Differs;
}
#endif

/// The colours, as a screen shows them.
image::Picture picture_of(const ReplayOptions& options, const inspect::Recording& recording,
                          const Planes& planes) {
    const inspect::ShownMaps maps(recording);
    if (maps.last() == nullptr || options.indices)
        return image::picture_of(planes.color, planes.width, planes.height,
                                 recording.profile.color_bits);
    return image::picture_of(inspect::through_map(planes.color, *maps.last()), planes.width,
                             planes.height, 8);
}

void write_files(const ReplayOptions& options, const inspect::Recording& recording,
                 const Planes& planes, const Session& session) {
    image::OutputSet output(session.inputs);
    if (!options.planes.empty()) {
        output.make_folder(options.planes);
        const image::Picture shown = picture_of(options, recording, planes);
        image::put_planes(output, options.planes, planes, recording.profile, &shown);
    }
    if (!options.picture.empty())
        image::put_picture(output.add(options.picture), picture_of(options, recording, planes));
    if (!options.planes.empty()) put_index(output, options.planes, session);
    output.commit();
}

int replay(const ReplayOptions& options, Session& session) {
    check(options);
    Progress progress("reading", options.machine.quiet);
#ifdef GW_WITH_OPENGL
    if (!options.on.implementation.empty()) return replay_on_opengl(options, session);
#endif
    const inspect::Recording recording = load_recording(options.recording, session);
    session.inputs.check(options.picture);
    progress.at("replaying");
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
    const std::string summary =
        fmt::format("{}, {}, {} x {} pixels on profile {}{}\n",
                    inspect::plural(machine->passes().size(), "pass", "passes"),
                    inspect::plural(inspect::command_count(recording), "command", "commands"),
                    recording.width, recording.height, escape_controls(recording.profile.name),
                    options.machine.both()
                        ? ": reference and fast agree in every plane and counter after every pass"
                        : "");
    write_files(options, recording, machine->planes(), session);
    print(summary);  // without memory: the files are there
    return Done;
}

}  // namespace

Command add_replay(CLI::App& app) {
    CLI::App* command = app.add_subcommand("replay", "A recording on a machine, without its scene");
    const auto options = std::make_shared<ReplayOptions>();
    add_options(*command, *options);
    command->footer(
        "Exit code 3 if machines or implementations differ.\n"
        "Example:\n"
        "  build/release/bin/gw record scenes/rings.toml -o rings.gwt && build/release/bin/gw "
        "replay rings.gwt --machine both -o rings.png");
    return {command, [options](Session& session) { return replay(*options, session); }};
}

}  // namespace gw::apps
