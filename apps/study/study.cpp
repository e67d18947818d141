// gw study: measurements of pictures, as plots with their numbers.
#include "apps/command/command.h"
#include "apps/command/command_recorder.h"
#include "apps/command/progress.h"
#include "apps/command/table.h"
#include "apps/command/terminal.h"
#include "apps/figures/folder_index.h"
#include "apps/recordings/machine_options.h"
#include "apps/render/picture_options.h"
#include "apps/study/hidden.h"
#include "gw/error.h"
#include "image/output/output_set.h"
#include "study/adding.h"
#include "study/convergence.h"
#include "study/distance.h"
#include "study/growth.h"
#include "study/hemicube.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

namespace gw::apps {
namespace {

struct StudyOptions {
    std::filesystem::path output;
    int threads = 0, samples = 256;
    HiddenStudyOptions hidden;  ///< its own prices and limit
    bool quiet = false;
};

constexpr Size size{160, 120}, large{320, 240};

/// The studies' scenes are the repository's.
scene::Scene study_scene(const char* file) {
    return load_scene({.scene = file, .size = size, .quiet = true});
}

study::MachineMaker maker(const StudyOptions& options, Size window) {
    return [=](const Profile& profile) {
        return taped(make_fast(profile, window.width, window.height, {.threads = options.threads}),
                     window.width, window.height);
    };
}

/// The folder, before long work: what cannot be written is found now.
void check(const StudyOptions& options) {
    if (options.output.empty()) throw UsageError("-o is empty; expected the name of a folder");
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

int study_convergence(const StudyOptions& options) {
    check(options);
    Progress progress("drawing", options.quiet);
    const auto say = [&](const std::string& what) { progress.at(what); };
    image::OutputSet output;
    output.make_folder(options.output);
    struct Case {
        const char *name, *scene, *title;
        int dimensions;
    };
    std::vector<std::vector<std::string>> rows{{"error falls as", "vgx", "reality", "ideal"}};
    for (const Case& c :
         {Case{"antialiasing", "scenes/edges.toml", "Anti-aliasing: error against samples", 2},
          Case{"soft_shadow", "scenes/penumbra.toml", "Soft shadow: error against samples", 4}}) {
        const auto errors =
            study::convergence(study_scene(c.scene), profiles(), maker(options, size),
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
    put_index(output, options.output);
    output.commit();
    print(table(rows));
    return done;
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

int study_precision(const StudyOptions& options) {
    check(options);
    Progress progress("drawing", options.quiet);
    const auto say = [&](const std::string& what) { progress.at(what); };
    const auto added = study::adding(study_scene("scenes/columns.toml"), {1, 4, 16, 64}, profiles(),
                                     maker(options, large), large.width, large.height, say);
    const auto apart =
        study::distances({study_scene("scenes/rings.toml")}, {8, 16, 32, 64, 128}, profiles(),
                         maker(options, large), large.width, large.height, say);
    image::OutputSet output;
    output.make_folder(options.output);
    put_plot(output, options, "adding", "precision", study::adding_plot(added));
    put_plot(output, options, "distance", "precision", study::distance_plot(apart));
    put_index(output, options.output);
    output.commit();
    print(adding_table(added) + "\n" + distance_table(apart));
    return done;
}

int study_hidden_surfaces(const StudyOptions& options) {
    check(options);
    HiddenStudyOptions hidden = options.hidden;
    hidden.output = options.output;
    if (options.threads > 0) hidden.threads = options.threads;
    hidden.quiet = options.quiet;
    hidden.command =
        fmt::format("build/release/bin/gw study hidden -o {}", options.output.string());
    if (!hidden.axis.empty()) hidden.command += " --axis " + hidden.axis;
    if (hidden.limit != HiddenStudyOptions{}.limit)
        hidden.command += fmt::format(" --limit {}", hidden.limit);
    return study_hidden(hidden);
}

int study_hemicube(const StudyOptions& options) {
    check(options);
    Progress progress("drawing", options.quiet);
    const auto rows = study::hemicube_errors({16, 32, 64, 128, 256, 512}, 8,
                                             [&](const std::string& what) { progress.at(what); });
    image::OutputSet output;
    output.make_folder(options.output);
    put_plot(output, options, "hemicube", "hemicube", study::hemicube_plot(rows));
    put_index(output, options.output);
    output.commit();
    std::vector<std::vector<std::string>> lines{
        {"hemicube", "pixels a texel", "rms drawn", "oversampled", "missed drawn", "oversampled"}};
    const auto percent = [](double v) { return fmt::format("{:.2f} %", 100 * v); };
    for (const study::HemicubeError& r : rows)
        lines.push_back({std::to_string(r.size), fmt::format("{:g}", r.pixels),
                         percent(r.rms_drawn), percent(r.rms_oversampled), percent(r.missed_drawn),
                         percent(r.missed_oversampled)});
    print(table(lines));
    return done;
}

}  // namespace

Command add_study(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "study", "Measurements of pictures, as plots (SVG) with their numbers (CSV)");
    const auto options = std::make_shared<StudyOptions>();
    const auto which = std::make_shared<std::string>();
    const std::vector<std::string> known{"convergence", "precision", "hidden", "hemicube"};
    command
        ->add_option_function<std::string>(
            "STUDY", [=](const std::string& word) { *which = one_of("STUDY", word, known); },
            "convergence: error against the number of samples; precision: rounding of added passes, distance "
            "of "
            "renderers; hidden: growth and cost of the hidden-surface algorithms; hemicube: error of form "
            "factors against "
            "resolution")
        ->required()
        ->type_name("NAME");
    command
        ->add_option("-o,--output", options->output,
                     "Folder of the plots; made where it is missing")
        ->required()
        ->type_name("DIR");
    add_threads_option(*command, options->threads,
                       "Threads of the fast machine (default: all; hidden: 1)");
    command
        ->add_option_function<std::string>(
            "--samples",
            [=](const std::string& word) {
                options->samples = whole_number_from("--samples", word, 4, 4096);
            },
            "convergence: up to N samples (default 256) against a picture of 8 N")
        ->type_name("N");
    command
        ->add_option_function<std::string>(
            "--limit",
            [=](const std::string& word) {
                options->hidden.limit = number_from("--limit", word, 0.001, 3600);
            },
            "hidden: an algorithm whose next size would take longer is stopped there (default 0.5)")
        ->type_name("SECONDS");
    command
        ->add_option_function<std::string>(
            "--axis",
            [=](const std::string& word) {
                std::vector<std::string> axes;
                for (const study::GrowthAxis& axis : study::growth_axes())
                    axes.push_back(axis.name);
                options->hidden.axis = one_of("--axis", word, axes);
            },
            "hidden: polygons, depth, resolution or frames only (default: all)")
        ->type_name("NAME");
    command
        ->add_option(
            "--prices", options->hidden.prices,
            "hidden: folder of recipes.toml and price lists (default scenes/hidden/prices)")
        ->type_name("DIR");
    command->add_flag("--quiet", options->quiet, "No progress");
    command->footer(
        "Example:\n  build/release/bin/gw study convergence --samples 16 -o convergence");
    return {command, [=] {
                if (*which == "hidden") return study_hidden_surfaces(*options);
                if (*which == "hemicube") return study_hemicube(*options);
                return *which == "convergence" ? study_convergence(*options)
                                               : study_precision(*options);
            }};
}

}  // namespace gw::apps
