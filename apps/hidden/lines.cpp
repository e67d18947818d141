// gw hidden with a hidden-line algorithm: the drawing, its counts and steps.
#include "apps/command/command.h"
#include "apps/command/terminal.h"
#include "apps/figures/folder_index.h"
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

std::string text_of(const hs::LineAlgorithm& algorithm, const hs::LineCounts& counts, Form form) {
    auto json = nlohmann::ordered_json::object();
    std::string text = fmt::format("{:<12} {:>16}\n", "", algorithm.name), names = "algorithm",
                values = algorithm.name;
    for (const auto& [name, count] : hs::line_count_names()) {
        text += fmt::format("{:<12} {:>16}\n", name, counts.*count);
        names += std::string(",") + name;
        values += fmt::format(",{}", counts.*count);
        json[name] = counts.*count;
    }
    if (form == Form::Csv) return names + "\n" + values + "\n";
    if (form == Form::Text) return text;
    return nlohmann::ordered_json::array({{{"algorithm", algorithm.name},
                                           {"title", algorithm.title},
                                           {"claim", algorithm.claim},
                                           {"counts", json}}})
               .dump(2) +
           "\n";
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

void put_line_steps(image::OutputSet& output, const HiddenOptions& options, const hs::Input& input,
                    const hs::LineAlgorithm& algorithm, const hs::LineResult& result,
                    const std::vector<hs::Step>& steps) {
    const auto& folder = options.steps;
    const hs::LogSubject subject{.algorithm = algorithm.name,
                                 .title = algorithm.title,
                                 .lines = true,
                                 .level = options.level};
    put_log(output, folder,
            log_text(input, subject, steps, hs::log_end(steps.size(), result.counts)));
    image::put_picture(output.add(folder / "picture.png"), picture_of(input, result, false));
    image::put_picture(output.add(folder / "difference.png"), picture_of(input, result, true));
    output.add(folder / "lines.svg").write_text(hs::lines_svg(input, result.lines));
}

}  // namespace

int hidden_lines(const HiddenOptions& options, Session& session) {
    Progress progress("reading", options.picture.quiet);
    const Profile profile = load_profile(options.picture, session);
    const scene::Scene scene = load_scene(options.picture, session);
    image::OutputSet output(session.inputs);
    if (!options.steps.empty()) output.make_folder(options.steps);
    const scene::View view =
        scene::make_view(scene, options.picture.size.width, options.picture.size.height);
    const auto machine = make_machine(options.picture, profile, session);
    const hs::Input input = hs::make_input(scene, view, profile);
    const hs::LineAlgorithm& algorithm = *hs::line_algorithm_named(options.algorithm);
    if (const hs::Estimate estimate = hs::estimate(algorithm, input);
        hs::is_beyond(estimate, options.limit))
        throw Error(hs::text_of(estimate) + "; --limit 0 to try");
    hs::StepLog log = options.steps.empty() ? hs::StepLog() : hs::StepLog(options.level);
    progress.at(algorithm.name);
    const hs::LineResult result = hs::run_on(*machine, algorithm, input, log);
    progress.at("writing");
    if (!options.steps.empty())
        put_line_steps(output, options, input, algorithm, result, log.steps());
    if (!options.steps.empty()) put_index(output, options.steps, session);
    output.commit();
    print(text_of(algorithm, result.counts, options.form));
    return Done;
}

}  // namespace gw::apps
