// gw quiz: writes a handout of questions with drawings and scenes, and the answers beside
// it; or one for each student.
#include "hiddensurface/quiz/quiz.h"
#include "apps/command/command.h"
#include "apps/command/folder_index.h"
#include "apps/command/terminal.h"
#include "apps/hidden/files.h"
#include "apps/hidden/options.h"
#include "apps/hidden/page.h"
#include "apps/hidden/quiz/quiz_drawing.h"
#include "apps/hidden/quiz/quiz_page.h"
#include "apps/hidden/quiz/students.h"
#include "hiddensurface/lines/draw_lines.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <memory>

namespace gw::apps {

namespace hs = hiddensurface;
using Json = nlohmann::ordered_json;

namespace {

struct QuizOptions {
    std::filesystem::path folder;
    int seed = 1, questions = 7;
    std::string kind;      ///< of the questions; "": all kinds in turn
    std::string students;  ///< students_from; "": one quiz
    Form form = Form::Text;
    bool quiet = false;
};

/// The log of the algorithm that decides the question, as a page; empty if the build has no pages.
std::string player_of(const hs::Question& question) {
    if (embedded_page("player.html").empty()) return "";
    const scene::View view = scene::make_view(question.scene, hs::quiz_width, hs::quiz_height);
    const hs::Input input = hs::make_input(question.scene, view, vgx());
    const auto machine = make_fast(vgx(), hs::quiz_width, hs::quiz_height, {.threads = 1});
    const hs::DecidingStep& decided = question.decided;
    hs::StepLog log(decided.level);
    hs::LogSubject subject{.algorithm = decided.algorithm, .title = "", .level = decided.level};
    std::string end;
    if (const hs::LineAlgorithm* lines = hs::line_algorithm_named(decided.algorithm)) {
        subject.title = lines->title;
        subject.lines = true;
        const hs::LineResult result = hs::run_on(*machine, *lines, input, log);
        end = hs::log_end(log.steps().size(), result.counts);
    } else {
        const hs::Algorithm& algorithm = hs::algorithm_named(decided.algorithm);
        subject.title = algorithm.title;
        subject.in_world = algorithm.in_world;
        hs::StepLog none;
        const auto expected = hs::run_on(*machine, hs::algorithm_named("z-buffer"), input, none);
        hs::Result result = hs::run_on(*machine, algorithm, input, log);
        hs::compare(result, expected.ids, input);
        end = hs::log_end(log.steps().size(), result.counts, hs::grid_of(input),
                          hs::blame_of(log.steps(), result, input.view.width));
    }
    return page_with("player.html", {log_text(input, subject, log.steps(), end)});
}

/// The player's address of the deciding step, at the question's pixel.
std::string link_of(const hs::Question& question, const std::string& player) {
    std::string link = fmt::format("{}#step={}", player, question.decided.step);
    if (question.point)
        link += fmt::format("&pixel={},{}", int(question.point->x),
                            hs::quiz_height - 1 - int(question.point->y));
    return link;
}

std::string mtl_of(const scene::Scene& scene) {
    std::string text;
    for (const scene::Material& m : scene.materials)
        text += fmt::format("newmtl {0}\nKa {1:.9g} {2:.9g} {3:.9g}\nKd {1:.9g} {2:.9g} {3:.9g}\n",
                            m.name, m.Kd.x, m.Kd.y, m.Kd.z);
    return text;
}

std::string obj_of(const scene::Scene& scene, const std::string& mtl) {
    std::string text = "mtllib " + mtl + "\n";
    for (const scene::Object& object : scene.objects) {
        const auto& corners = object.mesh->data().positions;
        text += "o " + object.name + "\nusemtl " + scene.materials[object.material].name + "\n";
        for (const vec3& p : corners)
            text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
        text += "f";
        for (std::size_t k = 0; k < corners.size(); ++k)
            text += fmt::format(" -{}", corners.size() - k);
        text += "\n";
    }
    return text;
}

std::string toml_of(const hs::Question& question, const std::string& obj) {
    const scene::Camera& c = *question.scene.camera;
    const vec3& b = question.scene.background;
    std::string text = fmt::format(
        "background = [{:.9g}, {:.9g}, {:.9g}]\n\n[camera]\neye = [{}, {}, {}]\nat = [{}, {}, "
        "{}]\n",
        b.x, b.y, b.z, c.eye.x, c.eye.y, c.eye.z, c.at.x, c.at.y, c.at.z);
    text += c.ortho_height > 0 ? fmt::format("ortho = {}\n", c.ortho_height)
                               : fmt::format("fov = {}\n", c.fov);
    return text +
           "\n[[light]]\ndirection = [-0.4, -0.5, -0.8]\nIa = 0.4\nId = 0.6\n\n[[object]]\nfile "
           "= \"" +
           obj + "\"\n";
}

/// The questions as text and as JSON, the form to fill in, and the key.
struct Texts {
    std::string text;
    Json questions = Json::array(), form = Json::object(), key = Json::array();
};

std::string corners_text(const hs::Question& question) {
    std::string text;
    for (const QuizCorner& c : corners_of(question))
        text += fmt::format("   {}: {:.1f} {:.1f} {:.4f}\n", c.name, c.x, c.y, c.Z);
    return text.empty() ? "" : "   Corners: x, y in pixels from the upper left, Z 0 to 1\n" + text;
}

void add_question(const hs::Question& q, std::size_t number, const std::string& picture,
                  const std::string& scene, Texts& out) {
    out.text += fmt::format("{}. ({}) {}\n   {}\n   Picture: {}; scene: {}\n{}", number, q.kind,
                            q.text.en, q.text.ja, picture, scene, corners_text(q));
    Json json{{"number", number},         {"kind", q.kind},     {"question", q.text.en},
              {"question_ja", q.text.ja}, {"picture", picture}, {"scene", scene}};
    Json choices = Json::object();
    for (std::size_t i = 0; i < q.choices.size(); ++i) {
        const auto& [en, ja] = q.choices[i];
        out.text += fmt::format("   {}) {}{}\n", char('a' + i), en, en == ja ? "" : " / " + ja);
        choices[std::string(1, char('a' + i))] = en;
    }
    if (!choices.empty()) json["choices"] = std::move(choices);
    out.text += "\n";
    out.questions.push_back(json);
    out.form[std::to_string(number)] = "";
    out.key.push_back({{"number", number},
                       {"kind", q.kind},
                       {"answer", q.answer},
                       {"why", q.why.en},
                       {"why_ja", q.why.ja},
                       {"algorithm", q.decided.algorithm},
                       {"step", q.decided.step}});
}

/// One student's folders.
struct Folders {
    std::filesystem::path handout, answers;
};

/// Returns the questions as text or JSON.
std::string put_quiz(image::OutputSet& output, const Folders& folders, const QuizSheet& sheet,
                     Form form) {
    Texts all;
    std::vector<std::string> players;
    for (std::size_t i = 0; i < sheet.questions.size(); ++i) {
        const hs::Question& question = sheet.questions[i];
        const std::string name = fmt::format("{:02}", i + 1), picture = "picture_" + name + ".svg",
                          scene = "scene_" + name;
        const auto file = [&](const std::string& rest) -> image::OutputFile& {
            return output.add(folders.handout / rest);
        };
        file(picture).write_text(drawing_of(question) + "\n");
        file(scene + ".toml").write_text(toml_of(question, scene + ".obj"));
        file(scene + ".obj").write_text(obj_of(question.scene, scene + ".mtl"));
        file(scene + ".mtl").write_text(mtl_of(question.scene));
        add_question(question, i + 1, picture, scene + ".toml", all);
        players.emplace_back();
        if (const std::string player = player_of(question); !player.empty()) {
            const std::string page = "steps_" + name + ".html";
            output.add(folders.answers / page).write_text(player);
            players.back() = link_of(question, page);
        }
    }
    const Json head{{"seed", sheet.seed},
                    {"size", fmt::format("{}x{}", hs::quiz_width, hs::quiz_height)}};
    Json questions = head, empty{{"seed", sheet.seed}, {"answers", all.form}},
         key{{"seed", sheet.seed}, {"student", sheet.student}, {"answers", all.key}};
    questions["questions"] = all.questions;
    output.add(folders.handout / "quiz.html").write_text(handout_page(sheet));
    output.add(folders.handout / "questions.txt").write_text(all.text);
    output.add(folders.handout / "questions.json").write_text(questions.dump(2) + "\n");
    output.add(folders.handout / "answers.json").write_text(empty.dump(2) + "\n");
    output.add(folders.answers / "answers.html").write_text(answers_page(sheet, players));
    output.add(folders.answers / "key.json").write_text(key.dump(2) + "\n");
    return form == Form::Json ? questions.dump(2) + "\n" : all.text;
}

QuizSheet quiz_sheet(const QuizOptions& options, const std::string& student, int seed) {
    return {student, seed, hs::make_quiz(std::uint32_t(seed), options.questions, options.kind)};
}

/// A folder and a seed for each student, and the class's list.
std::string put_class(image::OutputSet& output, const QuizOptions& options,
                      const std::vector<Student>& students, Progress& progress) {
    const auto handout = options.folder / "handout", answers = options.folder / "answers";
    output.make_folder(answers);
    std::string list = "student,seed,folder\n", text;
    for (const Student& student : students) {
        progress.at(fmt::format("quiz {} of {}", student.folder, students.size()));
        const Folders folders{handout / student.folder, answers / student.folder};
        output.make_folder(folders.handout);
        output.make_folder(folders.answers);
        put_quiz(output, folders, quiz_sheet(options, student.name, student.seed), Form::Text);
        list += fmt::format("\"{}\",{},{}\n", student.name, student.seed, student.folder);
        text += fmt::format("{}: seed {}\n", student.folder, student.seed);
        output.commit();
    }
    output.add(options.folder / "class.csv").write_text(list);
    return text;
}

int quiz(const QuizOptions& options, const Session& session) {
    image::OutputSet output(session.inputs);
    std::vector<Student> students;
    if (!options.students.empty()) students = students_from(options.students, options.seed);
    const std::filesystem::path handout = options.folder / "handout";
    output.make_folder(options.folder);
    output.make_folder(handout);
    Progress progress("making questions", options.quiet);
    const std::string text = options.students.empty()
                                 ? put_quiz(output, {handout, options.folder},
                                            quiz_sheet(options, "", options.seed), options.form)
                                 : put_class(output, options, students, progress);
    if (options.students.empty()) put_index(output, options.folder, session);
    output.commit();
    print(text);
    return Done;
}

void add_whole_number(CLI::App& command, const char* name, int& to, int low, int high,
                      const char* help) {
    command
        .add_option_function<std::string>(
            name,
            [name, &to, low, high](const std::string& word) {
                to = whole_number_from(name, word, low, high);
            },
            help)
        ->type_name("N");
}

}  // namespace

Command add_quiz(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("quiz", "Exercises about hidden surfaces, with their answers");
    const auto options = std::make_shared<QuizOptions>();
    command
        ->add_option("DIR", options->folder,
                     "The exercises go to DIR/handout, their answers to DIR/key.json")
        ->required()
        ->type_name("DIR");
    add_whole_number(*command, "--seed", options->seed, 0, 2147483647,
                     "The same seed gives the same questions (default 1)");
    add_whole_number(*command, "--questions", options->questions, 1, 99,
                     "The number of questions (default 7)");
    command
        ->add_option("--students", options->students,
                     "A quiz for each student, in folders of their own. A number, or a file with "
                     "lines name or name,seed")
        ->type_name("N|FILE.csv");
    command
        ->add_option_function<std::string>(
            "--kind",
            [options](const std::string& word) {
                options->kind = one_of("--kind", word, hs::quiz_kinds());
            },
            "Questions of one kind (default: all kinds in turn)")
        ->type_name("NAME");
    add_form_options(*command, options->form, false);
    command->add_flag("--quiet", options->quiet, "No progress");
    command->footer("Example:\n  build/release/bin/gw quiz quiz --seed 7");
    return {command, [options](Session& session) { return quiz(*options, session); }};
}

}  // namespace gw::apps
