// gw fragments: compares a list of the visible fragments with the Z-buffer's picture.
#include "hiddensurface/quiz/fragments.h"
#include "apps/command/command.h"
#include "apps/command/terminal.h"
#include "apps/hidden/options.h"
#include "apps/hidden/pictures.h"
#include "gw/escape_controls.h"
#include "hiddensurface/interface/algorithm.h"
#include "image/write.h"
#include "scene/text/text_file.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <memory>

namespace gw::apps {

namespace hs = hiddensurface;
using Json = nlohmann::ordered_json;

namespace {

struct FragmentsOptions {
    PictureOptions picture = polygon_options();
    std::filesystem::path fragments;      ///< a student's list; "": none
    std::filesystem::path truth, marked;  ///< files to write: the correct list, the mistakes
    Form form = Form::Text;
};

/// A reason why most pixels are wrong, if they are; a list of another size often is.
std::string hint_of(const hs::FragmentGrade& grade, const Size& size) {
    if (2 * grade.right >= grade.expected) return "";
    return fmt::format(
        "most pixels are wrong: was the list made with --size {}x{} and with this camera?\n",
        size.width, size.height);
}

std::string text_of(const hs::FragmentGrade& grade, const std::string& name) {
    constexpr std::size_t most = 20;
    std::string text = fmt::format(
        "expected {}\nright {}\nmissing {}\ndoubled {}\nmisplaced {}\nwrong {}\n", grade.expected,
        grade.right, grade.missing, grade.doubled, grade.misplaced, grade.wrong);
    for (std::size_t i = 0; i < grade.mistakes.size() && i < most; ++i) {
        const hs::FragmentMistake& m = grade.mistakes[i];
        text += m.line > 0 ? fmt::format("{}:{}: ", name, m.line) : name + ": ";
        text += fmt::format("{}: {},{}", hs::name_of(m.mistake), m.x, m.y);
        if (m.given != 0) text += fmt::format(" polygon {}", m.given);
        text += m.expected != 0 ? fmt::format("; expected polygon {}\n", m.expected)
                                : "; expected none\n";
    }
    if (grade.mistakes.size() > most)
        text += fmt::format("and {} more\n", grade.mistakes.size() - most);
    return text;
}

std::string json_of(const hs::FragmentGrade& grade) {
    Json json{{"expected", grade.expected},   {"right", grade.right},
              {"missing", grade.missing},     {"doubled", grade.doubled},
              {"misplaced", grade.misplaced}, {"wrong", grade.wrong}};
    json["mistakes"] = Json::array();
    for (const hs::FragmentMistake& m : grade.mistakes)
        json["mistakes"].push_back({{"mistake", hs::name_of(m.mistake)},
                                    {"x", m.x},
                                    {"y", m.y},
                                    {"line", m.line},
                                    {"given", m.given},
                                    {"expected", m.expected}});
    return json.dump(2) + "\n";
}

/// The darkened picture with the mistakes in the colours of gw hidden --compare: wrong red, doubled
/// yellow, misplaced cyan, missing blue.
image::Picture marked(image::Picture picture, const hs::FragmentGrade& grade) {
    for (std::uint16_t& v : picture.values) v = static_cast<std::uint16_t>(v / 3);
    for (const hs::FragmentMistake& m : grade.mistakes) {
        const Color color = m.mistake == hs::Mistake::Wrong       ? red
                            : m.mistake == hs::Mistake::Doubled   ? yellow
                            : m.mistake == hs::Mistake::Misplaced ? cyan
                                                                  : blue;
        put(picture, pixel_index(m.x, picture.height - 1 - m.y, picture.width), color);
    }
    return picture;
}

int fragments(const FragmentsOptions& options, Session& session) {
    if (options.fragments.empty() && options.truth.empty())
        throw UsageError("LIST.csv is missing; expected a list of fragments, or --truth FILE.csv");
    if (!options.marked.empty() && options.fragments.empty())
        throw UsageError("--marked shows mistakes; expected a list, LIST.csv");
    if (!options.marked.empty()) check_picture_target(options.marked);
    if (!options.truth.empty()) image::check_target(options.truth);
    Progress progress("reading", options.picture.quiet);
    const Profile profile = load_profile(options.picture, session);
    const scene::Scene scene = load_scene(options.picture, session);
    if (!options.fragments.empty()) session.inputs.add(options.fragments);
    for (const auto& target : {options.truth, options.marked}) session.inputs.check(target);
    const scene::View view =
        scene::make_view(scene, options.picture.size.width, options.picture.size.height);
    const hs::Input input = hs::make_input(scene, view, profile);
    hs::StepLog none;
    const auto z_buffer = hs::run_on(*make_machine(options.picture, profile, session),
                                     hs::algorithm_named("z-buffer"), input, none)
                              .ids;
    if (!options.truth.empty())
        image::write_file(options.truth, hs::fragments_text(z_buffer, input));
    if (options.fragments.empty()) return Done;
    const std::string name = options.fragments.string();
    const auto grade = hs::grade_fragments(
        hs::read_fragments(name, scene::read_text(options.fragments), input), z_buffer, input);
    if (!options.marked.empty())
        image::write_picture(options.marked,
                             marked(picture_of_ids(input, z_buffer, flat_colors(input)), grade));
    print(options.form == Form::Json
              ? json_of(grade)
              : text_of(grade, escape_controls(name)) + hint_of(grade, options.picture.size));
    return grade.all_right() ? Done : Differs;
}

}  // namespace

Command add_fragments(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("fragments", "Compares a list of visible fragments with the Z-buffer's");
    const auto options = std::make_shared<FragmentsOptions>();
    add_polygon_options(*command, options->picture);
    command
        ->add_option("LIST", options->fragments,
                     "Lines x,y,polygon, one for each pixel that shows a polygon")
        ->type_name("LIST.csv");
    command->add_option("--truth", options->truth, "Writes the correct list")
        ->type_name("FILE.csv");
    command->add_option("--marked", options->marked, "A picture of the list's mistakes")
        ->type_name("IMAGE");
    add_form_options(*command, options->form, false);
    command->footer(
        "Exit code 3 unless all are right.\n"
        "Example:\n"
        "  build/release/bin/gw fragments scenes/hidden/cycle.toml --size 64x48 --truth truth.csv");
    return {command, [options](Session& session) { return fragments(*options, session); }};
}

}  // namespace gw::apps
