// gw play: for algorithms in any language. Writes the polygons; draws the steps that come back,
// counts them and grades them by the Z-buffer.
#include "hiddensurface/run/play.h"
#include "apps/command/command.h"
#include "apps/command/folder_index.h"
#include "apps/command/table.h"
#include "apps/command/terminal.h"
#include "apps/hidden/files.h"
#include "apps/hidden/options.h"
#include "apps/hidden/pictures.h"
#include "hiddensurface/run/blame.h"
#include "hiddensurface/run/step_json.h"
#include "image/write.h"
#include "scene/text/text_file.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <memory>
#include <span>

namespace gw::apps {

namespace hs = hiddensurface;
using Json = nlohmann::ordered_json;

namespace {

struct PlayOptions {
    PictureOptions picture = polygon_options();
    std::filesystem::path answer;           ///< a program's steps; "": none
    std::filesystem::path polygons, steps;  ///< a file and a folder to write
    Form form = Form::Text;
};

/// A played answer beside the Z-buffer.
struct Graded {
    Compared run;
    std::vector<hs::PolygonGrade> polygons;
    std::vector<hs::Blame> blame;
    hs::PictureGrid grid;
};

constexpr std::size_t most_lines = 20;  // lines of a kind

/// The polygons with wrong pixels; "" if none has any.
std::string polygons_text(const std::vector<hs::PolygonGrade>& polygons) {
    std::vector<std::vector<std::string>> rows{
        {"polygon", "expected", "shown", "missing", "extra"}};
    std::size_t more = 0;
    for (const hs::PolygonGrade& g : polygons) {
        if (g.missing + g.extra == 0) continue;
        if (rows.size() > most_lines)
            more += 1;
        else
            rows.push_back({g.id == 0 ? "none" : std::to_string(g.id), std::to_string(g.expected),
                            std::to_string(g.shown), std::to_string(g.missing),
                            std::to_string(g.extra)});
    }
    if (rows.size() == 1) return "";
    return "\n" + table(rows) + (more > 0 ? fmt::format("and {} more\n", more) : "");
}

/// The steps to blame, those with most wrong pixels first.
std::string blame_text(std::vector<hs::Blame> blame, int height) {
    std::ranges::stable_sort(blame, std::ranges::greater(), &hs::Blame::pixels);
    std::string text = blame.empty() ? "" : "\n";
    for (const hs::Blame& b : std::span(blame).first(std::min(most_lines, blame.size())))
        text += hs::sentence_of(b, height) + "\n";
    return text + (blame.size() > most_lines
                       ? fmt::format("and {} more\n", blame.size() - most_lines)
                       : "");
}

std::string play_text(const Graded& graded) {
    const hs::Result& result = graded.run.result;
    return counts_text({graded.run}) + polygons_text(graded.polygons) +
           blame_text(graded.blame, graded.grid.height) +
           fmt::format("\n{} of {} pixels wrong\n", result.counts.wrong, result.ids.size());
}

std::string play_json(const Graded& graded) {
    const auto& [run, polygons, blame, grid] = graded;
    Json json = Json::object();
    json["wrong"] = run.result.counts.wrong;
    json["pixels"] = run.result.ids.size();
    json["counts"] = Json::object();
    for (const auto& [name, count] : hs::count_names())
        json["counts"][name] = run.result.counts.*count;
    json["polygons"] = Json::array();
    for (const hs::PolygonGrade& g : polygons)
        json["polygons"].push_back({{"id", g.id},
                                    {"expected", g.expected},
                                    {"shown", g.shown},
                                    {"missing", g.missing},
                                    {"extra", g.extra}});
    json["blame"] = Json::array();
    for (const hs::Blame& b : blame)
        json["blame"].push_back({{"step", b.step},
                                 {"pixels", b.pixels},
                                 {"sentence", hs::sentence_of(b, grid.height)}});
    return json.dump(2) + "\n";
}

int play_answer(const PlayOptions& options, const hs::Input& input, const Profile& profile,
                Session& session, Progress& progress) {
    image::OutputSet output(session.inputs);
    if (!options.steps.empty()) output.make_folder(options.steps);
    hs::Play play = hs::read_play(input, options.answer.string(), scene::read_text(options.answer));
    progress.at("playing");
    const auto machine = make_machine(options.picture, profile, session);
    hs::StepLog none, log(play.level);
    const auto expected = hs::run_on(*machine, hs::algorithm_named("z-buffer"), input, none).ids;
    const hs::Algorithm algorithm = hs::played(std::move(play));
    hs::Result result = hs::run_on(*machine, algorithm, input, log);
    hs::compare(result, expected, input);
    Graded graded{{&algorithm, std::move(result), std::move(log)}, {}, {}, hs::grid_of(input)};
    const Compared& run = graded.run;
    graded.polygons = hs::grades_of(run.result, expected);
    graded.blame = hs::blame_of(run.log.steps(), run.result, input.view.width);
    progress.at("writing");
    if (!options.steps.empty()) {
        put_player(output, options.steps, {put_steps(output, options.steps, input, run)});
        put_index(output, options.steps, session);
    }
    output.commit();
    print(options.form == Form::Json  ? play_json(graded)
          : options.form == Form::Csv ? counts_csv({run})
                                      : play_text(graded));
    return run.result.counts.wrong == 0 ? Done : Differs;
}

int play(const PlayOptions& options, Session& session) {
    if (options.answer.empty() && options.polygons.empty())
        throw UsageError(
            "STEPS.jsonl is missing; expected a program's answer, or --polygons FILE.json");
    if (!options.polygons.empty()) image::check_target(options.polygons);
    Progress progress("reading", options.picture.quiet);
    const Profile profile = load_profile(options.picture, session);
    const scene::Scene scene = load_scene(options.picture, session);
    if (!options.answer.empty()) session.inputs.add(options.answer);
    session.inputs.check(options.polygons);
    const scene::View view =
        scene::make_view(scene, options.picture.size.width, options.picture.size.height);
    const hs::Input input = hs::make_input(scene, view, profile);
    if (!options.polygons.empty())
        image::write_file(options.polygons, hs::polygons_json(input, hs::hex_colors(input)));
    return options.answer.empty() ? Done : play_answer(options, input, profile, session, progress);
}

}  // namespace

Command add_play(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "play", "Hidden-surface algorithms in any language: their polygons, their steps played");
    const auto options = std::make_shared<PlayOptions>();
    add_polygon_options(*command, options->picture);
    command
        ->add_option("STEPS", options->answer,
                     "The steps of a program, lines of JSON: drawn, counted and graded")
        ->type_name("FILE.jsonl");
    command
        ->add_option("--polygons", options->polygons,
                     "Writes the polygons on the window grid, which the program reads")
        ->type_name("FILE.json");
    command->add_option("--steps", options->steps, "The log of the steps, and its player")
        ->type_name("DIR");
    add_form_options(*command, options->form, true);
    command->footer(
        "Exit code 3 if a pixel is wrong.\n"
        "Example:\n"
        "  build/release/bin/gw play scenes/hidden/cycle.toml --polygons polygons.json");
    return {command, [options](Session& session) { return play(*options, session); }};
}

}  // namespace gw::apps
