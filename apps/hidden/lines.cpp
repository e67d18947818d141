// gw hidden with a hidden-line algorithm: the drawing, its counts and steps.
#include "apps/command/command.h"
#include "apps/command/folder_index.h"
#include "apps/command/terminal.h"
#include "apps/hidden/files.h"
#include "apps/hidden/options.h"
#include "apps/hidden/pictures.h"
#include "gw/error.h"
#include "hiddensurface/lines/draw_lines.h"
#include "hiddensurface/run/estimate.h"
#include "hiddensurface/run/svg.h"
#include "image/write.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace gw::apps {

namespace hs = hiddensurface;

namespace {

struct Drawn {
    const hs::LineAlgorithm* algorithm = nullptr;
    hs::LineResult result;
    hs::StepLog log;
};

/// A column for each algorithm.
std::string table_of(const std::vector<Drawn>& all) {
    std::string text = fmt::format("{:<12}", "");
    for (const Drawn& run : all) text += fmt::format(" {:>16}", run.algorithm->name);
    for (const auto& [name, count] : hs::line_count_names()) {
        text += fmt::format("\n{:<12}", name);
        for (const Drawn& run : all) text += fmt::format(" {:>16}", run.result.counts.*count);
    }
    return text + "\n";
}

std::string csv_of(const std::vector<Drawn>& all) {
    std::string text = "algorithm";
    for (const auto& [name, count] : hs::line_count_names()) text += std::string(",") + name;
    for (const Drawn& run : all) {
        text += "\n" + run.algorithm->name;
        for (const auto& [name, count] : hs::line_count_names())
            text += fmt::format(",{}", run.result.counts.*count);
    }
    return text + "\n";
}

std::string json_of(const std::vector<Drawn>& all) {
    auto list = nlohmann::ordered_json::array();
    for (const Drawn& run : all) {
        auto counts = nlohmann::ordered_json::object();
        for (const auto& [name, count] : hs::line_count_names())
            counts[name] = run.result.counts.*count;
        list.push_back({{"algorithm", run.algorithm->name},
                        {"title", run.algorithm->title},
                        {"claim", run.algorithm->claim},
                        {"counts", counts}});
    }
    return list.dump(2) + "\n";
}

image::Picture picture_of(const hs::Input& input, const hs::LineResult& result, bool difference) {
    image::Picture picture = blank(input.view.width, input.view.height);
    for (std::size_t i = 0; i < result.lit.size(); ++i) {
        const bool ours = result.lit[i], other = result.z_buffer[i];
        if (!difference && ours) put(picture, i, white);
        if (difference && (ours || other))
            put(picture, i, ours && other ? grey : ours ? yellow : red);
    }
    return picture;
}

/// Returns the log for the player.
std::string put_line_steps(image::OutputSet& output, const std::filesystem::path& folder,
                           const hs::Input& input, const Drawn& run) {
    const std::vector<hs::Step>& steps = run.log.steps();
    const hs::LogSubject subject{.algorithm = run.algorithm->name,
                                 .title = run.algorithm->title,
                                 .lines = true,
                                 .level = run.log.finest()};
    std::string log =
        hs::log_text(input, subject, steps, hs::log_end(steps.size(), run.result.counts));
    output.add(folder / "steps.jsonl").write_text(log);
    image::put_picture(output.add(folder / "picture.png"), picture_of(input, run.result, false));
    image::put_picture(output.add(folder / "difference.png"), picture_of(input, run.result, true));
    output.add(folder / "lines.svg").write_text(hs::lines_svg(input, run.result.lines));
    return log;
}

void put_all_steps(image::OutputSet& output, const HiddenOptions& options, const hs::Input& input,
                   const std::vector<Drawn>& all) {
    std::vector<std::string> logs;
    for (const Drawn& run : all)
        logs.push_back(
            put_line_steps(output, folder_of_steps(options, run.algorithm->name), input, run));
    put_player(output, options.steps, logs);
}

/// Throws Error if one of them would take too long.
std::vector<const hs::LineAlgorithm*> chosen_algorithms(const HiddenOptions& options,
                                                        const hs::Input& input) {
    std::vector<const hs::LineAlgorithm*> all;
    for (const std::string& name : options.algorithms) {
        all.push_back(hs::line_algorithm_named(name));
        const hs::Estimate estimate = hs::estimate(*all.back(), input);
        if (hs::is_beyond(estimate, options.limit))
            throw Error(hs::text_of(estimate) + "; --limit 0 to try");
    }
    return all;
}

}  // namespace

int hidden_lines(const HiddenOptions& options, Session& session) {
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
    std::vector<Drawn> all;
    for (const hs::LineAlgorithm* algorithm : chosen_algorithms(options, input)) {
        progress.at(algorithm->name);
        hs::StepLog log = options.steps.empty() ? hs::StepLog() : hs::StepLog(options.level);
        hs::LineResult result = hs::run_on(*machine, *algorithm, input, log);
        all.push_back({algorithm, std::move(result), std::move(log)});
    }
    progress.at("writing");
    if (!options.steps.empty()) {
        put_all_steps(output, options, input, all);
        put_index(output, options.steps, session);
    }
    output.commit();
    print(options.form == Form::Json  ? json_of(all)
          : options.form == Form::Csv ? csv_of(all)
                                      : table_of(all));
    return Done;
}

}  // namespace gw::apps
