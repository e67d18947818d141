// gw record: writes everything that enters the machine while a scene is drawn.
#include "apps/command/command.h"
#include "apps/command/terminal.h"
#include "apps/recordings/recording_files.h"
#include "gw/error.h"
#include "hiddensurface/interface/algorithm.h"
#include "image/output/output_set.h"
#include "inspect/compare/verify.h"

#include <CLI/CLI.hpp>

#include <fstream>

namespace gw::apps {
namespace {

struct RecordOptions {
    PictureOptions picture;
    std::string algorithm;  ///< a hidden-surface algorithm; empty: the renderer's passes
    std::filesystem::path output, manifest;
    bool values = true;
    bool stream = false;
};

void add_options(CLI::App& command, RecordOptions& options) {
    add_picture_options(command, options.picture);
    command.add_option("-o,--output", options.output, "The recording, usually .gwt")
        ->required()
        ->type_name("FILE.gwt");
    command
        .add_option_function<std::string>(
            "--algorithm",
            [&](const std::string& word) {
                options.algorithm = one_of("--algorithm", word, hiddensurface::algorithm_names());
            },
            "Instead of a renderer, a hidden-surface algorithm of gw hidden")
        ->type_name("NAME");
    command
        .add_option(
            "--manifest", options.manifest,
            "Also write the manifest for gw verify: state, counters and digests of every pass as "
            "JSON, and the planes' values beside it")
        ->type_name("FILE.json");
    command.add_flag("--stream", options.stream,
                     "Append to the file while drawing: small memory, and the lists executed so "
                     "far stay if the drawing is ended");
    command.add_flag(
        "!--no-values", options.values,
        "With --manifest: no values; gw verify then names no pixel of another recording");
}

/// Not by a temporary name: what is written must be there if this process ends early.
int stream_to(const std::filesystem::path& file, const Drawing& drawing, const Session& session,
              const std::string& algorithm) {
    std::ofstream out(file, std::ios::binary);
    if (!out) throw Error(file.string(), 0, "cannot be written");
    try {
        record_stream(drawing, session, algorithm, out);
    } catch (const Error&) {
        if (out) throw;
        throw Error(file.string(), 0, "cannot be written");
    }
    return Done;
}

int record_scene(const RecordOptions& options, Session& session) {
    image::check_target(options.output);
    if (options.manifest == options.output)
        throw UsageError("--manifest and --output are the same file; expected two");
    if (!options.manifest.empty() && options.stream)
        throw UsageError(
            "--stream keeps no lists for --manifest; expected one of them (gw verify "
            "--update writes a manifest)");
    if (!options.manifest.empty()) image::check_target(options.manifest);
    Progress progress("reading", options.picture.quiet);
    const Drawing drawing = make_drawing(options.picture, session);
    session.inputs.check(options.output);
    session.inputs.check(options.manifest);
    progress.at("drawing");
    if (options.stream) return stream_to(options.output, drawing, session, options.algorithm);
    const inspect::Recording recording = record(drawing, session, options.algorithm);
    progress.at("writing");
    image::OutputSet output(session.inputs);
    output.add(options.output).write(inspect::encode(recording));
    if (!options.manifest.empty())
        put_manifest(output, options.manifest, recording,
                     inspect::maker_of(options.picture.machine), options.values);
    output.commit();
    return Done;
}

}  // namespace

Command add_record(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("record", "Everything that enters the machine while a scene is drawn");
    const auto options = std::make_shared<RecordOptions>();
    add_options(*command, *options);
    command->footer("Example:\n  build/release/bin/gw record scenes/rings.toml -o rings.gwt");
    return {command, [options](Session& session) { return record_scene(*options, session); }};
}

}  // namespace gw::apps
