// gw golden: compares every pass of every figure, on each profile, with a folder of manifests.
#include "apps/command/command.h"
#include "apps/command/command_recorder.h"
#include "apps/command/terminal.h"
#include "apps/figures/figure_table.h"
#include "apps/figures/folder_index.h"
#include "apps/recordings/machine_options.h"
#include "apps/recordings/recording_files.h"
#include "gw/error.h"
#include "gw/profile.h"
#include "gw/shown.h"
#include "image/write.h"
#include "inspect/manifest/manifest.h"
#include "inspect/recording/recording.h"
#include "inspect/text/plural.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace gw::apps {

namespace fs = std::filesystem;

namespace {

/// A panel's recording, and the name of its manifest in the folder of goldens: "fig1/3_vgx.json".
struct GoldenRecording {
    std::filesystem::path file;
    inspect::Recording recording;
};

/// A temporary folder for the pictures, which nobody looks at.
class Scratch {
public:
    Scratch() {
        std::string name = (fs::temp_directory_path() / "gw-golden-XXXXXX").string();
        if (!::mkdtemp(name.data()))
            throw Error(name + ": cannot be made; expected a folder for pictures");
        folder_ = name;
    }
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    const fs::path& folder() const { return folder_; }

private:
    fs::path folder_;
};

std::vector<std::string> small_words(const Panel& panel, const Profile& profile,
                                     const fs::path& folder) {
    std::vector<std::string> words = words_of(panel, folder);
    words.push_back("--quiet");
    if (words[0] == "study") {
        set_option(words, "--samples", "4");
        return words;
    }
    set_option(words, "--size", "96x72");
    set_option(words, "--profile", profile.name);
    if (option_in(words, "--samples")) set_option(words, "--samples", "2");
    if (words[0] == "radiosity")
        for (const auto& [option, value] :
             {std::pair{"--shots", "2"}, {"--hemicube", "16"}, {"--threads", "1"}})
            set_option(words, option, value);
    return words;
}

std::vector<inspect::Recording> run_panel(const Panel& panel, const Profile& profile) {
    const Scratch scratch;
    const SilenceStdout muted;
    CommandRecorder recorder;
    const std::vector<std::string> words = small_words(panel, profile, scratch.folder());
    if (run_command({.words = words, .recorder = &recorder, .is_inner = true}) != Done)
        throw Error("gw " + panel.command + ": does not work");
    return recorder.take(words[1], words[0]);
}

/// Panel `index` from 0, on these profiles. 96 x 72 pixels; radiosity: two shots of small
/// hemicubes. A panel that superposes does it at most twice, unless the scene asks for more.
/// Recordings that do not depend on the profile (a study's machines, hemicubes) come with the first
/// profile.
std::vector<GoldenRecording> run_golden_panel(const Figure& figure, std::size_t index,
                                              const std::vector<Profile>& profiles) {
    const Panel& panel = figure.panels[index];
    const bool has_profile = !panel.command.starts_with("study ");
    std::vector<GoldenRecording> all;
    std::set<std::string> taken;
    for (const Profile& profile : profiles) {
        const bool first = profile == gw::paper_profiles().front();
        if (!first && !has_profile) continue;
        for (inspect::Recording& r : run_panel(panel, profile)) {
            if (!first && r.profile != profile) continue;
            const std::string stem = fmt::format("{}_{}", index + 1, r.profile.name);
            std::string name = stem;
            for (int i = 2; !taken.insert(name).second; ++i) name = fmt::format("{}_{}", stem, i);
            all.push_back({fs::path(figure.name) / (name + ".json"), std::move(r)});
        }
    }
    return all;
}

struct GoldenOptions {
    fs::path folder, recordings;
    std::vector<std::string> only;
    std::vector<Profile> profiles = gw::paper_profiles();
    MachineOptions machine;
    bool update = false;
};

/// The counts over all figures so far.
struct Tally {
    std::size_t manifests = 0, passes = 0, different = 0;
    std::set<fs::path> files;
};

/// The recording as another process would read it, from its bytes.
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
                ? "the commands are the same: the machine differs"
                : "the commands differ: the code that makes the passes has changed");
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
    print(shown(file.string()) + ": " + text(*finding, golden.recording.height));
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

/// Reports, or with --update removes, manifests that none of the figure's panels makes any more.
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
            print(shown(file.string()) + ": no panel of this figure makes it\n");
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
    if (options.profiles.size() == gw::paper_profiles().size())
        check_unknown(figure, options, tally);
}

int golden(const GoldenOptions& options) {
    if (!fs::exists("scenes"))
        throw Error("scenes: does not exist; expected to be run from the repository's root");
    if (options.update) make_folder(options.folder);
    if (!fs::is_directory(options.folder))
        throw Error(options.folder.string(), 0,
                    "is no folder; expected goldens, which --update writes");
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
                          ? "all unchanged"
                          : inspect::plural(std::uint64_t(tally.different), "differs", "differ")));
    return tally.different == 0 ? Done : Differs;
}

}  // namespace

Command add_golden(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("golden", "Compares every pass of every figure with stored manifests");
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
                for (const Profile& profile : paper_profiles()) names.push_back(profile.name);
                options->profiles = {profile_named(one_of("--profile", word, names))};
            },
            "Only this profile")
        ->type_name("NAME");
    add_machine_options(*command, options->machine);
    command->add_flag("--update", options->update,
                      "Write the manifests anew instead of checking them");
    command
        ->add_option("--recordings", options->recordings,
                     "Also write the recordings that differ, for gw replay and pixel")
        ->type_name("DIR2");
    command->footer(
        "Exit code 3 if something differs.\n"
        "Example:\n"
        "  build/release/bin/gw golden tests/golden --only fig1");
    return {command, [options](Session&) { return golden(*options); }};
}

}  // namespace gw::apps
