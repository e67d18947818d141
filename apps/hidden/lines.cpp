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

class Pictures {
public:
    Pictures(Machine& machine, const hs::Input& input, const hs::LineAlgorithm& algorithm,
             const std::vector<hs::Line>& lines)
        : machine_(machine), input_(input), algorithm_(algorithm), lines_(lines) {}

    /// The visible parts of the first `count` lines in white, the hidden parts of the last in yellow.
    image::Picture of_step(std::size_t count) {
        const std::vector<hs::Line> first(lines_.begin(), lines_.begin() + std::ptrdiff_t(count));
        std::vector<hs::Line> last;
        if (count > 0)
            last.push_back({.a = first.back().a, .b = first.back().b, .visible = {{0, 1}}});
        const std::vector<bool> seen = lit(first), at = lit(last);
        image::Picture picture = blank(input_.view.width, input_.view.height);
        for (std::size_t i = 0; i < seen.size(); ++i)
            if (seen[i] || at[i]) put(picture, i, seen[i] ? white : yellow);
        return captioned(enlarged(picture), caption(count));
    }

private:
    std::vector<bool> lit(const std::vector<hs::Line>& lines) {
        machine_.execute(hs::draw_lines(input_, algorithm_.name, lines));
        std::vector<bool> found;
        for (const Rgba& color : machine_.planes().color) found.push_back(color[0] > 0);
        return found;
    }
    std::vector<TextLine> caption(std::size_t count) const {
        const TextLine head{{algorithm_.name},
                            {fmt::format("{} of {}", count, lines_.size()), grey}};
        if (count == 0) return {head, {}};
        const hs::Line& line = lines_[count - 1];
        std::string seen;
        for (const auto& [from, to] : line.visible)
            seen += fmt::format(" {:.3g}..{:.3g}", from, to);
        return {head,
                {{fmt::format("polygon {}:", line.id), grey},
                 {seen.empty() ? "hidden" : "visible" + seen}}};
    }

    Machine& machine_;
    const hs::Input& input_;
    const hs::LineAlgorithm& algorithm_;
    const std::vector<hs::Line>& lines_;
};

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
                    const std::vector<hs::Step>& steps, Pictures pictures) {
    const auto& folder = options.steps;
    const hs::LogSubject subject{.algorithm = algorithm.name,
                                 .title = algorithm.title,
                                 .lines = true,
                                 .level = options.level};
    put_log(output, folder,
            log_text(input, subject, steps, hs::log_end(steps.size(), result.counts)));
    std::vector<image::Picture> frames;
    for (const std::size_t place : places(result.lines.size(), options.pictures)) {
        frames.push_back(pictures.of_step(place));
        image::put_picture(output.add(folder / fmt::format("step_{:04}.png", frames.size())),
                           frames.back());
    }
    image::put_animation(output.add(folder / "steps.gif"), frames, 4);
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
        put_line_steps(output, options, input, algorithm, result, log.steps(),
                       Pictures(*machine, input, algorithm, result.lines));
    if (!options.steps.empty()) put_index(output, options.steps, session);
    output.commit();
    print(text_of(algorithm, result.counts, options.form));
    return Done;
}

}  // namespace gw::apps
