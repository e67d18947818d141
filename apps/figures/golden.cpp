// gw golden: every pass of every figure, on each profile, against manifests that are kept in a
// folder.
#include "apps/command/command.h"
#include "apps/command/progress.h"
#include "apps/command/terminal.h"
#include "apps/figures/folder_index.h"
#include "apps/figures/golden_run.h"
#include "apps/figures/panel_words.h"
#include "apps/recordings/machine_options.h"
#include "apps/recordings/recording_files.h"
#include "gw/error.h"
#include "image/write.h"
#include "inspect/manifest/merge_runs.h"
#include "inspect/text/plural.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <set>

namespace gw::apps {

namespace fs = std::filesystem;

namespace {

struct GoldenOptions {
    fs::path folder, recordings;
    std::vector<std::string> only;
    std::vector<Profile> profiles = gw::profiles();
    MachineOptions machine;
    bool update = false;
};

/// What was found in all figures so far.
struct Tally {
    std::size_t manifests = 0, passes = 0, different = 0;
    std::set<fs::path> files;
};

/// As another process would: from its bytes.
inspect::Recording reread(const inspect::Recording& recording) {
    return inspect::decode(inspect::encode(recording));
}

void keep(const GoldenOptions& options, const GoldenRecording& golden) {
    if (options.recordings.empty()) return;
    fs::path file = options.recordings / golden.file;
    make_folder(file.parent_path());
    image::OutputSet output;
    output.add(file.replace_extension(".gwt")).write(inspect::encode(golden.recording));
    output.commit();
}

std::optional<inspect::Finding> difference(const inspect::Manifest& expected,
                                           const GoldenRecording& golden,
                                           const GoldenOptions& options,
                                           inspect::Manifest& actual) {
    const inspect::Recording recording = reread(golden.recording);
    actual = merge_runs(replayed_manifest(recording, options.machine.make(), nullptr));
    auto finding = first_difference(expected, actual);
    if (finding)
        finding->notes.push_back(
            expected.commands_hash == actual.commands_hash
                ? "the commands are the same: the machine is another one"
                : "the commands are others: what makes the passes has changed");
    if (!finding && options.machine.both())
        finding =
            compare_machines(recording, inspect::maker_of("reference"), options.machine.make());
    return finding;
}

void check(const GoldenRecording& golden, const GoldenOptions& options, Tally& tally) {
    const fs::path file = options.folder / golden.file;
    const inspect::Manifest expected = inspect::load_manifest(file).manifest;
    inspect::Manifest actual;
    const auto finding = difference(expected, golden, options, actual);
    tally.passes += actual.passes.size();
    if (!finding) return;
    ++tally.different;
    print(file.string() + ": " + text(*finding, golden.recording.height));
    keep(options, golden);
}

void update(const GoldenRecording& golden, const GoldenOptions& options, Tally& tally) {
    const fs::path file = options.folder / golden.file;
    make_folder(file.parent_path());
    inspect::Manifest manifest =
        merge_runs(replayed_manifest(reread(golden.recording), options.machine.make(), nullptr));
    tally.passes += manifest.passes.size();
    image::write_file(file, to_json(manifest));
}

/// Manifests of a figure that none of its panels makes any more.
void check_unknown(const Figure& figure, const GoldenOptions& options, Tally& tally) {
    std::set<fs::path> unknown;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(options.folder / figure.name, none))
        if (!tally.files.contains(fs::path(figure.name) / entry.path().filename()))
            unknown.insert(entry.path());
    for (const fs::path& file : unknown) {
        if (options.update) {
            fs::remove(file);
        } else {
            ++tally.different;
            print(file.string() + ": no panel of this figure makes it\n");
        }
    }
}

void run_figure(const Figure& figure, const GoldenOptions& options, Progress& progress,
                Tally& tally) {
    for (std::size_t i = 0; i < figure.panels.size(); ++i) {
        progress.at(fmt::format("{}, {} of {}", figure.name, i + 1, figure.panels.size()));
        for (const GoldenRecording& golden : run_golden_panel(figure, i, options.profiles)) {
            tally.files.insert(golden.file);
            ++tally.manifests;
            (options.update ? update : check)(golden, options, tally);
        }
    }
    if (options.profiles.size() == gw::profiles().size()) check_unknown(figure, options, tally);
}

int golden(const GoldenOptions& options) {
    if (!fs::exists("scenes"))
        throw Error("scenes: does not exist; expected to be run from the repository's root");
    if (options.update) make_folder(options.folder);
    if (!fs::is_directory(options.folder))
        throw Error(options.folder.string(), 0,
                    "is no folder; expected goldens, which --update makes");
    if (!options.recordings.empty()) make_folder(options.recordings);
    Progress progress("goldens", options.machine.quiet);
    Tally tally;
    for (const Figure* figure : wanted_figures(options.only))
        run_figure(*figure, options, progress, tally);
    print(fmt::format("{}, {}: {}\n",
                      inspect::plural(std::uint64_t(tally.manifests), "manifest", "manifests"),
                      inspect::plural(std::uint64_t(tally.passes), "pass", "passes"),
                      options.update ? "written"
                      : tally.different == 0
                          ? "all as they were"
                          : inspect::plural(std::uint64_t(tally.different), "differs", "differ")));
    return tally.different == 0 ? Done : Differs;
}

}  // namespace

Command add_golden(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "golden", "Every pass of every figure against the manifests that are kept");
    const auto options = std::make_shared<GoldenOptions>();
    command->add_option("DIR", options->folder, "The folder of manifests, tests/golden")
        ->required()
        ->type_name("DIR");
    add_only_option(*command, options->only);
    command
        ->add_option_function<std::string>(
            "--profile",
            [options](const std::string& word) {
                std::vector<std::string> names;
                for (const Profile& profile : profiles()) names.push_back(profile.name);
                options->profiles = {profile_named(one_of("--profile", word, names))};
            },
            "On this profile only")
        ->type_name("NAME");
    add_machine_options(*command, options->machine);
    command->add_flag("--update", options->update,
                      "Instead of checking them, write the manifests anew");
    command
        ->add_option("--recordings", options->recordings,
                     "Also recordings of what differs, for gw replay and pixel")
        ->type_name("DIR2");
    command->footer(
        "Exit code 3 where something differs.\n"
        "Example:\n"
        "  build/release/bin/gw golden tests/golden --only fig1");
    return {command, [options](Session&) { return golden(*options); }};
}

}  // namespace gw::apps
