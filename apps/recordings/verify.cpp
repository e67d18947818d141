// gw verify: compares a recording's replay with its manifest.
#include "inspect/compare/verify.h"
#include "apps/command/command.h"
#include "apps/command/terminal.h"
#include "apps/recordings/machine_options.h"
#include "apps/recordings/recording_files.h"
#include "gw/escape_controls.h"
#include "image/output/output_set.h"
#include "inspect/text/plural.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

namespace gw::apps {
namespace {

struct VerifyOptions {
    RecordingChoice recording;
    std::filesystem::path manifest;
    MachineOptions machine;
    bool update = false, values = true;
};

void add_options(CLI::App& command, VerifyOptions& options) {
    add_recording_options(command, options.recording);
    command
        .add_option("MANIFEST", options.manifest,
                    "A manifest by gw record --manifest or gw render --manifest")
        ->required()
        ->type_name("FILE.json");
    add_machine_options(command, options.machine);
    command.add_flag("--update", options.update, "Write the manifest anew instead of checking it");
    command.add_flag("!--no-values", options.values, "With --update: no values beside it");
}

int update(const VerifyOptions& options, const inspect::Recording& recording,
           const Session& session) {
    image::OutputSet output(session.inputs);
    put_manifest(output, options.manifest, recording, options.machine.make(), options.values);
    output.commit();
    print(escape_controls(options.manifest.string()) + ": written\n");
    return Done;
}

int report(const inspect::Verification& verification, const VerifyOptions& options, int height) {
    print(text(*verification.finding, height));
    if (!verification.same_scene)
        print("  the recording's meshes or maps are not those of the manifest\n");
    else if (!verification.same_commands)
        print("  the recording's commands are not those of the manifest\n");
    else
        print(
            "  the commands are those of the manifest: the machine is not the one that wrote it\n");
    print(fmt::format("{}: not as {} says\n", escape_controls(options.recording.file.string()),
                      escape_controls(options.manifest.string())));
    return Differs;
}

int check(const VerifyOptions& options, const inspect::Recording& recording, Progress& progress) {
    const inspect::ManifestFile expected = inspect::load_manifest(options.manifest);
    if (options.machine.both()) {
        progress.at("comparing machines");
        const auto finding =
            compare_machines(recording, inspect::maker_of("reference"), options.machine.make());
        if (finding) {
            print("reference (expected) and fast differ: " + text(*finding, recording.height));
            return Differs;
        }
    }
    progress.at("verifying");
    const auto verification = inspect::verify(recording, expected.manifest, expected.values,
                                              options.machine.make(), options.machine.make_other());
    if (verification.finding) return report(verification, options, recording.height);
    if (!verification.same_commands)
        print(fmt::format(
            "{}: its commands are not those of {}, though they make the same planes{}\n",
            escape_controls(options.recording.file.string()),
            escape_controls(options.manifest.string()),
            verification.same_scene ? "" : "; meshes or maps differ too"));
    print(fmt::format("{}: as {} says, {}, every plane and counter{}\n",
                      escape_controls(options.recording.file.string()),
                      escape_controls(options.manifest.string()),
                      inspect::plural(expected.manifest.passes.size(), "pass", "passes"),
                      options.machine.both() ? ", on reference and fast" : ""));
    return Done;
}

int verify_recording(const VerifyOptions& options, Session& session) {
    if (options.update) image::check_target(options.manifest);
    Progress progress("reading", options.machine.quiet);
    const inspect::Recording recording = load_recording(options.recording, session);
    if (options.update) session.inputs.check(options.manifest);
    progress.at("replaying");
    return options.update ? update(options, recording, session)
                          : check(options, recording, progress);
}

}  // namespace

Command add_verify(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "verify", "Compares a recording with its manifest: exit code 3 if they differ");
    const auto options = std::make_shared<VerifyOptions>();
    add_options(*command, *options);
    command->footer(
        "Example:\n"
        "  build/release/bin/gw record scenes/rings.toml -o rings.gwt --manifest rings.json && "
        "build/release/bin/gw verify rings.gwt rings.json --machine both");
    return {command, [options](Session& session) { return verify_recording(*options, session); }};
}

}  // namespace gw::apps
