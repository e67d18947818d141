// gw hidden: runs one or all of the lecture's hidden-surface algorithms, with counts, steps and
// comparisons.
#include "apps/command/command.h"
#include "apps/command/folder_index.h"
#include "apps/command/terminal.h"
#include "apps/hidden/files.h"
#include "apps/hidden/options.h"
#include "gw/error.h"
#include "hiddensurface/interface/line_algorithm.h"
#include "hiddensurface/run/estimate.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

namespace gw::apps {

namespace hs = hiddensurface;

namespace {

std::string algorithms_help() {
    std::string help = "One algorithm, or two (default: all of hidden surfaces):";
    for (const hs::Algorithm& algorithm : hs::algorithms())
        help += "\n" + algorithm.name + ": " + algorithm.title;
    for (const hs::LineAlgorithm& algorithm : hs::line_algorithms())
        help += "\n" + algorithm.name + " (lines): " + algorithm.title;
    return help;
}

std::vector<std::string> all_names() {
    std::vector<std::string> names = hs::algorithm_names();
    for (const hs::LineAlgorithm& algorithm : hs::line_algorithms())
        names.push_back(algorithm.name);
    return names;
}

/// "newell", or two for one page: "newell,z-buffer".
std::vector<std::string> algorithms_from(const std::string& list) {
    std::vector<std::string> names;
    for (std::size_t from = 0; from <= list.size();) {
        const std::size_t end = std::min(list.find(',', from), list.size());
        names.push_back(one_of("--algorithm", list.substr(from, end - from), all_names()));
        from = end + 1;
    }
    const auto draws_lines = [](const std::string& name) {
        return hs::line_algorithm_named(name) != nullptr;
    };
    if (names.size() > 2)
        throw UsageError("--algorithm '" + list + "' has " + std::to_string(names.size()) +
                         " names; expected one, or two side by side");
    if (names.size() == 2 && names[0] == names[1])
        throw UsageError("--algorithm '" + list + "' has one name twice; expected two algorithms");
    if (draws_lines(names.front()) != draws_lines(names.back()))
        throw UsageError("--algorithm '" + list +
                         "' has one of surfaces and one of lines; expected two of a kind");
    return names;
}

hs::Level level_from(const std::string& word) {
    const std::vector<std::string> names{"polygon", "line", "span", "pixel"};
    one_of("--level", word, names);
    return static_cast<hs::Level>(std::find(names.begin(), names.end(), word) - names.begin());
}

void add_output_options(CLI::App& command, HiddenOptions& options) {
    CLI::Option* const steps =
        command
            .add_option(
                "--steps", options.steps,
                "For one algorithm, or two side by side: step log, its player, the last picture, SVG of "
                "the pieces")
            ->type_name("DIR");
    command
        .add_option_function<std::string>(
            "--level", [&](const std::string& word) { options.level = level_from(word); },
            "With --steps: one step is a polygon (default), line, span or pixel")
        ->type_name("NAME")
        ->needs(steps);
    command
        .add_option("--compare", options.compare,
                    "A sheet of all algorithms with difference pictures, and the counts as CSV, "
                    "JSON and HTML")
        ->type_name("DIR");
    add_form_options(command, options.form, true);
}

/// Tasks that have commands of their own.
void add_other_commands(CLI::App& command) {
    constexpr std::pair<const char*, const char*> others[] = {
        {"--quiz", "gw quiz DIR"},
        {"--seed", "gw quiz DIR --seed N"},
        {"--questions", "gw quiz DIR --questions N"},
        {"--kind", "gw quiz DIR --kind NAME"},
        {"--students", "gw quiz DIR --students N"},
        {"--grade", "gw grade KEY.json ANSWERS.json"},
        {"--fragments", "gw fragments SCENE LIST.csv"},
        {"--marked", "gw fragments SCENE LIST.csv --marked IMAGE"},
        {"--truth", "gw fragments SCENE --truth FILE.csv"},
        {"--play", "gw play SCENE STEPS.jsonl"},
        {"--polygons", "gw play SCENE --polygons FILE.json"},
    };
    for (const auto& [name, other] : others)
        command
            .add_option_function<std::vector<std::string>>(
                name,
                [name = name, other = other](const std::vector<std::string>&) {
                    throw UsageError(std::string(name) +
                                     ": gw hidden has no such option; expected " + other);
                },
                "")
            ->expected(0, 2)
            ->group("");
}

void add_options(CLI::App& command, HiddenOptions& options) {
    add_polygon_options(command, options.picture);
    command
        .add_option_function<std::string>(
            "--algorithm",
            [&](const std::string& word) { options.algorithms = algorithms_from(word); },
            algorithms_help())
        ->type_name("NAME[,NAME]");
    command
        .add_option_function<std::string>(
            "--limit",
            [&](const std::string& word) { options.limit = number_from("--limit", word, 0, 1e9); },
            "Leave out algorithms that would take longer (default 300); 0: none")
        ->type_name("SECONDS");
    add_output_options(command, options);
    add_other_commands(command);
}

void check(const HiddenOptions& options) {
    if (!options.steps.empty() && options.algorithms.empty())
        throw UsageError(
            "--steps needs an algorithm; expected --algorithm NAME, or two (NAME,NAME)");
    if (!options.compare.empty() && !options.algorithms.empty())
        throw UsageError("--compare compares all algorithms; expected no --algorithm");
}

std::vector<const hs::Algorithm*> chosen_algorithms(const HiddenOptions& options) {
    std::vector<const hs::Algorithm*> all;
    for (const std::string& name : options.algorithms) all.push_back(&hs::algorithm_named(name));
    if (!all.empty()) return all;
    for (const hs::Algorithm& algorithm : hs::algorithms()) all.push_back(&algorithm);
    return all;
}

/// The wanted algorithms within the time limit. Of all, warns of each that is left out, and throws
/// Error if all are; of those asked for by name, none may be.
std::vector<const hs::Algorithm*> within_limit(const HiddenOptions& options,
                                               const hs::Input& input) {
    std::vector<const hs::Algorithm*> within;
    std::string last;
    for (const hs::Algorithm* algorithm : chosen_algorithms(options)) {
        const hs::Estimate estimate = hs::estimate(*algorithm, input);
        if (!hs::is_beyond(estimate, options.limit)) {
            within.push_back(algorithm);
            continue;
        }
        last = hs::text_of(estimate) + "; --limit 0 to try";
        if (!options.algorithms.empty()) throw Error(last);
        print_warning("left out: " + last);
    }
    if (within.empty()) throw Error(last);
    return within;
}

void put_all_steps(image::OutputSet& output, const HiddenOptions& options, const hs::Input& input,
                   const std::vector<Compared>& all) {
    std::vector<std::string> logs;
    for (const Compared& run : all)
        logs.push_back(
            put_steps(output, folder_of_steps(options, run.algorithm->name), input, run));
    put_player(output, options.steps, logs);
}

/// Not every algorithm decides by lines, spans or pixels.
void warn_of_coarse(const std::string& algorithm, const hs::StepLog& log) {
    hs::Level finest = hs::Level::Polygon;
    for (const hs::Step& step : log.steps()) finest = std::max(finest, step.level);
    if (log.on() && finest < log.finest())
        print_warning(fmt::format("--level {}: {} has no finer steps than of a {}",
                                  hs::name_of(log.finest()), algorithm, hs::name_of(finest)));
}

/// One line for all algorithms that took two planes for one.
void warn_of_one_plane(const hs::Input& input, const std::vector<Compared>& all) {
    std::string names;
    hs::OnePlane most;
    for (const Compared& run : all) {
        const hs::OnePlane& found = run.result.one_plane;
        if (!run.algorithm->in_world || found.pixels == 0) continue;
        names += (names.empty() ? "" : ", ") + run.algorithm->name;
        if (found.pixels > most.pixels) most = found;
    }
    if (!names.empty()) print_warning(hs::one_plane_warning(names, input, most));
}

int surfaces(const HiddenOptions& options, Session& session) {
    Progress progress("reading", options.picture.quiet);
    const Profile profile = load_profile(options.picture, session);
    const scene::Scene scene = load_scene(options.picture, session);
    image::OutputSet output(session.inputs);
    make_folders(output, options);
    const scene::View view =
        scene::make_view(scene, options.picture.size.width, options.picture.size.height);
    const auto machine = make_machine(options.picture, profile, session);
    const hs::Input input = hs::make_input(scene, view, profile);
    progress.at("estimating");
    const std::vector<const hs::Algorithm*> chosen = within_limit(options, input);
    hs::StepLog none;
    progress.at("z-buffer");
    const hs::Result expected = hs::run_on(*machine, hs::algorithm_named("z-buffer"), input, none);
    std::vector<Compared> all;
    for (const hs::Algorithm* algorithm : chosen) {
        progress.at(algorithm->name);
        hs::StepLog log = options.steps.empty() ? hs::StepLog() : hs::StepLog(options.level);
        hs::Result result = hs::run_on(*machine, *algorithm, input, log);
        hs::compare(result, expected.ids, input);
        warn_of_coarse(algorithm->name, log);
        all.push_back({algorithm, std::move(result), std::move(log)});
    }
    if (!options.picture.quiet) warn_of_one_plane(input, all);
    progress.at("writing");
    if (!options.steps.empty()) put_all_steps(output, options, input, all);
    if (!options.compare.empty()) put_comparison(output, options.compare, input, all);
    for (const auto& folder : {options.steps, options.compare})
        if (!folder.empty()) put_index(output, folder, session);
    output.commit();
    print(options.form == Form::Json  ? counts_json(all)
          : options.form == Form::Csv ? counts_csv(all)
                                      : counts_text(all));
    return Done;
}

int hidden(const HiddenOptions& options, Session& session) {
    check(options);
    const bool lines = !options.algorithms.empty() &&
                       hs::line_algorithm_named(options.algorithms.front()) != nullptr;
    return lines ? hidden_lines(options, session) : surfaces(options, session);
}

}  // namespace

void make_folders(image::OutputSet& output, const HiddenOptions& options) {
    for (const auto& folder : {options.steps, options.compare})
        if (!folder.empty()) output.make_folder(folder);
    if (options.steps.empty() || options.algorithms.size() < 2) return;
    for (const std::string& name : options.algorithms)
        output.make_folder(folder_of_steps(options, name));
}

std::filesystem::path folder_of_steps(const HiddenOptions& options, const std::string& algorithm) {
    return options.algorithms.size() < 2 ? options.steps : options.steps / algorithm;
}

Command add_hidden(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("hidden", "Hidden-surface algorithms, step by step and compared");
    const auto options = std::make_shared<HiddenOptions>();
    add_options(*command, *options);
    command->footer(
        "Example:\n  build/release/bin/gw hidden scenes/hidden/cycle.toml --algorithm newell "
        "--steps newell");
    return {command, [options](Session& session) { return hidden(*options, session); }};
}

}  // namespace gw::apps
