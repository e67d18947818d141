// gw diff: the first difference of two recordings or two manifests, in their commands and in their
// results.
#include "apps/command/command.h"
#include "apps/command/option_values.h"
#include "apps/command/terminal.h"
#include "apps/recordings/machine_options.h"
#include "apps/recordings/recording_files.h"
#include "gw/error.h"
#include "image/plane_pictures.h"
#include "image/write.h"
#include "inspect/compare/difference.h"
#include "inspect/compare/verify.h"
#include "inspect/recording/read_bytes.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

namespace gw::apps {
namespace {

struct DiffOptions {
    std::filesystem::path a, b, picture;
    std::string window;  ///< of both recordings
    int pixels = 10;
    bool quiet = false;
};

image::Picture picture_of(const inspect::ResultDifference& d) {
    return image::distance_picture(inspect::distances(d.a, d.b, d.plane), d.a.width, d.a.height);
}

Planes values_after(const inspect::ManifestFile& file, std::size_t pass) {
    const inspect::Manifest& m = file.manifest;
    return inspect::planes_after(file.values, m.width, m.height, pass, m.profile.color_planes);
}

int diff_manifests(const DiffOptions& options) {
    const inspect::ManifestFile a = inspect::load_manifest(options.a),
                                b = inspect::load_manifest(options.b);
    const auto finding = inspect::first_difference(a.manifest, b.manifest);
    if (!finding) {
        print("the same profile, window, passes, states, counters and planes\n");
        return Done;
    }
    print(inspect::text(*finding, a.manifest.height));
    if (!finding->pass || !finding->what.starts_with("plane ") || a.values.empty() ||
        b.values.empty())
        return Differs;
    const inspect::ResultDifference d =
        inspect::located({.finding = *finding,
                          .a = values_after(a, *finding->pass),
                          .b = values_after(b, *finding->pass),
                          .map_a = map_of_pass(a.manifest, *finding->pass),
                          .map_b = map_of_pass(b.manifest, *finding->pass)});
    print(inspect::text(d.finding, a.manifest.height) +
          inspect::wrong_pixel_lines(d, std::size_t(options.pixels)));
    if (!options.picture.empty()) image::write_picture(options.picture, picture_of(d));
    return Differs;
}

int diff_recordings(const DiffOptions& options, Session& session, Progress& progress) {
    const inspect::Recording a = load_recording({options.a, options.window}, session),
                             b = load_recording({options.b, options.window}, session);
    const auto commands = first_command_difference(a, b);
    if (commands) print("commands: " + text(*commands, a.height));
    const auto maps = first_map_difference(a, b);
    if (maps) print("colour map: " + text(*maps, a.height));
    if (a.width != b.width || a.height != b.height) return Differs;
    progress.at("replaying");
    const auto result = first_result_difference(a, b, inspect::maker_of("fast"));
    if (!result) {
        print(commands || maps ? "result: the same planes after every pass that both have\n"
                               : "the same commands; the same planes after every pass\n");
        return commands || maps ? Differs : Done;
    }
    const ivec2 worst = *result->finding.pixel;
    print("result: " + text(result->finding, a.height));
    print("first difference in its history:\n" + first_event_difference(a, b, worst.x, worst.y));
    print("wrong pixels, worst first:\n" + wrong_pixel_lines(*result, std::size_t(options.pixels)));
    if (!options.picture.empty()) image::write_picture(options.picture, picture_of(*result));
    return Differs;
}

int diff(const DiffOptions& options, Session& session) {
    if (!options.picture.empty()) check_picture_target(options.picture);
    session.inputs.add(options.a);
    session.inputs.add(options.b);
    session.inputs.check(options.picture);
    Progress progress("reading", options.quiet);
    const bool a = inspect::is_manifest(inspect::first_bytes(options.a)),
               b = inspect::is_manifest(inspect::first_bytes(options.b));
    if (a != b)
        throw Error(
            (a ? options.b : options.a).string(), 0,
            "is a recording, the other file a manifest; expected two of a kind (gw verify compares "
            "a recording with a manifest)");
    return a ? diff_manifests(options) : diff_recordings(options, session, progress);
}

}  // namespace

Command add_diff(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("diff", "The first difference of two recordings or manifests");
    const auto options = std::make_shared<DiffOptions>();
    command->add_option("A", options->a, "A recording or a manifest")
        ->required()
        ->type_name("FILE");
    command->add_option("B", options->b, "Another of the same kind")->required()->type_name("FILE");
    add_window_option(*command, options->window);
    command
        ->add_option("-o,--output", options->picture,
                     "A picture of the first plane that differs: equal pixels black, "
                     "the worst white")
        ->type_name("IMAGE");
    command
        ->add_option_function<std::string>(
            "--pixels",
            [options](const std::string& word) {
                options->pixels = whole_number_from("--pixels", word, 1, 1000000);
            },
            "List at most N wrong pixels (default 10)")
        ->type_name("N");
    command->add_flag("--quiet", options->quiet, "No progress");
    command->footer(
        "Exit code 3 if they differ.\n"
        "Example:\n"
        "  build/release/bin/gw record scenes/rings.toml -o rings.gwt --size 160x120 && "
        "build/release/bin/gw diff rings.gwt rings.gwt");
    return {command, [options](Session& session) { return diff(*options, session); }};
}

}  // namespace gw::apps
