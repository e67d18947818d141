// gw hidden --polygons and --play: for algorithms in any language. Writes the polygons; draws the
// steps that come back, counts them and grades them by the Z-buffer.
#include "hiddensurface/run/play.h"
#include "apps/command/command.h"
#include "apps/command/table.h"
#include "apps/command/terminal.h"
#include "apps/figures/folder_index.h"
#include "apps/hidden/files.h"
#include "apps/hidden/options.h"
#include "apps/hidden/pictures.h"
#include "image/write.h"
#include "scene/text/text_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace gw::apps {

namespace hs = hiddensurface;
using Json = nlohmann::ordered_json;

namespace {

using Grades = std::vector<hs::PolygonGrade>;

std::string play_text(const Compared& run, const Grades& grades) {
    constexpr std::size_t most = 20;
    std::vector<std::vector<std::string>> rows{
        {"polygon", "expected", "shown", "missing", "extra"}};
    std::size_t more = 0;
    for (const hs::PolygonGrade& g : grades) {
        if (g.missing + g.extra == 0) continue;
        if (rows.size() > most)
            more += 1;
        else
            rows.push_back({g.id == 0 ? "none" : std::to_string(g.id), std::to_string(g.expected),
                            std::to_string(g.shown), std::to_string(g.missing),
                            std::to_string(g.extra)});
    }
    std::string text = counts_text({run});
    if (rows.size() > 1) text += "\n" + table(rows);
    if (more > 0) text += fmt::format("and {} more\n", more);
    return text +
           fmt::format("\n{} of {} pixels wrong\n", run.result.counts.wrong, run.result.ids.size());
}

std::string play_json(const Compared& run, const Grades& grades) {
    Json json = Json::object();
    json["wrong"] = run.result.counts.wrong;
    json["pixels"] = run.result.ids.size();
    json["counts"] = Json::object();
    for (const auto& [name, count] : hs::count_names())
        json["counts"][name] = run.result.counts.*count;
    json["polygons"] = Json::array();
    for (const hs::PolygonGrade& g : grades)
        json["polygons"].push_back({{"id", g.id},
                                    {"expected", g.expected},
                                    {"shown", g.shown},
                                    {"missing", g.missing},
                                    {"extra", g.extra}});
    return json.dump(2) + "\n";
}

}  // namespace

int hidden_polygons(const HiddenOptions& options, Session& session) {
    image::check_target(options.polygons);
    Progress progress("reading", options.picture.quiet);
    const Profile profile = load_profile(options.picture, session);
    const scene::Scene scene = load_scene(options.picture, session);
    session.inputs.check(options.polygons);
    const scene::View view =
        scene::make_view(scene, options.picture.size.width, options.picture.size.height);
    const hs::Input input = hs::make_input(scene, view, profile);
    image::write_file(options.polygons, hs::polygons_json(input, hs::hex_colors(input)));
    return Done;
}

int hidden_play(const HiddenOptions& options, Session& session) {
    Progress progress("reading", options.picture.quiet);
    const Profile profile = load_profile(options.picture, session);
    const scene::Scene scene = load_scene(options.picture, session);
    session.inputs.add(options.play);
    image::OutputSet output(session.inputs);
    if (!options.steps.empty()) output.make_folder(options.steps);
    const scene::View view =
        scene::make_view(scene, options.picture.size.width, options.picture.size.height);
    const hs::Input input = hs::make_input(scene, view, profile);
    hs::Play play = hs::read_play(input, options.play.string(), scene::read_text(options.play));
    progress.at("playing");
    const auto machine = make_machine(options.picture, profile, session);
    hs::StepLog none, log(play.level);
    const auto expected = hs::run_on(*machine, hs::algorithm_named("z-buffer"), input, none).ids;
    const hs::Algorithm algorithm = hs::played(std::move(play));
    hs::Result result = hs::run_on(*machine, algorithm, input, log);
    hs::compare(result, expected, input);
    const Compared run{&algorithm, std::move(result), std::move(log)};
    progress.at("writing");
    if (!options.steps.empty()) {
        put_player(output, options.steps, {put_steps(output, options.steps, input, run)});
        put_index(output, options.steps, session);
    }
    output.commit();
    const Grades grades = hs::grades_of(run.result, expected);
    print(options.form == Form::Json  ? play_json(run, grades)
          : options.form == Form::Csv ? counts_csv({run})
                                      : play_text(run, grades));
    return run.result.counts.wrong == 0 ? Done : Differs;
}

}  // namespace gw::apps
