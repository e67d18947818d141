// gw study: measures pictures and algorithms; writes plots with their numbers.
#include "apps/command/command.h"
#include "apps/command/command_recorder.h"
#include "apps/command/folder_index.h"
#include "apps/command/table.h"
#include "apps/command/terminal.h"
#include "apps/picture/picture_options.h"
#include "apps/recordings/machine_options.h"
#include "apps/study/convergence.h"
#include "apps/study/growth.h"
#include "apps/study/hemicube.h"
#include "apps/study/hidden.h"
#include "apps/study/passes/study_passes.h"
#include "apps/study/precision.h"
#include "gw/error.h"
#include "image/output/output_set.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <optional>

namespace gw::apps {
namespace {

struct StudyOptions {
    std::filesystem::path output;
    int threads = 0, samples = 256;
    std::optional<double> limit;   ///< seconds; absent: the study's own
    std::filesystem::path prices;  ///< empty: the study's own
    HiddenStudyOptions hidden;     ///< options of gw study hidden alone
    PassStudyOptions passes;       ///< options of gw study passes alone, with SCENE
    bool quiet = false;
};

constexpr Size size{160, 120}, large{320, 240};

/// A scene of the repository.
scene::Scene study_scene(const char* file, Session& session) {
    return load_scene({{.scene = file, .size = size}, true}, session);
}

study::MachineMaker maker(const StudyOptions& options, Size window, const Session& session) {
    return [=, recorder = session.recorder](const Profile& profile) {
        return recorded(
            make_fast(profile, window.width, window.height, {.threads = options.threads}),
            window.width, window.height, recorder);
    };
}

/// Creates the folder before long work, so that a bad name is found early.
void check(const StudyOptions& options) {
    image::OutputSet output;
    output.make_folder(options.output);
    image::check_target(options.output / "plot.svg");
}

void put_plot(image::OutputSet& output, const StudyOptions& options, const std::string& name,
              const std::string& study, plot::Plot plot) {
    plot.command =
        fmt::format("build/release/bin/gw study {} -o {}", study, options.output.string());
    if (options.samples != StudyOptions{}.samples)
        plot.command += fmt::format(" --samples {}", options.samples);
    output.add(options.output / (name + ".svg")).write_text(plot::svg(plot));
    output.add(options.output / (name + ".csv")).write_text(plot::csv(plot));
}

/// A picture whose error falls with samples.
struct Case {
    const char *name, *scene, *title;
    int dimensions;
};
constexpr Case cases[] = {
    {"antialiasing", "scenes/edges.toml", "Anti-aliasing: error against samples", 2},
    {"soft_shadow", "scenes/penumbra.toml", "Soft shadow: error against samples", 4},
};

int study_convergence(const StudyOptions& options, Session& session) {
    check(options);
    Progress progress("drawing", options.quiet);
    const auto say = [&](const std::string& what) { progress.at(what); };
    image::OutputSet output;
    output.make_folder(options.output);
    std::vector<std::vector<std::string>> rows{{"error falls as", "vgx", "reality", "ideal"}};
    for (const Case& c : cases) {
        const auto errors = study::convergence(study_scene(c.scene, session), paper_profiles(),
                                               maker(options, size, session),
                                               {.largest = options.samples,
                                                .reference = 8 * options.samples,
                                                .width = size.width,
                                                .height = size.height},
                                               say);
        put_plot(output, options, c.name, "convergence",
                 study::convergence_plot(errors, c.title, c.dimensions));
        rows.push_back({c.name});
        std::vector<std::string> grid{std::string(c.name) + ", distance from a 256x256 grid"};
        for (const auto& e : errors) {
            rows.back().push_back(fmt::format("N^{:.3f}", e.law.exponent));
            grid.push_back(fmt::format("{:.2f}", e.grid));
        }
        rows.push_back(std::move(grid));
    }
    put_index(output, options.output, session);
    output.commit();
    print(table(rows));
    return Done;
}

std::string text_of(const study::Difference& d) {
    return fmt::format("{:.3f} {:+.3f} {:.2f}", d.rms, d.mean, d.largest);
}

std::string adding_table(const std::vector<study::Adding>& rows) {
    std::vector<std::vector<std::string>> lines{
        {"profile", "lights", "frame buffer", "accumulation", "full strength", "saturated"}};
    for (const study::Adding& row : rows)
        lines.push_back({row.profile, std::to_string(row.lights), text_of(row.frame_buffer),
                         text_of(row.accumulation), text_of(row.full_strength),
                         fmt::format("{:.1f} %", 100 * row.saturated)});
    return "Adding the passes of lights: rms, mean and largest error in 255ths of white\n" +
           table(lines);
}

std::string distance_table(const std::vector<study::Distance>& rows) {
    std::vector<std::vector<std::string>> lines{{"profile", "sides", "hardware", "multi-pass"}};
    for (const study::Distance& row : rows)
        lines.push_back({row.profile, std::to_string(row.sides),
                         fmt::format("{:.3f}", row.hardware),
                         fmt::format("{:.3f}", row.multipass)});
    return "Distance from the scan-line picture: rms in 255ths of white\n" + table(lines);
}

int study_precision(const StudyOptions& options, Session& session) {
    check(options);
    Progress progress("drawing", options.quiet);
    const auto say = [&](const std::string& what) { progress.at(what); };
    const auto added =
        study::adding(study_scene("scenes/columns.toml", session), {1, 4, 16, 64}, paper_profiles(),
                      maker(options, large, session), large.width, large.height, say);
    const auto apart = study::distances(
        {study_scene("scenes/rings.toml", session)}, {8, 16, 32, 64, 128}, paper_profiles(),
        maker(options, large, session), large.width, large.height, say);
    image::OutputSet output;
    output.make_folder(options.output);
    put_plot(output, options, "adding", "precision", study::adding_plot(added));
    put_plot(output, options, "distance", "precision", study::distance_plot(apart));
    put_index(output, options.output, session);
    output.commit();
    print(adding_table(added) + "\n" + distance_table(apart));
    return Done;
}

int study_hidden_surfaces(const StudyOptions& options, Session& session) {
    check(options);
    HiddenStudyOptions hidden = options.hidden;
    hidden.output = options.output;
    if (options.limit) hidden.limit = *options.limit;
    if (!options.prices.empty()) hidden.prices = options.prices;
    if (options.threads > 0) hidden.threads = options.threads;
    hidden.quiet = options.quiet;
    hidden.command =
        fmt::format("build/release/bin/gw study hidden -o {}", options.output.string());
    if (!hidden.axis.empty()) hidden.command += " --axis " + hidden.axis;
    if (hidden.limit != HiddenStudyOptions{}.limit)
        hidden.command += fmt::format(" --limit {}", hidden.limit);
    return study_hidden(hidden, session);
}

int study_hemicube(const StudyOptions& options, Session& session) {
    check(options);
    Progress progress("drawing", options.quiet);
    const auto rows = study::hemicube_errors({16, 32, 64, 128, 256, 512}, 8,
                                             [&](const std::string& what) { progress.at(what); });
    image::OutputSet output;
    output.make_folder(options.output);
    put_plot(output, options, "hemicube", "hemicube", study::hemicube_plot(rows));
    put_index(output, options.output, session);
    output.commit();
    std::vector<std::vector<std::string>> lines{
        {"hemicube", "pixels a texel", "rms drawn", "oversampled", "missed drawn", "oversampled"}};
    const auto percent = [](double v) { return fmt::format("{:.2f} %", 100 * v); };
    for (const study::HemicubeError& r : rows)
        lines.push_back({std::to_string(r.size), fmt::format("{:g}", r.pixels),
                         percent(r.rms_drawn), percent(r.rms_oversampled), percent(r.missed_drawn),
                         percent(r.missed_oversampled)});
    print(table(lines));
    return Done;
}

int study_of_passes(const StudyOptions& options, Session& session) {
    PassStudyOptions passes = options.passes;
    if (passes.picture.scene.empty())
        throw UsageError("study passes: no SCENE; expected a TOML, OBJ or glTF file");
    check(options);
    passes.output = options.output;
    passes.prices = options.prices;
    if (options.limit) passes.limit = *options.limit;
    passes.picture.threads = options.threads > 0 ? options.threads : 1;
    passes.picture.quiet = options.quiet;
    return study_passes(passes, session);
}

struct Study {
    const char *name, *about;
    int (*run)(const StudyOptions&, Session&);
};

constexpr Study studies[] = {
    {"convergence", "error against the number of samples", study_convergence},
    {"precision", "rounding of added passes, distance of renderers", study_precision},
    {"hidden", "growth and cost of the hidden-surface algorithms", study_hidden_surfaces},
    {"hemicube", "error of form factors against resolution", study_hemicube},
    {"passes", "one SCENE by passes, item buffer and rays, counted and estimated", study_of_passes},
};

const Study& study_named(const std::string& word) {
    std::vector<std::string> names;
    for (const Study& study : studies) names.emplace_back(study.name);
    one_of("STUDY", word, names);
    return *std::ranges::find(studies, word, &Study::name);
}

std::string studies_help() {
    std::string help;
    for (const Study& study : studies)
        help += fmt::format("{}{}: {}", help.empty() ? "" : "; ", study.name, study.about);
    return help;
}

void add_common_options(CLI::App& command, StudyOptions& options) {
    command
        .add_option("-o,--output", options.output, "The folder of the plots; created if missing")
        ->required()
        ->type_name("DIR");
    add_threads_option(command, options.threads,
                       "Threads of the fast machine (default: all; hidden, passes: 1)");
    command
        .add_option_function<std::string>(
            "--samples",
            [&options](const std::string& word) {
                options.samples = whole_number_from("--samples", word, 4, 4096);
            },
            "convergence: up to N samples (default 256) against a picture of 8 N")
        ->type_name("N");
    command.add_flag("--quiet", options.quiet, "No progress");
}

void add_own_options(CLI::App& command, StudyOptions& options) {
    command
        .add_option_function<std::string>(
            "--limit",
            [&options](const std::string& word) {
                options.limit = number_from("--limit", word, 0.001, 3600);
            },
            "hidden: stop an algorithm before a size that would take longer (default 0.5); passes: "
            "end a sweep before a row that would (default 60)")
        ->type_name("SECONDS");
    command
        .add_option_function<std::string>(
            "--axis",
            [&options](const std::string& word) {
                std::vector<std::string> axes;
                for (const study::GrowthAxis& axis : study::growth_axes())
                    axes.push_back(axis.name);
                options.hidden.axis = one_of("--axis", word, axes);
            },
            "hidden: polygons, depth, resolution or frames only (default: all)")
        ->type_name("NAME");
    command
        .add_option("--prices", options.prices,
                    "hidden: folder of recipes.toml and price lists (default "
                    "scenes/hidden/prices); passes: folder of price lists (default: the VGX's and "
                    "two of today)")
        ->type_name("DIR");
}

}  // namespace

Command add_study(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "study", "Measurements of pictures, as plots (SVG) with their numbers (CSV)");
    const auto options = std::make_shared<StudyOptions>();
    const auto study = std::make_shared<const Study*>();
    command
        ->add_option_function<std::string>(
            "STUDY", [study](const std::string& word) { *study = &study_named(word); },
            studies_help())
        ->required()
        ->type_name("NAME");
    command
        ->add_option("SCENE", options->passes.picture.scene, "passes: a TOML scene or an OBJ file")
        ->type_name("FILE");
    add_common_options(*command, *options);
    add_own_options(*command, *options);
    add_pass_study_options(*command, options->passes);
    command->footer(
        "Example:\n  build/release/bin/gw study passes scenes/rings.toml --size 160x120 --sweep "
        "lights=1,2,4 -o passes");
    return {command, [=](Session& session) {
                if (!options->passes.picture.scene.empty() && (*study)->run != study_of_passes)
                    throw UsageError(
                        fmt::format("study {}: SCENE '{}'; expected none, its scenes are its own",
                                    (*study)->name, options->passes.picture.scene.string()));
                return (*study)->run(*options, session);
            }};
}

}  // namespace gw::apps
