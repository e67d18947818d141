// gw golden: compares every pass of every figure, on each profile, with a folder of manifests and
// the table of digests beside them.
#include "apps/command/command.h"
#include "apps/command/command_recorder.h"
#include "apps/command/folder_index.h"
#include "apps/command/terminal.h"
#include "apps/figures/figure_table.h"
#include "apps/figures/golden_table.h"
#include "apps/recordings/machine_options.h"
#include "apps/recordings/recording_files.h"
#include "gw/error.h"
#include "gw/escape_controls.h"
#include "gw/profile.h"
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

/// A panel's recording, and its name in the folder of goldens: "fig1/3_vgx".
struct GoldenRecording {
    std::string name;
    inspect::Recording recording;

    /// The papers' machine has manifests, the other profiles a table of digests.
    bool has_manifest() const {
        for (const Profile& profile : paper_profiles())
            if (profile != vgx() && profile.name == recording.profile.name) return false;
        return true;
    }
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
            all.push_back({figure.name + "/" + name, std::move(r)});
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
    fs::path manifest(const GoldenRecording& golden) const {
        return folder / (golden.name + ".json");
    }
    fs::path table() const { return folder / "digests.txt"; }
};

/// The counts over all figures so far.
struct Tally {
    std::size_t panels = 0, passes = 0, different = 0;
    std::set<std::string> names;
    GoldenTable table;  ///< of the file; with --update, what it becomes
};

/// The recording as another process would read it, from its bytes.
inspect::Recording reread(const inspect::Recording& recording) {
    return inspect::decode(inspect::encode(recording));
}

void keep(const GoldenOptions& options, const GoldenRecording& golden) {
    if (options.recordings.empty()) return;
    const fs::path file = options.recordings / (golden.name + ".gwt");
    make_folder(file.parent_path());
    image::OutputSet output;
    output.add(file).write(inspect::encode(golden.recording));
    output.commit();
}

inspect::Manifest manifest_of(const GoldenRecording& golden, const GoldenOptions& options) {
    return merge_runs(replayed_manifest(reread(golden.recording), options.machine.make(), nullptr));
}

/// A difference, and the digest of the commands that the golden was made of.
struct GoldenDifference {
    std::optional<inspect::Finding> finding;
    std::string commands;
};

GoldenDifference manifest_difference(const inspect::Manifest& actual, const GoldenRecording& golden,
                                     const GoldenOptions& options) {
    const inspect::Manifest expected = inspect::load_manifest(options.manifest(golden)).manifest;
    return {first_difference(expected, actual), to_string(expected.commands_hash)};
}

/// The finding says how to see more than digests.
GoldenDifference table_difference(const inspect::Manifest& actual, const GoldenRecording& golden,
                                  const GoldenOptions& options, const Tally& tally) {
    const auto row = tally.table.find(golden.name);
    if (row == tally.table.end())
        throw Error(options.table().string() + ": has no panel " + golden.name +
                    "; expected one, which --update writes");
    auto finding = first_difference(row->second, digests_of(actual));
    if (finding)
        finding->notes.push_back(fmt::format(
            "to see it: with this build and the one before, gw golden {} --only {} --profile {} "
            "--recordings DIR2, then gw diff of the two DIR2/{}.gwt",
            options.folder.string(), golden.name.substr(0, golden.name.find('/')),
            golden.recording.profile.name, golden.name));
    return {std::move(finding), row->second.commands};
}

void check(const GoldenRecording& golden, const GoldenOptions& options, Tally& tally) {
    const inspect::Manifest actual = manifest_of(golden, options);
    auto [finding, commands] = golden.has_manifest()
                                   ? manifest_difference(actual, golden, options)
                                   : table_difference(actual, golden, options, tally);
    tally.passes += actual.passes.size();
    if (finding)
        finding->notes.push_back(
            commands == to_string(actual.commands_hash)
                ? "the commands are the same: the machine differs"
                : "the commands differ: the code that makes the passes has changed");
    else if (options.machine.both())
        finding = compare_machines(reread(golden.recording), inspect::maker_of("reference"),
                                   options.machine.make());
    if (!finding) return;
    ++tally.different;
    print(escape_controls(
              (golden.has_manifest() ? options.manifest(golden) : options.table()).string()) +
          ": " + (golden.has_manifest() ? "" : golden.name + ", ") +
          text(*finding, golden.recording.height));
    keep(options, golden);
}

void update(const GoldenRecording& golden, const GoldenOptions& options, Tally& tally) {
    const inspect::Manifest manifest = manifest_of(golden, options);
    tally.passes += manifest.passes.size();
    if (!golden.has_manifest()) {
        tally.table[golden.name] = digests_of(manifest);
        return;
    }
    make_folder(options.manifest(golden).parent_path());
    image::write_file(options.manifest(golden), to_json(manifest));
}

void report_unknown(const std::string& where, const GoldenOptions& options, Tally& tally) {
    if (options.update) return;
    ++tally.different;
    print(escape_controls(where) + ": no panel of this figure makes it\n");
}

/// Reports, or with --update removes, goldens that none of the figure's panels makes any more.
void check_unknown(const Figure& figure, const GoldenOptions& options, Tally& tally) {
    std::set<fs::path> unknown;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(options.folder / figure.name, none)) {
        const fs::path name = entry.path().filename();
        if (name.extension() != ".json" ||
            !tally.names.contains(figure.name + "/" + name.stem().string()) ||
            tally.table.contains(figure.name + "/" + name.stem().string()))
            unknown.insert(entry.path());
    }
    for (const fs::path& file : unknown) {
        report_unknown(file.string(), options, tally);
        if (options.update) fs::remove(file);
    }
    const auto is_unknown = [&](const auto& row) {
        return row.first.starts_with(figure.name + "/") && !tally.names.contains(row.first);
    };
    for (const auto& row : tally.table)
        if (is_unknown(row))
            report_unknown(options.table().string() + ": " + row.first, options, tally);
    if (options.update) std::erase_if(tally.table, is_unknown);
}

void run_figure(const Figure& figure, const GoldenOptions& options, Progress& progress,
                Tally& tally) {
    for (std::size_t i = 0; i < figure.panels.size(); ++i) {
        progress.at(fmt::format("{}, {} of {}", figure.name, i + 1, figure.panels.size()));
        for (const GoldenRecording& golden : run_golden_panel(figure, i, options.profiles)) {
            tally.names.insert(golden.name);
            ++tally.panels;
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
    Tally tally{.table = read_golden_table(options.table())};
    for (const Figure* figure : wanted_figures(options.only))
        run_figure(*figure, options, progress, tally);
    if (options.update) image::write_file(options.table(), text_of(tally.table));
    print(fmt::format("{}, {}: {}\n",
                      inspect::plural(std::uint64_t(tally.panels), "recording", "recordings"),
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
        app.add_subcommand("golden", "Compares every pass of every figure with stored goldens");
    const auto options = std::make_shared<GoldenOptions>();
    command->add_option("DIR", options->folder, "The folder of goldens, tests/golden")
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
                      "Write the goldens anew instead of checking them");
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
