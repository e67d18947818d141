// Hidden-surface and hidden-line algorithms, step by step.
#include "gw/error.h"
#include "hiddensurface/faces/flat_colors.h"
#include "hiddensurface/lines/draw_lines.h"
#include "hiddensurface/run/estimate.h"
#include "hiddensurface/run/play.h"
#include "hiddensurface/run/step_json.h"
#include "web/engine/method.h"
#include "web/engine/request.h"

#include <algorithm>

namespace gw::lab {

namespace hs = hiddensurface;

namespace {

hs::Level level_from(const std::string& word) {
    for (const hs::Level level :
         {hs::Level::Polygon, hs::Level::Line, hs::Level::Span, hs::Level::Pixel})
        if (word == hs::name_of(level)) return level;
    throw Error("level '" + word + "'; expected polygon, line, span or pixel");
}

void check(const hs::Estimate& estimate, const Json& options) {
    if (hs::is_beyond(estimate, options.value("limit", 20.0)))
        throw Error(hs::text_of(estimate) + "; expected fewer polygons, or another algorithm");
}

}  // namespace

Json LabSession::about(const Json&) {
    Json all = Json::array();
    for (const hs::Algorithm& a : hs::algorithms())
        all.push_back({{"name", a.name}, {"title", a.title}, {"lines", false}});
    for (const hs::LineAlgorithm& a : hs::line_algorithms())
        all.push_back({{"name", a.name}, {"title", a.title}, {"lines", true}});
    return {{"algorithms", all}, {"simd", simd_target()}};
}

std::string LabSession::hidden(const Json& options) {
    const scene::Scene scene = scene_for(options);
    const scene::View view = view_of(scene, options);
    Machine& machine = machine_for(options);
    const hs::Input input = hs::make_input(scene, view, machine.profile());
    const std::string name = options.value("algorithm", "z-buffer");
    const hs::Level level = level_from(options.value("level", "polygon"));
    if (const hs::LineAlgorithm* lines = hs::line_algorithm_named(name)) {
        check(hs::estimate(*lines, input), options);
        difference_.clear();
        hs::StepLog log(level);
        const hs::LineResult result = hs::run_on(machine, *lines, input, log);
        const hs::LogSubject subject{
            .algorithm = name, .title = lines->title, .lines = true, .level = level};
        return hs::log_text(input, subject, log.steps(),
                            hs::log_end(log.steps().size(), result.counts));
    }
    const hs::Algorithm& algorithm = hs::algorithm_named(name);
    check(hs::estimate(algorithm, input), options);
    return graded_log(machine, algorithm, input, level);
}

std::string LabSession::polygons(const Json& options) {
    const scene::Scene scene = scene_for(options);
    const scene::View view = view_of(scene, options);
    const Profile profile = render::load_profile(request_of(options));
    const hs::Input input = hs::make_input(scene, view, profile);
    return hs::polygons_json(input, hs::hex_colors(input));
}

std::string LabSession::play(const Json& options) {
    const scene::Scene scene = scene_for(options);
    const scene::View view = view_of(scene, options);
    Machine& machine = machine_for(options);
    const hs::Input input = hs::make_input(scene, view, machine.profile());
    hs::Play play = hs::read_play(input, "step", options.at("steps").get<std::string>());
    const hs::Level level = play.level;
    return graded_log(machine, hs::played(std::move(play)), input, level);
}

std::string LabSession::graded_log(Machine& machine, const hs::Algorithm& algorithm,
                                   const hs::Input& input, hs::Level level) {
    hs::StepLog none, log(level);
    const hs::Result expected = hs::run_on(machine, hs::algorithm_named("z-buffer"), input, none);
    hs::Result result = hs::run_on(machine, algorithm, input, log);
    hs::compare(result, expected.ids, input);
    keep_difference(result, input.view.width);
    const hs::LogSubject subject{.algorithm = algorithm.name,
                                 .title = algorithm.title,
                                 .in_world = algorithm.in_world,
                                 .level = level};
    return hs::log_text(input, subject, log.steps(),
                        hs::log_end(log.steps().size(), result.counts, hs::grid_of(input),
                                    hs::blame_of(log.steps(), result, input.view.width)));
}

void LabSession::keep_difference(const hs::Result& result, int width) {
    difference_.clear();
    for (auto end = result.difference.end(); end != result.difference.begin(); end -= width)
        for (auto at = end - width; at != end; ++at) difference_.push_back(std::uint8_t(*at));
}

const Method hidden_methods[] = {
    {"about", &LabSession::about},
    {"hidden", &LabSession::hidden, {{"difference", &LabSession::difference}}},
    {"polygons", &LabSession::polygons},
    {"play", &LabSession::play, {{"difference", &LabSession::difference}}},
};

}  // namespace gw::lab
